/*  PicSolver: forces of the last step on walls, where they are asked for. Nothing of this is part
    of a step.

    Pressure: pic/cutCells/wallParts.hpp. Shear, of water that sticks: what the viscous term takes
    from a face beside a side of the domain, 2 mu (u - w)/h times its area, and across each pair of
    faces of which one lies in the water and one in an obstacle mu (u - w)/(theta h).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/pic/picSolver.hpp"

namespace riprap
{

//- Of where the walls were when the pressure was solved
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::setWallParts()
{
    const double t = base_.moves ? clock_.time - clock_.lastStep : 0;
    if (wallParts_ && wallPartsTime_ == t) return;
    wallParts_ = std::make_unique<WallParts<D>>(
        partsOfWalls<D>(config_, sides_, inside_.obstacles, inside_.motion, t));
    wallPartsTime_ = t;
}

template<class Backend, int D, class P>
std::vector<FluidForce> PicSolver<Backend, D, P>::forcesOnWalls()
{
    std::vector<FluidForce> all;
    shearAsked_ = sticksInside();
    if (!clock_.steps || !clock_.initial) return all;       // no pressure yet, no water
    setWallParts();
    addPressureForces(all);
    if (config_.noSlip && config_.viscosity > 0) addSideStress(all);
    if (sticksInside()) addObstacleStress(all);
    return all;
}

template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::addPressureForces(std::vector<FluidForce>& all)
{
    const std::vector<double> p = wholePressure().download();
    Vec<D, double> weight;
    for (int d = 0; d < D; ++d) weight[d] = config_.density*gravity_[d];
    for (const WallPiece<D>& piece : wallParts_->pieces)
    {
        const Vec<D, double> force = pressureForce(grid_, piece, p, weight);
        if (squaredNorm(force) == 0) continue;
        FluidForce f;
        f.part = piece.part;
        f.place[config_.axes[2]] = emptyCoordinate_;
        for (int d = 0; d < D; ++d)
        {
            f.place[config_.axes[d]] = piece.middle[d];
            f.pressure[config_.axes[d]] = force[d];
        }
        all.push_back(f);
    }
}

template<class Backend, int D, class P>
FluidForce PicSolver<Backend, D, P>::shearOn(
    int part, int component, double force, const Vec<D, double>& place) const
{
    FluidForce f;
    f.part = part;
    f.place[config_.axes[2]] = emptyCoordinate_;
    for (int d = 0; d < D; ++d) f.place[config_.axes[d]] = place[d];
    f.viscous[config_.axes[component]] = force;
    return f;
}

//- A face beside a side drags the parts of it that bound the cells below and above the face, half
//  each
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::addSideStress(std::vector<FluidForce>& all)
{
    const double stress = config_.viscosity*grid_.area()/grid_.h;
    const std::vector<unsigned char> wet = wet_.download();
    for (int component = 0; component < D; ++component)
    {
        const std::vector<real> u = u_[component].download();
        for (int f = 0; f < grid_.faces(component); ++f)
        {
            const auto x = grid_.faceIndex(component, f);
            if (!(wallParts_->aperture[component][f] > leastKnown)
                || (grid_.periodic[component] && x.c[component] == grid_.n[component]))
                continue;
            const int cells[2] = {grid_.cellOf(component, x, 0), grid_.cellOf(component, x, 1)};
            if (!((cells[0] >= 0 && wet[cells[0]]) || (cells[1] >= 0 && wet[cells[1]]))) continue;
            for (int d = 0; d < D; ++d)
                for (int side = 0; side < 2; ++side)
                {
                    if (d == component || !grid_.sticks[d][side]
                        || x.c[d] != side*(grid_.n[d] - 1))
                        continue;
                    Vec<D, double> place = faceMiddle(grid_, component, f);
                    place[d] += (side - 0.5)*grid_.h;
                    const double force = 2*stress*(double(u[f]) - grid_.slide[d][side][component]);
                    for (const int cell : cells)
                    {
                        if (cell < 0) continue;
                        const int wall = grid_.faceOf(d, grid_.cellIndex(cell), side);
                        const int part = sides_.part[d].empty() ? -1 : sides_.part[d][wall];
                        if (part >= 0)
                            all.push_back(shearOn(part, component,
                                cells[0] < 0 || cells[1] < 0 ? force : 0.5*force, place));
                    }
                }
        }
    }
}

//- The part that the middle of a face lies deepest in, -1: there are no obstacles
template<class Backend, int D, class P>
int PicSolver<Backend, D, P>::nearestObstacle(
    int component, const typename UniformGrid<D>::Index& face) const
{
    int part = -1;
    double least = 1e300;
    for (std::size_t k = 0; k < wallParts_->part.size(); ++k)
    {
        if (wallParts_->distanceOf[k].empty()) continue;    // water slips along sheets
        const double distance = distanceOfFace(
            NodeGrid<D>{grid_}, component, face, wallParts_->distanceOf[k].data());
        if (distance < least) { least = distance; part = wallParts_->part[k]; }
    }
    return part;
}

//- Velocities that viscosity has made: the projection, which comes after, leaves those beside cut
//  cells rough
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::keepSheared()
{
    for (int d = 0; d < D; ++d)
    {
        if (shearedU_[d].size() == 0)
        {
            shearedU_[d].allocate(context_, grid_.faces(d));
            shearedLayer_[d].allocate(context_, grid_.faces(d));
        }
        forEach(context_, grid_.faces(d),
            KeepSheared<real>{
                u_[d].data(), layer_[d].data(), shearedU_[d].data(), shearedLayer_[d].data()});
    }
}

//- As bodies are dragged (picSolids.hpp)
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::addObstacleStress(std::vector<FluidForce>& all)
{
    const double stress = config_.viscosity*grid_.area()/grid_.h;
    // asked for the first time, or since a state was loaded: it comes with the next step
    if (shearedU_[0].size() == 0) return;
    for (int component = 0; component < D; ++component)
    {
        const int faces = grid_.faces(component);
        const std::vector<real> u = shearedU_[component].download();
        const std::vector<unsigned char> layer = shearedLayer_[component].download();
        const std::vector<double>& moving = base_.walls.wallVelocity[component];
        std::vector<real> distance(faces), w(faces, real(0));
        std::copy(moving.begin(), moving.end(), w.begin());
        for (int f = 0; f < faces; ++f)
            FaceDistances<D, real>{
                {grid_}, component, wallParts_->distance.data(), distance.data()}(f);
        const ViscousFaces<D, real> about{
            grid_, component, layer.data(), nullptr, false, distance.data(), w.data()};
        for (int i = 0; i < faces; ++i)
        {
            if (!about.inSolid(i)) continue;
            const auto at = grid_.faceIndex(component, i);
            const int part = nearestObstacle(component, at);
            for (int d = 0; d < D && part >= 0; ++d)
                for (int offset = -1; offset <= 1; offset += 2)
                {
                    auto next = at;
                    next.c[d] += offset;
                    if (next.c[d] < 0 || next.c[d] >= grid_.layers(component, d)) continue;
                    const int j = grid_.face(component, next);
                    if (!about.open(j)) continue;
                    const real theta = about.theta(j, i);
                    Vec<D, double> place = faceMiddle(grid_, component, i);
                    place[d] += offset*(1 - double(theta))*grid_.h;
                    all.push_back(shearOn(part, component,
                        stress*(double(u[j]) - about.onSurface(j, i, theta))/theta, place));
                }
        }
    }
}

} // namespace riprap

/*  Forces of the last step on walls, where they are asked for. Nothing of this is part of a step.

    Pressure: pic/cutCells/wallParts.hpp. Shear, of water that sticks: what the viscous term takes
    from a face beside a side of the domain, 2 mu (u - w)/h times its area, and across each pair of
    faces of which one lies in the water and one in an obstacle mu (u - w)/(theta h).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/cutCells/wallParts.hpp"
#include "pic/terms/viscosity.hpp"
#include "solvers/pic/parts/picParts.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class ForcesOnWalls
{
public:

    using real = typename P::real;

    explicit ForcesOnWalls(PicParts<Backend, D, P>& parts) : p_(parts) {}

    //- ofAllRanks: else those in this rank's brick
    std::vector<FluidForce> all(bool ofAllRanks);

    //- Has somebody asked for the shear on obstacles?
    bool shearAsked() const { return asked_; }
    void keepSheared();

private:

    bool isHere(const Vec<D, double>& x) const;
    void setParts();
    void addPressure(std::vector<FluidForce>&);
    void addSideStress(std::vector<FluidForce>&);
    void addObstacleStress(std::vector<FluidForce>&);
    int nearestObstacle(int component, const typename UniformGrid<D>::Index& face) const;
    FluidForce shearOn(int part, int component, double force, const Vec<D, double>& place) const;
    void tell(
        std::vector<FluidForce>&, const FluidForce&, const Vec<D, double>& place) const;

    PicParts<Backend, D, P>& p_;
    std::unique_ptr<WallParts<D>> parts_;       // once somebody has asked for forces
    double partsTime_ = 0;
    bool asked_ = false;
    bool ofAllRanks_ = false;                   // are forces told of all ranks?
    // once it was: of the last step, what drags obstacles
    Array<Backend, real> u_[D];
    Array<Backend, unsigned char> layer_[D];
};

template<class Backend, int D, class P>
std::vector<FluidForce> ForcesOnWalls<Backend, D, P>::all(bool ofAllRanks)
{
    std::vector<FluidForce> all;
    asked_ = p_.sticksInside();
    ofAllRanks_ = ofAllRanks;
    if (!p_.set.clock.steps || !p_.set.clock.initial) return all;       // no pressure yet, no water
    setParts();
    addPressure(all);
    if (p_.set.config.noSlip && p_.set.config.viscosity > 0) addSideStress(all);
    if (p_.sticksInside()) addObstacleStress(all);
    return all;
}

//- Is a place of the block, from the world's origin, for this rank to tell of?
template<class Backend, int D, class P>
bool ForcesOnWalls<Backend, D, P>::isHere(const Vec<D, double>& x) const
{
    if (!p_.halo) return true;
    const UniformGrid<D>& whole = p_.set.whole();
    typename UniformGrid<D>::Index c{{0, 0, 0}};
    for (int d = 0; d < D; ++d)
    {
        const int i = floorInt((x.c[d] - whole.origin[d])/whole.h);
        c.c[d] = std::max(0, std::min(i, whole.n[d] - 1));
    }
    return p_.set.bricks->owner(c) == p_.set.bricks->rank();
}

//- All ranks find all forces, in the order of one process
template<class Backend, int D, class P>
void ForcesOnWalls<Backend, D, P>::tell(
    std::vector<FluidForce>& all, const FluidForce& f, const Vec<D, double>& place) const
{
    if (ofAllRanks_ || isHere(place)) all.push_back(f);
}

//- Of where the walls were when the pressure was solved
template<class Backend, int D, class P>
void ForcesOnWalls<Backend, D, P>::setParts()
{
    const double t = p_.cut.base.moves ? p_.set.clock.time - p_.set.clock.lastStep : 0;
    if (parts_ && partsTime_ == t) return;
    parts_ = std::make_unique<WallParts<D>>(
        partsOfWalls<D>(p_.set.config, p_.walls.sides, p_.inside.obstacles, p_.inside.motion, t));
    partsTime_ = t;
}

template<class Backend, int D, class P>
void ForcesOnWalls<Backend, D, P>::addPressure(std::vector<FluidForce>& all)
{
    const PicConfig& config = p_.set.config;
    const std::vector<double> p = p_.whole(p_.pressure.whole(), -1);
    Vec<D, double> weight;
    for (int d = 0; d < D; ++d) weight[d] = config.density*p_.set.gravity[d];
    for (const WallPiece<D>& piece : parts_->pieces)
    {
        const Vec<D, double> force = pressureForce(p_.set.whole(), piece, p, weight);
        if (squaredNorm(force) == 0) continue;
        FluidForce f;
        f.part = piece.part;
        f.place[config.axes[2]] = p_.set.emptyCoordinate;
        for (int d = 0; d < D; ++d)
        {
            f.place[config.axes[d]] = piece.middle[d];
            f.pressure[config.axes[d]] = force[d];
        }
        tell(all, f, piece.middle);
    }
}

template<class Backend, int D, class P>
FluidForce ForcesOnWalls<Backend, D, P>::shearOn(
    int part, int component, double force, const Vec<D, double>& place) const
{
    const PicConfig& config = p_.set.config;
    FluidForce f;
    f.part = part;
    f.place[config.axes[2]] = p_.set.emptyCoordinate;
    for (int d = 0; d < D; ++d) f.place[config.axes[d]] = place[d];
    f.viscous[config.axes[component]] = force;
    return f;
}

//- A face beside a side drags the parts of it that bound the cells below and above the face, half
//  each
template<class Backend, int D, class P>
void ForcesOnWalls<Backend, D, P>::addSideStress(std::vector<FluidForce>& all)
{
    const UniformGrid<D>& grid = p_.set.whole();
    const double stress = p_.set.config.viscosity*grid.area()/grid.h;
    const std::vector<unsigned char> wet = p_.whole(p_.surface.wet, -1);
    for (int component = 0; component < D; ++component)
    {
        const std::vector<real> u = p_.whole(p_.faces.u[component], component);
        for (int f = 0; f < grid.faces(component); ++f)
        {
            const auto x = grid.faceIndex(component, f);
            if (!(parts_->aperture[component][f] > leastKnown)
                || (grid.periodic[component] && x.c[component] == grid.n[component]))
                continue;
            const int cells[2] = {grid.cellOf(component, x, 0), grid.cellOf(component, x, 1)};
            if (!((cells[0] >= 0 && wet[cells[0]]) || (cells[1] >= 0 && wet[cells[1]]))) continue;
            for (int d = 0; d < D; ++d)
                for (int side = 0; side < 2; ++side)
                {
                    if (d == component || !grid.sticks[d][side] || x.c[d] != side*(grid.n[d] - 1))
                        continue;
                    Vec<D, double> place = faceMiddle(grid, component, f);
                    place[d] += (side - 0.5)*grid.h;
                    const double force = 2*stress*(double(u[f]) - grid.slide[d][side][component]);
                    for (const int cell : cells)
                    {
                        if (cell < 0) continue;
                        const int wall = grid.faceOf(d, grid.cellIndex(cell), side);
                        const int part = p_.walls.sides.part[d].empty()
                            ? -1
                            : p_.walls.sides.part[d][wall];
                        if (part >= 0)
                            tell(all,
                                shearOn(part, component,
                                    cells[0] < 0 || cells[1] < 0 ? force : 0.5*force, place),
                                place);
                    }
                }
        }
    }
}

//- The part that the middle of a face lies deepest in, -1: there are no obstacles
template<class Backend, int D, class P>
int ForcesOnWalls<Backend, D, P>::nearestObstacle(
    int component, const typename UniformGrid<D>::Index& face) const
{
    int part = -1;
    double least = 1e300;
    for (std::size_t k = 0; k < parts_->part.size(); ++k)
    {
        if (parts_->distanceOf[k].empty()) continue;    // water slips along sheets
        const double distance = distanceOfFace(
            NodeGrid<D>{p_.set.whole()}, component, face, parts_->distanceOf[k].data());
        if (distance < least) { least = distance; part = parts_->part[k]; }
    }
    return part;
}

//- Velocities that viscosity has made: the projection, which comes after, leaves those beside cut
//  cells rough
template<class Backend, int D, class P>
void ForcesOnWalls<Backend, D, P>::keepSheared()
{
    const UniformGrid<D>& grid = p_.set.grid;
    Context<Backend>& context = p_.set.context;
    for (int d = 0; d < D; ++d)
    {
        if (u_[d].size() == 0)
        {
            u_[d].allocate(context, grid.faces(d));
            layer_[d].allocate(context, grid.faces(d));
        }
        forEach(context, grid.faces(d),
            KeepSheared<real>{
                p_.faces.u[d].data(), p_.faces.layer[d].data(), u_[d].data(), layer_[d].data()});
    }
}

//- As bodies are dragged (bodyCoupling.hpp)
template<class Backend, int D, class P>
void ForcesOnWalls<Backend, D, P>::addObstacleStress(std::vector<FluidForce>& all)
{
    const UniformGrid<D>& grid = p_.set.whole();
    const double stress = p_.set.config.viscosity*grid.area()/grid.h;
    // asked for the first time, or since a state was loaded: it comes with the next step
    if (u_[0].size() == 0) return;
    for (int component = 0; component < D; ++component)
    {
        const int faces = grid.faces(component);
        const std::vector<real> u = p_.whole(u_[component], component);
        const std::vector<unsigned char> layer = p_.whole(layer_[component], component);
        const std::vector<double>& moving = p_.cut.base.walls.wallVelocity[component];
        std::vector<real> distance(faces), w(faces, real(0));
        std::copy(moving.begin(), moving.end(), w.begin());
        for (int f = 0; f < faces; ++f)
            FaceDistances<D, real>{{grid}, component, parts_->distance.data(), distance.data()}(f);
        const ViscousFaces<D, real> about{
            grid, component, layer.data(), nullptr, false, distance.data(), w.data()};
        for (int i = 0; i < faces; ++i)
        {
            if (!about.inSolid(i)) continue;
            const auto at = grid.faceIndex(component, i);
            const int part = nearestObstacle(component, at);
            for (int d = 0; d < D && part >= 0; ++d)
                for (int offset = -1; offset <= 1; offset += 2)
                {
                    auto next = at;
                    next.c[d] += offset;
                    if (next.c[d] < 0 || next.c[d] >= grid.layers(component, d)) continue;
                    const int j = grid.face(component, next);
                    if (!about.open(j)) continue;
                    const real theta = about.theta(j, i);
                    Vec<D, double> place = faceMiddle(grid, component, i);
                    place[d] += offset*(1 - double(theta))*grid.h;
                    tell(all,
                        shearOn(part, component,
                            stress*(double(u[j]) - about.onSurface(j, i, theta))/theta, place),
                        place);
                }
        }
    }
}

} // namespace riprap

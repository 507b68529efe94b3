/*  PicSolver: solids that move with the water. Nothing of this is called in a scene that has none.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/cutCells/obstacleDistance.hpp"
#include "solvers/pic/picSolver.hpp"

namespace riprap
{

template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::setSolids(bool inWater)
{
    if (!inside_.scene) return;
    solidSide_ = dynamic_cast<SolidSide<D, P>*>(inside_.scene.get());
    if (!solidSide_)
        throw std::invalid_argument("solids of another dimension or precision than the fluid's");
    if (inWater) solidSide_->external();        // forces from outside are to come
    bodies_ = std::make_unique<PicBodies<D>>(config_, *inside_.solids, *inside_.scene);
    insideMoves_ = true;
}

//- The grid for bodies to cut
template<class Backend, int D, class P>
CutFields<D, typename P::real> PicSolver<Backend, D, P>::cutFields()
{
    CutFields<D, real> f{};
    for (int d = 0; d < D; ++d)
    {
        f.aperture[d] = aperture_[d].data();
        f.wallVelocity[d] = wallVelocity_[d].data();
        f.baseAperture[d] = baseAperture_[d].data();
        f.baseVelocity[d] = base_.walls.wallVelocity[d].empty() ? nullptr : baseVelocity_[d].data();
    }
    f.distance = nodeDistance_.data();
    f.baseDistance = baseDistance_.data();
    f.band = bandNodes*grid_.h;
    return f;
}

//- What bodies leave of the grid that walls and obstacles have cut
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::cutByBodies()
{
    if (opens()) openFully();
    bodyCut_.cut(context_, grid_, bodies_->bodies(), std::max(steepest(), 0), cutFields());
    if (opens()) keepOpenParts();
    std::vector<double> velocity;
    for (const auto& b : bodies_->bodies())
        velocity.insert(velocity.end(), b.velocity.begin(), b.velocity.end());
    bodyCut_.setVelocities(context_, velocity, cutFields());
    if (opens()) writeOpenFaces();
}

//- Where the surface cuts the volumes of faces, bodies have what is under water
template<class Backend, int D, class P> void PicSolver<Backend, D, P>::cutToWater()
{
    if (bodyCut_.cutToWater(context_, phi_.data(), cutFields())) bodiesRest_ = false;
}

//- The closed parts of faces move with bodies as predicted, or as in the step before
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::useBodyVelocities(bool predicted)
{
    const std::vector<double> velocity = bodies_->velocities(predicted);
    const bool rest = std::all_of(
        velocity.begin(), velocity.end(), [](double v) { return v == 0; });
    if (rest && bodiesRest_) return;
    bodiesRest_ = rest;
    bodyCut_.setVelocities(context_, velocity, cutFields());
    if (opens()) writeOpenFaces();
}

//- Do bodies give way in the pressure's equation? Else they are walls for it, as where all sleep
template<class Backend, int D, class P> bool PicSolver<Backend, D, P>::bodiesYield() const
{
    return bodies_ && !bodies_->weak() && bodies_->yield();
}

//- Light bodies bring slow modes, which a solver on the host takes away; it may also be the better
//  for knowing where walls stand (pic/bodies/hats.hpp)
template<class Backend, int D, class P>
PressureReport PicSolver<Backend, D, P>::solveWithBodies(
    const PressureFields<D, real>& fields, bool sameWater, double tolerance)
{
    const MultigridControls* own = linearSolver_.onDevice();
    if (!bodiesYield())
    {
        std::vector<BodyTerm> walls;
        if (bodies_ && !own) walls = bodyCut_.terms();
        for (BodyTerm& t : walls) t.modes = 0;
        return pressureStep_.project(
            context_, fields, linearSolver_, &walls, sameWater, &rows_, nullptr, tolerance);
    }
    if (own
        && !bodies_->anyLighter(bodyCut_.volumes(),
            pressureStep_.heavyFrom(bodies_->bodies().size(), sameWater)*config_.density))
    {
        const std::vector<double> roots = bodies_->roots();
        const BodiesOnGrid<Backend, D> onGrid{bodyCut_, roots};
        return pressureStep_.project(
            context_, fields, linearSolver_, nullptr, sameWater, &rows_, &onGrid, tolerance);
    }
    std::vector<BodyTerm> terms = bodyCut_.terms();
    bodies_->fill(terms);
    return pressureStep_.project(
        context_, fields, linearSolver_, &terms, sameWater, &rows_, nullptr, tolerance);
}

//- The impulse by which particles are left ahead is known before
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::projectWithBodies(double dt, bool sameWater)
{
    if (config_.reflection > 0)
        bodies_->foresee(
            bodiesYield() ? bodyCut_.gather(context_, ahead_.data()) : std::vector<double>());
    useBodyVelocities(true);
    lastPressure_ = solveWithBodies(pressureFields(dt), sameWater);
    bodies_->move(bodyCut_.gather(context_, pressure_.data()), dt);
}

//- Of solids at the faces about their surfaces, as in the step before: bodies' rigid motion, else
//  that of the closed part of a face
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::setSolidVelocity()
{
    constexpr double about = 1.5;               // cells
    for (int component = 0; component < D; ++component)
    {
        std::vector<real> w = wallVelocity_[component].download();
        if (bodies_)
        {
            const auto moving = bodies_->withVelocities(false);
            std::vector<double> nearest(w.size(), about*grid_.h);
            bodies_->eachFaceNear(grid_, component, about,
                [&](int body, const typename UniformGrid<D>::Index& f, const Vec<D, double>& x)
                {
                    const int i = grid_.face(component, f);
                    const double distance = moving[body].shape.distance(x);
                    if (!(distance < nearest[i])) return;
                    nearest[i] = distance;
                    double v = 0;
                    for (int m = 0; m < bodyModes<D>; ++m)
                        v += modeVelocity(m, component, x - moving[body].centre)
                            *moving[body].velocity[m];
                    w[i] = real(v);
                });
        }
        solidVelocity_[component].upload(context_, w);
    }
}

//- What viscosity has taken from the water beside bodies in a step dt, they have got: across each
//  pair of faces of which one lies in the water and one in the body mu (u - w)/theta h^(D - 2)
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::dragBodies(double dt)
{
    const double stress = config_.viscosity*(D == 2 ? 1.0 : grid_.h);
    bodies_->startDrag();
    for (int component = 0; component < D; ++component)
    {
        const std::vector<real> u = u_[component].download(),
                                w = solidVelocity_[component].download();
        const std::vector<real> distance = faceDistance_[component].download();
        const std::vector<unsigned char> layer = layer_[component].download();
        const ViscousFaces<D, real> faces{
            grid_, component, layer.data(), nullptr, false, distance.data(), w.data()};
        // the mean of a face's corners, by which faces are told, differs from the distance of its
        // middle by the bend of the surface
        bodies_->eachFaceNear(grid_, component, 0.1,
            [&](int body, const typename UniformGrid<D>::Index& f, const Vec<D, double>& x)
            {
                const int i = grid_.face(component, f);
                if (!faces.inSolid(i)) return;
                for (int d = 0; d < D; ++d)
                    for (int offset = -1; offset <= 1; offset += 2)
                    {
                        typename UniformGrid<D>::Index at = f;
                        at.c[d] += offset;
                        if (at.c[d] < 0 || at.c[d] >= grid_.layers(component, d)) continue;
                        const int j = grid_.face(component, at);
                        if (!faces.open(j)) continue;
                        const real theta = faces.theta(j, i);
                        Vec<D, double> surface = x;
                        surface[d] += offset*(1 - theta)*grid_.h;
                        bodies_->drag(body, component,
                            stress*(double(u[j]) - faces.onSurface(j, i, theta))/theta,
                            surface);
                    }
            });
    }
    bodies_->endDrag(dt, config_.viscosity, bodyCut_.volumes());
}

//- Eq. 20
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::slowBetweenSolids(double dt)
{
    const std::vector<ContactArea<D>> areas = bodies_->contacts(grid_);
    if (areas.empty()) return;
    const ContactBoxes<D> boxes(grid_);
    std::vector<std::pair<int, int>> order;
    for (int k = 0; k < int(areas.size()); ++k) order.push_back({boxes.number(areas[k].point), k});
    std::sort(order.begin(), order.end());
    std::vector<int> box;
    std::vector<ContactArea<D>> sorted;
    for (const auto& [b, k] : order)
    {
        box.push_back(b);
        sorted.push_back(areas[k]);
    }
    contactBoxes_.upload(context_, box);
    contactAreas_.upload(context_, sorted);
    SlowBetweenSolids<D, real> slow{grid_, particles(), boxes, int(box.size()),
        contactBoxes_.data(), contactAreas_.data(), bodies_->contactVelocity(),
        bodies_->contactTimes(dt), {}};
    for (int d = 0; d < D; ++d) slow.u[d] = (config_.reflection > 0 ? after_ : u_)[d].data();
    forEach(context_, n_, slow);
}

//- \return false when a guard of the solids has fired
template<class Backend, int D, class P>
bool PicSolver<Backend, D, P>::advanceSolids(double dt, double before)
{
    const double from = clock_.time;
    if (!bodies_->finite()) return false;
    // a clump feels a force from outside a step of its own later
    constexpr int leastOfClumps = 8;
    // K of paper 2, Eqs. 21 to 25
    const int steps = std::max(solidSide_->subcycles(dt), bodies_->clumps() ? leastOfClumps : 1);
    const double first = dt/steps;
    // leapfrog's velocities are behind by half the last step, and get the new force for it
    const double lag = bodies_->verlet() ? 0 : 2*(solidSide_->kickTime(dt, steps) - dt) + first;
    bodies_->push(before, lag, solidSide_->kickTime(first, 1));
    if (!solidSide_->advanceTo(steps == 1 ? from + dt : from + first, first, 1)) return false;
    bodies_->hold();
    if (steps > 1 && !solidSide_->advanceTo(from + dt, dt - first, steps - 1)) return false;
    subcycles_ = steps;
    return true;
}

} // namespace riprap

/*  PicSolver: solids inside the domain, which cut the cells. Nothing of this is called in a scene
    that has none.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/pic/picObstacles.hpp"
#include "solvers/pic/picSolver.hpp"

namespace riprap
{

template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::allocateCut()
{
    const int cells = grid_.cells();
    const NodeGrid<D> nodes{grid_};
    nodeDistance_.allocate(context_, nodes.count());
    for (auto* a : {&open_, &openWeight_}) a->allocate(context_, cells);
    cellLayer_.allocate(context_, cells);
    for (int d = 0; d < D; ++d)
    {
        sealed_[d].allocate(context_, grid_.faces(d));
        if (sticksInside()) faceDistance_[d].allocate(context_, grid_.faces(d));
    }
}

//- For the step dt that begins at t; nothing is to be done where nothing moves
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::cutGrid(double t, double dt)
{
    const bool anew = base_.nodeDistance.empty() || base_.moves, moved = bodies_ && bodies_->read();
    if (!anew && !moved && !bodiesLoaded_)
    {
        if (bodies_) bodyCut_.forgetWater(context_, cutFields());
        return;
    }
    bodiesRest_ = bodiesLoaded_ = false;
    // where blocks, before and after, are more than all there is
    const bool all = anew || 2*bodyCut_.blockNodes() > grid_.cells();
    if (anew)
    {
        base_ = cutWalls(config_, sides_, inside_.obstacles, inside_.motion, t, dt);
        for (int d = 0; d < D; ++d)
            sealed_[d].upload(context_,
                std::vector<unsigned char>(base_.sealed[d].begin(), base_.sealed[d].end()));
        setWalls(base_.walls);
        nodeDistance_.upload(context_, base_.nodeDistance);
        if (bodies_) keepBase();
    }
    else if (bodies_)
    {
        bodyCut_.restore(context_, cutFields());
        if (!all) measureOpenings(false);       // where the new cut may not come
    }
    if (bodies_) cutByBodies();
    measureOpenings(all);
    for (int d = 0; d < D && sticksInside(); ++d)
        forEach(context_, grid_.faces(d),
            FaceDistances<D, real>{{grid_}, d, nodeDistance_.data(), faceDistance_[d].data()});
    insideMoves_ = base_.moves || bodies_;
}

//- Open parts of cells: of all, or of those about the bodies. What an opening's neighbours see of
//  it across a periodic side lies in no block
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::measureOpenings(bool all)
{
    const OpenVolumes<D, real> volumes{{grid_}, nodeDistance_.data(), open_.data()};
    const OpenWeights<D, real> weights{grid_, open_.data(), openWeight_.data()};
    for (int d = 0; d < D; ++d) all = all || grid_.periodic[d];
    if (all)
    {
        forEach(context_, grid_.cells(), volumes);
        forEach(context_, grid_.cells(), weights);
        return;
    }
    bodyCut_.eachCell(context_, volumes);
    bodyCut_.eachCell(context_, weights);
}

//- The grid without bodies, to put back what they change
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::keepBase()
{
    baseDistance_.upload(context_, base_.nodeDistance);
    for (int d = 0; d < D; ++d)
    {
        baseAperture_[d].upload(context_,
            std::vector<real>(base_.walls.aperture[d].begin(), base_.walls.aperture[d].end()));
        const std::vector<double>& w = base_.walls.wallVelocity[d];
        if (!w.empty()) baseVelocity_[d].upload(context_, std::vector<real>(w.begin(), w.end()));
    }
}

//- Solids to where they are at the end of the step; particles that they have run over come out.
//  \return false when a guard has fired
template<class Backend, int D, class P>
bool PicSolver<Backend, D, P>::moveInside(double dt, double before)
{
    if (!cuts()) return true;
    if (bodies_ && !advanceSolids(dt, before)) return false;
    if (insideMoves_)
    {
        cutGrid(clock_.time + dt, dt);
        cutForStep_ = true;
    }
    PushOut<D, real> out{solidField(), particles(), wallMargin*grid_.h, {}};
    for (int d = 0; d < D; ++d)
        out.shift[d] = config_.positionCorrection > 0 ? shift_[d].data() : nullptr;
    forEach(context_, n_, out);
    return true;
}

template<class Backend, int D, class P>
SolidField<D, typename P::real> PicSolver<Backend, D, P>::solidField()
{
    SolidField<D, real> f{};
    f.grid = grid_;
    f.distance = nodeDistance_.data();
    for (int d = 0; d < D; ++d)
    {
        f.aperture[d] = aperture_[d].data();
        f.wallVelocity[d] = wallsMove_ ? wallVelocity_[d].data() : nullptr;
        f.sealed[d] = sealed_[d].data();
    }
    return f;
}

//- phi on into the solids, about the water
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::extendSurface(Array<Backend, real>& phi)
{
    rows_.eachCellOfBoth(context_, MarkKnownCells<real>{open_.data(), cellLayer_.data()});
    for (int pass = 1; pass <= int(bandCells) + 1; ++pass)
        rows_.eachCellOfBoth(context_,
            ExtendSurface<D, real>{grid_, static_cast<unsigned char>(pass), cellLayer_.data(),
                phi.data(), real(bandCells*grid_.h)});
}

//- Of the host's copies: cells that no solid is near, to `clear`; the open parts of all
template<class Backend, int D, class P>
std::vector<char> PicSolver<Backend, D, P>::clearCells(double clear)
{
    const std::vector<double> distance = nodeDistance_.download();
    const NodeGrid<D> nodes{grid_};
    std::vector<char> known(grid_.cells());
    for (int i = 0; i < grid_.cells(); ++i)
    {
        const int first = nodes.node(grid_.cellIndex(i));
        bool far = true;
        for (int corner = 0; corner < (1 << D); ++corner)
        {
            int node = first;
            for (int d = 0; d < D; ++d) node += (corner >> d & 1)*nodes.stride(d);
            far = far && distance[node] >= clear;
        }
        known[i] = far;
    }
    return known;
}

} // namespace riprap

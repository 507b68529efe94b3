/*  DemSolver: construction from a configuration and its input.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <limits>
#include "dem/walls/repeatSurface.hpp"
#include "solvers/dem/driver/demSolver.hpp"
#include "solvers/dem/demStill.hpp"

namespace riprap
{

template<class Backend, int D, class P>
DemSolver<Backend, D, P>::DemSolver(const DemConfig& config, const DemInput& input, const DemPlan& plan)
:
    set_(config, input, plan), particles_(set_, int(input.particles.size())), given_(&input)
{
    still_ = isStill(input);
    reported_ = particles_.n;
    pairs_.set(input.particles);
    setBox();
    if (config.ranks && config.ranks->size() > 1) setRanks();
    particles_.add(sleeps() || others_);
    particles_.fill(input.particles);
    setOrder();
    motion_.holdGroups(groups_.motions());
    bonds_.set(input.bonds, input.particles);
    clumps_.set(input.particles);
    setWalls();
    given_ = nullptr;
    setFrames();
    prime();
    if (others_)
    {
        // from now on there is memory for what is here
        setCapacity(others_->residents() + others_->residents()/4 + 256);
        rebuild();
    }
}

//- What the search adds to contact unless fast particles need more [m]
template<class Backend, int D, class P>
double DemSolver<Backend, D, P>::leastSkin() const
{ return (set_.config.skin >= 0 ? set_.config.skin : (Backend::gpu ? 0.1 : 0.15))*2*radii_.smallest; }

//- How far the search looks
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::setReach(double skin)
{
    skin_ = skin;
    halfSkin_ = real(0.5*skin);
    reach_ = skin + pairs_.largestGap();
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::setBox()
{
    const DemConfig& c = set_.config;
    radii_ = RadiusClasses::of(given_->particles.radius);
    setReach(leastSkin());
    const double margin = 2*radii_.largest + reach_;
    for (int d = 0; d < D; ++d)
    {
        const int axis = c.axes[d];
        const double lo = c.domainMin[axis], hi = c.domainMax[axis];
        if (c.periodic[axis] && hi - lo < 3.001*margin)
            throw std::invalid_argument("the periodic domain is " + std::to_string(hi - lo)
              + " m long; it must be at least three times the reach of the largest particles, " + std::to_string(3.001*margin) + " m");
        // a margin, so that fixed-point differences across it are never mistaken for near ones
        if (c.periodic[axis]) set_.box.set(d, lo, hi - lo, true);
        else set_.box.set(d, lo - margin, hi - lo + 2*margin, false);
    }
    setDomain();
}

//- Where particles leave, in the box's units, and the cells
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::setDomain()
{
    for (int d = 0; d < D; ++d)
    {
        const int axis = set_.config.axes[d];
        const bool periodic = set_.config.periodic[axis];
        const double below = set_.config.walled[axis][0]*radii_.smallest, above = set_.config.walled[axis][1]*radii_.smallest;
        domainMin_[d] = periodic ? std::numeric_limits<std::int64_t>::min() : set_.box.toFixed(d, set_.config.domainMin[axis] - below);
        domainMax_[d] = periodic ? std::numeric_limits<std::int64_t>::max() : set_.box.toFixed(d, set_.config.domainMax[axis] + above);
    }
    classes_.set(set_.box, radii_, reach_, Backend::gpu);
    if (others_) setPieces();
}

//- Memory of what follows from positions
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::setOrder()
{
    records_.allocate(set_.context, particles_.n);
    reference_.allocate(set_.context, std::size_t(particles_.n)*D);
    sort_.allocate(set_.context, particles_.n, classes_.cells());
    inverse_.allocate(set_.context, particles_.n);
    slotOf_.allocate(set_.context, particles_.n);
    if (sleeps())
    {
        wakes_.allocate(set_.context, particles_.n);
        waits_.allocate(set_.context, particles_.n);
    }
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::setWalls()
{
    nWalls_ = int(set_.input.walls.size());
    if (!nWalls_) return;
    const double cell = wallCell();
    SurfaceBuilder<D> builder;
    std::vector<WallData> walls;
    int motions = 0;
    for (const DemWall& in : set_.input.walls)
    {
        WallData w{};
        w.material = in.material;
        w.plane = in.plane;
        surfaces_ = surfaces_ || !in.plane;
        w.motion = in.motion;
        motions = std::max(motions, in.motion + 1);
        for (int d = 0; d < 3; ++d) w.frame.R[4*d] = 1;
        double length = 0;
        for (int d = 0; d < D; ++d) length += in.normal[set_.config.axes[d]]*in.normal[set_.config.axes[d]];
        for (int d = 0; d < D; ++d)
        {
            const int axis = set_.config.axes[d];
            w.point[d] = in.point[axis];
            w.normal[d] = in.normal[axis]/std::sqrt(std::max(length, 1e-300));
            w.low[d] = set_.config.domainMin[axis];
            w.high[d] = set_.config.domainMax[axis];
        }
        if (!in.plane)
        {
            std::vector<double> vertices;
            for (std::size_t v = 0; v < in.vertices.size(); v += 3)
                for (int d = 0; d < D; ++d) vertices.push_back(in.vertices[v + set_.config.axes[d]]);
            std::vector<int> elements(in.elements.begin(), in.elements.end());
            for (int d = 0; d < D; ++d)
            {
                const int axis = set_.config.axes[d];
                if (!set_.config.periodic[axis] || in.motion >= 0) continue;
                repeatSurface<D>(vertices, elements, d, set_.config.domainMin[axis], set_.config.domainMax[axis], cell);
            }
            builder.add(vertices, elements, cell, w);
        }
        walls.push_back(w);
    }
    walls_.upload(set_.context, walls);
    vertices_.upload(set_.context, builder.vertex);
    elements_.upload(set_.context, builder.element);
    sharedFirst_.upload(set_.context, builder.sharedFirst);
    shared_.upload(set_.context, builder.shared);
    cellFirst_.upload(set_.context, builder.cellFirst);
    cellElement_.upload(set_.context, builder.cellElement);
    motion_.holdWalls(motions);
    clearPassed();
}

//- Where steps are fused a particle's way is measured against what is around it. Who sleeps does not look where others go
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::setFrames()
{
    if constexpr (Backend::gpu)
        if (fuses() && !sleeps()) parts_.frames.set(set_.context, set_.box, 3*(2*radii_.largest + reach_), 2e6);
}

//- First neighbours and forces, with a step of no length
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::prime()
{
    const int all = particles_.n;
    set_.context.toDevice(const_cast<int*>(sort_.active()), &all, sizeof(int));
    clock_.now.time = set_.config.startTime;
    clock_.now.fullDt = set_.plan.timeStep;
    motion_.sample(clock_.now);
    clock_.now.active = 1;
    clock_.write();
    // moving walls take their places; no step has any length yet
    if (motion_.walls()) forEach(set_.context, nWalls_, MoveWalls{walls_.data(), motion_.wallTable(), clock_.data(), clock_.data(), 1e300, 1e300});
    rebuild(true);
    forces();
    collectForces();
    clock_.read();
    clock_.now.active = 0;
    clock_.write();
    // on the GPU once more: what a rebuild needs besides is loaded and has its memory before the first step
    if (Backend::gpu || clock_.now.needRebuild) rebuild();
    set_.context.synchronise();
}

} // namespace riprap

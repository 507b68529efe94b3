/*  DemSolver: construction from a configuration and its input.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <limits>
#include "solvers/dem/driver/demSolver.hpp"

namespace riprap
{

template<class Backend, int D, class P>
DemSolver<Backend, D, P>::DemSolver(const DemConfig& config, const DemInput& input, const DemPlan& plan)
:
    p_(config, input, plan)
{
    p_.pairs.set(input.particles);
    p_.reach.setBox(input.particles.radius);
    if (config.ranks && config.ranks->size() > 1) ranks_.begin();
    p_.particles.add(p_.sleeps() || ranks_.others);
    p_.particles.fill(input.particles);
    p_.order.allocate(p_.particles.n, p_.reach.classes.cells());
    sleepers_.allocate();
    p_.motion.holdGroups(p_.groups.motions());
    p_.bonds.set(input.bonds, input.particles);
    p_.clumps.set(input.particles);
    p_.motion.holdWalls(p_.walls.set(p_.reach.wallCell(), p_.particles.n));
    neighbours_.setFrames();
    prime();
    if (ranks_.others)
    {
        // from now on there is memory for what is here
        ranks_.setCapacity();
        neighbours_.rebuild();
    }
}

//- First neighbours and forces, with a step of no length
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::prime()
{
    const int all = p_.particles.n;
    p_.set.context.toDevice(const_cast<int*>(p_.order.sort.active()), &all, sizeof(int));
    p_.clock.now.time = p_.set.config.startTime;
    p_.clock.now.fullDt = p_.set.plan.timeStep;
    p_.motion.sample(p_.clock.now);
    p_.clock.now.active = 1;
    p_.clock.write();
    // moving walls take their places; no step has any length yet
    if (p_.motion.walls()) forEach(p_.set.context, p_.walls.count, MoveWalls{p_.walls.walls.data(), p_.motion.wallTable(), p_.clock.data(), p_.clock.data(), 1e300, 1e300});
    neighbours_.rebuild(true);
    forces_.evaluate();
    forces_.collectForces();
    p_.clock.read();
    p_.clock.now.active = 0;
    p_.clock.write();
    // on the GPU once more: what a rebuild needs besides is loaded and has its memory before the first step
    if (Backend::gpu || p_.clock.now.needRebuild) neighbours_.rebuild();
    p_.set.context.synchronise();
}

} // namespace riprap

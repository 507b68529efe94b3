/*  DemSolver: how far beyond contact neighbours are sought, by the speeds and the step.

    Lists hold until a particle has gone half the skin. What a scene has by default lasts for many steps where bodies are stiff. Soft bodies have long
    steps: where lists last for a few steps alone the skin becomes what the fastest needs for `stepsOfList`, and less again once speeds have fallen. A
    function of the exact state: the same run has the same skins, saved and continued or not. Lists that hold for no step at all cost time and
    nothing else: the step then seeks neighbours before its forces (demStep.hpp).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/dem/driver/demSolver.hpp"

namespace riprap
{

//- New cells for it; lists are those of before until the next rebuild
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::setSkin(double skin)
{
    p_.reach.set(skin);
#ifdef __CUDACC__
    p_.memory.graphs.clear();                  // they hold on to the cells' and walls' numbers
#endif
    p_.reach.setDomain();
    if (ranks_.others) ranks_.setPieces();
    setFrames();
    p_.order.setCells(p_.particles.n, p_.reach.classes.cells(), p_.order.active());
}

//- Before a rebuild
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::adaptSkin()
{
    constexpr std::int64_t few = 8, many = 64;
    constexpr double stepsOfList = 16;
    if (p_.set.config.skin >= 0 || p_.reach.driven) return;
    DemClockData now = p_.clock.now;
    if constexpr (!Backend::gpu) now = *p_.clock.data();
    const std::int64_t lasted = now.step - p_.reach.searchedAt;
    p_.reach.searchedAt = now.step;
    if (lasted >= few && !(p_.reach.skin > p_.reach.leastSkin() && lasted > many)) return;
    const double speed = std::max(largestSpeed(), (p_.motion.walls() ? p_.walls.largestSpeed() : 0));
    const double wanted = std::min(std::max(2*1.25*stepsOfList*speed*now.fullDt, p_.reach.leastSkin()), p_.reach.mostSkin(p_.walls.surfaces));
    if (lasted < few ? wanted > 1.1*p_.reach.skin : wanted < 0.5*p_.reach.skin) setSkin(wanted);
}

} // namespace riprap

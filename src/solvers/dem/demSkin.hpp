/*  DemSolver: how far beyond contact neighbours are sought, by the speeds and the step.

    Lists hold until a particle has gone half the skin. What a scene has by default lasts for many steps where bodies are stiff. Soft bodies have long
    steps: where lists last for a few steps alone the skin becomes what the fastest needs for `stepsOfList`, and less again once speeds have fallen. A
    function of the exact state: the same run has the same skins, saved and continued or not. Lists that hold for no step at all cost time and
    nothing else: the step then seeks neighbours before its forces (demStep.hpp).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/dem/demSolver.hpp"

namespace riprap
{

//- New cells for it; lists are those of before until the next rebuild
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::setSkin(double skin)
{
    setReach(skin);
#ifdef __CUDACC__
    parts_.graphs.clear();                  // they hold on to the cells' and walls' numbers
#endif
    setDomain();
    setFrames();
    const int active = activeSolids();
    sort_.allocate(context_, n_, classes_.cells());
    context_.toDevice(const_cast<int*>(sort_.active()), &active, sizeof(int));
}

//- Half a diameter; where the domain is periodic what a third of it leaves, and no more than walls there have been repeated for
template<class Backend, int D, class P>
double DemSolver<Backend, D, P>::mostSkin() const
{
    double most = radii_.smallest;
    for (int d = 0; d < D; ++d)
    {
        if (!box_.periodic[d]) continue;
        if (surfaces_) return leastSkin();
        most = std::min(most, box_.length[d]/3.001 - 2*radii_.largest - largestGap_);
    }
    return std::max(most, leastSkin());
}

//- Cells of walls are made once
template<class Backend, int D, class P>
double DemSolver<Backend, D, P>::wallCell() const
{ return radii_.largest + leastSkin() + largestGap_; }

template<class Backend, int D, class P>
double DemSolver<Backend, D, P>::largestWallSpeed()
{
    double most2 = 0;
    if (wallMotions_)
        for (const WallData& w : walls_.download())
            for (int corner = 0; corner < 8 && w.motion >= 0; ++corner) most2 = std::max(most2, MoveWalls::cornerSpeed2(w, corner));
    return std::sqrt(most2);
}

//- Before a rebuild
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::adaptSkin()
{
    constexpr std::int64_t few = 8, many = 64;
    constexpr double stepsOfList = 16;
    if (config_.skin >= 0 || driven_) return;
    DemClockData now = host_;
    if constexpr (!Backend::gpu) now = *clock_.data();
    const std::int64_t lasted = now.step - searchedAt_;
    searchedAt_ = now.step;
    if (lasted >= few && !(skin_ > leastSkin() && lasted > many)) return;
    const double speed = std::max(largestSpeed(), largestWallSpeed());
    const double wanted = std::min(std::max(2*1.25*stepsOfList*speed*now.fullDt, leastSkin()), mostSkin());
    if (lasted < few ? wanted > 1.1*skin_ : wanted < 0.5*skin_) setSkin(wanted);
}

} // namespace riprap

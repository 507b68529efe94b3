/*  Whether anything in a scene of solids can move. In a fluid, solids that are all held need no
    steps of their own.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include "api/demScene.hpp"

namespace riprap
{

//- Nothing can move: all particles are held at rest, and so are the walls
inline bool isStill(const DemInput& in)
{
    if (!in.clumps.empty()) return false;
    for (const DemWall& w : in.walls) if (w.motion >= 0) return false;
    const auto moves = [](const std::vector<double>& v)
    { return std::any_of(v.begin(), v.end(), [](double u) { return u != 0; }); };
    if (moves(in.particles.velocity) || moves(in.particles.spin)) return false;
    const auto held = [](const DemGroup& g)
    { return g.motion < 0 && g.heldSpin && g.held[0] && g.held[1] && g.held[2]; };
    for (std::size_t i = 0; i < in.particles.size(); ++i)
    {
        const std::size_t group = in.particles.group.empty() ? 0 : in.particles.group[i];
        if (group >= in.groups.size() || !held(in.groups[group])) return false;
    }
    return true;
}

} // namespace riprap

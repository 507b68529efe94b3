/*  Steps of a scene small enough for one block of the GPU: many in one launch, barriers where
    launches would follow one another. The passes, and so the bits, are those of a launch each.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/singleBlock.hpp"
#include "dem/bond/bondPass.hpp"
#include "dem/passes/gatherPass.hpp"
#include "dem/motion/mover.hpp"
#include "dem/walls/wallPass.hpp"

namespace riprap
{

struct BlockLimits
{
    static constexpr int threads = 512;
    // with more, launches that fill the device are faster
    static constexpr int particles = 1024, bonds = 3072, nearWalls = 2048;
};

//- Velocity Verlet
template<class Backend, int D, class P, class Law>
struct BlockSteps
{
    static constexpr const char* name = "blockSteps";

    DemTick tick;
    MoveSolids<D, P> move;
    GatherPass<Backend, D, P, Law> contacts;
    WallPass<D, P, Law> walls;
    BondPass<D, P> bonds;
    GatherBonds<D, P> gather;
    FinishVerlet<D, P> finish;
    int n, nearWalls, bondCount;    // 0: no pass over walls, over bonds
    int steps;

    HD void operator()(const Team& team) const
    {
        for (int k = 0; k < steps; ++k)
        {
            if (team.index == 0) tick(0);
            team.wait();
            if (!tick.clock->active) return;
            team.each(n, move);
            team.each(n, contacts);
            if (nearWalls) team.each(nearWalls, walls);
            if (bondCount)
            {
                team.each(bondCount, bonds);
                team.each(n, gather);
            }
            team.each(n, finish);
        }
    }
};

} // namespace riprap

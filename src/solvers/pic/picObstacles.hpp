/*  Obstacles in the grid of a PIC scene: from surfaces and where they are, what is open of the
    faces, and how walls move.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/cutCells/wallParts.hpp"
#include "api/picScene.hpp"

namespace riprap
{

//- The walls of a scene with these obstacles at time t and during the step dt that follows; sides:
//  what the domain's own sides are (as in PicWalls; empty: closed, at rest)
struct PicCut
{
    PicWalls walls;
    // to the nearest solid [m], negative in it, at most two cells; nodes x fastest
    std::vector<double> nodeDistance;
    std::vector<char> sealed[3];            // faces that thin walls close
    bool moves = false;
};
PicCut cutWalls(const PicConfig&, const PicWalls& sides, const std::vector<PicObstacle>&,
    const WallMotion& motion, double t, double dt);

//- Which part closes what at time t
template<int D>
WallParts<D> partsOfWalls(const PicConfig&, const PicWalls& sides, const std::vector<PicObstacle>&,
    const WallMotion& motion, double t);

} // namespace riprap

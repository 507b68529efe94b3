/*  Obstacles in the grid of a PIC scene: from surfaces and where they are, what is open of the faces, and how walls move.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "scene/picScene.hpp"

namespace riprap
{

//- A surface inside the domain, oriented or not
struct PicObstacle
{
    std::string name;
    std::vector<double> vertices;           // 3 each [m], as at the identity pose
    std::vector<int> elements;              // 2D: two vertices each, in the plane; 3D: three
    bool closed = true;                     // else a sheet: it parts, but has no inside
    bool solidOutside = false;              // the water is inside, as in a basin
    int body = -1;                          // index of its motion, -1: it rests
};

//- The walls of a scene with these obstacles at time t and during the step dt that follows; sides: what the domain's own sides
//  are (as in PicWalls; empty: closed, at rest)
struct PicCut
{
    PicWalls walls;
    std::vector<double> nodeDistance;       // to the nearest solid [m], negative in it, at most two cells; nodes x fastest
    bool moves = false;
};
PicCut cutWalls(const PicConfig&, const PicWalls& sides, const std::vector<PicObstacle>&, const WallMotion& motion, double t, double dt);

} // namespace riprap

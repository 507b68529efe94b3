/*  How a scene is shared by several processes (docs/parallel.md).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

namespace riprap
{

class Transport;

//- Each process is given the whole scene, and keeps its part
struct RankConfig
{
    // lives longer than the scene. Null, or of one rank: there are no others
    Transport* ranks = nullptr;
    // the largest part may be so much above the mean before space is divided anew
    double imbalance = 0.1;
    // parts are even in the time that their particles cost; else in their numbers
    bool measured = false;
    // GPUs that reach each other send what a step needs without the host
    bool direct = true;
};

} // namespace riprap

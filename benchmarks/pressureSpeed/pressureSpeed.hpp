/*  What is timed: one pressure step of a scene, and what came of it.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <string>
#include <vector>
#include "core/backend/backend.hpp"

namespace riprap
{

struct SpeedCase
{
    std::string scene = "wavy";     // wavy | spray | tank | baffles
    int dimensions = 3;
    int n[3] = {64, 64, 64};
    int box = 1;                    // the box is this many times as high around the same water
    bool mixed = true;
    double tolerance = 1e-8;
    int repeats = 5;
    bool phases = false;            // time each kernel instead
};

struct SpeedRow
{
    int cells = 0, wet = 0, iterations = 0, pocketCells = 0;
    double residual = 0, best = 0, median = 0;      // [s] by the clock
    double processor = 0;                           // [s] of all threads, the least
    bool repeats = true;                            // the same bits each time
    std::string device;
    std::vector<std::pair<std::string, double>> phases;     // [s] a step
    std::vector<long long> launches;
};

SpeedRow timePressure(Cpu, const SpeedCase&);
SpeedRow timePressure(Gpu, const SpeedCase&);

} // namespace riprap

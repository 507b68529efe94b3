/*  A row of the table of sphSpeed: what was measured of one scene, as CSV and as a line on the
    screen.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <string>
#include <vector>
#include "speedOptions.hpp"

namespace riprap
{

struct MachineLimits
{
    double triad = 0;           // [B/s]
    double fma = 0;             // [1/s], in the precision of pairs
    double gather = 0;          // [neighbours/s]; 0: there are no gathers
};

struct SpeedRow
{
    std::string device;
    bool gpu = false;
    int threads = 1;
    std::size_t fluid = 0, walls = 0;
    double neighbours = 0;
    int steps = 0;
    double developed = 0;       // time before the first timed step [s]
    double timeStep = 0;        // [s]
    double seconds = 0;         // a step, median of repeats
    double spread = 0;          // (longest - shortest)/median
    double cpuSeconds = 0;      // of all threads, a step, median
    double interval = 0;        // steps between rebuilds
    double bytes = 0, bytesWithLists = 0;   // a fluid particle
    double memory = 0;          // of everything [B]
    std::vector<KernelInfo> kernels;        // seconds and launches a step
    MachineLimits limits;

    //- The named columns, in order
    std::vector<std::pair<std::string, std::string>> columns(const SpeedOptions&) const;
};

void appendCsv(const SpeedOptions&, const SpeedRow&);
void printHeader();
void printRow(const SpeedOptions&, const SpeedRow&);

} // namespace riprap

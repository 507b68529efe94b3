/*  What sphSpeed is asked to run.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <string>
#include <vector>
#include "api/sphScene.hpp"

namespace riprap
{

//- minimal: laminar viscosity alone; paper: with anti-clump term and XSPH; delta: artificial
//  viscosity and density diffusion
enum class TermSet {minimal, paper, delta};

struct SpeedOptions
{
    std::string name;                       // of the case, in the table
    int dimensions = 2;
    std::vector<double> particles{20000};   // wanted numbers, a row each
    PrecisionKind precision = PrecisionKind::mixed;
    DeviceKind device = DeviceKind::automatic;
    double ratio = 1.25;                    // h/dp
    std::string integrator = "leapfrog";
    std::string walls = "extrapolated";
    TermSet terms = TermSet::minimal;
    double skin = -1;                       // of the support; < 0: the solver's choice
    bool atRest = false;                    // else the column starts in motion
    int develop = 300;                      // steps before anything is timed
    // a repeat; 0: as many as take `seconds`, at most 0.05 s of the flow
    int steps = 0;
    double seconds = 0.3;
    int repeat = 7;
    bool kernels = false;
    std::string csv, note, version;
    // columns of the table and what they should reach
    std::vector<std::pair<std::string, double>> goals;
};

//- The words of the command line
//  @throws std::invalid_argument that says what is valid
SpeedOptions readSpeedOptions(int argc, char** argv);

const char* wordOf(TermSet);
const char* wordOf(PrecisionKind);
const char* wordOf(DeviceKind);

} // namespace riprap

/*  demStability: where riprap's DEM fails, found by bisection, beside theory.

        demStability [-csv FILE] [limits|energy|laws]...

    All scenes are small and run on the CPU in double precision through createDemScene. See the
    header comment of each experiment.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "demResults.hpp"

int main(int argc, char** argv)
{
    using namespace riprap;
    return runExperiments<DemResults>(argc, argv, "demStability",
        {{"limits", contactLimits}, {"energy", energy}, {"laws", laws}});
}

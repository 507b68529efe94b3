/*  couplingStability: where water and solids in one scene fail, found by bisection, beside theory.

        couplingStability [-csv FILE] [density|step|bonds|leak]...

    The scene is stirredBlock.hpp; see experiments.hpp.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "experiments.hpp"
#include "../stability/experiments.hpp"

int main(int argc, char** argv)
{
    using namespace riprap;
    return runExperiments<CouplingRows>(argc, argv, "couplingStability",
        {{"density", density}, {"step", step}, {"bonds", bonds}, {"leak", leak}});
}

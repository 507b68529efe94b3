/*  picStability: where the particle-in-cell solver fails.

        picStability [-csv FILE] [step|blend|particles|tolerance|levels]...

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "experiments.hpp"
#include "../stability/experiments.hpp"

int main(int argc, char** argv)
{
    using namespace riprap;
    return runExperiments<PicRows>(argc, argv, "picStability",
        {{"step", step}, {"blend", blend}, {"particles", particles}, {"tolerance", tolerance},
            {"levels", levels}});
}

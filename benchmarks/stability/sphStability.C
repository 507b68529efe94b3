/*  sphStability: where riprap's SPH fails, found by bisection, beside theory.

        sphStability [-csv FILE] [-quick] [acoustic|viscous|force|tensile|passage|faces|wild]...

    All scenes are 2D, small, and run on the CPU through createSphScene. See the header comment of
    each experiment.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "resultTable.hpp"

int main(int argc, char** argv)
{
    using namespace riprap;
    bool quick = false;
    const auto with = [&quick](void (*experiment)(ResultTable&, bool))
    { return [=, &quick](ResultTable& t) { experiment(t, quick); }; };
    return runExperiments<ResultTable>(argc, argv, "sphStability",
        {{"acoustic", with(acoustic)}, {"viscous", with(viscous)}, {"force", with(impactForce)},
            {"tensile", with(tensile)}, {"passage", with(passage)}, {"faces", with(wallFaces)},
            {"wild", with(wildRule)}},
        {{"-quick", &quick}});
}

/*  A template: copy it to tests/unit beside the scheme's header. The closed form that the formula
    is to meet; all that is common to schemes is tested by transferCards.C, picSchemes.hpp,
    picRows.C and picSchemeScenes.C.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <gtest/gtest.h>
#include "pic/transfer/schemes/filteredFlip.hpp"

namespace riprap
{
namespace
{

//- A grid at rest: a velocity v0 that a particle has at first, and du more each step, make a (v0 +
//  N du) in N steps, a = dt/tau
TEST(FilteredFlip, KeepsWhatLasts)
{
    TransferProperties p;
    FilteredFlip::filterTime.set(p, 0.1);
    const double dt = 0.02, a = 0.2, v0 = 3, du = 0.5;
    const auto formula = FilteredFlip::make<double>(p, dt);
    double v = v0, s = 0;
    for (int n = 1; n <= 10; ++n)
    {
        v = formula.velocity(v, du, 0.0, &s);
        EXPECT_NEAR(v, a*(v0 + n*du), 1e-14);
    }
}

//- The longest step is FLIP
TEST(FilteredFlip, IsFlipAtTheLongestStep)
{
    TransferProperties p;
    FilteredFlip::filterTime.set(p, 0.1);
    double s = 0.7;
    EXPECT_NEAR(
        FilteredFlip::make<double>(p, FilteredFlip::timeStep(p)).velocity(3.0, 0.5, 2.0, &s), 3.5,
        1e-15);
}

} // namespace
} // namespace riprap

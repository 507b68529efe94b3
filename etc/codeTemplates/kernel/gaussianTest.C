/*  A template: copy it to tests/unit beside the kernel's header. Values that are published or
    follow from the formula; all that is common to kernels is tested by kernels.hpp, pack.C,
    terms.hpp and sphCards.C.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <gtest/gtest.h>
#include "sph/kernels/gaussian.hpp"

namespace riprap
{
namespace
{

TEST(Gaussian, Values)
{
    EXPECT_NEAR(Gaussian::value(0.0), 1 - std::exp(-9.0), 1e-15);
    EXPECT_NEAR(Gaussian::value(1.0), std::exp(-1.0) - std::exp(-9.0), 1e-15);
    EXPECT_NEAR(Gaussian::slope(2.0), -2*std::exp(-4.0), 1e-16);
    // without the truncation alpha is pi^(-D/2)
    const double pi = std::acos(-1.0);
    EXPECT_NEAR(pi*Gaussian::alpha(2), 1, 2e-3);
    EXPECT_NEAR(std::pow(pi, 1.5)*Gaussian::alpha(3), 1, 4e-3);
}

//- The second moment, sum of V r^2 W, decides what SPH sums smooth away: D h^2/2 of the whole
//  Gaussian, 0.5 % less of this one in 2D
TEST(Gaussian, SecondMoment)
{
    const double pi = std::acos(-1.0), dq = 1e-4;
    double sum = 0;
    for (double q = 0.5*dq; q < 3; q += dq) sum += 2*pi*q*q*q*Gaussian::value(q)*dq;
    const double cut = std::exp(-9.0), expected = (1 - 10*cut - 40.5*cut)/(1 - 10*cut);
    EXPECT_NEAR(Gaussian::alpha(2)*sum, expected, 1e-6);
}

} // namespace
} // namespace riprap

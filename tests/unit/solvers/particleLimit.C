/*  More particles than a scene can count are refused, and the limit is said.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <gtest/gtest.h>
#include "api/particleLimit.hpp"

namespace riprap
{
namespace
{

std::string refusal(double n, double most)
{
    try { requireCountable(n, most, "particles"); }
    catch (const std::invalid_argument& e) { return e.what(); }
    return "";
}

TEST(ParticleLimit, IsNamed)
{
    EXPECT_EQ(refusal(5e8, mostFluidParticles), "");
    EXPECT_EQ(refusal(500000001, mostFluidParticles), "there are 500000001 particles, and a scene, which counts them in 32 bits, can have 500000000");
    EXPECT_EQ(refusal(3e9, mostSolidParticles), "there are 3000000000 particles, and a scene, which counts them in 32 bits, can have 250000000");
}

//- Three coordinates of each, eight entries of lists of a solid
TEST(ParticleLimit, IsWithin32Bits)
{
    EXPECT_LT(3*mostFluidParticles, 2147483648.0);
    EXPECT_LT(8*mostSolidParticles, 2147483648.0);
}

} // namespace
} // namespace riprap

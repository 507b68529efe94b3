/*  More particles than a scene can count are refused, and the limit is said.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <cstdint>
#include <gtest/gtest.h>
#include "api/particleLimit.hpp"
#include "api/picScene.hpp"

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
    EXPECT_EQ(refusal(500000001, mostFluidParticles),
        "there are 500000001 particles, and a scene, which counts them in 32 bits, can have "
        "500000000");
    EXPECT_EQ(refusal(3e9, mostSolidParticles),
        "there are 3000000000 particles, and a scene, which counts them in 32 bits, can have "
        "250000000");
}

//- Three coordinates of each, eight entries of lists of a solid
TEST(ParticleLimit, IsWithin32Bits)
{
    EXPECT_LT(3*mostFluidParticles, 2147483648.0);
    EXPECT_LT(8*mostSolidParticles, 2147483648.0);
    EXPECT_LT(3*mostCells, 2147483648.0);
}

TEST(ParticleLimit, SumsOfListsThatWrapAreRefused)
{
    EXPECT_EQ(requireListed(2147483647, "solid particles"), 2147483647u);
    EXPECT_THROW(requireListed(int(std::uint32_t(3e9)), "solid particles"), std::runtime_error);
}

//- Before anything is made of the grid
TEST(ParticleLimit, CellsAreCountedFirst)
{
    PicConfig c;
    c.device = DeviceKind::cpu;
    c.dimensions = 3;
    c.cellSize = 1e-3;
    c.spacing = 5e-4;
    for (int& n : c.cells) n = 1000;
    FluidInput one;
    one.position = {0.5, 0.5, 0.5};
    one.velocity = {0, 0, 0};
    try
    {
        createPicScene(c, one, {});
        FAIL() << "a thousand million cells";
    }
    catch (const std::invalid_argument& e)
    {
        EXPECT_STREQ(e.what(),
            "there are 1000000000 cells, and a scene, which counts them in 32 bits, can have "
            "500000000");
    }
}

} // namespace
} // namespace riprap

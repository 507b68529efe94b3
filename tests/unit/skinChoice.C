/*  When fluid on the GPU is listed with a wide skin: where lists last for few steps, several times in a row, and until they last for many.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "scene/sphSkin.hpp"

#include <gtest/gtest.h>

namespace riprap
{

TEST(SkinChoice, FollowsHowLongListsLast)
{
    SkinChoice skin;
    const auto often = [&](int times, int steps, bool aged)
    {
        int changes = 0;
        for (int k = 0; k < times; ++k) changes += skin.heed(steps, aged);
        return changes;
    };
    EXPECT_EQ(often(100, 34, true), 0);         // 17 steps a list
    EXPECT_EQ(often(100, 8, true), 0);
    EXPECT_EQ(often(2, 5, true), 0);            // a splash that has passed
    EXPECT_EQ(often(1, 20, true), 0);
    EXPECT_EQ(often(2, 5, true), 0);
    EXPECT_EQ(often(100, 4, false), 0);         // cycles that were short, not lists
    EXPECT_EQ(often(1, 8, true), 0);
    EXPECT_FALSE(skin.wide);
    // cycles that are fitted to lists of two or three steps are cut now and then
    EXPECT_EQ(often(1, 5, true) + often(2, 4, false) + often(1, 5, true) + often(2, 4, false), 0);
    EXPECT_EQ(often(1, 5, true), 1);
    EXPECT_TRUE(skin.wide);
    // three times as long as before, and more, is no reason to go back
    EXPECT_EQ(often(100, 3*7, true), 0);
    EXPECT_EQ(often(100, 39, true), 0);
    EXPECT_EQ(often(3, 44, false), 1);
    EXPECT_FALSE(skin.wide);
}

//- A saved state goes on as if it had not been one
TEST(SkinChoice, IsPartOfTheState)
{
    SkinChoice a;
    for (int k = 0; k < 40; ++k)
    {
        const SkinChoice b = SkinChoice::of(a.word());
        EXPECT_EQ(a.wide, b.wide);
        EXPECT_EQ(a.votes, b.votes);
        EXPECT_LT(a.word(), 16);
        a.heed(k < 20 ? 3 : 50, k < 20);
    }
}

} // namespace riprap

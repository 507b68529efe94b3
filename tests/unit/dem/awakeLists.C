/*  Who takes part in steps where others sleep, against a look at everyone.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <random>
#include <gtest/gtest.h>
#include "dem/passes/scatterPass.hpp"

using namespace riprap;

namespace
{

//- Half lists: of a particle those of higher number that are near
struct HalfLists
{
    std::vector<int> base, count;
    std::vector<std::uint32_t> entry;

    static int other(std::uint32_t e) { return int(e & 0x7fffffffu); }
    int index(int i, int k) const { return base[i] + k; }

    HalfLists(int n, std::mt19937& random)
    {
        for (int i = 0; i < n; ++i)
        {
            base.push_back(int(entry.size()));
            for (int j = i + 1; j < std::min(n, i + 40); ++j)
                if (random() % 8 == 0) entry.push_back(std::uint32_t(j) | (random() % 2 << 31));
            count.push_back(int(entry.size()) - base.back());
        }
        base.push_back(int(entry.size()));
    }
};

} // namespace

TEST(AwakeLists, areThoseOfEveryone)
{
    std::mt19937 random(5);
    for (int trial = 0; trial < 60; ++trial)
    {
        const int n = 1 + int(random() % 300);
        const HalfLists list(n, random);
        std::vector<char> asleep(n);
        std::vector<int> wallFirst(n + 1, 0);
        // from nobody to everyone
        for (char& a : asleep) a = int(random() % 60) < trial;
        for (int i = 0; i < n; ++i) wallFirst[i + 1] = wallFirst[i] + int(random() % 3 == 0);

        DeferredForces<3, float> deferred;
        std::vector<int> cuts{0, n/3, n/3, n};
        if (trial % 2) cuts.clear();
        deferred.set(n, list, cuts);
        deferred.setRanges(list, true, [&](int i) { return asleep[i] != 0; });
        deferred.awake.setWalls(n, wallFirst.data());

        std::vector<int> all, looking, near, walls;
        std::vector<char> isNear(n, 0);
        for (int i = 0; i < n; ++i)
        {
            bool looks = !asleep[i];
            for (int k = 0; k < list.count[i]; ++k)
                looks |= !asleep[HalfLists::other(list.entry[list.index(i, k)])];
            if (!asleep[i]) all.push_back(i);
            if (!asleep[i] && wallFirst[i + 1] > wallFirst[i]) walls.push_back(i);
            if (!looks) continue;
            looking.push_back(i);
            isNear[i] = 1;
            for (int k = 0; k < list.count[i]; ++k)
                isNear[HalfLists::other(list.entry[list.index(i, k)])] = 1;
        }
        for (int i = 0; i < n; ++i) if (isNear[i]) near.push_back(i);

        const AwakeLists& lists = deferred.awake;
        ASSERT_TRUE(lists.some);
        std::vector<int> awake;
        for (const AwakeLists::Run& run : lists.runs)
        {
            ASSERT_LE(run.end - run.begin, AwakeLists::longest);
            for (int i = run.begin; i < run.end; ++i) awake.push_back(i);
        }
        ASSERT_EQ(awake, all);
        ASSERT_EQ(lists.looking, looking);
        ASSERT_EQ(lists.near, near);
        ASSERT_EQ(lists.walls, walls);
        ASSERT_EQ(lists.wallCount, int(walls.size()));
        ASSERT_EQ(int(lists.first.size()), deferred.blocks + 1);
        for (int b = 0; b < deferred.blocks; ++b)
            for (int k = lists.first[b]; k < lists.first[b + 1]; ++k)
                ASSERT_TRUE(lists.runs[k].begin >= deferred.begin(b)
                    && lists.runs[k].end <= deferred.begin(b + 1));
        ASSERT_EQ(lists.first.back(), int(lists.runs.size()));
    }
}

//- Where nobody may sleep passes go over all
TEST(AwakeLists, areEmptyWhereNobodySleeps)
{
    std::mt19937 random(6);
    const HalfLists list(50, random);
    DeferredForces<2, double> deferred;
    deferred.set(50, list);
    deferred.setRanges(list, true, [](int i) { return i % 2 == 0; });
    EXPECT_EQ(deferred.awake.runs.size(), 25u);
    deferred.setRanges(list, false, [](int) { return true; });
    deferred.awake.setWalls(50, nullptr);
    EXPECT_FALSE(deferred.awake.some);
    EXPECT_TRUE(deferred.awake.runs.empty() && deferred.awake.walls.empty());
    EXPECT_EQ(deferred.awake.wallCount, 0);
    std::vector<int> wallFirst(51, 2);
    for (int i = 0; i < 8; ++i) wallFirst[i] = i < 4 ? 0 : 1;
    deferred.awake.setWalls(50, wallFirst.data());
    EXPECT_EQ(deferred.awake.walls, (std::vector<int>{3, 7}));
    EXPECT_EQ(deferred.awake.wallCount, 2);
}

/*  Water in cells on several ranks, threads here, with openings: what comes in and goes out,
    wherever their faces lie, and what is counted of it.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <set>
#include "picRankScene.hpp"
#include "rankObstacles.hpp"

namespace riprap
{
namespace
{

class PicRankOpenings : public PicRankScene
{
protected:

    static PicOpening velocity(const Vector3& v)
    {
        PicOpening o;
        o.name = "river";
        o.kind = "velocity";
        o.velocity = [v](double) { return v; };
        return o;
    }
    static PicOpening flow(double rate)
    {
        PicOpening o;
        o.name = "pump";
        o.kind = "flowRate";
        o.flowRate = [rate](double t) { return rate*(1 + t); };
        return o;
    }
    static PicOpening level(double height)
    {
        PicOpening o;
        o.name = "sea";
        o.kind = "level";
        o.level = [height](double) { return height; };
        return o;
    }

    //- A stream from a side that water flows in by to one that a level stands beyond, and a fall
    //  from a part of the lid. Both sides and the lid's part belong to several ranks
    RankScene stream() const
    {
        PicConfig c = basin();
        const double top = c.domainMax[1] - c.domainMin[1];
        c.openings = {velocity({{2, 0, 0}}), flow(D() == 2 ? 0.8 : 0.3),
            level(c.domainMin[1] + 0.55*top)};
        RankScene s{c, water(c, {{0, 0, 0}}, {{1, 0.6, 1}}), sides(c), {}};
        move(s.water, {{2, 0, D() == 3 ? 0.3 : 0.0}});
        eachFace(c, [&](int d, const std::array<int, 3>& at)
        {
            int number = -1;
            if (d == 0 && at[0] == 0 && at[1] > 2) number = 0;
            if (d == 0 && at[0] == c.cells[0]) number = 2;
            // from one brick to the next
            if (d == 1 && at[1] == c.cells[1] && at[0] > c.cells[0]/3 - 4
                && at[0] < c.cells[0]/3 + 5)
                number = 1;
            s.walls.opening[d].push_back(number);
        });
        return s;
    }
    int some() const { return D() == 2 ? 10 : 3; }
};

//- Ids of those that come in are one process's, each passage is counted once
TEST_P(PicRankOpenings, stream)
{
    const RankScene s = stream();
    const RankOutcome one = onOne(s, stepsOf(some()));
    ASSERT_EQ(one.numbers.size(), 17u + 12u);
    EXPECT_GT(one.numbers[17], 20) << "came in by the side";
    EXPECT_GT(one.numbers[17 + 4], D() == 2 ? 4 : 20) << "fell in";
    EXPECT_GT(one.numbers[17 + 9], 20) << "left";
    EXPECT_TRUE(one.escaped.empty());
    expectSame(one, onSeveral(ranks(5)[0], s, stepsOf(some())));
}

TEST_P(PicRankOpenings, dividedPressure)
{
    compareDivided(stream(), stepsOf(D() == 2 ? 5 : 2), ranks(4));
}

//- Solids that cover a part of an opening and stand in the stream; the lid is open, and some of the
//  water leaves through it, which is no opening
TEST_P(PicRankOpenings, weir)
{
    RankScene s = stream();
    PicConfig& c = s.config;
    c.transfer = "apic";
    const double h = c.cellSize;
    const Vector3& o = c.domainMin;
    s.obstacles = {
        boxObstacle(D(), {{o[0] - h, o[1] + 3.3*h, o[2] - h}},
            {{o[0] + 2.4*h, o[1] + 7.7*h, o[2] + 20*h}}),
        boxObstacle(D(), {{o[0] + 14.3*h, o[1] - h, o[2] - h}},
            {{o[0] + 18.2*h, o[1] + 9.4*h, o[2] + 9.4*h}})};
    eachFace(c, [&](int d, const std::array<int, 3>& at)
    {
        const bool inner = at[d] > 0 && at[d] < c.cells[d],
                   lid = d == 1 && at[1] == c.cells[1] && at[0] > c.cells[0]/2;
        s.walls.aperture[d].push_back(inner || lid ? 1 : 0);
    });
    s.water.position[1] = c.domainMax[1] - 0.2*h;       // one that is soon through the lid
    s.water.position[0] = c.domainMax[0] - 5.2*h;
    s.water.velocity[1] = 6;
    c.seedsPerDirection = 0;
    const RankOutcome one = onOne(s, stepsOf(some()));
    EXPECT_FALSE(one.escaped.empty());
    expectSame(one, onSeveral(ranks(4)[0], s, stepsOf(some())));
}

//- 2 ranks go on with the state of 4, or 3: what is kept, owed and counted goes on
TEST_P(PicRankOpenings, savedStates)
{
    compareStates(stream(), {ranks(4)[0], 2}, 3, true);
}

//- What had passed before, and is no particles yet
TEST_P(PicRankOpenings, countsGoOn)
{
    RankScene s = stream();
    s.config.openings[0].before = PicPassage{7, 2, 0.03, 0.002};
    s.config.openings[2].before = PicPassage{1, 9, -0.02, -0.001};
    compare(s, stepsOf(2), {3});
}

INSTANTIATE_TEST_SUITE_P(, PicRankOpenings, testing::ValuesIn(setups({2, 3})), setupName);

} // namespace
} // namespace riprap

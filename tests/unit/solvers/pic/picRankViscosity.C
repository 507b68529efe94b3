/*  Water in cells on several ranks, threads here, with implicit viscosity: the same bits as on one,
    also where it sticks to surfaces inside the mesh.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "picRankScene.hpp"
#include "rankObstacles.hpp"

namespace riprap
{
namespace
{

class PicRankViscosity : public PicRankScene
{
protected:

    //- So that the explicit limit lies far below the step's length
    RankScene honey() const
    {
        const PicConfig c = basin();
        RankScene s{c, column(c), sides(c), {}};
        s.config.viscosity = 100;
        s.config.noSlip = true;
        s.config.viscousScheme = "implicit";
        s.config.slide[1][0] = {{2, 0, 0}};
        return s;
    }

    //- Forces are asked for on the way: then the shear on obstacles is kept
    Course asking() const
    {
        return [this](PicScene& scene, RankOutcome& o)
        {
            o.include(scene.advance(1e9, D() == 2 ? 2 : 1));
            scene.forcesOnWalls();
            o.include(scene.advance(1e9, 1));
        };
    }

    static bool sheared(const RankOutcome& o, int from)
    {
        bool found = false;
        for (std::size_t k = 0; k < o.forces.size(); k += 7)
            found = found || (o.forces[k] >= from && o.forces[k + 4] != 0);
        return found;
    }
};

TEST_P(PicRankViscosity, implicit)
{
    const RankScene s = honey();
    const RankOutcome one = onOne(s, asking());
    EXPECT_TRUE(sheared(one, 0));
    expectSame(one, onSeveral(ranks(5)[0], s, asking()));
    compareDivided(s, asking(), ranks(4));
}

//- Explicit where the step is short enough: the first step is, those that follow are not
TEST_P(PicRankViscosity, automatic)
{
    RankScene s = honey();
    s.config.viscousScheme = "automatic";
    s.config.viscosity = 200;               // 1 ms is explicit, the steps are of 8 ms
    const auto course = [](PicScene& scene, RankOutcome& o)
    {
        o.include(scene.advance(1e-4));
        o.include(scene.advance(1e9, 2));
    };
    compare(s, course, {3});
}

//- Water comes around
TEST_P(PicRankViscosity, periodicSides)
{
    RankScene s = honey();
    s.config.periodic[0] = true;
    s.config.slide[1][0] = {{0, 0, 0}};
    s.walls = PicWalls();
    compare(s, stepsOf(2), {3});
}

TEST_P(PicRankViscosity, sticksToObstacles)
{
    RankScene s = honey();
    s.obstacles = randomObstacles(s.config, 6);
    s.water = water(s.config, {{0, 0, 0}}, {{0.8, 0.75, 1}});
    move(s.water, {{1.5, 1, 0}});
    const RankOutcome one = onOne(s, asking());
    EXPECT_TRUE(sheared(one, 10));
    expectSame(one, onSeveral(ranks(4)[0], s, asking()));
    compareDivided(s, asking(), ranks(4));
}

//- 2 ranks go on with the state of 4, or 3
TEST_P(PicRankViscosity, savedStates)
{
    RankScene s = honey();
    s.obstacles = randomObstacles(s.config, 7);
    compareStates(s, {ranks(4)[0], 2}, 2);
}

INSTANTIATE_TEST_SUITE_P(, PicRankViscosity, testing::ValuesIn(setups({2, 3})), setupName);

} // namespace
} // namespace riprap

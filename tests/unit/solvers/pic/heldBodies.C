/*  Bodies that are held in water at rest bear its weight that they displace (Archimedes), at
    whatever height of the grid.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "picShapeScene.hpp"
#include "pic/shapes/shapes.hpp"

namespace riprap
{
namespace
{

class HeldBodies : public PicShapeScene
{
protected:

    static constexpr double h = 0.02, level = 0.3, weight = 1000*9.81;

    //- 2D: a tank of the same section
    PicConfig tank() const
    {
        PicConfig c = config(1);
        c.domainMax = {{0.6, 0.4, D() == 3 ? 0.4 : 1}};
        for (int d = 0; d < D(); ++d) c.cells[d] = int(std::lround(c.domainMax[d]/h));
        c.cellSize = h;
        c.spacing = 0.5*h;
        c.seedsPerDirection = 1;
        c.adjustTimeStep = false;
        c.fixedTimeStep = 1e-3;
        return c;
    }

    template<class Distance> PicShape shapeIn(const Vector3& half, const Distance& distance) const
    {
        return shapeOf(D(), half, 0.25*h, 2*h, distance);
    }

    PicShape boxShape(const Vector3& half) const
    {
        PicShape s = shapeIn(half,
            [&](double x, double y, double z)
            {
                if (D() == 2)
                    return AxisBox<2>{{{-half[0], -half[1]}}, {{half[0], half[1]}}}.distance(
                        {{x, y}});
                return AxisBox<3>{{{-half[0], -half[1], -half[2]}}, {{half[0], half[1], half[2]}}}
                    .distance({{x, y, z}});
            });
        s.volume = 4*half[0]*half[1]*(D() == 3 ? 2*half[2] : 1);
        return s;
    }

    //- Force of the water in the first step, and its moment about the third axis
    Vector3 held(
        const PicShape& shape, const Vector3& at, double turn = 0, double surface = level) const
    {
        const PicConfig c = tank();
        PicInside inside;
        auto solids = body(c, at, shape, 1, 1, turn);
        solids->input.groups.resize(1);
        for (bool& held : solids->input.groups[0].held) held = true;
        solids->input.groups[0].heldSpin = true;
        inside.solids = solids;
        const FluidInput water = box(c, {{0, 0, 0}}, {{c.domainMax[0], surface, c.domainMax[2]}},
            [](double, double) { return true; });
        const auto s = createPicScene(c, water, PicWalls(), nullptr, std::move(inside));
        EXPECT_EQ(s->advance(1e-3, 1).stop, StopReason::none);
        const Vector3 f = s->coupling().force;
        const DemClumpState q = s->solids()->clumps();
        return {{f[0], f[1], q.moment[2]}};
    }
};

RIPRAP_ALL_SETUPS(HeldBodies);

//- A barge whose bottom passes through two layers of cells, its draught from one to six cells
TEST_P(HeldBodies, ABargeBearsWhatItDisplaces)
{
    if (D() == 3 && !mixed()) GTEST_SKIP() << "seconds saved";
    const Vector3 half{{0.15, 0.05, 0.075}};
    const PicShape shape = boxShape(half);
    const double area = 2*half[0]*(D() == 3 ? 2*half[2] : 1);
    for (const double y : {0.301, 0.305, 0.309, 0.3101, 0.311, 0.315, 0.319, 0.24, 0.2, 0.193})
    {
        const double draught = std::min(level - y + half[1], 2*half[1]);
        const Vector3 f = held(shape, {{0.3, y, 0.2}});
        // a hundredth of what five cells of draught bear
        EXPECT_NEAR(f[1], weight*area*draught, 0.01*weight*area*5*h) << y;
        EXPECT_NEAR(f[0], 0, 1e-3*weight*area*draught);
    }
}

//- A deck that lies between the surface and the next cell, or a little under water
TEST_P(HeldBodies, ADeckAtTheSurfaceBearsWhatIsUnderWater)
{
    if (D() == 3) GTEST_SKIP() << "the same";
    const Vector3 half{{0.15, 0.05, 0.075}};
    const PicShape shape = boxShape(half);
    for (const double freeboard : {0.013, 0.008, 0.003, -0.004, -0.012})
        for (const double surface : {0.3, 0.31})
        {
            const double draught = 2*half[1] - std::max(0.0, freeboard);
            const Vector3 f = held(shape, {{0.3, surface + freeboard - half[1], 0.2}}, 0, surface);
            EXPECT_NEAR(f[1], weight*2*half[0]*draught, 0.01*weight*2*half[0]*5*h)
                << freeboard << ' ' << surface;
        }
}

//- The same, tilted: what is under water lies between the level and the lowest corner
TEST_P(HeldBodies, ATiltedBoxBearsWhatItDisplaces)
{
    if (D() == 3 && !mixed()) GTEST_SKIP() << "seconds saved";
    const Vector3 half{{0.1, 0.06, 0.075}};
    const PicShape shape = boxShape(half);
    for (const double degrees : {3.0, 10.0, 25.0, 40.0})
        for (int k = 0; k < 5; k += D() == 3 ? 2 : 1)
        {
            const double turn = degrees*M_PI/180, y = 0.18 + 0.2*h*k;
            // all of it under water
            const double displaced = weight*4*half[0]*half[1]*(D() == 3 ? 2*half[2] : 1);
            const Vector3 f = held(shape, {{0.303, y, 0.2}}, turn);
            EXPECT_NEAR(f[1], displaced, 0.01*displaced) << degrees << ' ' << y;
            EXPECT_NEAR(f[0], 0, 0.01*displaced) << degrees << ' ' << y;
        }
}

//- A cylinder on its side, and a sphere, 5 cells deep and whole
TEST_P(HeldBodies, ARoundBodyBearsWhatItDisplacesAtAnyHeight)
{
    if (D() == 3 && !mixed()) GTEST_SKIP() << "seconds saved";
    const double R = 5*h;
    const PicShape shape = shapeIn({{R, R, R}},
        [&](double x, double y, double z)
        { return std::sqrt(x*x + y*y + (D() == 3 ? z*z : 0)) - R; });
    for (const double depth : {0.0, 1.5*R})
    {
        double before = 0;
        for (int k = 0; k <= 20; k += D() == 3 ? 4 : 1)
        {
            const double y = level - depth + 0.1*h*(k - 10), t = std::min(level - y, R);
            const double volume = D() == 2
                ? R*R*(M_PI/2 + std::asin(t/R)) + t*std::sqrt(R*R - t*t)
                : M_PI*(2*R*R*R/3 + R*R*t - t*t*t/3);
            const Vector3 f = held(shape, {{0.3, y, 0.2}});
            const double ratio = f[1]/(weight*volume);
            EXPECT_NEAR(ratio, 1, 0.01) << depth << ' ' << k;
            if (k > 0) { EXPECT_NEAR(ratio, before, 0.005) << depth << ' ' << k; }
            before = ratio;
        }
    }
}

//- Half as heavy as water, let go where it floats: it stays there, wherever the level lies in a
//  cell
TEST_P(HeldBodies, AFreeBoxKeepsItsDraughtAtAnyOffset)
{
    if (D() == 3) GTEST_SKIP() << "seconds saved";
    const Vector3 half{{0.1, 0.05, 0}};
    const PicShape shape = boxShape(half);
    const double mass = 500*4*half[0]*half[1];
    for (const int k : {1, 2, 3})
    {
        PicConfig c = tank();
        c.seedsPerDirection = 0;
        const double surface = 0.2 + 0.25*h*k;
        PicInside inside;
        inside.solids = body(c, {{0.3, surface, 0}}, shape, mass,
            mass*(half[0]*half[0] + half[1]*half[1])/3);
        const FluidInput water = box(c, {{0, 0, 0}}, {{0.6, surface, 1}},
            [&](double x, double y)
            { return std::abs(x - 0.3) > half[0] || y < surface - half[1]; });
        const auto s = createPicScene(c, water, PicWalls(), nullptr, std::move(inside));
        double most = 0;
        for (int i = 1; i <= 6; ++i)
        {
            ASSERT_EQ(s->advance(0.05*i).stop, StopReason::none);
            most = std::max(most, std::abs(s->solids()->clumps().position[1] - surface));
        }
        EXPECT_LT(most, 0.01*half[1]) << k;         // of the draught; waves that the start makes
    }
}

} // namespace
} // namespace riprap

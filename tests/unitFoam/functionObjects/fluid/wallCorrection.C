// SPDX-License-Identifier: GPL-3.0-or-later
/*  What walls hide from kernel sums: at faces, edges and corners, fixed and moving ones, through
    periodic ends. */

#include "runningFluid.hpp"
#include "wallCorrection.H"

using namespace Foam;
using functionObjects::wallCorrection;

namespace
{
    const double dp = 0.05, h = 1.25*dp;

    const std::string piston("piston { patches (xMin); solidBodyMotionFunction linearMotion; "
                             "linearMotionCoeffs { velocity (0.1 0 0); } }");

    struct Walls
    {
        RunningSph run;
        wallCorrection walls;

        explicit Walls(const BoxMesh& box, const std::string& motion = "",
            const std::string& geometry = "")
        :
            run(box, "maxVelocity 3; walls { motion { " + motion + " } }", "endTime 1;")
        {
            if (!geometry.empty()) run.writeDict("constant/geometry", geometry);
            startAt(0);
        }

        void startAt(double t)
        {
            run.time().setTime(t, label(t));
            run.start(dp, {{point(0.3, 0, 0.7), point(0.5, 0.2, 0.8)}});
        }

        const wallCorrection& at(const pointField& points, bool sight = false)
        {
            walls.reset(sight);
            walls.update(run.object(), points);
            return walls;
        }
    };

    //- From a flat wall to the centroid of the half of Wendland's C2 kernel that is before it
    double centroidOfHalf(int D)
    {
        double mass = 0, moment = 0;
        const int n = 20000;
        for (int k = 0; k < n; ++k)
        {
            const double q = 2*(k + 0.5)/n, w = std::pow(1 - q/2, 4)*(2*q + 1);
            mass += w*std::pow(q, D - 1);
            moment += w*std::pow(q, D);
        }
        // mean of cos over the half circle, the half sphere
        return h*moment/mass*(D == 2 ? 2/std::acos(-1.0) : 0.5);
    }
}

TEST(WallCorrection, facesEdgesAndCorners)
{
    for (const int D : {2, 3})
    {
        Walls w(tank(D, 1, 1, 10, 0.5));
        const auto& at = w.at(pointField(
            {{0.5, 0.25, 0}, {0.5, 0.25, 0.3}, {0, 0.25, 0.3}, {0, 0.25, 0}, {0, 0, 0}}));
        const double away = centroidOfHalf(D);
        EXPECT_NEAR(at.share(0), 0.5, 0.01);
        EXPECT_NEAR(mag(at.offset(0) - vector(0, 0, away)), 0, 0.12*away);
        EXPECT_NEAR(at.pressure(w.run.settings.config, 0), 1e4*away, 0.12*1e4*away);
        EXPECT_EQ(at.share(1), 1);
        EXPECT_EQ(mag(at.offset(1)), 0);
        EXPECT_EQ(at.pressure(w.run.settings.config, 1), 0);
        EXPECT_NEAR(at.share(2), 0.5, 0.01);
        EXPECT_NEAR(mag(at.offset(2) - vector(away, 0, 0)), 0, 0.12*away);
        EXPECT_NEAR(at.share(3), 0.25, 0.01);
        EXPECT_NEAR(at.share(4), D == 2 ? 0.25 : 0.125, 0.01);
    }
}

//- The wall's face, and those of walls that are seen from there
TEST(WallCorrection, planes)
{
    Walls w(tank(2, 1, 1, 10));
    const riprap::SightPlanes planes(
        w.at(pointField({{0.5, 0, 0.3}, {0, 0, 0.3}, {0, 0, 0.03}}), true).planes());
    ASSERT_EQ(planes.first, (std::vector<std::int32_t>{0, 0, 1, 3}));
    EXPECT_NEAR(planes.normal[0], 1, 1e-6);
    EXPECT_NEAR(planes.depth[0], 0, 2e-3*dp);
    EXPECT_NEAR(planes.normal[3 + 0], 1, 1e-6);
    EXPECT_NEAR(planes.normal[6 + 2], 1, 1e-6);
    EXPECT_NEAR(planes.depth[2], 0.03, 2e-3*dp);
}

//- Walls that have moved cover what is near them now
TEST(WallCorrection, wallsThatMove)
{
    Walls w(tank(2, 1, 1, 10), piston);
    const pointField points({{0, 0.5, 0.3}, {0.1, 0.5, 0.3}, {0.5, 0.5, 0.3}});
    w.at(points);
    EXPECT_NEAR(w.walls.share(0), 0.5, 0.01);
    EXPECT_NEAR(w.walls.share(1), 1, 1e-3);
    w.startAt(1);
    w.walls.update(w.run.object(), points);
    // behind the face: what is left at least
    EXPECT_NEAR(w.walls.share(0), 0.1, 1e-12);
    EXPECT_NEAR(w.walls.share(1), 0.5, 0.01);
    EXPECT_GT(w.walls.offset(1).x(), 0.8*centroidOfHalf(2));
    EXPECT_EQ(w.walls.share(2), 1);
    w.startAt(0);
    w.walls.update(w.run.object(), points);
    EXPECT_NEAR(w.walls.share(0), 0.5, 0.01);
    EXPECT_NEAR(w.walls.share(1), 1, 1e-3);
}

//- A block that has gone through a periodic end
TEST(WallCorrection, throughPeriodicEnds)
{
    BoxMesh box(tank(2, 1, 1, 10));
    box.sides(0, "cyclic");
    Walls w(box, "block { patches (block); solidBodyMotionFunction linearMotion; "
        "linearMotionCoeffs { velocity (0.2 0 0); } }",
        "block { type searchableBox; min (0.6 -1 0.2); max (0.9 2 0.6); }");
    const pointField points({{0.9, 0.5, 0.4}, {0.1, 0.5, 0.4}, {0.95, 0.5, 0.4}});
    const auto& at = w.at(points);
    EXPECT_NEAR(at.share(0), 0.5, 0.01);
    EXPECT_EQ(at.share(1), 1);
    w.startAt(1);
    w.walls.update(w.run.object(), points);
    // from 0.8 to 1.1
    EXPECT_NEAR(at.share(0), 0.1, 1e-12);
    EXPECT_NEAR(at.share(1), 0.5, 0.01);
    EXPECT_NEAR(at.share(2), 0.1, 1e-12);
    EXPECT_GT(at.offset(1).x(), 0.8*centroidOfHalf(2));
}

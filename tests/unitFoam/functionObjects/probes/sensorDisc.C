// SPDX-License-Identifier: GPL-3.0-or-later
/*  Points of a pressure sensor, and of a gauge. */

#include "riprapFoam/functionObjects/fluid/gaugeLine.H"
#include "riprapFoam/functionObjects/probes/sensorDisc.H"

#include <gtest/gtest.h>

TEST(SensorDisc, averagesAsADiscDoes)
{
    const double R = 0.3;
    for (const bool flat : {false, true})
    {
        const Foam::sensorDisc disc
        (
            Foam::makeSensorDisc({1, 2, 3}, {-1, 0, 0}, Foam::vector(0, 0, flat), R)
        );
        double one = 0, y = 0, yy = 0;
        for (Foam::label i = 0; i < disc.points.size(); ++i)
        {
            const double d = disc.points[i].y() - 2;
            EXPECT_NEAR(disc.points[i].x(), 1, 1e-14);
            if (flat) { EXPECT_NEAR(disc.points[i].z(), 3, 1e-14); }
            one += disc.weights[i];
            y += disc.weights[i]*d;
            yy += disc.weights[i]*d*d;
        }
        EXPECT_NEAR(one, 1, 1e-14);
        EXPECT_NEAR(y, 0, 1e-14);
        // Second moment of a disc's area about a diameter; 3D: less 1/37^2 of it
        EXPECT_NEAR(yy, R*R/4*(flat ? 1 : 1 - 1.0/1369), 1e-14);
    }
}

TEST(GaugeLine, fromFootToTheBounds)
{
    const Foam::boundBox bounds(Foam::point(0, 0, 0), Foam::point(2, 1, 0.1));
    EXPECT_NEAR(Foam::gaugeLength(bounds, {0.5, 0.25, 0}, {0, 1, 0}), 0.75, 1e-15);
    EXPECT_NEAR(Foam::gaugeLength(bounds, {0.5, 0.25, 0}, {-1, 0, 0}), 0.5, 1e-15);
    EXPECT_LT(Foam::gaugeLength(bounds, {0.5, 1.25, 0}, {0, 1, 0}), 0);

    const Foam::gaugeLine line(Foam::makeGaugeLine(bounds, {0.5, 0, 0}, {0, 1, 0}, 0.1));
    EXPECT_EQ(line.points.size(), 41);
    EXPECT_EQ(line.points.last(), Foam::point(0.5, 1, 0));
    EXPECT_EQ(line.height.back(), 1);
}

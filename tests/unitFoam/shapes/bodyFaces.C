// SPDX-License-Identifier: GPL-3.0-or-later
/*  Surfaces of rigid bodies as water is held off them: closed, outwards, of the volume of their
    shape, in the frame of the body. */

#include "bodyFaces.H"
#include "testTime.H"

#include <cmath>
#include <gtest/gtest.h>

using riprap::Vector3;
using riprap::WallFaceInput;

namespace
{
    riprap::SphConfig config(int dimensions)
    {
        riprap::SphConfig c;
        c.dimensions = dimensions;
        // 2D: in the plane of x and z, whose axes with y are left-handed
        if (dimensions == 2) { c.axes[1] = 2; c.axes[2] = 1; }
        c.spacing = 0.01;
        return c;
    }

    Vector3 vertex(const WallFaceInput& f, std::size_t i, int c)
    {
        const double* p = &f.point[3*std::size_t(f.vertex[3*i + c])];
        return Vector3{{p[0], p[1], p[2]}};
    }

    //- Divergence theorem: sum n.x A/D. Gauss' sum of n A must vanish
    double volume(const WallFaceInput& f, int dimensions, double& open)
    {
        double sum = 0, area[3] = {0, 0, 0};
        for (std::size_t i = 0; i < f.size(); ++i)
        {
            const Vector3 a = vertex(f, i, 0), b = vertex(f, i, 1),
                          c = dimensions == 3 ? vertex(f, i, 2) : b;
            double cross2 = 0, length2 = 0, along = 0;
            for (int d = 0; d < 3; ++d)
            {
                const int e = (d + 1) % 3, g = (d + 2) % 3;
                const double n = (b[e] - a[e])*(c[g] - a[g]) - (b[g] - a[g])*(c[e] - a[e]);
                cross2 += n*n;
                length2 += (b[d] - a[d])*(b[d] - a[d]);
                along += f.normal[3*i + d]*a[d];
            }
            const double A = dimensions == 3 ? 0.5*std::sqrt(cross2) : std::sqrt(length2);
            for (int d = 0; d < 3; ++d) area[d] += A*f.normal[3*i + d];
            sum += A*along/dimensions;
        }
        open = std::abs(area[0]) + std::abs(area[1]) + std::abs(area[2]);
        return sum;
    }

    WallFaceInput facesOf(int dimensions, const std::string& surface, const riprap::DemClump& body)
    {
        const Foam::dictionary properties(entries("surfaces { one { body 0; " + surface + " } }"));
        return Foam::bodyFaces(properties, testTime(), config(dimensions), {body});
    }

    void expectVolume(int dimensions, const std::string& surface, const Vector3& centre,
        double expected, double tolerance)
    {
        riprap::DemClump body;
        body.position = centre;
        const WallFaceInput f = facesOf(dimensions, surface, body);
        ASSERT_GT(f.size(), 0u) << surface;
        EXPECT_EQ(Foam::bodiesWithFaces(f), 1);
        double open;
        EXPECT_NEAR(volume(f, dimensions, open)/expected, 1, tolerance) << surface;
        EXPECT_LT(open, 1e-9) << surface;
        // in the body's frame: the centre is the origin
        double middle[3] = {0, 0, 0};
        const std::size_t points = f.point.size()/3;
        for (std::size_t i = 0; i < f.point.size(); ++i)
            middle[i % 3] += f.point[i]/double(points);
        for (int d = 0; d < 3; ++d)
        {
            if (dimensions == 3 || d != 1) { EXPECT_NEAR(middle[d], 0, 1e-9) << surface; }
        }
    }
}

// A chord a hundredth of a spacing off the arc of radius R: volumes are less by 4/3 (2D) to 3
// (sphere) of that over R at most
TEST(BodyFaces, Volumes)
{
    const double pi = std::acos(-1.0);
    expectVolume(3, "source box; box (3 1 2) (2 5 4);", {{2.5, 3, 3}}, 8, 1e-12);
    expectVolume(3, "source cylinder; p1 (1 1 1); p2 (1 2 3); radius 0.2;", {{1, 1.5, 2}},
        pi*0.04*std::sqrt(5.0), 2e-3);
    expectVolume(3, "source sphere; centre (1 2 3); radius 0.1;", {{1, 2, 3}}, 4*pi/3*1e-3, 4e-3);
    expectVolume(2, "source box; box (3 0 2) (2 5 4);", {{2.5, 0, 3}}, 2, 1e-12);
    expectVolume(
        2, "source cylinder; p1 (1 -1 1); p2 (1 2 1); radius 0.2;", {{1, 0, 1}}, pi*0.04, 2e-3);
    expectVolume(2, "source cylinder; p1 (1 0.5 1); p2 (2 0.5 2); radius 0.2;", {{1.5, 0.5, 1.5}},
        0.4*std::sqrt(2.0), 1e-12);
    expectVolume(2, "source sphere; centre (1 0.5 3); radius 0.1;", {{1, 0.5, 3}}, pi*0.01, 3e-3);
}

//- A body that was made turned by a right angle about z: its axes are principal ones, and where it
//  is now does not matter
TEST(BodyFaces, FrameOfTheBody)
{
    riprap::DemClump body;
    body.moved = true;
    body.position = Vector3{{7, 8, 9}};
    body.start.position = Vector3{{1, 2, 3}};
    body.start.orientation = {{std::sqrt(0.5), 0, 0, std::sqrt(0.5)}};
    const WallFaceInput f = facesOf(3, "source box; box (0 0 0) (2 8 6);", body);
    double low[3] = {1e9, 1e9, 1e9}, high[3] = {-1e9, -1e9, -1e9};
    for (std::size_t i = 0; i < f.point.size(); ++i)
    {
        low[i % 3] = std::min(low[i % 3], f.point[i]);
        high[i % 3] = std::max(high[i % 3], f.point[i]);
    }
    // x of space is -y of the body, y of space its x
    EXPECT_NEAR(low[0], -2, 1e-12);
    EXPECT_NEAR(high[0], 6, 1e-12);
    EXPECT_NEAR(low[1], -1, 1e-12);
    EXPECT_NEAR(high[1], 1, 1e-12);
    EXPECT_NEAR(high[2], 3, 1e-12);
}

//- Clumps of one outline: each has it, given either way round
TEST(BodyFaces, Outlines)
{
    riprap::DemClump a, b;
    a.shape = b.shape = 0;
    for (const char* outline : {"((0 0 0) (0.3 0 0) (0 0 0.3))", "((0 0 0.3) (0.3 0 0) (0 0 0))"})
    {
        const Foam::dictionary properties(
            entries(std::string("shapes { one { outline ") + outline + "; } }"));
        const WallFaceInput f = Foam::bodyFaces(properties, testTime(), config(2), {a, b});
        EXPECT_EQ(Foam::bodiesWithFaces(f), 2);
        ASSERT_EQ(f.size(), 6u);
        double open;
        EXPECT_NEAR(volume(f, 2, open), 2*0.045, 1e-12);
    }
    EXPECT_EQ(
        Foam::bodiesWithFaces(Foam::bodyFaces(entries(""), testTime(), config(2), {a, b})), 0);
}

// SPDX-License-Identifier: GPL-3.0-or-later
/*  Solids in a fluid: how fast they can become, and whose choice the device is. */

#include "coupledSolids.H"
#include "particleCase.hpp"

#include <cmath>
#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    const std::string rock("materials { rock { rho 2600; E 1e7; nu 0.2; } } ");

    //- With input of the test's own
    struct Solids : coupledSolids
    {
        using coupledSolids::coupledSolids;
        riprap::DemInput& input() { return input_; }
    };

    struct SolidsCase : ParticleCase
    {
        autoPtr<fvMesh> fv;
        autoPtr<nearestPatch> boundary;

        explicit SolidsCase(const std::string& text)
        :
            ParticleCase(BoxMesh(), "endTime 2; deltaT 1e-3;"),
            fv(BoxMesh().make<fvMesh>(time(), "fv")),
            boundary(new nearestPatch(fv()))
        {
            writeDict("constant/solidProperties", text);
        }

        autoPtr<Solids> make(riprap::DeviceKind device = riprap::DeviceKind::automatic,
            riprap::PrecisionKind precision = riprap::PrecisionKind::mixed)
        {
            return autoPtr<Solids>(
                new Solids(time(), fv(), "sphProperties", device, precision, boundary()));
        }
    };

    //- Balls of radius 0.1 above each other, the first at z = 0.5
    void addBalls(riprap::DemInput& input, const std::vector<double>& heights)
    {
        for (const double z : heights)
        {
            input.particles.position.insert(input.particles.position.end(), {0.5, 0.5, z});
            input.particles.velocity.insert(input.particles.velocity.end(), {0, 0, 0});
            input.particles.radius.push_back(0.1);
        }
    }

    const vector g(0, 0, -10);
}

TEST(CoupledSolids, fallToTheFloor)
{
    SolidsCase c(rock);
    auto solids = c.make();
    addBalls(solids->input(), {0.5, 0.9});
    // the floor is z = 0: x & g = 0
    EXPECT_NEAR(solids->fallSpeed(g, 0), std::sqrt(2*10*0.8), 1e-12);
    solids->input().particles.velocity[0] = 3;
    solids->input().particles.velocity[3] = 4;
    EXPECT_NEAR(solids->fallSpeed(g, 0), std::sqrt(2*10*0.8 + 16), 1e-12);
    // what is below it does not rise
    EXPECT_NEAR(solids->fallSpeed(g, -100), 4, 1e-12);
}

//- A body, by bonds or as a clump, falls until its lowest part is on the floor
TEST(CoupledSolids, partsOfABodyFallTogether)
{
    SolidsCase c(rock);
    for (const bool clump : {true, false})
    {
        auto solids = c.make();
        riprap::DemInput& input = solids->input();
        addBalls(input, {0.3, 0.9, 0.7});
        if (clump)
        {
            input.clumps.resize(1);
            input.particles.clump = {0, 0, -1};
        }
        else
        {
            input.particles.id = {30, 10, 20};
            input.bonds.a = {10};
            input.bonds.b = {30};
        }
        // the body by 0.2, the other by 0.6
        EXPECT_NEAR(solids->fallSpeed(g, 0), std::sqrt(2*10*0.6), 1e-12);
        input.particles.velocity[5] = -3.5;
        EXPECT_NEAR(solids->fallSpeed(g, 0), std::sqrt(2*10*0.2 + 3.5*3.5), 1e-12);
    }
}

TEST(CoupledSolids, whatIsHeldDoesNotFall)
{
    SolidsCase c(rock);
    auto solids = c.make();
    riprap::DemInput& input = solids->input();
    addBalls(input, {0.5});
    input.groups.resize(1);
    input.particles.group = {0};
    EXPECT_NEAR(solids->fallSpeed(g, 0), std::sqrt(2*10*0.4), 1e-12);
    input.groups[0].held[0] = true;
    EXPECT_NEAR(solids->fallSpeed(g, 0), std::sqrt(2*10*0.4), 1e-12);
    input.groups[0].held[2] = true;
    EXPECT_EQ(solids->fallSpeed(g, 0), 0);
    input.groups[0].held[2] = false;
    input.groups[0].gravity = false;
    EXPECT_EQ(solids->fallSpeed(g, 0), 0);
}

TEST(CoupledSolids, speedOfWhatIsMoved)
{
    SolidsCase c(rock + "groups { arm { motion { solidBodyMotionFunction rotatingMotion; origin "
        "(0.5 0.5 0); axis (0 1 0); omega 3; } } } walls { motion { lid { patches (zMax); "
        "solidBodyMotionFunction linearMotion; velocity (1 0 0.5); } } }");
    auto solids = c.make();
    riprap::DemInput& input = solids->input();
    EXPECT_EQ(solids->movedSpeed(), 0);
    input.walls.resize(1);
    input.walls[0].motion = 0;
    input.walls[0].vertices = {0, 0, 1, 1, 0, 1, 0, 1, 1};
    EXPECT_NEAR(solids->movedSpeed(), std::sqrt(1.25), 1e-6);
    addBalls(input, {0.5});
    input.groups.resize(1);
    input.groups[0].motion = 0;
    input.particles.group = {0};
    EXPECT_NEAR(solids->movedSpeed(), 3*0.5, 1e-3);
}

TEST(CoupledSolids, deviceAndPrecisionAreTheFluids)
{
    SolidsCase c(rock + "device gpu; precision double;");
    EXPECT_TRUE(coupledSolids::there(c.time()));
    const auto said = [&](riprap::DeviceKind device, riprap::PrecisionKind precision)
    {
        return messageOf([&]() { c.make(device, precision); });
    };
    EXPECT_EQ(said(riprap::DeviceKind::gpu, riprap::PrecisionKind::doubled), "");
    EXPECT_EQ(said(riprap::DeviceKind::cpu, riprap::PrecisionKind::doubled),
        "Entry device is gpu, and cpu in constant/sphProperties: solids are where their fluid is. "
        "Leave it out here, or say cpu");
    EXPECT_EQ(said(riprap::DeviceKind::gpu, riprap::PrecisionKind::mixed),
        "Entry precision is double, and mixed in constant/sphProperties: solids are where their "
        "fluid is. Leave it out here, or say mixed");
}

/*  Rigid bodies that are hinged, guided, sprung and moored, against closed forms.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "dem/demTest.hpp"

namespace riprap
{
namespace
{

using DemConstraints = DemTest;

constexpr double mass = 2, inertia[3] = {0.01, 0.02, 0.04};
constexpr double weight = 10;           // g [m/s2]

//- One body of two spheres, free of contacts
DemInput oneBody(Vector3 x, std::array<double, 4> q = {{1, 0, 0, 0}})
{
    DemInput in = oneMaterial();
    in.groups.emplace_back();
    in.groups[0].name = "body";
    DemClump k;
    k.mass = mass;
    for (int d = 0; d < 3; ++d) k.inertia[d] = inertia[d];
    k.position = x;
    k.orientation = q;
    in.clumps.push_back(k);
    for (const double side : {-0.02, 0.02})
    {
        addParticle(in, {{x[0] + side, x[1], x[2]}}, {{0, 0, 0}}, 0.01);
        in.particles.clump.push_back(0);
    }
    return in;
}

DemConfig withStep(DemConfig c, double step)
{
    c.timeStep = step;
    c.gravity = Vector3{{0, -weight, 0}};
    return c;
}

//- Small swings of a physical pendulum: w^2 = m g d/(J + m d^2), w lowered by 1/16 of the
//  amplitude's square
TEST_P(DemConstraints, PendulumKeepsItsPeriod)
{
    const double length = 0.2, start = 0.05, turned = 0.6;
    for (const int D : {2, 3})
        for (const auto integrator :
            {"leapfrog", "velocityVerlet"})
        {
            // in 3D the hinge is no principal axis: n.J n = Jy sin^2 + Jz cos^2
            std::array<double, 4> q{{1, 0, 0, 0}};
            double about = inertia[2];
            if (D == 3)
            {
                q = {{std::cos(turned/2), std::sin(turned/2), 0, 0}};
                about = inertia[1]*std::pow(std::sin(turned), 2)
                    + inertia[2]*std::pow(std::cos(turned), 2);
            }
            const Vector3 point{{0.1, 0.2, 0}};
            DemInput in = oneBody(
                {{point[0] + length*std::sin(start), point[1] - length*std::cos(start), 0}}, q);
            in.groups[0].constraint.hinge = true;
            in.groups[0].constraint.point = point;
            DemConfig c = withStep(config(D), 1e-4);
            c.integrator = integrator;
            auto scene = createDemScene(c, in);
            const double energy = scene->energy().total(),
                         high = mass*weight*length*(1 - std::cos(start));
            const double w = std::sqrt(mass*weight*length/(about + mass*length*length))
                *(1 - start*start/16);
            for (int k = 1; k <= 8; ++k)
            {
                const double t = 0.25*k;
                scene->advance(t);
                const DemClumpState s = scene->clumps();
                const double x = s.position[0] - point[0], y = s.position[1] - point[1];
                EXPECT_NEAR(std::hypot(x, y), length, 1e-12);
                EXPECT_NEAR(std::atan2(x, -y), start*std::cos(w*t), 2e-4*start)
                    << D << "D, t = " << t;
                // the velocity is that of a turn about the hinge
                EXPECT_NEAR(s.velocity[0], -s.spin[2]*y, 1e-9);
                EXPECT_NEAR(s.velocity[1], s.spin[2]*x, 1e-9);
                EXPECT_NEAR(scene->energy().total(), energy, 1e-4*high);
            }
        }
}

//- Down a line at 30 degrees, and across a direction, gravity accelerates by its part along them
TEST_P(DemConstraints, GuidedBodiesFallByTheirShare)
{
    const double slope = pi/6, t = 0.2, fallen = 0.5*weight*t*t;
    for (const int D : {2, 3})
        for (const bool line : {true, false})
        {
            DemInput in = oneBody({{0, 0.2, 0}});
            auto& constraint = in.groups[0].constraint;
            constraint.translation = line ? TranslationKind::line : TranslationKind::plane;
            constraint.direction = Vector3{{2*std::cos(slope), -2*std::sin(slope), 0}};
            constraint.rotation = RotationKind::none;
            auto scene = createDemScene(withStep(config(D), 1e-4), in);
            scene->advance(t);
            const DemClumpState s = scene->clumps();
            const double part = line ? std::sin(slope) : std::cos(slope);
            const double ex = line ? std::cos(slope) : -std::sin(slope),
                         ey = line ? -std::sin(slope) : -std::cos(slope);
            EXPECT_NEAR(s.position[0], fallen*part*ex, 1e-9);
            EXPECT_NEAR(s.position[1], 0.2 + fallen*part*ey, 1e-9);
            EXPECT_NEAR(s.velocity[1], weight*t*part*ey, 1e-9);
            EXPECT_EQ(s.orientation[0], 1);
        }
}

//- About a fixed axis that is no principal one: spin and energy stay; a moment turns by n.M t^2/(2
//  n.J n)
TEST_P(DemConstraints, TurnsAboutItsAxisAlone)
{
    const double s = 1/std::sqrt(3.0), about = (inertia[0] + inertia[1] + inertia[2])/3, t = 0.5;
    for (const double moment : {0.0, 0.05})
    {
        DemInput in = oneBody({{0, 0, 0}});
        in.groups[0].gravity = false;
        in.groups[0].constraint.rotation = RotationKind::axis;
        in.groups[0].constraint.axis = Vector3{{1, 1, 1}};
        in.groups[0].moment = Vector3{{0, moment, 0}};
        for (double& w : in.clumps[0].spin) w = 2*s;
        in.clumps[0].velocity = Vector3{{0.1, 0, 0}};
        auto scene = createDemScene(withStep(config(3), 1e-4), in);
        const double energy = scene->energy().rotation;
        scene->advance(t);
        const DemClumpState now = scene->clumps();
        const double angle = 2*t + 0.5*moment*s/about*t*t;
        EXPECT_NEAR(2*std::acos(now.orientation[0]), angle, 1e-6);
        for (int d = 0; d < 3; ++d) EXPECT_NEAR(now.spin[d], s*(2 + moment*s/about*t), 1e-6) << d;
        EXPECT_NEAR(now.position[0], 0.1*t, 1e-9);
        if (moment == 0) { EXPECT_NEAR(scene->energy().rotation, energy, 1e-9*energy); }
    }
}

DemSpring springAt(Vector3 anchor, Vector3 point, double stiffness, double length)
{
    DemSpring s;
    s.name = "s";
    s.anchor = anchor;
    s.point = point;
    s.stiffness = stiffness;
    s.length = length;
    return s;
}

//- x0 cos(w t), w^2 = k/m; of a spring at an arm a from a centre that is held, w^2 = k a^2/J
TEST_P(DemConstraints, SpringsSwingInTime)
{
    const double k = 800, start = 0.05, arm = 0.02, w = std::sqrt(k/mass);
    for (const int D : {2, 3})
    {
        DemInput in = oneBody({{start, 0, 0}});
        in.groups[0].gravity = false;
        in.groups[0].springs = {springAt({{0, 0, 0}}, {{start, 0, 0}}, k, 0)};
        auto scene = createDemScene(withStep(config(D), 1e-4), in);
        EXPECT_NEAR(scene->energy().spring, 0.5*k*start*start, 1e-12);
        const double energy = scene->energy().total();
        for (const double t : {0.1, 0.37, 1.0})
        {
            scene->advance(t);
            EXPECT_NEAR(scene->clumps().position[0], start*std::cos(w*t), 1e-4*start) << t;
            EXPECT_NEAR(scene->energy().total(), energy, 1e-4*energy);
        }
        DemInput turning = oneBody({{0, 0, 0}});
        turning.groups[0].gravity = false;
        turning.groups[0].constraint.translation = TranslationKind::none;
        turning.clumps[0].spin = Vector3{{0, 0, 0.01}};
        turning.groups[0].springs = {springAt({{arm, 0, 0}}, {{arm, 0, 0}}, k, 0)};
        auto swing = createDemScene(withStep(config(D), 1e-4), turning);
        const double wt = std::sqrt(k*arm*arm/inertia[2]), t = 0.3;
        swing->advance(t);
        const DemClumpState s = swing->clumps();
        EXPECT_NEAR(2*std::asin(s.orientation[3]), 0.01/wt*std::sin(wt*t), 1e-4*0.01/wt);
    }
}

//- At rest a damped spring is longer by m g/k, and its force is the weight
TEST_P(DemConstraints, HangsWhereItsWeightSays)
{
    const double k = 2000, length = 0.1;
    for (const bool slack : {false, true})
    {
        DemInput in = oneBody({{0, 0.1, 0}});
        in.groups[0].springs = {springAt({{0, 0.25, 0}}, {{0, 0.13, 0}}, k, length)};
        in.groups[0].springs[0].damping = 60;
        in.groups[0].springs[0].slack = slack;
        auto scene = createDemScene(withStep(config(2), 1e-4), in);
        scene->advance(3);
        EXPECT_NEAR(scene->clumps().position[1], 0.25 - length - mass*weight/k - 0.03, 1e-9);
        const auto s = scene->springs();
        ASSERT_EQ(s.size(), 1u);
        EXPECT_EQ(s[0].name, "body.s");
        EXPECT_NEAR(s[0].tension, mass*weight, 1e-6);
        EXPECT_NEAR(s[0].force[1], mass*weight, 1e-6);
        EXPECT_NEAR(s[0].point[1], 0.25 - s[0].length, 1e-12);
    }
}

//- A slack line lets a body fall, then stretches by s with m g (L + s) = k s^2/2
TEST_P(DemConstraints, SlackLinesPullAlone)
{
    const double k = 2e4, length = 0.1, drop = 0.04;
    DemInput in = oneBody({{0, 0.3, 0}});
    in.groups[0].springs = {springAt({{0, 0.3 + length - drop, 0}}, {{0, 0.3, 0}}, k, length)};
    in.groups[0].springs[0].slack = true;
    auto scene = createDemScene(withStep(config(2), 2e-5), in);
    scene->advance(0.05);
    EXPECT_NEAR(scene->clumps().position[1], 0.3 - 0.5*weight*0.05*0.05, 1e-9);
    EXPECT_EQ(scene->springs()[0].tension, 0);
    double lowest = 1;
    for (int i = 1; i <= 300; ++i)
    {
        scene->advance(0.05 + 4e-4*i);
        lowest = std::min(lowest, scene->clumps().position[1]);
    }
    const double a = mass*weight, stretch = (a + std::sqrt(a*a + 2*k*a*drop))/k;
    EXPECT_NEAR(0.3 - drop - lowest, stretch, 2e-3*stretch);
}

//- A scene of a body that has moved knows where its points were
TEST_P(DemConstraints, PointsStayOnTheBody)
{
    DemInput in = oneBody({{0, 0, 0}});
    in.clumps[0].spin = Vector3{{0, 0, 3}};
    in.clumps[0].velocity = Vector3{{0.1, 0.2, 0}};
    in.groups[0].springs = {springAt({{0, 0.3, 0}}, {{0.03, 0.02, 0}}, 50, 0.1)};
    auto scene = createDemScene(withStep(config(2), 1e-4), in);
    scene->advance(0.3);
    const DemClumpState s = scene->clumps();
    const DemState p = scene->particles();
    DemInput later = in;
    DemClump& k = later.clumps[0];
    k.moved = true;
    k.start = DemPose{k.position, k.orientation};
    k.position = at(s.position, 0);
    for (int e = 0; e < 4; ++e) k.orientation[e] = s.orientation[e];
    for (std::size_t i = 0; i < p.id.size(); ++i)
        for (int d = 0; d < 3; ++d) later.particles.position[3*p.id[i] + d] = p.position[3*i + d];
    const auto before = scene->springs(),
               now = createDemScene(withStep(config(2), 1e-4), later)->springs();
    for (int d = 0; d < 2; ++d) EXPECT_NEAR(now[0].point[d], before[0].point[d], 1e-9);
    EXPECT_NEAR(now[0].length, before[0].length, 1e-9);
    EXPECT_NEAR(std::hypot(before[0].point[0] - s.position[0], before[0].point[1] - s.position[1]),
        std::hypot(0.03, 0.02), 1e-12);
}

TEST_P(DemConstraints, RefusesWhatCannotBe)
{
    const auto refused = [&](const DemInput& in, const char* word)
    {
        try
        {
            createDemScene(withStep(config(2), 1e-4), in);
            ADD_FAILURE() << "accepted, should say " << word;
        }
        catch (const std::invalid_argument& e)
        {
            EXPECT_NE(std::string(e.what()).find(word), std::string::npos) << e.what();
        }
    };
    DemInput held = oneBody({{0, 0, 0}});
    held.groups[0].constraint.hinge = true;
    DemInput loose = held;
    held.groups[0].held[0] = true;
    refused(held, "exclude");
    addParticle(loose, {{0.2, 0, 0}});
    loose.particles.clump.push_back(-1);
    refused(loose, "of no rigid body");
    DemInput stiff = oneBody({{0, 0, 0}});
    stiff.groups[0].springs = {springAt({{0, 0.3, 0}}, {{0, 0, 0}}, 1e12, 0.1)};
    refused(stiff, "springs of body");
    stiff.groups[0].springs[0].stiffness = -1;
    refused(stiff, "stiffness");
}

RIPRAP_DEM_CASES(DemConstraints);

} // namespace
} // namespace riprap

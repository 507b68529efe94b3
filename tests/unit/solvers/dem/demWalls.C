/*  Walls and rigid bodies: triangles feel as a plane, corners and edges, moving walls; clumps as
    rigid bodies.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "dem/demTest.hpp"

namespace riprap
{
namespace
{

using DemWalls = DemTest;

//- The plane y = -0.2 as n x n irregular quadrilaterals of two triangles (3D), or n segments (2D)
DemWall meshedPlane(int D, int n)
{
    DemWall w;
    w.name = "mesh";
    std::mt19937 engine(4);
    std::uniform_real_distribution<double> u(-0.3, 0.3);
    const double cell = 0.9/n;
    for (int j = 0; j <= (D == 3 ? n : 0); ++j)
        for (int i = 0; i <= n; ++i)
        {
            const bool border = i == 0 || i == n || j == 0 || j == n;
            w.vertices.push_back(-0.45 + cell*(i + (border ? 0 : u(engine))));
            w.vertices.push_back(-0.2);
            w.vertices.push_back(-0.45 + cell*(j + (border ? 0 : u(engine))));
        }
    for (int i = 0; i < n && D == 2; ++i) { w.elements.push_back(i); w.elements.push_back(i + 1); }
    for (int j = 0; j < n && D == 3; ++j)
        for (int i = 0; i < n; ++i)
        {
            const int a = j*(n + 1) + i;
            for (const int v : {a, a + 1, a + n + 2, a, a + n + 2, a + n + 1})
                w.elements.push_back(v);
        }
    return w;
}

//- Rolling and bouncing over the edges of triangles far smaller, alike and larger than the sphere:
//  as over the plane to 1e-10, in either precision
TEST_P(DemWalls, TrianglesFeelAsAPlane)
{
    for (const int D : {2, 3})
        for (const int n : {3, 20, D == 2 ? 300 : 120})
            for (const double tilt : {0.1, 0.5})
            {
                DemConfig c = config(D);
                c.normal = "hertz";
                c.tangential = "history";
                c.rolling = "spring";
                c.stepFraction = 0.1;
                c.gravity = Vector3{{9.81*std::sin(tilt), -9.81*std::cos(tilt), D == 3 ? 0.5 : 0}};
                DemInput in = oneMaterial();
                PairProperties& p = in.pairs[0].properties;
                p.friction = 0.3;
                p.restitution = 0.6;
                p.rollingFriction = 0.02;
                addParticle(in, {{-0.3, -0.18, 0.02}}, {{0.4, 0, 0.1}}, 0.01, 0.01);
                DemState s[2];
                for (const int mesh : {0, 1})
                {
                    in.walls.clear();
                    in.walls.push_back(
                        mesh ? meshedPlane(D, n) : planeWall({{0, -0.2, 0}}, {{0, 1, 0}}));
                    auto scene = createDemScene(c, in);
                    const DemReport r = scene->advance(0.3);
                    EXPECT_EQ(r.stop, DemStop::none);
                    EXPECT_EQ(r.particles, 1u);
                    s[mesh] = scene->particles();
                }
                EXPECT_GT(s[1].position[0], -0.2);
                for (int d = 0; d < 3; ++d)
                {
                    EXPECT_NEAR(s[0].position[d], s[1].position[d], 1e-10)
                        << D << " " << n << " " << tilt;
                    EXPECT_NEAR(s[0].velocity[d], s[1].velocity[d], 1e-9);
                    EXPECT_NEAR(s[0].spin[d], s[1].spin[d], 1e-7);
                }
            }
}

//- A surface goes on across periodic sides, seam included: a sphere that crosses them rolls and
//  bounces as over the plane
TEST_P(DemWalls, SurfacesCrossPeriodicSides)
{
    for (const int D : {2, 3})
        for (const int n : {1, 3, 30})
        {
            DemConfig c = config(D);
            c.periodic[0] = true;
            c.periodic[2] = D == 3;
            c.domainMin = Vector3{{-0.45, -0.5, -0.45}};
            c.domainMax = Vector3{{0.45, 0.5, 0.45}};
            c.normal = "hertz";
            c.tangential = "history";
            c.stepFraction = 0.1;
            c.gravity = Vector3{{0, -9.81, 0}};
            DemInput in = oneMaterial();
            in.pairs[0].properties.friction = 0.3;
            in.pairs[0].properties.restitution = 0.6;
            addParticle(in, {{0.4, -0.185, 0.43}}, {{0.4, 0, 0.3}}, 0.01, 0.01);
            DemState s[2];
            for (const int mesh : {0, 1})
            {
                in.walls.clear();
                in.walls.push_back(
                    mesh ? meshedPlane(D, n) : planeWall({{0, -0.2, 0}}, {{0, 1, 0}}));
                auto scene = createDemScene(c, in);
                EXPECT_EQ(scene->advance(0.4).stop, DemStop::none);
                s[mesh] = scene->particles();
            }
            EXPECT_LT(s[1].position[0], -0.3);          // it has crossed
            if (D == 3)
            {
                EXPECT_LT(s[1].position[2], -0.3);
            }
            for (int d = 0; d < 3; ++d)
            {
                EXPECT_NEAR(s[0].position[d], s[1].position[d], 1e-10) << D << " " << n;
                EXPECT_NEAR(s[0].spin[d], s[1].spin[d], 1e-7);
            }
        }
}

//- A sphere that falls beside the end of a plate turns about its edge; on a corner of two plates it
//  rests on both, and only on both
TEST_P(DemWalls, EdgesAndCorners)
{
    for (const int D : {2, 3})
    {
        DemConfig c = config(D);
        c.gravity = Vector3{{0, -9.81, 0}};
        DemInput in = oneMaterial();
        in.pairs[0].properties.restitution = 0.1;
        DemWall w;
        w.name = "corner";
        for (const double z : {-0.4, 0.4})
            for (const Vector3 x :
                {Vector3{{-0.1, 0.1, 0}}, Vector3{{0, 0, 0}}, Vector3{{0.1, 0.1, 0}}})
            {
                w.vertices.push_back(x[0]);
                w.vertices.push_back(x[1]);
                w.vertices.push_back(z);
            }
        if (D == 2) w.elements = {0, 1, 1, 2};
        else w.elements = {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4};
        in.walls.push_back(w);
        const double rest = 0.01*std::sqrt(2.0);
        addParticle(in, {{0, rest, 0}});
        auto scene = createDemScene(c, in);
        scene->advance(0.3);
        const DemState s = scene->particles();
        // each face carries m g/sqrt(2)
        EXPECT_NEAR(s.position[1], rest - 0.01*9.81/1e4, 1e-7);
        EXPECT_NEAR(s.position[0], 0, 1e-9);
        EXPECT_NEAR(scene->wallForces()[0].force[1], -0.01*9.81, 1e-5);
    }
}

TEST_P(DemWalls, EdgeIsFelt)
{
    for (const int D : {2, 3})
    {
        DemConfig c = config(D);
        DemInput in = oneMaterial();
        DemWall w = meshedPlane(D, 4);
        in.walls.push_back(w);
        // beside the end of the plane, centre 0.006 out and 0.006 above: touches the edge by R -
        // 0.006 sqrt(2)
        addParticle(in, {{0.456, -0.194, 0.013}});
        auto scene = createDemScene(c, in);
        const DemContacts k = scene->contacts();
        ASSERT_EQ(k.a.size(), 1u);
        const double f = 1e4*(0.01 - 0.006*std::sqrt(2.0));
        EXPECT_NEAR(k.force[0], f/std::sqrt(2.0), 1e-5*f);
        EXPECT_NEAR(k.force[1], f/std::sqrt(2.0), 1e-5*f);
        EXPECT_NEAR(k.point[0], 0.45, 2e-3);
        EXPECT_EQ(k.b[0], -1);
        EXPECT_EQ(scene->particles().contacts[0], 1);
    }
}

//- A plate that moves up carries a particle along at its speed; a turning one (friction) drags it
TEST_P(DemWalls, MovingWalls)
{
    DemConfig c = config(3);
    c.gravity = Vector3{{0, -9.81, 0}};
    c.tangential = "history";
    DemInput in = oneMaterial();
    in.pairs[0].properties.friction = 0.5;
    in.pairs[0].properties.restitution = 0.2;
    DemWall w = meshedPlane(3, 10);
    w.motion = 0;
    in.walls.push_back(w);
    in.wallMotion = [](int, double t)
    {
        WallPose p;
        p.translation = Vector3{{0, 0.1*t, 0}};
        return p;
    };
    const double rest = -0.19 - 0.01*9.81/1e4;
    addParticle(in, {{0.1, rest, 0}});
    auto scene = createDemScene(c, in);
    DemReport r = scene->advance(0.5);
    EXPECT_EQ(r.stop, DemStop::none) << r.stopMessage;
    DemState s = scene->particles();
    EXPECT_NEAR(s.position[1], rest + 0.05, mixed() ? 1e-8 : 1e-9);
    EXPECT_NEAR(s.velocity[1], 0.1, 1e-4);

    in.wallMotion = [](int, double t)       // turns about the vertical axis through the particle
    {
        WallPose p;
        const double a = 3*t, q = std::cos(a), s = std::sin(a);
        p.rotation = {{q, 0, s, 0, 1, 0, -s, 0, q}};
        return p;
    };
    scene = createDemScene(c, in);
    r = scene->advance(0.05);
    EXPECT_EQ(r.stop, DemStop::none) << r.stopMessage;
    s = scene->particles();
    // The surface runs at w x r = (0, 3, 0) x (0.1, ., 0) = (0, 0, -0.3). The sphere slides until
    // 0.3/(3.5 mu g) = 0.017 s, then rolls with 2/7 of it, and is turned with 2/7 of w (turntable):
    // by 1 - cos(0.03) = 4e-4 of it until the end
    EXPECT_NEAR(s.velocity[2], -0.3*2/7, 1e-3*0.3);
    EXPECT_NEAR(s.velocity[2] - 0.01*s.spin[0], -0.3, 1e-3*0.3) << "it rolls: no slip at the floor";
}

//- Motions are asked for neither before the run nor after its target, where a table may end; an
//  accelerated plate and a group that moves alike are where the motion says at every target all the
//  same: x = a t^2/2, exact at the samples, for the table's polynomial
TEST_P(DemWalls, MotionsAreAskedForWithinTheRun)
{
    DemConfig c = config(3);
    c.startTime = 2;
    DemInput in = oneMaterial();
    DemWall w = planeWall({{0, -0.2, 0}}, {{0, 1, 0}});
    w.motion = 0;
    in.walls.push_back(w);
    in.groups.resize(2);
    in.groups[1].motion = 0;
    double now = 2, target = 2.001;             // at the start a step or two may be looked ahead
    bool within = true;
    const double a = 30;
    in.wallMotion = [&](int, double t)
    {
        within = within && t >= now && t <= target;
        WallPose p;
        p.translation[1] = 0.5*a*(t - 2)*(t - 2);
        return p;
    };
    in.groupMotion = [&](int, double t)
    {
        within = within && t >= now && t <= target;
        RigidMotion m;
        m.velocity[1] = a*(t - 2);
        return m;
    };
    // carried by the plate; carried by the group's motion
    addParticle(in, {{0, -0.19 - 0.01*a/1e4, 0}});
    addParticle(in, {{0.2, 0.1, 0}});
    in.particles.group = {0, 1};
    auto scene = createDemScene(c, in);
    for (const double next : {2.001, 2.00105, 2.05, 2.0500001, 2.1})
    {
        now = scene->time();
        target = next;
        const DemReport r = scene->advance(next);
        ASSERT_EQ(r.stop, DemStop::none) << r.stopMessage;
        ASSERT_TRUE(within) << next;
        const DemState s = scene->particles();
        const double way = 0.5*a*(next - 2)*(next - 2);
        EXPECT_NEAR(s.position[3*find(s, 1) + 1], 0.1 + way, mixed() ? 1e-8 : 1e-9);
    }
    // it was started at rest with its plate: half a step's kick is all it is apart
    const DemState s = scene->particles();
    EXPECT_NEAR(s.position[3*find(s, 0) + 1], -0.19 - 0.01*a/1e4 + 0.5*a*0.01, 1e-5);
}

//- A wall faster than detection stops the run
TEST_P(DemWalls, TooFastWallIsRefused)
{
    DemConfig c = config(3);
    DemInput in = oneMaterial();
    DemWall w = planeWall({{0, -0.2, 0}}, {{0, 1, 0}});
    w.motion = 0;
    in.walls.push_back(w);
    in.wallMotion = [](int, double t) { WallPose p; p.translation[1] = 1000*t; return p; };
    addParticle(in, {{0, 0, 0}});
    const DemReport r = createDemScene(c, in)->advance(1);
    EXPECT_EQ(r.stop, DemStop::tooFast);
    EXPECT_NE(r.stopMessage.find("wall"), std::string::npos);
}

//- A soft body that is pressed through a plate beyond its centre comes back on the side that it
//  came from, with all of its energy; one that not even a whole diameter of overlap holds is said
//  to have passed
TEST_P(DemWalls, SoftBodiesStayOnTheirSide)
{
    for (const int D : {2, 3})
        // overlaps of 0.6, 1.6, 1.9 and 2.8 radii
        for (const double speed : {2.0, 5.0, 6.0, 9.0})
        {
            DemConfig c = config(D);
            DemInput in = oneMaterial(1e3);
            in.walls.push_back(meshedPlane(D, 4));
            addParticle(in, {{0.013, -0.18, 0.07}}, {{0.3, -speed, 0}});
            in.particles.id = {5};
            auto scene = createDemScene(c, in);
            const double before = scene->energy().total();
            DemReport r = scene->advance(0.2/speed);
            ASSERT_EQ(r.stop, DemStop::none) << r.stopMessage;
            const DemState s = scene->particles();
            ASSERT_EQ(s.id.size(), 1u);
            if (speed > 8)
            {
                EXPECT_LT(s.position[1], -0.2);
                EXPECT_EQ(r.passedWalls, 1u);
                EXPECT_EQ(r.passedId, 5);
                EXPECT_EQ(scene->advance(0.21/speed).passedWalls, 0u);
                continue;
            }
            EXPECT_EQ(r.passedWalls, 0u);
            EXPECT_GT(s.position[1], -0.2);
            EXPECT_NEAR(s.velocity[1], speed, 1e-3*speed) << D << " " << speed;
            EXPECT_NEAR(s.velocity[0], 0.3, 1e-9);
            EXPECT_NEAR(scene->energy().total(), before, 2e-3*before);
        }
}

//- While it is on the other side the overlap is more than its radius, and grows as far as it goes
TEST_P(DemWalls, OverlapOfOneThatIsPressedThrough)
{
    DemConfig c = config(3);
    DemInput in = oneMaterial(1e3);
    in.walls.push_back(meshedPlane(3, 4));
    addParticle(in, {{0.013, -0.18, 0.07}}, {{0, -5, 0}});
    auto scene = createDemScene(c, in);
    double deepest = 0;
    for (int k = 0; k < 400; ++k)
    {
        scene->advance(1e9, 1);
        const double height = scene->particles().position[1] + 0.2;
        deepest = std::min(deepest, height);
        if (height < 0.0099) { EXPECT_NEAR(scene->deepestOverlap(), (0.01 - height)/0.02, 1e-5); }
    }
    EXPECT_NEAR(deepest, 0.01 - 5*std::sqrt(0.01/1e3), 2e-4);
}

//- The same at the end of the domain, where its centre is outside meanwhile: it has not escaped
//  where a wall is said to stand there
TEST_P(DemWalls, PressedIntoTheWallOfTheDomain)
{
    for (const int D : {2, 3})
        for (const bool walled : {true, false})
        {
            DemConfig c = config(D);
            c.domainMin[1] = -0.2;
            c.walled[1][0] = walled;
            DemInput in = oneMaterial(1e3);
            in.walls.push_back(meshedPlane(D, 4));
            addParticle(in, {{0.013, -0.18, 0.07}}, {{0, -5, 0}});
            auto scene = createDemScene(c, in);
            const DemReport r = scene->advance(0.04);
            EXPECT_EQ(r.escaped.size(), walled ? 0u : 1u) << D;
            if (walled) { EXPECT_NEAR(scene->particles().velocity[1], 5, 5e-3); }
        }
}

DemInput dumbbell(Vector3 inertia, Vector3 spin)
{
    DemInput in = oneMaterial();
    DemClump k;
    k.mass = 0.05;
    k.inertia = inertia;
    k.spin = spin;
    k.velocity = Vector3{{0.1, 0, 0}};
    in.clumps.push_back(k);
    for (const double x : {-0.02, 0.02})
    {
        addParticle(in, {{x, 0, 0}}, {{0, 0, 0}}, 0.015);
        in.particles.clump.push_back(0);
    }
    return in;
}

//- Velocity and spin of a body are those of now, not of half a step ago: under a force and a moment
//  that stay v = F t/m and w = M t/I
TEST_P(DemWalls, ClumpsVelocityAndSpinAreOfNow)
{
    for (const std::string kind : {"leapfrog", "velocityVerlet"})
    {
        DemConfig c = config(3);
        c.integrator = kind;
        c.timeStep = 1e-4;
        DemInput in = dumbbell(Vector3{{1e-5, 1e-5, 1e-5}}, Vector3{{0, 0, 0}});
        in.groups.resize(1);
        in.groups[0].force = Vector3{{0, 0.01, 0}};
        in.groups[0].moment = Vector3{{0, 0, 2e-5}};
        auto scene = createDemScene(c, in);
        scene->advance(1e-2);
        const DemClumpState s = scene->clumps();
        EXPECT_NEAR(s.velocity[1], 0.01*1e-2/0.05, 1e-8);
        EXPECT_NEAR(s.spin[2], 2e-5*1e-2/1e-5, 1e-7);
        const double rotation = 0.5*1e-5*s.spin[2]*s.spin[2];
        EXPECT_NEAR(scene->energy().rotation, rotation, 1e-9*rotation);
    }
}

//- Free rotation: about a principal axis as a clock; about the middle axis it tumbles, with energy
//  and angular momentum kept
TEST_P(DemWalls, ClumpTurnsFreely)
{
    for (const int D : {2, 3})
    {
        DemConfig c = config(D);
        c.timeStep = 1e-4;
        auto scene = createDemScene(c, dumbbell({{1e-5, 2e-5, 3e-5}}, {{0, 0, 10}}));
        scene->advance(0.5);
        const DemClumpState s = scene->clumps();
        EXPECT_NEAR(s.position[0], 0.05, 1e-9);
        EXPECT_NEAR(s.spin[2], 10, 1e-9);
        EXPECT_NEAR(2*std::atan2(s.orientation[3], s.orientation[0]), 5, 1e-9);
        const DemState p = scene->particles();
        const double expected = s.position[0] + 0.02*std::cos(5.0);
        EXPECT_NEAR(p.position[3*find(p, 1)], expected, 1e-9);
    }
    DemConfig c = config(3);
    c.timeStep = 1e-4;
    auto scene = createDemScene(c, dumbbell({{1e-5, 2e-5, 3e-5}}, {{0.1, 10, 0.1}}));
    const double before = scene->energy().rotation;
    double least = 10;
    for (int k = 1; k <= 20; ++k)
    {
        scene->advance(0.1*k);
        least = std::min(least, scene->clumps().spin[1]);
        // second order in w dt = 1e-3
        EXPECT_NEAR(scene->energy().rotation, before, 1e-5*before);
    }
    // the spin in space stays near L, though the body turns over
    EXPECT_GT(least, 5);
}

//- A clump of one sphere is a sphere
TEST_P(DemWalls, ClumpOfOneIsASphere)
{
    Vector3 x[2], w[2];
    for (const bool clump : {false, true})
    {
        DemConfig c = config(3);
        c.gravity = Vector3{{1, -9.81, 0}};
        c.tangential = "history";
        c.timeStep = 2e-5;
        DemInput in = oneMaterial();
        in.pairs[0].properties.friction = 0.3;
        in.pairs[0].properties.restitution = 0.7;
        in.walls.push_back(planeWall({{0, -0.2, 0}}, {{0, 1, 0}}));
        addParticle(in, {{-0.1, -0.1, 0}});
        if (clump)
        {
            DemClump k;
            k.position = Vector3{{-0.1, -0.1, 0}};
            k.mass = 0.01;
            k.inertia = Vector3{{4e-7, 4e-7, 4e-7}};
            in.clumps.push_back(k);
            in.particles.clump.push_back(0);
        }
        auto scene = createDemScene(c, in);
        scene->advance(0.4);
        const DemState s = scene->particles();
        x[clump] = at(s.position, 0);
        w[clump] = clump ? at(scene->clumps().spin, 0) : at(s.spin, 0);
    }
    for (int d = 0; d < 3; ++d)
    {
        // after several bounces; a clump turns in double, a particle in single precision
        EXPECT_NEAR(x[0][d], x[1][d], mixed() ? 1e-5 : 1e-10);
        EXPECT_NEAR(w[0][d], w[1][d], mixed() ? 2e-2 : 1e-6);
    }
}

//- A dumbbell dropped flat comes to rest on both spheres, which share its weight
TEST_P(DemWalls, ClumpRests)
{
    for (const int D : {2, 3})
    {
        DemConfig c = config(D);
        c.gravity = Vector3{{0, -9.81, 0}};
        c.tangential = "history";
        c.timeStep = 2e-5;
        DemInput in = dumbbell({{1e-5, 2e-5, 2e-5}}, {{0, 0, 0}});
        in.clumps[0].velocity = Vector3{{0, 0, 0}};
        in.pairs[0].properties.friction = 0.3;
        in.pairs[0].properties.restitution = 0.2;
        in.walls.push_back(planeWall({{0, -0.02, 0}}, {{0, 1, 0}}));
        auto scene = createDemScene(c, in);
        const DemReport r = scene->advance(0.8);
        ASSERT_EQ(r.stop, DemStop::none) << r.stopMessage;
        EXPECT_NEAR(scene->clumps().position[1], -0.005 - 0.5*0.05*9.81/1e4, 2e-8);
        EXPECT_NEAR(scene->wallForces()[0].force[1], -0.05*9.81, 1e-3);
    }
}

RIPRAP_DEM_CASES(DemWalls);

} // namespace
} // namespace riprap

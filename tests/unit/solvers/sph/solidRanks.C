/*  Solids in the water of several ranks (threads here): each has all of them, and the bits of one
    process.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "coupling/boxFaces.hpp"
#include "rankedTank.hpp"

namespace riprap
{
namespace
{

const std::string allKinds[] = {
    "stationary", "pressureGradient", "pressureApproximation", "extrapolated"};
const std::string allForces[] = {"held", "interpolated", "impulse"};

enum class Make {loose, bonded, rigid};

class SolidRanks : public RankedTank
{
protected:

    SolidInput solids_;

    std::unique_ptr<SphScene> make(const SphConfig& c, const FluidInput& f, const WallInput& w,
        const WallMotion& motion) const override
    {
        SolidInput solids = solids_;
        solids.config.ranks = c.ranks;      // which the scene does not heed
        return createSphDemScene(c, f, w, solids, motion);
    }

    SphConfig basin() const
    {
        SphConfig c = damBreak(D() == 2 ? 0.025 : 0.0625);
        c.maxDensityDeviation = 0.5;
        c.maxVelocity = 4;
        c.soundSpeed = 40;
        return c;
    }

    //- No solids yet; a floor for them at y = 0
    void begin(const SphConfig& c)
    {
        SolidInput& s = solids_;
        s = SolidInput();
        s.config.dimensions = D();
        s.config.domainMin = c.domainMin;
        s.config.domainMax = c.domainMax;
        for (int d = 0; d < 3; ++d) s.config.periodic[d] = c.periodic[d];
        s.config.normal = "linear";
        s.config.tangential = "none";
        s.config.integrator = "velocityVerlet";
        s.config.stepFraction = 0.3;
        s.input.materials.push_back(DemMaterial{"rubber", 1e6, 0.3});
        DemPair p;
        p.properties.normalStiffness = 1e5;
        s.input.pairs.push_back(p);
        for (const char* name : {"free", "held"})
        {
            s.input.groups.emplace_back();
            s.input.groups.back().name = name;
        }
        for (bool& held : s.input.groups[1].held) held = true;
        s.input.groups[1].heldSpin = true;
        DemWall floor;
        floor.plane = true;
        floor.normal = {{0, 1, 0}};
        s.input.walls.push_back(floor);
        s.coupling.xsph = s.coupling.antiClump = true;
        s.input.particles.clump.clear();
    }

    //- A block of particles of the given size from its lower corner on, in place of water. In 3D
    //  `across` deep. \return its first particle
    std::size_t add(const SphConfig& c, Make kind, const Vector3& lower, int nx, int ny, int across,
        double size, double density, FluidInput& f, const Vector3& velocity = {{0, 0, 0}})
    {
        DemParticles& p = solids_.input.particles;
        const std::size_t first = p.size();
        const int n[3] = {nx, ny, D() == 3 ? across : 1};
        const double mass = density*std::pow(size, D());
        for (int k = 0; k < n[2]; ++k)
            for (int j = 0; j < n[1]; ++j)
                for (int i = 0; i < n[0]; ++i)
                {
                    const int index[3] = {i, j, k};
                    for (int d = 0; d < 3; ++d)
                        p.position.push_back(d < D() ? lower[d] + (index[d] + 0.5)*size : 0);
                    p.velocity.insert(p.velocity.end(), velocity.begin(), velocity.end());
                    p.radius.push_back(0.5*size);
                    p.mass.push_back(mass);
                    p.group.push_back(0);
                    p.clump.push_back(-1);
                    solids_.volume.push_back(std::pow(size, D()));
                }
        Vector3 upper = lower;
        for (int d = 0; d < D(); ++d) upper[d] += n[d]*size;
        clear(c, lower, upper, f);
        if (kind == Make::rigid) makeRigid(first, velocity);
        if (kind == Make::bonded) bond(first, size);
        return first;
    }

    //- Neighbours in the lattice
    void bond(std::size_t first, double size)
    {
        DemInput& in = solids_.input;
        if (in.bondTypes.empty())
        {
            in.bondTypes.emplace_back();
            in.bondTypes[0].normalStiffness = 2e6/size;
            in.bondTypes[0].shearStiffness = 1e6/size;
        }
        for (std::size_t i = first; i < in.particles.size(); ++i)
            for (std::size_t j = i + 1; j < in.particles.size(); ++j)
            {
                double r2 = 0;
                for (int d = 0; d < D(); ++d)
                    r2 += std::pow(in.particles.position[3*i + d] - in.particles.position[3*j + d],
                        2);
                if (r2 > 1.01*size*size) continue;
                in.bonds.a.push_back(std::int32_t(i));
                in.bonds.b.push_back(std::int32_t(j));
            }
    }

    void makeRigid(std::size_t first, const Vector3& velocity)
    {
        DemParticles& p = solids_.input.particles;
        const double n = double(p.size() - first);
        DemClump body;
        body.velocity = velocity;
        for (std::size_t i = first; i < p.size(); ++i)
        {
            p.clump[i] = std::int32_t(solids_.input.clumps.size());
            body.mass += p.mass[i];
            for (int d = 0; d < 3; ++d) body.position[d] += p.position[3*i + d]/n;
        }
        for (std::size_t i = first; i < p.size(); ++i)
            for (int d = 0; d < 3; ++d)
                for (int e = 0; e < 3; ++e)
                    if (e != d)
                        body.inertia[d] += p.mass[i]
                            *std::pow(p.position[3*i + e] - body.position[e], 2);
        if (D() == 2) body.inertia[0] = body.inertia[1] = 0;
        solids_.input.clumps.push_back(body);
    }

    //- A bonded plate across the water, whose lowest row is held
    FluidInput gate(const SphConfig& c)
    {
        begin(c);
        FluidInput f = water(c);
        const double size = D() == 2 ? 0.02 : 0.05;
        const int across = D() == 3 ? 10 : 1, high = D() == 2 ? 16 : 6;
        const std::size_t first = add(c, Make::bonded, {{0.42, 0, 0}}, 2, high, across, size, 1100,
            f);
        auto& p = solids_.input.particles;
        for (std::size_t i = first; i < p.size(); ++i)
            if (p.position[3*i + 1] < size) p.group[i] = 1;
        return f;
    }

    //- Steps in which solids may leave
    static Course course(int n, int each = 10)
    {
        return [=](SphScene& s, Outcome& o)
        {
            for (int k = 0; k < n; k += each)
            {
                include(o, s.advance(1e9, each));
                includeSolids(o, s);
            }
        };
    }

    //- moves: particles change their ranks, if it is not too short for that (3D)
    Outcome expectSameOn(const SphConfig& c, const FluidInput& f, const Course& run,
        const std::vector<int>& ranks, bool moves = true) const
    {
        Outcome one = alone(c, f, walls(c), run);
        EXPECT_EQ(one.report.stop, StopReason::none);
        compare(c, f, walls(c), run, ranks, moves && D() == 2);
        return one;
    }
    int few() const { return D() == 2 ? 40 : 12; }

    //- The water pushes
    static double pushOf(const Outcome& o)
    {
        double most = 0;
        for (const double f : o.solids[0].coupling.force) most = std::max(most, std::abs(f));
        return most;
    }
};

//- Each way to take pressure, and each time at which solids get the force
TEST_P(SolidRanks, everyCoupling)
{
    const SphConfig c = basin();
    const FluidInput f = gate(c);
    for (const std::string& kind : allKinds)
        for (const std::string& force : allForces)
        {
            // in 3D each of both, in 2D each with each
            if (D() == 3 && kind != "extrapolated" && force != "held") continue;
            SCOPED_TRACE(kind + ", " + force);
            solids_.coupling.kind = kind;
            solids_.coupling.force = force;
            EXPECT_GT(pushOf(expectSameOn(c, f, course(few()), {3}, false)), 0);
        }
}

TEST_P(SolidRanks, elasticGate)
{
    const SphConfig c = basin();
    const FluidInput f = gate(c);
    const Outcome one = expectSameOn(c, f, course(D() == 2 ? 150 : 40), {2, 3, 4});
    EXPECT_GT(one.solids[0].energy.bond, 0);
}

TEST_P(SolidRanks, leapfrog)
{
    SphConfig c = basin();
    c.integrator = "leapfrog";
    const FluidInput f = gate(c);
    for (const std::string& force : allForces)
    {
        solids_.coupling.force = force;
        solids_.config.integrator = force == "held" ? "leapfrog" : "velocityVerlet";
        expectSameOn(c, f, course(few()), {3}, false);
    }
}

//- Bodies longer than a brick, with faces that water hits
TEST_P(SolidRanks, rigidBodies)
{
    SphConfig c = basin();
    c.maxSpeedRatio = 10;
    c.maxDensityDeviation = 2;
    begin(c);
    FluidInput f = water(c);
    const double size = c.spacing;
    const int across = D() == 3 ? 3 : 1, n = D() == 2 ? 10 : 4;
    add(c, Make::rigid, {{0.1, 0.2, 0.1}}, n, 3, across, size, 600, f);
    add(c, Make::rigid, {{0.42, 0.05, 0.1}}, 3, 3, across, size, 1500, f, {{-1, 0, 0}});
    addBoxFaces(solids_.faces, D(), 0, {{0.5*n*size, 1.5*size, 1.5*size}});
    addBoxFaces(solids_.faces, D(), 1, {{1.5*size, 1.5*size, 1.5*size}});
    // drops that fly at it, faster than pressure stops them
    const double z = D() == 3 ? 0.1 : 0;
    const FluidInput drops = lattice(
        c, {{0.42, 0.2, z}}, {{0.42 + 3*size, 0.2 + 3*size, D() == 3 ? z + 3*size : 0}});
    f.position.insert(f.position.end(), drops.position.begin(), drops.position.end());
    f.density.insert(f.density.end(), drops.density.begin(), drops.density.end());
    for (std::size_t i = 0; i < drops.size(); ++i)
        f.velocity.insert(f.velocity.end(), {0.5, -25, 0});
    for (const std::string force : {"held", "impulse"})
    {
        solids_.coupling.force = force;
        const bool held = force == "held";
        const Outcome one = expectSameOn(c, f, course(D() == 2 ? 100 : 40),
            held ? std::vector<int>{2, 3, 4} : std::vector<int>{3});
        EXPECT_GT(one.faces.atBodies, 0);
        EXPECT_NE(one.solids[0].bodies.spin[2], 0);
    }
}

//- Spheres that fall into the water and float, and bounce off the floor and each other
TEST_P(SolidRanks, freeSpheres)
{
    const SphConfig c = basin();
    begin(c);
    FluidInput f = water(c);
    add(c, Make::loose, {{0.05, 0.41, 0.1}}, 12, 2, 3, 0.8*c.spacing, 700, f, {{1, -2, 0}});
    add(c, Make::loose, {{0.1, 0.1, 0.1}}, 3, 3, 3, c.spacing, 2500, f);
    const Outcome one = expectSameOn(c, f, course(D() == 2 ? 100 : 25), {2, 3, 4});
    EXPECT_GT(pushOf(one), 0);
}

//- Solids that never move
TEST_P(SolidRanks, heldSolids)
{
    const SphConfig c = basin();
    begin(c);
    FluidInput f = water(c);
    add(c, Make::loose, {{0.42, 0, 0}}, 3, 4, 8, c.spacing, 2500, f);
    for (auto& g : solids_.input.particles.group) g = 1;
    EXPECT_GT(pushOf(expectSameOn(c, f, course(D() == 2 ? 100 : 30), {2, 4})), 0);
}

//- A bar that is driven through the bricks of all ranks
TEST_P(SolidRanks, prescribedMotion)
{
    const SphConfig c = basin();
    begin(c);
    FluidInput f = water(c);
    add(c, Make::loose, {{0.3, 0.05, 0}}, 2, D() == 2 ? 8 : 3, 6, c.spacing, 2500, f);
    solids_.input.groups[0].motion = 0;
    solids_.input.groupMotion = [](int, double t)
    {
        RigidMotion m;
        m.velocity = {{-4*(1 - std::exp(-200*t)), 0, 0}};
        return m;
    };
    const Outcome one = expectSameOn(c, f, course(D() == 2 ? 120 : 40), {2, 3, 4});
    EXPECT_LT(one.solids[0].state.position[0], 0.28);
}

TEST_P(SolidRanks, bondsThatBreak)
{
    const SphConfig c = basin();
    const FluidInput f = gate(c);
    solids_.input.bondTypes[0].tensileStrength = solids_.input.bondTypes[0].shearStrength = 2e3;
    const Outcome one = expectSameOn(c, f, course(D() == 2 ? 150 : 40), {3, 4});
    EXPECT_GT(one.solids[0].report.brokenBonds, 2u);
}

//- Spheres and a body leave through the top; each rank says so
TEST_P(SolidRanks, solidsLeaveTheDomain)
{
    const SphConfig c = basin();
    begin(c);
    FluidInput f = water(c);
    add(c, Make::loose, {{0.1, 0.36, 0.1}}, 4, 2, 2, c.spacing, 900, f, {{0, 14, 0}});
    add(c, Make::rigid, {{0.6, 0.7, 0.1}}, 3, 2, 2, c.spacing, 900, f, {{0, 8, 0}});
    const Course run = [](SphScene& s, Outcome& o)
    {
        for (int k = 1; k <= 3; ++k) { include(o, s.advance(0.022*k)); includeSolids(o, s); }
    };
    const Outcome one = expectSameOn(c, f, run, {3}, false);
    EXPECT_GT(one.solids[0].escapedId.size(), D() == 2 ? 6u : 12u);
}

//- Far from the water at first; then one rank alone sees them
TEST_P(SolidRanks, solidsThatMeetWaterLater)
{
    const SphConfig c = basin();
    begin(c);
    FluidInput f = water(c);
    add(c, Make::bonded, {{0.8, 0.1, 0.1}}, 4, 2, 2, c.spacing, 900, f, {{-6, 0, 0}});
    const Course run = [](SphScene& s, Outcome& o)
    {
        include(o, s.advance(1e9, 3));
        for (const double x : s.coupling().force) EXPECT_EQ(x, 0);
        include(o, s.advance(0.06));
    };
    EXPECT_GT(pushOf(expectSameOn(c, f, run, {2, 3}, false)), 0);
}

TEST_P(SolidRanks, moreRanksThanWater)
{
    const SphConfig c = basin();
    begin(c);
    FluidInput f = oneParticle(D(), {{0.3, 0.1, 0.2}}, {{0.5, 0, 0}});
    const FluidInput other = oneParticle(D(), {{0.37, 0.1, 0.2}}, {{-0.5, 0, 0}});
    f.position.insert(f.position.end(), other.position.begin(), other.position.end());
    f.velocity.insert(f.velocity.end(), other.velocity.begin(), other.velocity.end());
    f.density.push_back(1001);
    FluidInput none;
    add(c, Make::loose, {{0.2, 0.02, 0.1}}, 8, 2, 3, c.spacing, 900, none);
    EXPECT_GT(pushOf(expectSameOn(c, f, course(60), {5}, false)), 0);
}

//- Through periodic sides, with water that runs fast
TEST_P(SolidRanks, periodicSides)
{
    SphConfig c = basin();
    c.spacing = c.wallSpacing = D() == 2 ? 0.025 : 0.05;
    c.domainMin = {{0, -0.2, 0}};
    c.domainMax = {{1, 1, 0.5}};
    c.periodic[0] = true;
    c.periodic[2] = D() == 3;
    begin(c);
    FluidInput f = lattice(c, {{0, 0, 0}}, {{1, 0.3, D() == 3 ? 0.5 : 0.0}});
    disturb(c, f, 0.05, 0.2, 0.001);
    for (std::size_t i = 0; i < f.size(); ++i) f.velocity[3*i] += 4;
    add(c, Make::rigid, {{D() == 2 ? 0.89 : 0.82, 0.1, 0.2}}, 4, 3, 3, c.spacing, 900, f,
        {{4, 0, 2}});
    const auto floor = [&]
    {
        WallInput w;
        SphConfig points = c;
        const double z1 = D() == 3 ? 0.5 : 0;
        w.position = lattice(points, {{0, -layers*c.spacing, 0}}, {{1, 0, z1}}).position;
        for (std::size_t i = 0; i < w.size(); ++i) w.normal.insert(w.normal.end(), {0, 1, 0});
        return w;
    }();
    const Course run = course(D() == 2 ? 120 : 40);
    const Outcome one = alone(c, f, floor, run);
    EXPECT_EQ(one.report.stop, StopReason::none);
    double least = 1;               // in no order: a GPU sorts them
    for (std::size_t i = 0; i < one.solids[0].state.id.size(); ++i)
        least = std::min(least, one.solids[0].state.position[3*i]);
    EXPECT_LT(least, 0.5) << "through the side";
    compare(c, f, floor, run, {2, 3}, D() == 2);
}

//- Moving walls and solids in one tank
TEST_P(SolidRanks, besideMovingWalls)
{
    const SphConfig c = basin();
    const FluidInput f = gate(c);
    WallInput w = walls(c);
    makePiston(w);
    const Course run = [](SphScene& s, Outcome& o) { include(o, s.advance(0.05)); };
    compare(c, f, w, run, {3}, false, pistonMotion());
}

//- 4, 1 and 3 ranks go on with each other's states, and end with the words of one process
TEST_P(SolidRanks, savedStates)
{
    const SphConfig c = basin();
    for (const std::string force : {"interpolated", "impulse"})
    {
        FluidInput f = gate(c);
        add(c, Make::rigid, {{0.1, 0.2, 0.1}}, 4, 3, 3, c.spacing, 600, f);
        addBoxFaces(solids_.faces, D(), 0, {{2*c.spacing, 1.5*c.spacing, 1.5*c.spacing}});
        // far from the water: of their forces words have the sign of zero
        add(c, Make::loose, {{0.8, 0.3, 0.1}}, 2, 2, 2, c.spacing, 900, f);
        solids_.coupling.force = force;
        compareGoingOn(c, f, walls(c), {4, 1, 3},
            [](SphScene& scene, Outcome& o) { include(o, scene.advance(1e9, 25)); });
    }
}

//- In pieces, with states saved and all that is read back between: the same run
TEST_P(SolidRanks, piecesAndReadings)
{
    const SphConfig c = basin();
    const FluidInput f = gate(c);
    const Course run = [](SphScene& s, Outcome& o)
    {
        for (int k = 1; k <= 3; ++k)
        {
            include(o, s.advance(0.01*k));
            s.saveState();
            Outcome between;
            readBack(between, s);
        }
    };
    compare(c, f, walls(c), run, {3}, false);
}

//- Solids that run away stop all ranks at the same step, with the same words
TEST_P(SolidRanks, guardOfSolids)
{
    const SphConfig c = basin();
    FluidInput f = gate(c);
    add(c, Make::loose, {{0.7, 0.5, 0.1}}, 1, 1, 1, c.spacing, 900, f, {{1e7, 0, 0}});
    const Outcome one = alone(c, f, walls(c), stepsOf(30)),
                  three = onSeveral(3, c, f, walls(c), stepsOf(30));
    EXPECT_EQ(one.report.stop, StopReason::solids);
    EXPECT_EQ(three.report.stop, StopReason::solids);
    EXPECT_NE(one.solids[0].report.stopMessage, "");
    expectSame(one, three);
}

//- As on one process, by all
TEST_P(SolidRanks, sleepIsRefused)
{
    const SphConfig c = basin();
    const FluidInput f = gate(c);
    solids_.config.sleepAfter = solids_.config.sleepSpeed = 0.1;
    onRanks(2, [&](Transport& transport)
    {
        SphConfig own(c);
        own.ranks = &transport;
        try { make(own, f, walls(c), WallMotion()); }
        catch (const std::invalid_argument& e)
        {
            if (std::string(e.what()).find("do not sleep") == std::string::npos) throw;
            return;
        }
        throw std::logic_error("accepted");
    });
}

} // namespace

RIPRAP_ALL_SETUPS(SolidRanks);

} // namespace riprap

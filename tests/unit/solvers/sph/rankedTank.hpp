/*  A dam break and others in a tank on several ranks, threads here, beside one process: what runs
    end with, and whether it is the same.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <functional>
#include <set>
#include "tankScene.hpp"
#include "core/threadRanks.hpp"
#include "api/wholeSphScene.hpp"
#include "api/sphDemScene.hpp"

namespace riprap
{

//- What a run ends with, of all ranks together
struct Outcome
{
    FluidState fluid;               // by id
    WallState walls;
    SphReport report;
    SphEnergy energy;
    FluidExtremes extremes;
    FluidEnd end;
    FaceContacts faces;
    std::vector<Vector3> wallForces;
    std::vector<FluidForce> places;
    SampleResult sample;
    NeighbourCounts neighbours;
    std::array<std::size_t, SphScene::speedClasses> faster;
    std::string limit;
    double step = 0;
    std::vector<Vector3> escaped;
    std::vector<std::int32_t> escapedId, wild;
    std::int64_t steps = 0, rebuilds = 0, arrivals = 0, divisions = 0, ghosts = 0;
    double mostOwned = 0;
};

inline FluidState sorted(const FluidState& s)
{
    std::vector<std::size_t> order(s.id.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(),
        [&](std::size_t a, std::size_t b) { return s.id[a] < s.id[b]; });
    FluidState r;
    for (const std::size_t i : order)
    {
        r.id.push_back(s.id[i]);
        r.position.insert(r.position.end(), &s.position[3*i], &s.position[3*i] + 3);
        r.velocity.insert(r.velocity.end(), &s.velocity[3*i], &s.velocity[3*i] + 3);
        r.density.push_back(s.density[i]);
        r.pressure.push_back(s.pressure[i]);
        r.smoothingLength.push_back(s.smoothingLength[i]);
    }
    return r;
}

inline void include(Outcome& o, const SphReport& r)
{
    o.report = r;
    o.steps += r.steps;
    o.rebuilds += r.rebuilds;
    o.escaped.insert(o.escaped.end(), r.escaped.begin(), r.escaped.end());
    o.escapedId.insert(o.escapedId.end(), r.escapedId.begin(), r.escapedId.end());
    for (const WildParticle& w : r.wild) o.wild.push_back(w.id);
}

//- All that is read back of a scene; reading moves nothing
inline void readBack(Outcome& o, SphScene& s)
{
    std::vector<double> points;
    for (int i = 0; i < 12; ++i)
        for (int j = 0; j < 6; ++j)
            for (const double z : {0.0, 0.3})
                points.insert(points.end(), {-0.05 + 0.1*i, 0.02 + 0.1*j, z});
    o.fluid = sorted(s.fluid());
    o.energy = s.energy();
    o.extremes = s.extremes();
    o.end = s.farEnd(Vector3{{0.8, 0.6, 0}}, 0.1);
    o.faces = s.faceContacts();
    o.step = s.estimateTimeStep(o.limit);
    o.sample = s.sample(points);
    o.walls = s.walls();
    o.neighbours = s.countNeighbours();
    o.faster = s.fasterThan({{0, 0.01, 0.1, 0.3, 0.5, 1, 2, 4}});
    o.wallForces = s.wallForces();
    o.places = s.forcesOnWalls();
}

using Course = std::function<void(SphScene&, Outcome&)>;

inline Course stepsOf(std::int64_t n)
{
    return [n](SphScene& s, Outcome& o) { include(o, s.advance(1e9, n)); };
}

class RankedTank : public TankScene
{
protected:

    //- As the tutorial damBreak has it
    SphConfig damBreak(double spacing) const
    {
        SphConfig c = tank();
        c.spacing = c.wallSpacing = spacing;
        const double thick = layers*spacing;
        c.domainMin = {{-thick, -thick, -thick}};
        c.domainMax = {{1 + thick, 1, 0.5 + thick}};
        c.integrator = IntegratorKind::symplectic;
        c.variableSmoothing = true;
        c.maxSmoothingGrowth = 1.1;
        c.viscosity = 0.001;
        c.viscosityModel = "laminarAndArtificial";
        c.antiClump = 0.01;
        c.xsph = 0.05;
        c.diffusion = "fourtakas";
        c.acousticCourant = 0.4;
        c.forceCourant = 0.33;
        return c;
    }
    SphConfig damBreak() const { return damBreak(D() == 2 ? 0.02 : 0.05); }

    FluidInput water(const SphConfig& c) const
    {
        FluidInput f = column(c);
        disturb(c, f, 0.05, 0.2, 0.001);
        // so that some soon cross borders
        for (std::size_t i = 0; i < f.size(); ++i) f.velocity[3*i] += 1.5;
        return f;
    }

    static Outcome alone(const SphConfig& c, const FluidInput& f, const WallInput& w,
        const Course& run, const WallMotion& motion = WallMotion())
    {
        Outcome o;
        const auto scene = createSphScene(c, f, w, motion);
        run(*scene, o);
        readBack(o, *scene);
        return o;
    }

    static Outcome onSeveral(int ranks, const SphConfig& c, const FluidInput& f,
        const WallInput& w, const Course& run, const WallMotion& motion = WallMotion())
    {
        Outcome first;
        std::mutex mutex;
        std::int64_t arrivals = 0, ghosts = 0;
        double mostOwned = 0;
        onRanks(ranks, [&](Transport& transport)
        {
            SphConfig own(c);
            own.ranks = &transport;
            const auto part = createSphScene(own, f, w, motion);
            const auto whole = wholeSphScene(*part, transport);
            Outcome o;
            run(*whole, o);
            readBack(o, *whole);
            std::lock_guard<std::mutex> lock(mutex);
            arrivals += o.report.rank.arrivals;
            ghosts += std::int64_t(o.report.rank.ghosts);
            mostOwned = std::max(mostOwned, double(o.report.rank.owned));
            if (transport.rank() == 0) first = o;
        });
        first.arrivals = arrivals;
        first.ghosts = ghosts;
        first.mostOwned = mostOwned;
        first.divisions = first.report.rank.divisions;
        return first;
    }

    static void expectNear(double a, double b, double scale, const char* what)
    {
        EXPECT_NEAR(a, b, 1e-12*scale) << what;
    }

    static std::set<Vector3> points(const std::vector<double>& x)
    {
        std::set<Vector3> all;
        for (std::size_t i = 0; i < x.size(); i += 3)
            all.insert(Vector3{{x[i], x[i + 1], x[i + 2]}});
        return all;
    }

    //- Bits of what moves, and of what is a sum about one place; other sums are added up by rank
    void expectSame(const Outcome& a, const Outcome& b) const
    {
        EXPECT_EQ(a.fluid.id, b.fluid.id);
        EXPECT_EQ(a.fluid.position, b.fluid.position);
        EXPECT_EQ(a.fluid.velocity, b.fluid.velocity);
        EXPECT_EQ(a.fluid.density, b.fluid.density);
        EXPECT_EQ(a.fluid.pressure, b.fluid.pressure);
        EXPECT_EQ(a.fluid.smoothingLength, b.fluid.smoothingLength);
        EXPECT_EQ(a.steps, b.steps);
        EXPECT_EQ(a.rebuilds, b.rebuilds);
        EXPECT_EQ(a.report.time, b.report.time);
        EXPECT_EQ(a.report.lastTimeStep, b.report.lastTimeStep);
        EXPECT_EQ(a.report.limit, b.report.limit);
        EXPECT_EQ(a.report.maxSpeed, b.report.maxSpeed);
        EXPECT_EQ(a.report.maxDensityDeviation, b.report.maxDensityDeviation);
        EXPECT_EQ(a.report.fluid, b.report.fluid);
        EXPECT_FALSE(a.report.skinExceeded);
        EXPECT_FALSE(b.report.skinExceeded);
        EXPECT_EQ(std::set<Vector3>(a.escaped.begin(), a.escaped.end()),
            std::set<Vector3>(b.escaped.begin(), b.escaped.end()));
        EXPECT_EQ(std::set<int>(a.escapedId.begin(), a.escapedId.end()),
            std::set<int>(b.escapedId.begin(), b.escapedId.end()));
        EXPECT_EQ(std::set<int>(a.wild.begin(), a.wild.end()),
            std::set<int>(b.wild.begin(), b.wild.end()));
        EXPECT_EQ(a.walls.position, b.walls.position);
        EXPECT_EQ(a.walls.velocity, b.walls.velocity);
        EXPECT_EQ(a.walls.pressure, b.walls.pressure);
        EXPECT_EQ(a.sample.volumeFraction, b.sample.volumeFraction);
        EXPECT_EQ(a.sample.pressure, b.sample.pressure);
        EXPECT_EQ(a.sample.velocity, b.sample.velocity);
        EXPECT_EQ(a.sample.centroid, b.sample.centroid);
        EXPECT_EQ(a.extremes.speed, b.extremes.speed);
        EXPECT_EQ(a.extremes.densityDeviation, b.extremes.densityDeviation);
        EXPECT_EQ(a.end.particles, b.end.particles);
        EXPECT_EQ(points(a.end.position), points(b.end.position));
        EXPECT_EQ(a.step, b.step);
        EXPECT_EQ(a.limit, b.limit);
        EXPECT_EQ(a.faster, b.faster);
        EXPECT_EQ(a.neighbours.particles, b.neighbours.particles);
        EXPECT_EQ(a.neighbours.fluid, b.neighbours.fluid);
        EXPECT_EQ(a.neighbours.walls, b.neighbours.walls);
        EXPECT_EQ(a.neighbours.aboutWalls, b.neighbours.aboutWalls);
        EXPECT_EQ(a.faces.count, b.faces.count);
        expectSameSums(a, b);
    }

    void expectSameSums(const Outcome& a, const Outcome& b) const
    {
        const double all = a.energy.kinetic + std::abs(a.energy.potential) + a.energy.elastic;
        expectNear(a.energy.kinetic, b.energy.kinetic, all, "kinetic");
        expectNear(a.energy.potential, b.energy.potential, all, "potential");
        expectNear(a.energy.elastic, b.energy.elastic, all, "elastic");
        expectNear(a.energy.faceWork, b.energy.faceWork, all, "work of faces");
        expectNear(a.energy.wallWork, b.energy.wallWork, all, "work of walls");
        expectNear(a.energy.wallPressureWork, b.energy.wallPressureWork, all,
            "work of the pressure of walls");
        expectNear(a.energy.stiffening, b.energy.stiffening, all, "stiffening");
        double force = 1e-6;
        for (const FluidForce& f : a.places)
            for (int d = 0; d < 3; ++d) force += std::abs(f.pressure[d]) + std::abs(f.viscous[d]);
        ASSERT_EQ(a.wallForces.size(), b.wallForces.size());
        for (std::size_t k = 0; k < a.wallForces.size(); ++k)
            for (int d = 0; d < 3; ++d)
                expectNear(a.wallForces[k][d], b.wallForces[k][d], force, "force on walls");
        std::map<Vector3, Vector3> places;
        for (const FluidForce& f : a.places) places[f.place] = f.pressure;
        EXPECT_EQ(a.places.size(), b.places.size());
        for (const FluidForce& f : b.places) EXPECT_EQ(places[f.place], f.pressure);
        for (int d = 0; d < 3; ++d)
            expectNear(a.faces.impulse[d], b.faces.impulse[d], 1, "impulse of faces");
    }

    void compare(const SphConfig& c, const FluidInput& f, const WallInput& w, const Course& run,
        std::vector<int> ranks, bool moves = true,
        const WallMotion& motion = WallMotion()) const
    {
        const Outcome one = alone(c, f, w, run, motion);
        for (const int n : ranks)
        {
            SCOPED_TRACE(std::to_string(n) + " ranks");
            const Outcome o = onSeveral(n, c, f, w, run, motion);
            expectSame(one, o);
            EXPECT_TRUE(!moves || (o.ghosts > 0 && o.arrivals > 0));
            if (testing::Test::HasFailure()) return;
        }
    }
};

#define RIPRAP_CPU_SETUPS(suite) \
    INSTANTIATE_TEST_SUITE_P(, suite, testing::ValuesIn(std::vector<Setup> \
    { \
        {DeviceKind::cpu, 2, PrecisionKind::mixed}, {DeviceKind::cpu, 2, PrecisionKind::doubled}, \
        {DeviceKind::cpu, 3, PrecisionKind::mixed}, {DeviceKind::cpu, 3, PrecisionKind::doubled} \
    }), setupName)

} // namespace riprap

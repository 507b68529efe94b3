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

//- Of solids in the water, of which each rank has all
struct SolidOutcome
{
    DemState state;
    DemClumpState bodies;
    DemBondState bonds;
    DemContacts contacts;
    DemEnergy energy;
    DemGroupSums sums;
    CouplingState coupling;
    std::vector<FluidForce> forces;
    std::vector<DemWallForce> walls;
    std::vector<std::int32_t> escapedId;    // of all calls
    DemReport report;
};

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
    std::vector<SolidOutcome> solids;       // one a rank; none: no solids
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

inline SolidOutcome solidsOf(SphScene& s)
{
    DemScene& d = *s.solids();
    SolidOutcome o;
    o.state = d.particles();
    o.bodies = d.clumps();
    o.bonds = d.bonds();
    o.contacts = d.contacts();
    o.energy = d.energy();
    o.sums = d.groupSums(0);
    o.coupling = s.coupling();
    o.forces = s.forcesOnSolids();
    o.walls = d.wallForces();
    o.report = d.lastReport();
    return o;
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
    if (!s.solids()) return;
    std::vector<std::int32_t> escaped;
    if (!o.solids.empty()) escaped = o.solids[0].escapedId;
    o.solids.assign(1, solidsOf(s));
    o.solids[0].escapedId = escaped;
}

using Course = std::function<void(SphScene&, Outcome&)>;

//- After a call of advance: solids that left in it
inline void includeSolids(Outcome& o, SphScene& s)
{
    if (o.solids.empty()) o.solids.emplace_back();
    const std::vector<std::int32_t> left = s.solids()->lastReport().escapedId;
    std::vector<std::int32_t>& all = o.solids[0].escapedId;
    all.insert(all.end(), left.begin(), left.end());
}

inline Course stepsOf(std::int64_t n)
{
    return [n](SphScene& s, Outcome& o) { include(o, s.advance(1e9, n)); };
}

class RankedTank : public TankScene
{
protected:

    bool gpu() const { return GetParam().device == DeviceKind::gpu; }

    //- As the tutorial damBreak has it
    SphConfig damBreak(double spacing) const
    {
        SphConfig c = tank();
        c.spacing = c.wallSpacing = spacing;
        const double thick = layers*spacing;
        c.domainMin = {{-thick, -thick, -thick}};
        c.domainMax = {{1 + thick, 1, 0.5 + thick}};
        c.integrator = "symplectic";
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

    //- Other fixtures put solids into it
    virtual std::unique_ptr<SphScene> make(const SphConfig& c, const FluidInput& f,
        const WallInput& w, const WallMotion& motion) const
    {
        return createSphScene(c, f, w, motion);
    }

    Outcome alone(const SphConfig& c, const FluidInput& f, const WallInput& w,
        const Course& run, const WallMotion& motion = WallMotion()) const
    {
        Outcome o;
        const auto scene = make(c, f, w, motion);
        run(*scene, o);
        readBack(o, *scene);
        return o;
    }

    Outcome onSeveral(int ranks, const SphConfig& c, const FluidInput& f, const WallInput& w,
        const Course& run, const WallMotion& motion = WallMotion()) const
    {
        Outcome first;
        std::mutex mutex;
        std::int64_t arrivals = 0, ghosts = 0;
        double mostOwned = 0;
        std::vector<SolidOutcome> solids;
        onRanks(ranks, [&](Transport& transport)
        {
            SphConfig own(c);
            own.ranks = &transport;
            const auto part = make(own, f, w, motion);
            const auto whole = wholeSphScene(*part, transport);
            Outcome o;
            run(*whole, o);
            readBack(o, *whole);
            std::lock_guard<std::mutex> lock(mutex);
            arrivals += o.report.rank.arrivals;
            ghosts += std::int64_t(o.report.rank.ghosts);
            mostOwned = std::max(mostOwned, double(o.report.rank.owned));
            solids.insert(solids.end(), o.solids.begin(), o.solids.end());
            if (transport.rank() == 0) first = o;
        });
        first.solids = solids;
        first.arrivals = arrivals;
        first.ghosts = ghosts;
        first.mostOwned = mostOwned;
        first.divisions = first.report.rank.divisions;
        return first;
    }

    //- No water in a box, and half a spacing around it
    static void clear(
        const SphConfig& c, const Vector3& lower, const Vector3& upper, FluidInput& f)
    {
        FluidInput kept;
        for (std::size_t i = 0; i < f.size(); ++i)
        {
            bool beside = false;
            for (int d = 0; d < c.dimensions; ++d)
                beside = beside || f.position[3*i + d] < lower[d] - 0.5*c.spacing
                    || f.position[3*i + d] > upper[d] + 0.5*c.spacing;
            if (!beside) continue;
            kept.position.insert(kept.position.end(), &f.position[3*i], &f.position[3*i] + 3);
            kept.velocity.insert(kept.velocity.end(), &f.velocity[3*i], &f.velocity[3*i] + 3);
            kept.density.push_back(f.density[i]);
        }
        f = kept;
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
        // on GPUs a list that does not fit is made again, and ranks have lists of their own
        EXPECT_TRUE(gpu() || a.rebuilds == b.rebuilds) << a.rebuilds << " " << b.rebuilds;
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
        EXPECT_EQ(a.neighbours.solids, b.neighbours.solids);
        EXPECT_EQ(a.neighbours.aboutSolids, b.neighbours.aboutSolids);
        EXPECT_EQ(a.faces.atBodies, b.faces.atBodies);
        expectSameSums(a, b);
        EXPECT_EQ(a.solids.empty(), b.solids.empty());
        if (!a.solids.empty())
            for (const SolidOutcome& s : b.solids) expectSame(a.solids[0], s);
    }

    //- All bits: each rank does what one process does
    static void expectSame(const SolidOutcome& a, const SolidOutcome& b)
    {
        EXPECT_EQ(a.state.id, b.state.id);
        EXPECT_EQ(a.state.position, b.state.position);
        EXPECT_EQ(a.state.velocity, b.state.velocity);
        EXPECT_EQ(a.state.spin, b.state.spin);
        EXPECT_EQ(a.state.force, b.state.force);
        EXPECT_EQ(a.state.moment, b.state.moment);
        EXPECT_EQ(a.state.brokenBonds, b.state.brokenBonds);
        EXPECT_EQ(a.bodies.position, b.bodies.position);
        EXPECT_EQ(a.bodies.velocity, b.bodies.velocity);
        EXPECT_EQ(a.bodies.spin, b.bodies.spin);
        EXPECT_EQ(a.bodies.orientation, b.bodies.orientation);
        EXPECT_EQ(a.bodies.force, b.bodies.force);
        EXPECT_EQ(a.bodies.left, b.bodies.left);
        EXPECT_EQ(a.bonds.number, b.bonds.number);
        EXPECT_EQ(a.bonds.broken, b.bonds.broken);
        EXPECT_EQ(a.bonds.force, b.bonds.force);
        EXPECT_EQ(a.contacts.a, b.contacts.a);
        EXPECT_EQ(a.contacts.force, b.contacts.force);
        EXPECT_EQ(a.energy.total(), b.energy.total());
        EXPECT_EQ(a.sums.momentum, b.sums.momentum);
        EXPECT_EQ(a.coupling.force, b.coupling.force);
        EXPECT_EQ(a.coupling.total, b.coupling.total);
        EXPECT_EQ(a.coupling.pending, b.coupling.pending);
        EXPECT_EQ(a.coupling.subcycles, b.coupling.subcycles);
        ASSERT_EQ(a.forces.size(), b.forces.size());
        for (std::size_t i = 0; i < a.forces.size(); ++i)
        {
            EXPECT_EQ(a.forces[i].place, b.forces[i].place);
            EXPECT_EQ(a.forces[i].pressure, b.forces[i].pressure);
            EXPECT_EQ(a.forces[i].viscous, b.forces[i].viscous);
        }
        for (std::size_t i = 0; i < a.walls.size(); ++i)
            EXPECT_EQ(a.walls[i].force, b.walls[i].force);
        EXPECT_EQ(a.escapedId, b.escapedId);
        EXPECT_EQ(a.report.totalSteps, b.report.totalSteps);
        EXPECT_EQ(a.report.brokenBonds, b.report.brokenBonds);
        EXPECT_EQ(a.report.particles, b.report.particles);
        EXPECT_EQ(a.report.stopMessage, b.report.stopMessage);
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
        const std::vector<int>& ranks, bool moves = true,
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

    //- Turn by turn on so many ranks, each from the state that the turn before has saved: words and
    //  all else as one process does it
    void compareGoingOn(const SphConfig& c, const FluidInput& f, const WallInput& w,
        const std::vector<int>& turns, const Course& run,
        const WallMotion& motion = WallMotion()) const
    {
        std::vector<std::int32_t> one, many;
        std::mutex mutex;
        const auto goOn = [&](std::vector<std::int32_t>& state)
        {
            const auto from = std::make_shared<std::vector<std::int32_t>>(state);
            return Course([from, &run, &state, &mutex](SphScene& s, Outcome& o)
            {
                if (!from->empty()) s.loadState(*from);
                run(s, o);
                const std::vector<std::int32_t> words = s.saveState();
                std::lock_guard<std::mutex> lock(mutex);
                if (!words.empty()) state = words;
            });
        };
        for (const int ranks : turns)
        {
            SCOPED_TRACE(std::to_string(ranks) + " ranks");
            const Outcome a = alone(c, f, w, goOn(one), motion);
            const Outcome b = ranks == 1 ? alone(c, f, w, goOn(many), motion)
                                         : onSeveral(ranks, c, f, w, goOn(many), motion);
            EXPECT_EQ(a.report.stop, StopReason::none);
            expectSame(a, b);
            EXPECT_EQ(one, many);
        }
    }
};

} // namespace riprap

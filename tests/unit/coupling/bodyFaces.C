/*  Faces of rigid bodies in the fluid: what crosses them is put back, and the body gets the same
    blow the other way.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <cmath>
#include "boxFaces.hpp"
#include "couplingTest.hpp"
#include "dem/motion/clumpState.hpp"

namespace riprap
{
namespace
{

class BodyFaces : public CouplingTest
{
protected:

    static constexpr int across = 4;

    SphConfig openConfig() const
    {
        SphConfig c = config();
        c.wallSpacing = c.spacing;
        c.maxVelocity = 10;
        c.soundSpeed = 100;
        c.maxDensityDeviation = 0.9;
        return c;
    }

    //- A cube (2D: a square) of particles of the fluid's spacing about the middle of the domain,
    //  with its faces
    SolidInput body(const SphConfig& c, double density) const
    {
        const double side = across*c.spacing, low = 0.5 - 0.5*side;
        SolidInput s = rigid(block(c, across, c.spacing, {{low, low, low}}));
        const double share = density/800;
        for (double& m : s.input.particles.mass) m *= share;
        DemClump& b = s.input.clumps[0];
        b.mass *= share;
        for (double& j : b.inertia) j *= share;
        if (D() == 2) b.inertia[0] = b.inertia[1] = 0;
        s.input.pairs[0].properties.normalStiffness = 1e6;
        addBoxFaces(s.faces, D(), 0, {{0.5*side, 0.5*side, 0.5*side}});
        return s;
    }

    FluidInput particle(const Vector3& x, const Vector3& v) const { return oneParticle(D(), x, v); }

    //- How many particles are deeper in the body than this
    int inside(SphScene& s, double half, double depth) const
    {
        const DemClumpState b = s.solids()->clumps();
        const FluidState f = s.fluid();
        int count = 0;
        for (std::size_t i = 0; i < f.id.size(); ++i)
        {
            Vec<3, double> x{{0, 0, 0}};
            for (int d = 0; d < D(); ++d) x.c[d] = f.position[3*i + d] - b.position[d];
            const Vec<3, double> X = rotated(b.orientation.data(), x, true);
            double least = half;
            for (int d = 0; d < D(); ++d) least = std::min(least, half - std::abs(X.c[d]));
            count += least > depth;
        }
        return count;
    }

    //- Water thrown at a body from both sides
    FluidInput shots(const SphConfig& c, double speed) const
    {
        FluidInput all;
        for (const double side : {-1.0, 1.0})
        {
            Vector3 low{{0.5 + side*0.3 - 0.1, 0.38, D() == 3 ? 0.38 : 0}},
                high{{0.5 + side*0.3 + 0.1, 0.66, D() == 3 ? 0.62 : 0}};
            const FluidInput f = lattice(c, low, high);
            all.position.insert(all.position.end(), f.position.begin(), f.position.end());
            all.density.insert(all.density.end(), f.density.begin(), f.density.end());
            for (std::size_t i = 0; i < f.size(); ++i)
                for (const double v : {-side*speed, 0.1*speed, 0.0}) all.velocity.push_back(v);
        }
        return all;
    }
};

RIPRAP_ALL_SETUPS(BodyFaces);

//- Off the middle of a face: momentum, angular momentum and place
TEST_P(BodyFaces, TakeABlow)
{
    SphConfig c = openConfig();
    c.adjustTimeStep = false;
    c.fixedTimeStep = 1e-3;
    const double half = 0.5*across*c.spacing, h = c.spacing, v = 0.3*h/c.fixedTimeStep;
    const SolidInput solids = body(c, 500);
    const auto s = createSphDemScene(c,
        particle({{0.5 - half - 0.2*h, 0.5 + 0.6*half, 0.5}}, {{v, 0, 0}}), WallInput(),
        solids);
    const double m = c.density*std::pow(c.spacing, D()), M = solids.input.clumps[0].mass;
    s->advance(1e30, 1);
    const FluidState f = s->fluid();
    EXPECT_NEAR(f.position[0], 0.5 - half, 1e-5*h);
    EXPECT_EQ(s->faceContacts().atBodies, 1);
    EXPECT_EQ(s->faceContacts().count, 1);
    const DemClumpState b = s->solids()->clumps();
    const Momentum p = momentum(*s, c);
    EXPECT_NEAR(p.sum[0], m*v, 1e-5*m*v);
    // the face stops it and no more; pressure of the pass at the end is small beside that
    EXPECT_NEAR(b.velocity[0], m/M*v, 0.02*m/M*v);
    EXPECT_NEAR(b.spin[2]*solids.input.clumps[0].inertia[2], -m*v*0.6*half, 0.02*m*v*half);
}

//- A body that is held takes it all
TEST_P(BodyFaces, HeldBodies)
{
    SphConfig c = openConfig();
    c.adjustTimeStep = false;
    c.fixedTimeStep = 1e-3;
    const double half = 0.5*across*c.spacing, h = c.spacing;
    SolidInput solids = body(c, 500);
    DemGroup held;
    for (bool& axis : held.held) axis = true;
    held.heldSpin = true;
    solids.input.groups.assign(1, held);
    const auto s = createSphDemScene(c,
        particle({{0.5 - half - 0.2*h, 0.5, 0.5}}, {{0.3*h/c.fixedTimeStep, 0, 0}}),
        WallInput(), solids);
    s->advance(1e30, 1);
    EXPECT_NEAR(s->fluid().position[0], 0.5 - half, 1e-5*h);
    EXPECT_EQ(s->solids()->clumps().velocity[0], 0);
}

//- Thrown water does not come into a body, which it does without faces; the same bits twice, and
//  from a saved state
TEST_P(BodyFaces, HoldWhatIsThrown)
{
    const SphConfig c = openConfig();
    const double half = 0.5*across*c.spacing, near = 1e-3*c.spacing;
    SolidInput solids = body(c, 300);
    solids.coupling.kind = "stationary";
    for (double& v : solids.volume) v *= 0.1;       // forces alone let much in
    const FluidInput water = shots(c, 8);
    const auto make = [&](const SolidInput& in)
    { return createSphDemScene(c, water, WallInput(), in); };
    const auto worst = [&](SphScene& s)
    {
        int most = 0;
        for (int k = 1; k <= 20; ++k)
        {
            EXPECT_EQ(s.advance(1.5e-3*k).stop, StopReason::none);
            most = std::max(most, inside(s, half, near));
        }
        return most;
    };
    SolidInput open = solids;
    open.faces = WallFaceInput();
    EXPECT_GT(worst(*make(open)), 0) << "the test shows nothing";
    const auto s = make(solids);
    const Vector3 before = momentum(*s, c).sum;
    EXPECT_EQ(worst(*s), 0);
    EXPECT_GT(s->faceContacts().atBodies, 0);
    const Momentum after = momentum(*s, c);
    for (int d = 0; d < D(); ++d) EXPECT_NEAR(after.sum[d], before[d], 1e-5*after.size);
    const auto again = make(solids);
    again->advance(1.5e-3);
    const auto words = again->saveState();
    const auto other = make(solids);
    other->loadState(words);
    for (int k = 2; k <= 20; ++k) { again->advance(1.5e-3*k); other->advance(1.5e-3*k); }
    EXPECT_EQ(s->fluid().position, again->fluid().position);
    EXPECT_EQ(other->fluid().position, again->fluid().position);
    EXPECT_EQ(other->solids()->clumps().velocity, again->solids()->clumps().velocity);
}

} // namespace
} // namespace riprap

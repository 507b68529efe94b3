/*  What is read of the fluid: interpolation at points, and energies.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "farEnd.hpp"
#include "sceneTest.hpp"

namespace riprap
{
namespace
{

class Sample : public SceneTest
{
protected:

    double taitPressure(const SphConfig& c, double d) const
    { return c.soundSpeed*c.soundSpeed*c.density/c.gamma*(std::pow(1 + d, c.gamma) - 1); }

    //- A periodic box, or a blob in an open one, of uniform density and velocity
    FluidInput uniform(const SphConfig& c, bool periodic, double deviation, const Vector3& v) const
    {
        const double lo = periodic ? 0 : 0.2, hi = periodic ? 1 : 0.8;
        FluidInput f = lattice(c, {{lo, lo, D() == 3 ? lo : 0.0}}, {{hi, hi, D() == 3 ? hi : 0.0}});
        for (std::size_t i = 0; i < f.size(); ++i)
        {
            f.density[i] = c.density*(1 + deviation);
            for (int d = 0; d < D(); ++d) f.velocity[3*i + d] = v[d];
        }
        return f;
    }
};

RIPRAP_ALL_SETUPS(Sample);

TEST_P(Sample, ConstantFieldsAreReproduced)
{
    for (const bool variable : {false, true})
    {
        SphConfig c = config();
        for (bool& p : c.periodic) p = true;
        c.variableSmoothing = variable;
        const double deviation = 0.03;
        const Vector3 v{{0.7, -0.3, 0.4}};
        const auto s = scene(c, uniform(c, true, deviation, v));
        std::vector<double> points;
        std::mt19937 engine(3);
        for (int k = 0; k < 100; ++k)
            for (int d = 0; d < 3; ++d)
                points.push_back(k < 20 ? (k % 2 ? 0.999999 : 0.0) : riprap::uniform(engine, 0, 1));
        for (int round = 0; round < 2; ++round)
        {
            const SampleResult r = s->sample(points);
            for (int k = 0; k < 100; ++k)
            {
                // divided by the sum of weights: constants come back but for rounding, also across
                // the periodic edges
                ASSERT_NEAR(r.pressure[k], taitPressure(c, deviation),
                    30*epsilon()*taitPressure(c, deviation)/deviation);
                for (int d = 0; d < D(); ++d) ASSERT_NEAR(r.velocity[3*k + d], v[d], 30*epsilon());
                if (D() == 2) { ASSERT_EQ(r.velocity[3*k + 2], 0); }
                // mass/density is 1/1.03 of a cell; the sum over the lattice replaces an integral:
                // 1.3 % too much at a particle, less between
                ASSERT_NEAR(r.volumeFraction[k], 1/(1 + deviation), 0.015);
            }
            s->advance(0.02);       // and after the fluid has moved on
        }
    }
}

//- A Shepard mean of a linear field is the field's value at the centroid of what was sampled: with
//  that, it is exact at a surface too
TEST_P(Sample, LinearFieldFromTheCentroid)
{
    for (const bool variable : {false, true})
    {
        SphConfig c = config();
        c.eos = "linear";        // a linear pressure is a linear density
        c.variableSmoothing = variable;
        FluidInput f = uniform(c, false, 0, {{0, 0, 0}});
        const double mid = D() == 3 ? 0.5 : 0;
        const auto pressure = [&](const double* x) { return 3000 - 5000*x[1] + 2000*x[0]; };
        for (std::size_t i = 0; i < f.size(); ++i)
        {
            double& velocity = f.velocity[3*i];
            velocity = 0.5 + f.position[3*i + 1];
            f.density[i] = c.density + pressure(&f.position[3*i])/(c.soundSpeed*c.soundSpeed);
        }
        const auto s = scene(c, f);
        // inside, in surfaces, in a corner, and beyond the surface
        const std::vector<double> points{
            0.5, 0.5, mid, 0.5, 0.8, mid, 0.2, 0.47, mid, 0.8, 0.8, mid, 0.51, 0.85, mid};
        const SampleResult r = s->sample(points);
        for (int k = 0; k < 5; ++k)
        {
            const double* d = &r.centroid[3*k];
            const double gradient = -5000*d[1] + 2000*d[0];
            EXPECT_NEAR(r.pressure[k] - gradient, pressure(&points[3*k]),
                1000*epsilon()*c.soundSpeed*c.soundSpeed*c.density/400)
                << "point " << k;
            EXPECT_NEAR(r.velocity[3*k] - d[1], 0.5 + points[3*k + 1], 100*epsilon());
        }
        EXPECT_NEAR(r.centroid[1], 0, 0.01*c.spacing);
        EXPECT_LT(r.centroid[3*1 + 1], -0.3*c.spacing) << "below the surface";
        EXPECT_EQ(s->sample({5, 5, mid}).centroid[1], 0);
    }
}

TEST_P(Sample, NothingWhereNoFluidIs)
{
    SphConfig c = config();
    const auto s = scene(c, uniform(c, false, 0.03, {{1, 0, 0}}));
    const double h = 1.25*c.spacing, mid = D() == 3 ? 0.5 : 0;
    // beyond the support, outside the domain, far away; and the surface, where half the support is
    // empty
    const SampleResult r = s->sample(
        {0.2 - 2*h, 0.5, mid, 5, 0.5, mid, -1e6, 1e6, 0, 0.2, 0.5, mid, 0.5, 0.5, mid});
    for (int k = 0; k < 3; ++k)
    {
        EXPECT_EQ(r.volumeFraction[k], 0);
        EXPECT_EQ(r.pressure[k], 0);
        EXPECT_EQ(r.velocity[3*k], 0);
    }
    EXPECT_NEAR(r.volumeFraction[3], 0.5/1.03, 0.03);
    EXPECT_NEAR(r.pressure[3], taitPressure(c, 0.03), 1e-4*taitPressure(c, 0.03))
        << "does not fade at the surface";
    EXPECT_NEAR(r.volumeFraction[4], 1/1.03, 0.015);
    EXPECT_TRUE(s->sample({}).pressure.empty());
}

TEST_P(Sample, NothingBehindPlanes)
{
    // a linear pressure in x > 0.5, and wild particles beyond: a wall's face at 0.5, seen from it
    // and from a spacing and a half before it
    SphConfig c = config();
    c.eos = "linear";
    FluidInput f = uniform(c, false, 0, {{1, 0, 0}});
    const double slope = c.density*c.soundSpeed*c.soundSpeed*0.1, mid = D() == 3 ? 0.5 : 0;
    for (std::size_t i = 0; i < f.size(); ++i)
    {
        const double x = f.position[3*i];
        f.density[i] = c.density*(x > 0.5 ? 1 + 0.1*(x - 0.5) : 0.85);
        if (x < 0.5) f.velocity[3*i] = -100;
    }
    const auto s = scene(c, f);
    const std::vector<double> points{
        0.5, 0.5, mid, 0.5 + 1.5*c.spacing, 0.5, mid, 0.5, 0.5, mid, 0.7, 0.7, mid};
    const auto planes = [&](int n)
    {
        SightPlanes p;
        // the third point has two, one along y as well; the last none
        p.first = {0, 1, 2, 2 + n, 2 + n};
        p.normal = {1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0};
        p.depth = {1e-3*c.spacing, 1.501*c.spacing, 1e-3*c.spacing, 1e-3*c.spacing};
        p.normal.resize(3*(2 + n));
        p.depth.resize(2 + n);
        return p;
    };
    const SampleResult all = s->sample(points), seen = s->sample(points, planes(2));
    EXPECT_LT(all.pressure[0], -0.01*slope) << "without planes the wild ones are read";
    for (int k = 0; k < 4; ++k)
    {
        const double pressure = slope*(points[3*k] - 0.5 + seen.centroid[3*k]);
        EXPECT_NEAR(seen.pressure[k], pressure, 1000*epsilon()*slope) << "point " << k;
        EXPECT_NEAR(seen.velocity[3*k], 1, 100*epsilon()) << "point " << k;
    }
    // lattice planes lie half a spacing off the face and the cut along y: halves of each other
    EXPECT_NEAR(seen.volumeFraction[0], 0.5*all.volumeFraction[3], 0.02);
    EXPECT_NEAR(seen.volumeFraction[2], 0.5*seen.volumeFraction[0], 1e-5);
    EXPECT_EQ(seen.volumeFraction[3], all.volumeFraction[3]) << "a point without planes";
    EXPECT_GT(seen.centroid[3*2 + 1], 0.2*c.spacing);
}

TEST_P(Sample, FollowsTheFluid)
{
    // a blob that flies past a point: what is read belongs to now, not to the last time that
    // neighbours were sought
    SphConfig c = config();
    const auto s = scene(c, uniform(c, false, 0, {{1, 0, 0}}));
    const double mid = D() == 3 ? 0.5 : 0;
    for (int k = 0; k <= 10; ++k)
    {
        const double t = 0.01*k;
        s->advance(t);
        const SampleResult r = s->sample({0.8, 0.5, mid, 0.8 + t, 0.5, mid});
        if (k == 0 || k == 10)
        {
            EXPECT_NEAR(r.volumeFraction[0], k ? 1 : 0.5, 0.03)
                << "the surface was there at the start, and passes";
        }
        EXPECT_NEAR(r.volumeFraction[1], 0.5, 0.03) << "the surface is now here";
    }
}

TEST_P(Sample, EndsAndExtremesAreThoseOfAllParticles)
{
    SphConfig c = config();
    FluidInput f = uniform(c, false, 0.01, {{0.3, 0.2, -0.1}});
    std::mt19937 engine(5);
    for (std::size_t i = 0; i < f.size(); ++i)
    {
        f.density[i] *= 1 + riprap::uniform(engine, -0.004, 0.004);
        for (int d = 0; d < D(); ++d)
        {
            f.position[3*i + d] += riprap::uniform(engine, -0.2, 0.2)*c.spacing;
            f.velocity[3*i + d] += riprap::uniform(engine, -0.5, 0.5);
        }
    }
    const auto s = scene(c, f);
    expectFarEnds(*s, D(), c.density);
    s->advance(0.005);
    expectFarEnds(*s, D(), c.density);
}

TEST_P(Sample, EnergyByHand)
{
    for (const std::string eos : {"Tait", "linear"})
    {
        SphConfig c = config();
        c.eos = eos;
        c.gravity = {{1, -9.81, 3}};
        FluidInput f = uniform(c, false, 0, {{0, 0, 0}});
        disturb(c, f, 0.1, 1.5, 0.05);
        const auto s = scene(c, f);
        const double m = c.density*std::pow(c.spacing, D());
        double kinetic = 0, potential = 0, elastic = 0;
        for (std::size_t i = 0; i < f.size(); ++i)
        {
            for (int d = 0; d < D(); ++d)
            {
                kinetic += 0.5*m*f.velocity[3*i + d]*f.velocity[3*i + d];
                potential -= m*c.gravity[d]*f.position[3*i + d];
            }
            // the integral of p/rho^2 over rho: of p(d) = c0^2 rho0/gamma ((1 + d)^gamma - 1), and
            // of c0^2 rho0 d
            const double r = f.density[i]/c.density, c2 = c.soundSpeed*c.soundSpeed;
            elastic += m*c2*(eos == "linear" ? std::log(r) + 1/r - 1
                : ((std::pow(r, 6) - 1)/6 + 1/r - 1)/7);
        }
        const SphEnergy e = s->energy();
        // inputs were rounded to float, the deviation d to 6e-8 of itself
        const double tolerance = mixed() ? 1e-6 : 1e-12;
        EXPECT_NEAR(e.kinetic, kinetic, tolerance*kinetic);
        EXPECT_NEAR(e.potential, potential, tolerance*std::abs(potential));
        EXPECT_NEAR(e.elastic, elastic, tolerance*elastic);
        EXPECT_EQ(e.wallWork, 0);
    }
}

//- Without viscosity the symplectic scheme keeps the sum
TEST_P(Sample, EnergyIsKept)
{
    SphConfig c = config();
    if (D() == 3) c.spacing = 0.1;
    for (bool& p : c.periodic) p = true;
    c.integrator = "symplectic";
    c.acousticCourant = 0.1;
    FluidInput f = uniform(c, true, 0, {{0, 0, 0}});
    // a slow shear wave, with room to become disorder: 10 % of the speed of sound
    for (std::size_t i = 0; i < f.size(); ++i)
        f.velocity[3*i] = 0.5*std::sin(2*std::acos(-1.0)*f.position[3*i + 1]);
    const auto s = scene(c, f);
    const SphEnergy before = s->energy();
    s->advance(0.3);
    const SphEnergy after = s->energy();
    // the scheme is of second order in a step of a thirtieth of the fastest wave's period; no drift
    // but what disorder makes of it
    EXPECT_NEAR(
        after.kinetic + after.elastic, before.kinetic + before.elastic, 0.01*before.kinetic);
}

} // namespace
} // namespace riprap

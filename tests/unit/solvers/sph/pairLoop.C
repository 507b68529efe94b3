/*  The pair loop of whole scenes: accelerations, density rates and drifts of random particles
    against all pairs in double.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "bruteForce.hpp"
#include "randomScene.hpp"

namespace riprap
{
namespace
{

class PairLoop : public RandomScene
{
protected:

    void compare(const SphConfig& c, const FluidInput& f, const WallInput& w = {})
    {
        const auto s = scene(c, f, w);
        const BruteForce expected(c, f, w);
        const Derivatives d = derivatives(*s, c);
        ASSERT_EQ(d.acceleration.size(), f.size());
        // of the largest: mixed sums 20 to 65 terms of which each is right to some 6e-8 and which
        // mostly cancel; double likewise
        const double tolerance = mixed() ? 1e-5 : 1e-12;
        const double a = largest(expected.acceleration), r = largest(expected.rate),
                     u = largest(expected.drift);
        int wrong = 0;
        for (std::size_t i = 0; i < f.size() && wrong < 3; ++i)
        {
            for (int k = 0; k < 3; ++k)
            {
                EXPECT_NEAR(d.acceleration[i][k], expected.acceleration[i][k], tolerance*a)
                    << "particle " << i << ", axis " << k;
                EXPECT_NEAR(d.drift[i][k], expected.drift[i][k], tolerance*u)
                    << "drift of particle " << i << ", axis " << k;
            }
            EXPECT_NEAR(d.rate[i], expected.rate[i], tolerance*r) << "particle " << i;
            wrong += HasFailure();
        }
        if (c.wallModel == "extrapolated" && w.size())
        {
            const WallState state = s->walls();
            for (std::size_t i = 0; i < w.size() && wrong < 3; ++i)
            {
                EXPECT_NEAR(state.pressure[i], expected.wallPressure[i],
                    tolerance*largest(expected.wallPressure))
                    << "wall point " << i;
                wrong += HasFailure();
            }
        }
        // whole numbers, but where a pair lies within rounding of 2 h
        EXPECT_NEAR(s->neighboursPerParticle(), expected.neighbours, 2.5/f.size());
    }

    //- With constant and variable h, with all kernels
    void compareAll(SphConfig c, const WallInput& w = {})
    {
        const FluidInput f = particles(c);
        for (const std::string& kernel : kernelWords())
            for (const bool variable : {false, true})
            {
                SCOPED_TRACE(kernel + (variable ? ", variable h" : ""));
                c.kernel = kernel;
                c.variableSmoothing = variable;
                compare(c, f, w);
            }
    }
};

RIPRAP_ALL_SETUPS(PairLoop);

TEST_P(PairLoop, Inviscid) { compareAll(base()); }

TEST_P(PairLoop, LaminarAndTheCorrectionsOfThePaper)
{
    SphConfig c = base();
    c.viscosityModel = "laminar";
    c.viscosity = 20;           // as much as pressure, else a wrong factor would drown
    c.antiClump = 0.1;
    c.xsph = 0.5;
    compareAll(c);
}

TEST_P(PairLoop, EachTermAlone)
{
    const auto one = [&](const char* what, auto change)
    {
        SCOPED_TRACE(what);
        SphConfig c = base();
        change(c);
        compare(c, particles(c));
    };
    one("laminar", [](SphConfig& c) { c.viscosityModel = "laminar"; c.viscosity = 20; });
    one("artificial",
        [](SphConfig& c)
        {
            c.viscosityModel = "artificial";
            c.artificialAlpha = 0.5;
        });
    one("antiClump", [](SphConfig& c) { c.antiClump = 0.2; });
    one("XSPH", [](SphConfig& c) { c.xsph = 0.5; });
    one("molteni", [](SphConfig& c) { c.diffusion = "molteni"; c.diffusionDelta = 0.5; });
    one("fourtakas", [](SphConfig& c) { c.diffusion = "fourtakas"; c.diffusionDelta = 0.5; });
    one("fickian", [](SphConfig& c) { c.shifting = "fickian"; });
    one("linear equation of state", [](SphConfig& c) { c.eos = "linear"; });
    one("gamma 1.4", [](SphConfig& c) { c.gamma = 1.4; });
    one("laminar, diffusion", [](SphConfig& c)
    { c.viscosityModel = "laminar"; c.viscosity = 20; c.diffusion = "fourtakas"; });
    one("artificial, diffusion", [](SphConfig& c)
    { c.viscosityModel = "artificial"; c.artificialAlpha = 0.5; c.diffusion = "molteni"; });
}

TEST_P(PairLoop, EverythingAtOnce)
{
    SphConfig c = base();
    c.viscosityModel = "laminarAndArtificial";
    c.viscosity = 20;
    c.artificialAlpha = 0.5;
    c.antiClump = 0.2;
    c.xsph = 0.5;
    c.diffusion = "fourtakas";
    c.shifting = "fickian";
    c.wallModel = "extrapolated";
    compareAll(c, floorOf(c, 1, 0, 5));
}

TEST_P(PairLoop, Walls)
{
    for (const std::string model : {"stationary", "extrapolated"})
        for (const bool noSlip : {true, false})
        {
            SCOPED_TRACE(model
                + (noSlip ? ", noSlip" : ", freeSlip"));
            SphConfig c = base();
            c.wallModel = model;
            c.noSlip = noSlip;
            c.viscosityModel = "laminarAndArtificial";
            c.viscosity = 20;
            c.artificialAlpha = 0.5;
            WallInput w = floorOf(c, 1, 0, 5);
            // a lid that only spray would reach: wall points without fluid
            append(w, floorOf(c, 1, 1.1, 2));
            compare(c, particles(c), w);
        }
}

TEST_P(PairLoop, WiderSmoothing)
{
    SphConfig c = base();
    if (D() == 3) c.domainMax[0] = c.domainMax[2] = 1.2;
    c.smoothingRatio = D() == 2 ? 2.2 : 1.7;        // 60 and 160 neighbours in place of 20 and 65
    c.wallModel = "extrapolated";
    compare(c, particles(c), floorOf(c, 1, 0, D() == 2 ? 9 : 7));
}

//- A flat fluid may lie in any plane: x-y, z-x, ...
TEST_P(PairLoop, AnyPlane)
{
    if (D() == 3) GTEST_SKIP() << "of 2D";
    const int planes[][3] = {{0, 1, 2}, {0, 2, 1}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    for (const auto& axes : planes)
    {
        SCOPED_TRACE(std::string("axes ") + char('0' + axes[0]) + char('0' + axes[1]));
        SphConfig c = config();
        std::copy(axes, axes + 3, c.axes);
        c.periodic[axes[0]] = true;
        c.domainMin = {{-0.2, 0.3, 5}};
        c.domainMax = {{0.8, 1.3, 6}};
        c.gravity = {{1, 2, 3}};
        c.viscosityModel = "laminar";
        c.viscosity = 20;
        FluidInput f = lattice(c, c.domainMin, c.domainMax);
        // of no concern: it comes back as the middle of the domain
        for (std::size_t i = 0; i < f.size(); ++i) f.position[3*i + axes[2]] = i ? 0.77 : 0.88;
        disturb(c, f, 0.2, 1, 0.02);
        // of no concern in the plane
        for (std::size_t i = 0; i < f.size(); ++i) f.velocity[3*i + axes[2]] = 4;
        compare(c, f);
        const auto s = scene(c, f);
        const FluidState state = s->fluid();
        for (std::size_t k = 0; k < f.size(); ++k)
            ASSERT_EQ(state.position[3*k + axes[2]],
                0.5*(c.domainMin[axes[2]] + c.domainMax[axes[2]]));
    }
}

//- The shortest periods: rows of cells are each other's neighbours from both sides, and the skin is
//  what room there is
TEST_P(PairLoop, ShortPeriods)
{
    for (const double spacing : {0.1, 0.05, 0.03, 0.07, 0.011, 1.0/24})
        for (const double period : {7.88, 8.0})
        {
            SCOPED_TRACE(std::to_string(period) + " spacings of " + std::to_string(spacing));
            SphConfig c = config();
            c.spacing = spacing;
            for (int d = 0; d < 3; ++d)
            {
                c.periodic[d] = true;
                c.domainMax[d] = period*spacing;
            }
            FluidInput f = lattice(
                c, {{0, 0, 0}}, {{8*spacing, 8*spacing, D() == 3 ? 8*spacing : 0.0}});
            disturb(c, f, 0.2, 1, 0.02);
            for (std::size_t k = 0; k < f.position.size(); ++k)
                f.position[k] -= c.domainMax[k % 3]*std::floor(f.position[k]/c.domainMax[k % 3]);
            compare(c, f);
        }
}

TEST_P(PairLoop, RadialForcesConserveMomenta)
{
    // a free blob: pressure, anti-clump term and artificial viscosity act along the line of
    // centres, so that momentum and angular momentum are conserved; laminar viscosity (Morris)
    // conserves the first
    SphConfig c = config();
    if (D() == 3) c.spacing = 0.1;
    c.viscosityModel = "artificial";
    c.artificialAlpha = 0.5;
    c.antiClump = 0.2;
    for (const bool variable : {false, true})
    {
        c.variableSmoothing = variable;
        FluidInput f = lattice(
            c, {{0.2, 0.3, D() == 3 ? 0.2 : 0.0}}, {{0.8, 0.7, D() == 3 ? 0.8 : 0.0}});
        disturb(c, f, 0.3, 1, 0.02);
        const auto s = scene(c, f);
        const Derivatives d = derivatives(*s, c);
        Vector3 force{{0, 0, 0}}, moment{{0, 0, 0}};
        double sumForce = 0;
        for (std::size_t i = 0; i < f.size(); ++i)
        {
            const double* x = &f.position[3*i];
            const Vector3& a = d.acceleration[i];
            for (int k = 0; k < 3; ++k)
            {
                force[k] += a[k];
                moment[k] += x[(k + 1) % 3]*a[(k + 2) % 3] - x[(k + 2) % 3]*a[(k + 1) % 3];
                sumForce += std::abs(a[k]);
            }
        }
        // each pair's two halves are rounded separately: of 20 to 65 terms a particle, larger than
        // their sum, some 20 roundings each
        for (int k = 0; k < 3; ++k)
        {
            EXPECT_NEAR(force[k], 0, 10*epsilon()*sumForce);
            EXPECT_NEAR(moment[k], 0, 10*epsilon()*sumForce);
        }
    }
}

} // namespace
} // namespace riprap

/*  Motion without walls: free fall, conservation of momentum, and no preferred place in space.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "sceneTest.hpp"

namespace riprap
{
namespace
{

class Motion : public SceneTest
{
protected:

    //- All terms that pairs have
    static void everyTerm(SphConfig& c)
    {
        c.viscosityModel = "laminarAndArtificial";
        c.viscosity = 5;
        c.artificialAlpha = 0.1;
        c.antiClump = 0.01;
        c.xsph = 0.5;
        c.diffusion = "fourtakas";
        c.shifting = "fickian";
    }

    //- A periodic box, full, in disorder
    SphConfig periodicBox() const
    {
        SphConfig c = config();
        if (D() == 3) { c.spacing = 0.1; c.skin = 0.1; }
        for (bool& p : c.periodic) p = true;
        return c;
    }

    FluidInput disorder(const SphConfig& c) const
    {
        FluidInput f = lattice(c, c.domainMin,
            {{c.domainMax[0], c.domainMax[1], D() == 3 ? c.domainMax[2] : c.domainMin[2]}});
        disturb(c, f, 0.2, 0.5, 0.01);
        for (std::size_t i = 0; i < f.size(); ++i)
            for (int d = 0; d < D(); ++d)
            {
                // multiples of 2^-20: a shift by a power of two loses no digit
                double& x = f.position[3*i + d];
                const double s = std::floor((x - c.domainMin[d])*1048576)/1048576;
                x = c.domainMin[d] + s - std::floor(s);
            }
        return f;
    }

    static Vector3 momentum(const FluidState& s)
    {
        Vector3 p{{0, 0, 0}};
        for (std::size_t k = 0; k < s.velocity.size(); ++k) p[k % 3] += s.velocity[k];
        return p;
    }
};

RIPRAP_ALL_SETUPS(Motion);

TEST_P(Motion, FreeFall)
{
    for (const std::string integrator : {"leapfrog", "symplectic"})
        for (const bool adjust : {false, true})
        {
            SphConfig c = config();
            everyTerm(c);
            c.diffusion = "molteni";       // fourtakas expects the pressure of a fluid that rests,
            c.shifting = "none";            // and shifting moves what is fast
            c.integrator = integrator;
            c.gravity = {{1, -9.81, 2}};
            c.domainMin = {{-0.2, -0.4, -0.2}};
            c.adjustTimeStep = adjust;
            c.fixedTimeStep = 1e-3;
            FluidInput f = lattice(
                c, {{0.3, 0.4, D() == 3 ? 0.3 : 0.0}}, {{0.7, 0.8, D() == 3 ? 0.6 : 0.0}});
            for (std::size_t i = 0; i < f.size(); ++i) f.velocity[3*i] = 0.25;
            const auto s = scene(c, f);
            const double t = 0.3;
            const SphReport r = s->advance(t);
            const FluidState after = s->fluid();
            ASSERT_EQ(after.id.size(), f.size());
            // nothing but gravity acts, exactly: at rest density and equal velocities every pair
            // gives zero. Each step rounds v twice and dt once
            const double v = 3, tolerance = 3*r.steps*epsilon()*v;
            for (std::size_t k = 0; k < after.id.size(); ++k)
                for (int d = 0; d < D(); ++d)
                {
                    const std::size_t from = 3*after.id[k] + d, to = 3*k + d;
                    const double v0 = f.velocity[from], g = c.gravity[d];
                    ASSERT_NEAR(after.velocity[to], v0 + g*t, tolerance);
                    ASSERT_NEAR(after.position[to], f.position[from] + v0*t + 0.5*g*t*t,
                        tolerance*t + 1e-14);
                }
            for (const double rho : after.density) ASSERT_EQ(rho, c.density);
        }
}

TEST_P(Motion, MomentumIsConserved)
{
    for (const std::string integrator : {"leapfrog", "symplectic"})
        for (const bool variable : {false, true})
        {
            SphConfig c = periodicBox();
            everyTerm(c);
            c.integrator = integrator;
            c.variableSmoothing = variable;
            const auto s = scene(c, disorder(c));
            const FluidState first = s->fluid();
            const Vector3 before = momentum(first);
            const SphReport r = s->advance(1, 30);
            ASSERT_EQ(r.steps, 30);
            ASSERT_EQ(r.stop, StopReason::none);
            const FluidState last = s->fluid();
            const Vector3 after = momentum(last);
            double sum = 0, change = 0;
            for (std::size_t k = 0; k < last.velocity.size(); ++k)
                sum += std::abs(last.velocity[k]);
            for (std::size_t i = 0; i < first.id.size(); ++i)
                change = std::max(change, std::abs(last.velocity[3*i]));
            // the two halves of a pair force differ by their rounding alone: forces are some 20
            // times what remains of them; v is rounded twice a step
            for (int d = 0; d < D(); ++d)
                EXPECT_NEAR(after[d], before[d], 30*4*epsilon()*sum) << "axis " << d;
            EXPECT_GT(change, 0.1) << "or nothing happened";
        }
}

TEST_P(Motion, TheSameAnywhereInSpace)
{
    for (const bool exact : {true, false})
    {
        SphConfig c = periodicBox();
        everyTerm(c);
        c.viscosity = 0.5;
        const auto here = scene(c, disorder(c));
        // by powers of two no position is rounded: the same bits. By 100 m the positions move by up
        // to 1e-14 m, and mixed precision may see a neighbour a unit of 2^-32 m further off, whose
        // effect has no time to grow in ten steps
        const Vector3 shift = exact ? Vector3{{128, -256, 64}} : Vector3{{100, 100, -100}};
        SphConfig moved = c;
        for (int d = 0; d < 3; ++d)
        {
            moved.domainMin[d] += shift[d];
            moved.domainMax[d] += shift[d];
        }
        FluidInput f = disorder(c);
        for (std::size_t k = 0; k < f.position.size(); ++k) f.position[k] += shift[k % 3];
        const auto there = scene(moved, f);
        here->advance(1, 10);
        there->advance(1, 10);
        const FluidState a = here->fluid(), b = there->fluid();
        const auto orderA = byId(a), orderB = byId(b);
        ASSERT_EQ(a.id.size(), b.id.size());
        for (std::size_t k = 0; k < orderA.size(); ++k)
        {
            const std::size_t i = orderA[k], j = orderB[k];
            for (int d = 0; d < D(); ++d)
            {
                if (exact) { ASSERT_EQ(a.velocity[3*i + d], b.velocity[3*j + d]); }
                ASSERT_NEAR(a.velocity[3*i + d], b.velocity[3*j + d], 1e-6);
                double dx = b.position[3*j + d] - a.position[3*i + d] - shift[d];
                dx -= std::round(dx);
                ASSERT_NEAR(dx, 0, exact ? 1e-12 : 1e-9)
                    << "the sum with the box's corner is rounded at 256 m";
            }
            if (exact) { ASSERT_EQ(a.density[i], b.density[j]); }
        }
    }
}

} // namespace
} // namespace riprap

/*  Every family of kernels takes a few steps and does what the CPU does in double precision:
    integrators, walls that rest and that move, constant and variable smoothing, the paper's terms
    and all terms. Short on purpose: tests/Sanitize runs these under compute-sanitizer.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "tankScene.hpp"

namespace riprap
{
namespace
{

struct Model
{
    std::string integrator;
    std::string walls;
    bool piston, variableSmoothing, everyTerm;
};

class EveryModel : public TankScene
{
protected:

    static constexpr int steps = 12;

    SphConfig configOf(const Model& m) const
    {
        SphConfig c = tank();
        c.integrator = m.integrator;
        c.wallModel = m.walls;
        c.variableSmoothing = m.variableSmoothing;
        c.viscosity = 0.1;
        c.viscosityModel = m.everyTerm ? "laminarAndArtificial" : "laminar";
        if (m.everyTerm)
        {
            c.antiClump = 0.01;
            c.xsph = 0.3;
            c.diffusion = "fourtakas";
            c.shifting = "fickian";
        }
        // The same times in every precision, and neighbours sought anew every few steps
        c.adjustTimeStep = false;
        c.fixedTimeStep = 0.2*c.smoothingRatio*c.spacing/c.soundSpeed;
        c.skin = 0.01;
        return c;
    }

    std::unique_ptr<SphScene> sceneOf(const SphConfig& c, bool piston) const
    {
        FluidInput f = column(c);
        disturb(c, f, 0.05, 0.5, 0);
        WallInput w = walls(c);
        if (piston) makePiston(w);
        return scene(c, f, w, piston ? pistonMotion() : WallMotion());
    }

    //- In spacings, sound speeds and densities: a few roundings of pairs (6e-8, 1e-16; divisions on
    //  the GPU are to 2 ulp) in each of a dozen steps of which each moves a particle by a hundredth
    //  of a spacing. The CPU's mixed precision comes to 3e-8
    double tolerance() const { return mixed() ? 1e-6 : 1e-12; }

    void compare(SphScene& tested, SphScene& reference, const SphConfig& c) const
    {
        const FluidState a = tested.fluid(), b = reference.fluid();
        ASSERT_EQ(a.id.size(), b.id.size());
        const std::vector<std::size_t> ia = byId(a), ib = byId(b);
        double x = 0, v = 0, rho = 0;
        for (std::size_t k = 0; k < ia.size(); ++k)
        {
            ASSERT_EQ(a.id[ia[k]], b.id[ib[k]]);
            for (int d = 0; d < c.dimensions; ++d)
            {
                x = std::max(x, std::abs(a.position[3*ia[k] + d] - b.position[3*ib[k] + d]));
                v = std::max(v, std::abs(a.velocity[3*ia[k] + d] - b.velocity[3*ib[k] + d]));
            }
            rho = std::max(rho, std::abs(a.density[ia[k]] - b.density[ib[k]]));
        }
        EXPECT_LT(x/c.spacing, tolerance());
        EXPECT_LT(v/c.soundSpeed, tolerance());
        EXPECT_LT(rho/c.density, tolerance());

        const std::vector<double> points{0.2, 0.2, 0.25, 0.35, 0.1, 0.3};
        const SampleResult sa = tested.sample(points), sb = reference.sample(points);
        for (std::size_t k = 0; k < 2; ++k)
        {
            EXPECT_NEAR(sa.volumeFraction[k], sb.volumeFraction[k], tolerance());
            EXPECT_NEAR(sa.pressure[k], sb.pressure[k],
                tolerance()*c.density*c.soundSpeed*c.soundSpeed);
        }
        const std::vector<Vector3> fa = tested.wallForces(), fb = reference.wallForces();
        ASSERT_EQ(fa.size(), fb.size());
        for (std::size_t k = 0; k < fa.size(); ++k)
            for (int d = 0; d < c.dimensions; ++d)
                EXPECT_NEAR(
                    fa[k][d], fb[k][d], tolerance()*c.density*c.soundSpeed*c.soundSpeed);
    }
};

RIPRAP_ALL_SETUPS(EveryModel);

TEST_P(EveryModel, DoesAsTheCpuInDouble)
{
    if (GetParam().device == DeviceKind::cpu && !mixed())
        GTEST_SKIP() << "is what the others are compared with";
    for (int k = 0; k < 32; ++k)
    {
        const Model m{k & 1 ? "symplectic" : "leapfrog",
            k & 2 ? "extrapolated" : "stationary", bool(k & 4), bool(k & 8),
            bool(k & 16)};
        SCOPED_TRACE(std::string(k & 1 ? "symplectic" : "leapfrog")
            + (k & 2 ? ", extrapolated" : ", stationary") + (k & 4 ? ", piston" : "")
            + (k & 8 ? ", variable h" : "") + (k & 16 ? ", every term" : ""));
        const SphConfig c = configOf(m);
        SphConfig exact = c;
        exact.device = DeviceKind::cpu;
        exact.precision = PrecisionKind::doubled;
        const auto tested = sceneOf(c, m.piston), reference = sceneOf(exact, m.piston);
        const SphReport report = tested->advance(1, steps);
        reference->advance(1, steps);
        EXPECT_EQ(report.stop, StopReason::none);
        EXPECT_EQ(report.steps, steps);
        EXPECT_GT(report.rebuilds, 1);
        compare(*tested, *reference, c);

        // and on from its saved state
        const auto again = sceneOf(c, m.piston);
        again->loadState(tested->saveState());
        again->advance(1, 2);
        tested->advance(1, 2);
        expectSameBits(again->fluid(), tested->fluid());
    }
}

} // namespace
} // namespace riprap

/*  Moving walls: they are where their motion says, push the fluid, do work, and act on nothing that
    they do not touch.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "bruteForce.hpp"
#include "tankScene.hpp"

namespace riprap
{
namespace
{

class MovingWalls : public TankScene
{
protected:

    //- The tank full of water, 0.4 deep, at rest under its weight
    FluidInput full(const SphConfig& c) const
    {
        FluidInput f = lattice(c, {{0, 0, 0}}, {{1, 0.4, D() == 3 ? 0.5 : 0.0}});
        for (std::size_t i = 0; i < f.size(); ++i)
            f.density[i] = c.density
                *std::pow(1
                        + c.gamma*9.81*(0.4 - f.position[3*i + 1])
                            /(c.soundSpeed*c.soundSpeed),
                    1/c.gamma);
        return f;
    }

    static WallMotion shifted(const Vector3& by)
    { return [by](int, double) { WallPose p; p.translation = by; return p; }; }

    static void expectSame(const Derivatives& a, const Derivatives& b, double tolerance)
    {
        ASSERT_EQ(a.acceleration.size(), b.acceleration.size());
        const double scale = largest(b.acceleration);
        for (std::size_t i = 0; i < a.acceleration.size(); ++i)
        {
            for (int d = 0; d < 3; ++d)
                ASSERT_NEAR(a.acceleration[i][d], b.acceleration[i][d], tolerance*scale)
                    << "particle " << i;
            ASSERT_NEAR(a.rate[i], b.rate[i], tolerance*(largest(b.rate) + 1)) << "particle " << i;
        }
    }
};

RIPRAP_ALL_SETUPS(MovingWalls);

TEST_P(MovingWalls, FollowTheGivenMotion)
{
    // rotation about the empty (or third) axis with a swaying centre; poses are interpolated over
    // intervals of 0.01 s/32, where cubic Hermite polynomials err by interval^4/384 f'''': 1e-14
    // (12 rad/s)^4 1 m/384, in positions of 1 m known to 1e-16
    SphConfig c = tank();
    WallInput w = walls(c);
    makePiston(w);
    const auto pose = [](int, double t)
    {
        WallPose p;
        const double a = 0.05*std::sin(12*t);
        p.rotation = {{std::cos(a), -std::sin(a), 0, std::sin(a), std::cos(a), 0, 0, 0, 1}};
        p.translation = {{0.01*(1 - std::cos(9*t)), 0.02*std::sin(5*t), 0}};
        return p;
    };
    const auto s = scene(c, column(c), w, pose);
    for (const double t : {0.0, 0.01, 0.02, 0.03})
    {
        ASSERT_EQ(s->advance(t).stop, StopReason::none);
        const WallState state = s->walls();
        for (std::size_t i = 0; i < w.size(); ++i)
        {
            const double* X = &w.position[3*i];
            for (int d = 0; d < D(); ++d)
            {
                if (w.body[i] < 0)
                {
                    ASSERT_EQ(state.position[3*i + d], X[d]);
                    ASSERT_EQ(state.velocity[3*i + d], 0);
                    continue;
                }
                const auto x = [&](double time)
                {
                    const WallPose p = pose(0, time);
                    return p.translation[d] + p.rotation[3*d]*X[0]
                        + p.rotation[3*d + 1]*X[1] + p.rotation[3*d + 2]*X[2];
                };
                ASSERT_NEAR(state.position[3*i + d], x(t), 1e-9) << "point " << i << " at " << t;
                // rates come from differences of poses, 4e-7 s to 1e-6 s apart, which cancel 1e-16
                ASSERT_NEAR(state.velocity[3*i + d], (x(t + 1e-5) - x(t - 1e-5))/2e-5, 1e-6)
                    << "point " << i << " at " << t;
            }
        }
    }
}

TEST_P(MovingWalls, BeginWhereTheyAre)
{
    // walls given 5 m away and brought into place by their pose are as good as walls given in place
    for (const std::string model : {"stationary", "extrapolated"})
    {
        SphConfig c = tank();
        c.wallModel = model;
        c.startTime = 3;
        FluidInput f = column(c);
        disturb(c, f, 0.1, 0.5, 0.01);
        for (std::size_t k = 0; k < f.position.size(); k += 3)
            f.position[k] = std::max(f.position[k], 0.01);
        const WallInput fixed = walls(c);
        WallInput away = fixed;
        away.nBodies = 1;
        away.body.assign(away.size(), 0);
        const Vector3 by{{-5, 0.125, D() == 3 ? 2.0 : 0.0}};
        for (std::size_t k = 0; k < away.position.size(); ++k) away.position[k] -= by[k % 3];
        const auto a = scene(c, f, fixed), b = scene(c, f, away, shifted(by));
        // positions are rounded once more at 5 m: 1e-15 m, one unit of 2^-32 of the box in mixed
        // precision at most
        const double tolerance = mixed() ? 1e-5 : 1e-10;
        expectSame(derivatives(*a, c), derivatives(*b, c), tolerance);
        const auto p = a->walls().pressure, q = b->walls().pressure;
        for (std::size_t i = 0; i < p.size(); ++i)
            ASSERT_NEAR(p[i], q[i], tolerance*(largest(p) + 1));
        const Vector3 onFixed = a->wallForces()[0], onMoving = b->wallForces()[1];
        for (int d = 0; d < D(); ++d)
            EXPECT_NEAR(onFixed[d], onMoving[d], tolerance*(largest({onFixed}) + 1));
    }
}

TEST_P(MovingWalls, OutOfTheDomainTheyTouchNothing)
{
    // also where fixed-point positions would wrap: by one length of the box and a bit
    SphConfig c = tank();
    const FluidInput f = column(c);
    WallInput w = walls(c);
    w.nBodies = 1;
    w.body.assign(w.size(), 0);
    const auto alone = scene(c, f);
    alone->advance(0.01);
    for (const Vector3& by :
        {Vector3{{2.2, 0, 0}}, Vector3{{0, -3, 0}}, Vector3{{-1.574, 1.424, 0}}})
    {
        const auto s = scene(c, f, w, shifted(by));
        s->advance(0.01);
        expectSameBits(s->fluid(), alone->fluid());
        EXPECT_EQ(largest(s->wallForces()), 0);
    }
}

TEST_P(MovingWalls, AccelerationEntersTheirPressure)
{
    // Adami et al. 2012, Eq. 27: what accelerates with a_w feels g - a_w. The fluid at rest in both
    // frames
    SphConfig c = tank();
    c.viscosityModel = "none";
    WallInput w = walls(c);
    w.nBodies = 1;
    w.body.assign(w.size(), 0);
    const FluidInput f = full(c);
    const double a = -4;
    const auto s = scene(c, f, w,
        [&](int, double t)
        {
            WallPose p;
            p.translation[0] = 0.5*a*t*t;
            return p;
        });
    SphConfig frame = c;
    frame.gravity[0] = -a;
    const std::vector<double> expected = BruteForce(frame, f, w).wallPressure,
                              p = s->walls().pressure;
    // second differences of poses 3e-5 s apart: 1e-16/1e-9 m/s2
    for (std::size_t i = 0; i < p.size(); ++i)
        ASSERT_NEAR(p[i], expected[i], (mixed() ? 1e-5 : 1e-6)*largest(expected)) << i;
}

TEST_P(MovingWalls, PistonPushesTheFluid)
{
    for (const std::string integrator : {"leapfrog", "symplectic"})
    {
        SphConfig c = tank();
        c.integrator = integrator;
        c.viscosityModel = "none";
        c.diffusion = "fourtakas";
        WallInput w = walls(c);
        makePiston(w);
        const FluidInput f = full(c);
        const auto s = scene(c, f, w, pistonMotion());
        const SphEnergy before = s->energy();
        const double m = c.density*std::pow(c.spacing, D());
        for (int k = 1; k <= 10; ++k)
        {
            const double t = 0.02*k;
            const SphReport r = s->advance(t);
            ASSERT_EQ(r.stop, StopReason::none);
            ASSERT_TRUE(r.escaped.empty());
            const FluidState state = s->fluid();
            double nearest = 1;
            for (std::size_t i = 0; i < state.id.size(); ++i)
                nearest = std::min(nearest, state.position[3*i]);
            EXPECT_GT(nearest, stroke(t) + 0.25*c.spacing)
                << "fluid in the piston at " << t << " s";
            EXPECT_LT(nearest, stroke(t) + c.spacing) << "fluid left behind at " << t << " s";
        }
        // half of the stroke's way the water moves to the right; at its end the piston has lifted
        // it: 0.4/0.9 deep on average
        const SphEnergy after = s->energy();
        const double total = after.kinetic + after.potential + after.elastic - before.kinetic
            - before.potential - before.elastic;
        const double lifted = 0.5*m*f.size()*9.81*0.4*(1/0.9 - 1);
        EXPECT_GT(after.wallWork, 0.9*lifted) << "at least what the lift took";
        // 4.3 % (3D: 9.5 %) more than the piston's work, which the pressure of walls has lent; 0.9
        // % of it went into diffusion and noise
        const double given = after.wallWork + after.wallPressureWork;
        EXPECT_LT(total, 1.001*given) << "nothing comes from nowhere";
        EXPECT_NEAR(total, given, 0.02*given);
    }
}

//- m_w sum m p_w/rho_w^2 (v - u_w) . grad_w W dt, in a step whose velocities hardly change: of 1
//  us, where c0 goes h in 4 ms or so
TEST_P(MovingWalls, PressureWorkIsThatOfThePairs)
{
    SphConfig c = tank();
    c.integrator = "symplectic";
    c.viscosityModel = "none";
    c.adjustTimeStep = false;
    c.fixedTimeStep = 1e-6;
    WallInput w = walls(c);
    makePiston(w);
    FluidInput f = full(c);
    for (std::size_t i = 0; i < f.size(); ++i) f.velocity[3*i + 1] += 0.3 + f.position[3*i];
    const auto s = scene(c, f, w,
        [](int body, double t)
        {
            WallPose p;
            if (body == 0) p.translation[0] = 0.2*t;
            return p;
        });
    ASSERT_EQ(s->advance(1, 1).steps, 1);
    const FluidState fluid = s->fluid();
    const WallState wall = s->walls();
    const double h = c.smoothingRatio*c.spacing, m = c.density*std::pow(c.spacing, D()),
                 stiffness = c.soundSpeed*c.soundSpeed*c.density/c.gamma;
    double expected = 0, sizes = 0;
    for (std::size_t k = 0; k < w.size(); ++k)
    {
        const double p = wall.pressure[k], rho = c.density*std::pow(1 + p/stiffness, 1/c.gamma);
        for (std::size_t i = 0; i < fluid.id.size(); ++i)
        {
            Vector3 x{{0, 0, 0}}, u{{0, 0, 0}};
            for (int d = 0; d < D(); ++d)
            {
                x[d] = wall.position[3*k + d] - fluid.position[3*i + d];
                u[d] = fluid.velocity[3*i + d] - wall.velocity[3*k + d];
            }
            const double r = std::sqrt(paper::dot(x, x));
            if (r >= 2*h) continue;
            const double work = m*m*p/(rho*rho)*paper::dWdr(c.kernel, D(), r, h)/r
                *paper::dot(u, x)*c.fixedTimeStep;
            expected += work;
            sizes += std::abs(work);
        }
    }
    ASSERT_GT(std::abs(expected), 0.02*sizes);
    // velocities are those of the end against those foreseen; float sums
    EXPECT_NEAR(s->energy().wallPressureWork, expected, (mixed() ? 1e-4 : 1e-5)*sizes);
}

//- After sorting and moving, forces on the walls are still the reaction of those on the fluid
TEST_P(MovingWalls, ForcesBelongToTheState)
{
    SphConfig c = tank();
    // its last forces are those of the state it leaves
    c.integrator = "symplectic";
    c.viscosityModel = "none";
    WallInput w = walls(c);
    makePiston(w);
    const FluidInput f = full(c);
    const auto s = scene(c, f, w, pistonMotion());
    s->advance(0.1);
    const Derivatives d = derivatives(*s, c);
    const double m = c.density*std::pow(c.spacing, D());
    Vector3 total{{0, 0, 0}};
    double sum = 0;
    for (const Vector3& a : d.acceleration)
        for (int k = 0; k < D(); ++k)
        {
            total[k] += m*(a[k] - c.gravity[k]);
            sum += m*std::abs(a[k] - c.gravity[k]);
        }
    const auto forces = s->wallForces();
    ASSERT_EQ(forces.size(), 3u) << "fixed, piston, and a group without points";
    EXPECT_EQ(largest({forces[2]}), 0);
    EXPECT_LT(forces[1][0], -0.3*m*f.size()) << "the water pushes back";
    for (int k = 0; k < D(); ++k)
        EXPECT_NEAR(forces[0][k] + forces[1][k], -total[k], 100*epsilon()*sum) << "axis " << k;
}

} // namespace
} // namespace riprap

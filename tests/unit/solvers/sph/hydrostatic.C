/*  A column at rest on a floor: pressure rho g depth, and a floor that carries the weight.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "sceneTest.hpp"

namespace riprap
{
namespace
{

class Hydrostatic : public SceneTest
{
protected:

    static constexpr double width = 0.4, height = 0.5, g = 9.81;

    //- Periodic sideways, so that the floor is all there is to carry it
    SphConfig column() const
    {
        SphConfig c = config();
        c.domainMin = {{0, -0.2, 0}};
        c.domainMax = {{width, 0.8, width}};
        c.periodic[0] = c.periodic[2] = true;
        c.wallSpacing = c.spacing;
        c.gravity = {{0, -g, 0}};
        c.maxVelocity = std::sqrt(2*g*height);
        c.soundSpeed = 10*c.maxVelocity;
        c.viscosityModel = "artificial";
        c.artificialAlpha = 0.1;
        c.diffusion = "fourtakas";
        return c;
    }

    //- Compressed by its own weight: the inverse of Tait's equation at the depth of each particle
    FluidInput fluid(const SphConfig& c) const
    {
        FluidInput f = lattice(c, {{0, 0, 0}}, {{width, height, D() == 3 ? width : 0.0}});
        for (std::size_t i = 0; i < f.size(); ++i)
            f.density[i] = c.density
                *std::pow(1
                        + c.gamma*g*(height - f.position[3*i + 1])
                            /(c.soundSpeed*c.soundSpeed),
                    1/c.gamma);
        return f;
    }

    double weight(const SphConfig& c, std::size_t n) const
    {
        return c.density*std::pow(c.spacing, D())*double(n)*g;
    }
};

RIPRAP_ALL_SETUPS(Hydrostatic);

TEST_P(Hydrostatic, PressureStaysAndTheFloorCarriesTheWeight)
{
    for (const std::string integrator : {"leapfrog", "symplectic"})
    {
        // seconds saved
        if (D() == 3 && !mixed() && integrator == "symplectic") continue;
        SphConfig c = column();
        c.integrator = integrator;
        const FluidInput in = fluid(c);
        const WallInput floor = floorOf(c, 1, 0, 3);
        const auto s = scene(c, in, floor);
        // twenty sound waves up and down; the mean of the second half
        const double end = 20*2*height/c.soundSpeed;
        Vector3 force{{0, 0, 0}};
        double error2 = 0, wallError = 0;
        int samples = 0;
        for (int k = 1; k <= 20; ++k)
        {
            ASSERT_EQ(s->advance(end*k/20).stop, StopReason::none);
            if (k <= 10) continue;
            ++samples;
            const Vector3 now = s->wallForces()[0];
            for (int d = 0; d < 3; ++d) force[d] += now[d];
            const FluidState f = s->fluid();
            for (std::size_t i = 0; i < f.id.size(); ++i)
            {
                const double p = c.density*g*(height - f.position[3*i + 1]);
                error2 += std::pow((f.pressure[i] - p)/(c.density*g*height), 2)/f.id.size();
            }
            const WallState w = s->walls();
            for (std::size_t i = 0; i < w.pressure.size(); ++i)
            {
                const double y = floor.position[3*i + 1];
                if (y > -c.spacing)
                    wallError = std::max(
                        wallError, std::abs(w.pressure[i]/(c.density*g*(height - y)) - 1));
            }
        }
        // 10 particles high: the topmost lacks neighbours and its spacing settles, which moves all
        // others by a fraction of a spacing
        EXPECT_LT(std::sqrt(error2/samples), 0.03) << "L2 of the pressure, of rho g H";
        EXPECT_LT(wallError, 0.06) << "extrapolated from the fluid to the first layer of the wall";
        const double w = weight(c, in.size());
        EXPECT_NEAR(force[1]/samples, -w, 0.02*w);
        // nothing pushes sideways: the scene is the same at x and -x but for rounding
        EXPECT_NEAR(force[0]/samples, 0, 1e-3*w);
        EXPECT_NEAR(force[2]/samples, 0, 1e-3*w);
        const SphReport r = s->advance(end, 1);
        EXPECT_EQ(r.fluid, in.size());
        EXPECT_LT(s->energy().kinetic, 1e-4*w*height) << "it stays where it is";
    }
}

TEST_P(Hydrostatic, StationaryWallsCarryTheWeightToo)
{
    // they push when the density of the fluid rises: the column rings longer, hence stronger
    // damping
    SphConfig c = column();
    c.wallModel = "stationary";
    c.wallSpacing = 0.5*c.spacing;
    c.artificialAlpha = 0.5;
    const FluidInput in = fluid(c);
    const auto s = scene(c, in, floorOf(c, 1, 0, 5));
    const double end = 40*2*height/c.soundSpeed;
    double force = 0;
    int samples = 0;
    for (int k = 1; k <= 40; ++k)
    {
        ASSERT_EQ(s->advance(end*k/40).stop, StopReason::none);
        if (k > 20) { force += s->wallForces()[0][1]; ++samples; }
    }
    const double w = weight(c, in.size());
    EXPECT_NEAR(force/samples, -w, 0.02*w);
}

} // namespace
} // namespace riprap

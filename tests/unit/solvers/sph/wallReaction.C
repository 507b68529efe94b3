/*  What walls feel is what they give: wallForces against the momentum that the pass over the fluid
    finds.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "randomScene.hpp"

namespace riprap
{
namespace
{

class WallReaction : public RandomScene
{
protected:

    //- Parts of the wall, pressure and viscosity sum to the whole
    void parts(
        SphScene& s, const SphConfig& c, const WallInput& w, const Vector3& whole, double size)
    {
        Vector3 sum{{0, 0, 0}};
        double viscous = 0, ofParts[2] = {0, 0};
        for (const FluidForce& f : s.forcesOnWalls())
        {
            for (int k = 0; k < 3; ++k)
            {
                sum[k] += f.pressure[k] + f.viscous[k];
                viscous += std::abs(f.viscous[k]);
                ofParts[f.part] += std::abs(f.pressure[k]);
                EXPECT_EQ(f.pressureMoment[k], 0);
            }
        }
        // the same pairs in the same order but for the parts' sums
        for (int k = 0; k < D(); ++k) EXPECT_NEAR(sum[k], whole[k], epsilon()*size) << "axis " << k;
        EXPECT_GT(ofParts[0], 0);
        EXPECT_GT(ofParts[1], 0);
        if (c.viscosityModel == "none") EXPECT_EQ(viscous, 0);
        else EXPECT_GT(viscous, 1e-6*size);
        EXPECT_EQ(w.part.size(), w.size());
    }

    void compare(const SphConfig& c, bool moving)
    {
        WallInput w = floorOf(c, 1, 0, 5);
        for (std::size_t i = 0; i < w.size(); ++i)
            w.part.push_back(w.position[3*i] > 0.5*(c.domainMin[0] + c.domainMax[0]));
        WallMotion motion;
        if (moving)
        {
            w.nBodies = 1;
            w.body.assign(w.size(), 0);
            motion = [](int, double t)
            {
                WallPose p;
                p.translation = {{0.7*t, -0.4*t, 0}};
                return p;
            };
        }
        const auto s = scene(c, particles(c), w, motion);
        const Derivatives d = derivatives(*s, c);
        const double m = c.density*std::pow(c.spacing, D());
        // force on the fluid less its weight; that between its particles cancels
        Vector3 total{{0, 0, 0}};
        double sum = 0;
        for (const Vector3& a : d.acceleration)
            for (int k = 0; k < D(); ++k)
            {
                total[k] += m*(a[k] - c.gravity[k]);
                sum += m*std::abs(a[k]);
            }
        const Vector3 onWalls = s->wallForces()[moving ? 1 : 0];
        // both are sums over all pairs, rounded a few times each
        for (int k = 0; k < D(); ++k)
            EXPECT_NEAR(total[k], -onWalls[k], 20*epsilon()*sum) << "axis " << k;
        parts(*s, c, w, onWalls, sum);
        EXPECT_GT(std::abs(onWalls[1]), 1e-3*sum) << "or the test would prove nothing";
    }
};

RIPRAP_ALL_SETUPS(WallReaction);

TEST_P(WallReaction, EqualAndOpposite)
{
    for (const std::string model : {"stationary", "extrapolated"})
        for (const std::string viscosity : {"none", "laminar", "artificial"})
            for (const bool variable : {false, true})
                for (const bool moving : {false, true})
                {
                    SCOPED_TRACE(
                        model
                        + (viscosity == "laminar"
                                ? ", laminar"
                                : (viscosity == "artificial" ? ", artificial" : ""))
                        + (variable ? ", variable h" : "") + (moving ? ", moving" : ""));
                    SphConfig c = base();
                    c.wallModel = model;
                    c.viscosityModel = viscosity;
                    c.viscosity = 20;
                    c.artificialAlpha = 0.5;
                    c.variableSmoothing = variable;
                    compare(c, moving);
                }
}

} // namespace
} // namespace riprap

/*  What walls feel is what they give: wallForces against the momentum that the pass over the fluid finds.

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

    void compare(const SphConfig& c, bool moving)
    {
        WallInput w = floorOf(c, 1, 0, 5);
        WallMotion motion;
        if (moving)
        {
            w.nBodies = 1;
            w.body.assign(w.size(), 0);
            motion = [](int, double t) { WallPose p; p.translation = {{0.7*t, -0.4*t, 0}}; return p; };
        }
        const auto s = scene(c, particles(c), w, motion);
        const Derivatives d = derivatives(*s, c);
        const double m = c.density*std::pow(c.spacing, D());
        Vector3 total{{0, 0, 0}};       // force on the fluid less its weight; that between its particles cancels
        double sum = 0;
        for (const Vector3& a : d.acceleration)
            for (int k = 0; k < D(); ++k) { total[k] += m*(a[k] - c.gravity[k]); sum += m*std::abs(a[k]); }
        const Vector3 onWalls = s->wallForces()[moving ? 1 : 0];
        // both are sums over all pairs, rounded a few times each
        for (int k = 0; k < D(); ++k) EXPECT_NEAR(total[k], -onWalls[k], 20*epsilon()*sum) << "axis " << k;
        EXPECT_GT(std::abs(onWalls[1]), 1e-3*sum) << "or the test would prove nothing";
    }
};

RIPRAP_ALL_SETUPS(WallReaction);

TEST_P(WallReaction, EqualAndOpposite)
{
    for (const WallKind model : {WallKind::stationary, WallKind::extrapolated})
        for (const ViscosityKind viscosity : {ViscosityKind::none, ViscosityKind::laminar, ViscosityKind::artificial})
            for (const bool variable : {false, true})
                for (const bool moving : {false, true})
                {
                    SCOPED_TRACE(std::string(model == WallKind::stationary ? "stationary" : "extrapolated")
                      + (viscosity == ViscosityKind::laminar ? ", laminar" : (viscosity == ViscosityKind::artificial ? ", artificial" : ""))
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

/*  createSphScene refuses what makes no sense, and says what.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <limits>
#include "tankScene.hpp"

namespace riprap
{
namespace
{

class Checks : public TankScene
{
protected:

    SphConfig c;
    FluidInput f;
    WallInput w;
    WallMotion motion;

    void SetUp() override
    {
        TankScene::SetUp();
        if (IsSkipped()) return;
        c = tank();
        f = column(c);
        w = walls(c);
    }

    //- change(c, f, w, motion) must lead to an invalid_argument that contains `why`
    template<class Change>
    void refuses(const std::string& why, const Change& change)
    {
        SphConfig config = c;
        FluidInput fluid = f;
        WallInput wall = w;
        WallMotion m;
        change(config, fluid, wall, m);
        try
        {
            createSphScene(config, fluid, wall, m);
            ADD_FAILURE() << "accepted, but: " << why;
        }
        catch (const std::invalid_argument& e)
        {
            EXPECT_NE(std::string(e.what()).find(why), std::string::npos)
                << "'" << e.what() << "' does not say '" << why << "'";
        }
    }
};

RIPRAP_PLANE_SETUPS(Checks);

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
using C = SphConfig;
using F = FluidInput;
using W = WallInput;
using M = WallMotion;

TEST_P(Checks, TheSceneItselfIsFine) { EXPECT_NO_THROW(createSphScene(c, f, w)); }

TEST_P(Checks, Numbers)
{
    refuses("dimensions", [](C& c, F&, W&, M&) { c.dimensions = 1; });
    refuses("axes", [](C& c, F&, W&, M&) { c.axes[1] = 0; });
    refuses("axes", [](C& c, F&, W&, M&) { c.axes[2] = 3; });
    refuses("fluid's spacing", [](C& c, F&, W&, M&) { c.spacing = 0; });
    refuses("fluid's spacing", [](C& c, F&, W&, M&) { c.spacing = nan; });
    refuses("density must be positive", [](C& c, F&, W&, M&) { c.density = -1; });
    refuses("viscosity must not be negative", [](C& c, F&, W&, M&) { c.viscosity = -1; });
    refuses("viscosity must not be negative", [](C& c, F&, W&, M&) { c.viscosity = nan; });
    refuses("speed of sound", [](C& c, F&, W&, M&) { c.soundSpeed = 0; });
    refuses("maximum velocity", [](C& c, F&, W&, M&) { c.maxVelocity = 0; });
    refuses("gamma", [](C& c, F&, W&, M&) { c.gamma = 0; });
    refuses("smoothing length to spacing", [](C& c, F&, W&, M&) { c.smoothingRatio = 0.5; });
    refuses("smoothing length to spacing", [](C& c, F&, W&, M&) { c.smoothingRatio = 5; });
    refuses("growth limit", [](C& c, F&, W&, M&) { c.maxSmoothingGrowth = 0.9; });
    refuses("coefficient", [](C& c, F&, W&, M&) { c.artificialAlpha = -0.1; });
    refuses("coefficient", [](C& c, F&, W&, M&) { c.antiClump = -0.1; });
    refuses("coefficient", [](C& c, F&, W&, M&) { c.xsph = nan; });
    refuses("coefficient", [](C& c, F&, W&, M&) { c.diffusionDelta = -0.1; });
    refuses("coefficient", [](C& c, F&, W&, M&) { c.shiftingCoefficient = -0.1; });
    refuses("surface threshold", [](C& c, F&, W&, M&) { c.shiftingSurfaceThreshold = 0; });
    refuses("surface threshold", [](C& c, F&, W&, M&) { c.shiftingSurfaceThreshold = 2; });
    refuses("surface threshold", [](C& c, F&, W&, M&) { c.shiftingSurfaceThreshold = nan; });
    refuses("gravity", [](C& c, F&, W&, M&) { c.gravity[1] = nan; });
    refuses("fixed time step", [](C& c, F&, W&, M&) { c.adjustTimeStep = false; });
    refuses("Courant", [](C& c, F&, W&, M&) { c.acousticCourant = 0; });
    refuses("Courant", [](C& c, F&, W&, M&) { c.forceCourant = -1; });
    refuses("Courant", [](C& c, F&, W&, M&) { c.viscousCourant = nan; });
    refuses("time step", [](C& c, F&, W&, M&) { c.maxTimeStep = 0; });
    refuses("deviation", [](C& c, F&, W&, M&) { c.maxDensityDeviation = 0; });
    refuses("speed ratio", [](C& c, F&, W&, M&) { c.maxSpeedRatio = nan; });
}

TEST_P(Checks, Domain)
{
    refuses("domain is empty", [](C& c, F&, W&, M&) { c.domainMax[1] = c.domainMin[1]; });
    refuses("domain is empty", [](C& c, F&, W&, M&) { c.domainMax[0] = nan; });
    refuses("domain is empty", [](C& c, F&, W&, M&) { c.escapeInset = 10; });
    refuses("domain is empty",
        [](C& c, F&, W&, M&)
        {
            c.periodic[0] = true;
            c.domainMax[0] = c.domainMin[0];
        });
    refuses("three search radii", [](C& c, F& f, W& w, M&)
    {
        w = W();
        c.periodic[0] = true;
        c.domainMin[0] = 0;
        c.domainMax[0] = 0.35;          // 7 spacings; the support alone asks for 7.5
        f = lattice(c, {{0, 0, 0}}, {{0.35, 0.35, 0}});
    });
}

TEST_P(Checks, Fluid)
{
    refuses("no fluid particles", [](C&, F& f, W&, M&) { f = F(); });
    refuses("different lengths", [](C&, F& f, W&, M&) { f.velocity.pop_back(); });
    refuses("different lengths", [](C&, F& f, W&, M&) { f.density.push_back(1000); });
    refuses("ids of another length", [](C&, F& f, W&, M&) { f.id = {1, 2}; });
    refuses("fluid particle 5 at (", [](C&, F& f, W&, M&) { f.position[15] = 7; });
    refuses("outside the domain", [](C&, F& f, W&, M&) { f.position[15] = 7; });
    refuses("outside the domain", [](C&, F& f, W&, M&) { f.position[16] = nan; });
    refuses("outside the domain",
        [](C& c, F& f, W&, M&)
        {
            c.escapeInset = 0.1;
            f.position[1] = -0.06;
        });
    refuses("fluid particle 4", [](C&, F& f, W&, M&) { f.density[4] = 0; });
    refuses("fluid particle 4", [](C&, F& f, W&, M&) { f.density[4] = nan; });
    refuses("fluid particle 4", [](C&, F& f, W&, M&) { f.velocity[12] = nan; });
}

TEST_P(Checks, Walls)
{
    refuses("walls' spacing", [](C& c, F&, W&, M&) { c.wallSpacing = 0; });
    refuses("body indices of another length", [](C&, F&, W& w, M&) { w.body = {0}; });
    refuses("without a motion", [](C&, F&, W& w, M&) { makePiston(w); });
    refuses("body", [](C&, F&, W& w, M& m) { makePiston(w); m = pistonMotion(); w.body[3] = 2; });
    refuses("body", [](C&, F&, W& w, M& m) { makePiston(w); m = pistonMotion(); w.body[3] = -2; });
    refuses("body", [](C&, F&, W& w, M&) { w.body.assign(w.size(), 0); });
    refuses("wall point 3", [](C&, F&, W& w, M&) { w.position[9] = 5; });
    refuses("wall point 3", [](C&, F&, W& w, M&) { w.position[10] = nan; });
    EXPECT_NO_THROW(createSphScene(c, f, W()));
}

TEST_P(Checks, Device)
{
    std::string why;
    const int gpus = gpuCount(why);
    EXPECT_EQ(chooseDevice(DeviceKind::cpu, 1000000, 3).device, DeviceKind::cpu);
    EXPECT_FALSE(chooseDevice(DeviceKind::cpu, 1000000, 3).reason.empty());
    const DeviceChoice small = chooseDevice(DeviceKind::automatic, 10, 2),
                       large = chooseDevice(DeviceKind::automatic, 1000000, 2);
    EXPECT_EQ(small.device, DeviceKind::cpu) << small.reason;
    EXPECT_EQ(large.device, gpus ? DeviceKind::gpu : DeviceKind::cpu) << large.reason;
    EXPECT_NE(large.reason.find(gpus ? "1000000" : why), std::string::npos) << large.reason;
    if (gpus) { EXPECT_EQ(chooseDevice(DeviceKind::gpu, 10, 2).device, DeviceKind::gpu); }
    else { EXPECT_THROW(chooseDevice(DeviceKind::gpu, 10, 2), std::invalid_argument); }
    const auto s = createSphScene(c, f, w);
    EXPECT_EQ(s->device(), GetParam().device);
    EXPECT_FALSE(s->deviceName().empty());
}

} // namespace
} // namespace riprap

/*  Steps of a small scene in one launch (solvers/dem/parts/demBlockSteps.hpp) have the bits of
    those in a launch each, which is what they are while kernels are timed.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "dem/demTest.hpp"

namespace riprap
{
namespace
{

class DemOneBlock : public DemTest
{
protected:
    //- A bonded block that is thrown at walls, among loose particles; some bonds break
    DemInput scene(const DemConfig& c, int across, int loose) const
    {
        DemInput in = oneMaterial();
        in.pairs[0].properties.friction = 0.4;
        in.pairs[0].properties.restitution = 0.6;
        const int D = c.dimensions, layers = D == 3 ? across : 1;
        for (int k = 0; k < layers; ++k)
            for (int j = 0; j < across; ++j)
                for (int i = 0; i < across; ++i)
                    addParticle(in, {{0.02*i - 0.1, 0.02*j - 0.4, D == 3 ? 0.02*k - 0.1 : 0}},
                        {{1.5, -1, D == 3 ? 0.4 : 0}});
        in.bondTypes.emplace_back();
        in.bondTypes[0].normalStiffness = in.bondTypes[0].shearStiffness = 2e4;
        in.bondTypes[0].tensileStrength = D == 2 ? 30 : 300;
        in.bonds = bondsWithin(c, in.particles, 0, 1e-6);
        std::mt19937 engine(5);
        std::uniform_real_distribution<double> u(-1, 1);
        for (int i = 0; i < loose; ++i)
            addParticle(in,
                {{0.4*u(engine), 0.2 + 0.2*u(engine), D == 3 ? 0.4*u(engine) : 0}},
                {{u(engine), u(engine), D == 3 ? u(engine) : 0}}, 0.008 + 0.002*u(engine));
        addBox(in, D);
        return in;
    }
};

TEST_P(DemOneBlock, BitsOfALaunchEach)
{
    for (const int D : {2, 3})
    {
        DemConfig c = config(D);
        c.integrator = "velocityVerlet";
        c.tangential = "history";
        c.stepFraction = 0.1;
        c.gravity = {{0, -9.81, 0}};
        const DemInput in = scene(c, D == 2 ? 10 : 4, D == 2 ? 60 : 100);
        auto one = createDemScene(c, in), each = createDemScene(c, in);
        each->timeKernels(true);
        std::size_t broken = 0;
        for (int k = 0; k < 6; ++k)
        {
            ASSERT_EQ(one->advance(1e9, 150).stop, DemStop::none);
            ASSERT_EQ(each->advance(1e9, 150).stop, DemStop::none);
            const DemState a = one->particles(), b = each->particles();
            ASSERT_EQ(a.id, b.id);
            EXPECT_EQ(a.position, b.position) << D << " " << k;
            EXPECT_EQ(a.velocity, b.velocity) << D << " " << k;
            EXPECT_EQ(a.spin, b.spin) << D << " " << k;
            const auto state = one->bonds().broken, other = each->bonds().broken;
            EXPECT_EQ(state, other);
            broken = std::count_if(state.begin(), state.end(), [](auto v) { return int(v) != 0; });
        }
        EXPECT_GT(broken, 0u);
        EXPECT_LT(broken, in.bonds.size());
        EXPECT_GT(one->deepestOverlap() + one->energy().translation, 0);
        if (GetParam().device == DeviceKind::gpu)
        {
            const auto ran = [](const std::vector<KernelInfo>& kernels)
            {
                return std::any_of(kernels.begin(), kernels.end(),
                    [](const KernelInfo& k)
                    { return std::string(k.name) == "blockSteps" && k.launches > 0; });
            };
            EXPECT_TRUE(ran(one->kernels()));
            EXPECT_FALSE(ran(each->kernels()));
        }
    }
}

RIPRAP_DEM_CASES(DemOneBlock);

} // namespace
} // namespace riprap

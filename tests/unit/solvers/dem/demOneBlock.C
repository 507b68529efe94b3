/*  Steps of a small scene in one launch (solvers/dem/demBlockSteps.hpp) have the bits of those in a launch each, which is what they are while kernels are timed.

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
                    addParticle(in, {{0.02*i - 0.1, 0.02*j - 0.4, D == 3 ? 0.02*k - 0.1 : 0}}, {{1.5, -1, D == 3 ? 0.4 : 0}});
        in.bondTypes.emplace_back();
        in.bondTypes[0].normalStiffness = in.bondTypes[0].shearStiffness = 2e4;
        in.bondTypes[0].tensileStrength = D == 2 ? 30 : 300;
        in.bonds = bondsWithin(c, in.particles, 0, 1e-6);
        std::mt19937 engine(5);
        std::uniform_real_distribution<double> u(-1, 1);
        for (int i = 0; i < loose; ++i)
            addParticle(in, {{0.4*u(engine), 0.2 + 0.2*u(engine), D == 3 ? 0.4*u(engine) : 0}}, {{u(engine), u(engine), D == 3 ? u(engine) : 0}}, 0.008 + 0.002*u(engine));
        addBox(in, D);
        return in;
    }

    static constexpr double fall = 4;       // of bodies, [m/s]

    //- The block as rigid bodies of so many members each
    DemInput withBodies(const DemConfig& c, DemInput in, int members, int each) const
    {
        const int D = c.dimensions;
        in.bonds = DemBonds();
        in.bondTypes.clear();
        in.particles.clump.assign(in.particles.size(), -1);
        for (int first = 0; first < members; first += each)
        {
            DemClump body;
            for (int i = first; i < first + each; ++i)
            {
                in.particles.clump[i] = int(in.clumps.size());
                body.mass += in.particles.mass[i];
                for (int d = 0; d < 3; ++d) body.position[d] += in.particles.position[3*i + d]/each;
            }
            for (int i = first; i < first + each; ++i)
                for (int d = 0; d < 3; ++d)
                {
                    body.inertia[d] += 0.5*in.particles.mass[i]*std::pow(in.particles.radius[i], 2);
                    for (int e = 0; e < 3; ++e)
                        if (e != d) body.inertia[d] += in.particles.mass[i]*std::pow(in.particles.position[3*i + e] - body.position[e], 2);
                }
            body.velocity = {{1.5, -fall, D == 3 ? 0.4 : 0}};
            body.spin = {{D == 3 ? 2.0 : 0, 0, 3}};
            in.clumps.push_back(body);
        }
        return in;
    }

    static bool ran(const DemScene& s, const char* name)
    {
        const auto kernels = s.kernels();
        return std::any_of(kernels.begin(), kernels.end(), [&](const KernelInfo& k) { return std::string(k.name) == name && k.launches > 0; });
    }
};

TEST_P(DemOneBlock, BitsOfALaunchEach)
{
    for (const int D : {2, 3})
    {
        DemConfig c = config(D);
        c.integrator = DemIntegratorKind::velocityVerlet;
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
            EXPECT_TRUE(ran(*one, "blockSteps"));
            EXPECT_FALSE(ran(*each, "blockSteps"));
        }
    }
}

//- Sums over the members of a large body are those of a block of threads, over those of small ones those of one thread
TEST_P(DemOneBlock, BitsOfALaunchEachWithBodies)
{
    for (const int D : {2, 3})
        for (const bool large : {true, false})
        {
            DemConfig c = config(D);
            c.integrator = DemIntegratorKind::velocityVerlet;
            c.tangential = "history";
            c.stepFraction = 0.1;
            c.gravity = {{0, -9.81, 0}};
            const int members = D == 2 ? 100 : 125;
            const DemInput in = withBodies(c, scene(c, D == 2 ? 10 : 5, 60), members, large ? members : members/5);
            auto one = createDemScene(c, in), each = createDemScene(c, in);
            each->timeKernels(true);
            for (int k = 0; k < 3; ++k)
            {
                ASSERT_EQ(one->advance(1e9, 70).stop, DemStop::none);
                ASSERT_EQ(each->advance(1e9, 70).stop, DemStop::none);
                const DemState a = one->particles(), b = each->particles();
                ASSERT_EQ(a.id, b.id);
                EXPECT_EQ(a.position, b.position) << D << " " << k;
                EXPECT_EQ(a.velocity, b.velocity) << D << " " << k;
                const DemClumpState p = one->clumps(), q = each->clumps();
                EXPECT_EQ(p.position, q.position) << D << " " << k;
                EXPECT_EQ(p.orientation, q.orientation) << D << " " << k;
                EXPECT_EQ(p.force, q.force) << D << " " << k;
                EXPECT_EQ(p.moment, q.moment) << D << " " << k;
            }
            EXPECT_GT(one->clumps().velocity[1], -fall) << "it must have met the floor";
            if (GetParam().device == DeviceKind::gpu)
            {
                EXPECT_TRUE(ran(*one, "blockSteps"));
                EXPECT_FALSE(ran(*each, "blockSteps"));
            }
        }
}

RIPRAP_DEM_CASES(DemOneBlock);

} // namespace
} // namespace riprap

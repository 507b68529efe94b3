/*  What the GPU does, on the CPU: full lists in blocks of 32, forces gathered, histories kept at
    both ends, each step one kernel, in batches that switch themselves off. A backend that says it
    is a GPU and runs its kernels here is compared with the CPU's own way.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "solvers/dem/demFamilies.hpp"
#include "dem/demTest.hpp"

namespace riprap
{

//- The law of this test alone, of 35 that a solver would be compiled for
template<class F>
void withHertz(const LawChoice& c, F f)
{
    ASSERT_EQ(c.normal, NormalLaws::find(Hertz::word));
    ASSERT_EQ(c.tangential, TangentialLaws::find(Mindlin::word,
        [](auto law) { return decltype(law)::type::template goesWith<Hertz>; }));
    ASSERT_EQ(c.rolling, RollingLaws::find(RollingSpring::word));
    f(Contact<Hertz, Mindlin, RollingSpring>());
}

} // namespace riprap

#define withLaw withHertz
#include "solvers/dem/driver/demAll.hpp"
#undef withLaw

namespace riprap
{

struct GpuLike { static constexpr bool gpu = true; };

template<>
class Context<GpuLike> : public Context<Cpu>
{
};

inline void sortPairs(Context<GpuLike>& context, SortScratch<GpuLike>& s, int n, int bits)
{ sortPairs(static_cast<Context<Cpu>&>(context), reinterpret_cast<SortScratch<Cpu>&>(s), n, bits); }

inline void exclusiveScan(Context<GpuLike>& context, SortScratch<GpuLike>& s, int* data, int n)
{
    exclusiveScan(
        static_cast<Context<Cpu>&>(context), reinterpret_cast<SortScratch<Cpu>&>(s), data, n);
}

inline std::string deviceLabel(GpuLike) { return "a CPU in the way of a GPU"; }

namespace
{

//- A heap that falls together in a box: friction, rolling, bonds, a clump, walls
DemInput heap(DemConfig& c)
{
    c.dimensions = 3;
    c.device = DeviceKind::cpu;
    c.precision = PrecisionKind::doubled;
    c.domainMin = Vector3{{-0.5, -0.5, -0.5}};
    c.domainMax = Vector3{{0.5, 0.5, 0.5}};
    c.periodic[2] = true;
    c.gravity = Vector3{{0, -9.81, 0}};
    c.tangential = "history";
    c.rolling = "spring";
    c.stepFraction = 0.1;
    c.skin = 0.1;
    DemInput in = oneMaterial();
    in.materials[0].young = 1e6;
    PairProperties& p = in.pairs[0].properties;
    p.friction = 0.4;
    p.restitution = 0.5;
    p.rollingFriction = 0.05;
    std::mt19937 engine(8);
    std::uniform_real_distribution<double> u(-1, 1);
    for (int k = 0; k < 500; ++k)
    {
        const int layer = k/64;
        const double r = 0.02*std::pow(3.0, 0.25*(u(engine) - 1));
        addParticle(in,
            {{-0.13 + 0.036*(k % 8), -0.4 + 0.036*(k/8 % 8), -0.15 + 0.036*layer}},
            {{0.3*u(engine), 0.3*u(engine), 0.3*u(engine)}}, r, 1e4*r*r*r);
    }
    for (const double side : {-1.0, 1.0})
        in.walls.push_back(planeWall({{side*0.16, 0, 0}}, {{-side, 0, 0}}));
    in.walls.push_back(planeWall({{0, -0.42, 0}}, {{0, 1, 0}}));
    DemBondType t;
    t.normalStiffness = t.shearStiffness = 1e6;
    t.tensileStrength = 1e4;
    in.bondTypes.push_back(t);
    in.bonds.a = {0, 1, 8};
    in.bonds.b = {1, 2, 9};
    return in;
}

TEST(DemGather, FullListsAgreeWithHalfLists)
{
    DemConfig c;
    const DemInput in = heap(c);
    auto half = createDemScene(c, in);
    DemSolver<GpuLike, 3, Double> full(c, in, planDemScene(c, in));
    EXPECT_NEAR(full.neighboursPerParticle(), half->neighboursPerParticle(), 1e-9);
    DemState a, b;
    // apart by rounding alone while chaos has not had its time
    for (int k = 1; k <= 4; ++k)
    {
        const DemReport r = half->advance(1e9, 100), q = full.advance(1e9, 100);
        ASSERT_EQ(r.stop, DemStop::none) << r.stopMessage;
        ASSERT_EQ(q.stop, DemStop::none) << q.stopMessage;
        EXPECT_EQ(r.time, q.time);
        EXPECT_EQ(r.brokenBonds, q.brokenBonds);
        a = half->particles();
        b = full.particles();
        for (std::size_t i = 0; i < a.id.size(); ++i)
        {
            const std::size_t j = find(b, a.id[i]);
            for (int d = 0; d < 3; ++d)
            {
                ASSERT_NEAR(a.position[3*i + d], b.position[3*j + d], 1e-9) << "step " << 100*k;
                ASSERT_NEAR(a.spin[3*i + d], b.spin[3*j + d], 1e-4) << "step " << 100*k;
            }
            EXPECT_EQ(a.contacts[i], b.contacts[j]);
        }
        EXPECT_NEAR(
            half->energy().total(), full.energy().total(), 1e-9*std::abs(full.energy().total()));
    }
    EXPECT_GT(half->contacts().a.size(), 100u);
}

//- The same disks by float arithmetic, where steps keep positions and velocities in two words each
TEST(DemGather, MixedPrecisionKeepsWholePositions)
{
    DemConfig c;
    DemInput in = heap(c);
    c.dimensions = 2;
    c.periodic[2] = false;
    c.precision = PrecisionKind::mixed;
    in.walls.resize(2);
    in.bonds = DemBonds();
    DemParticles all = in.particles;
    in.particles = DemParticles();
    for (int k = 0; k < 64; ++k)
        addParticle(in, at(all.position, k), at(all.velocity, k), all.radius[k], all.mass[k]);
    auto half = createDemScene(c, in);
    DemSolver<GpuLike, 2, Mixed> full(c, in, planDemScene(c, in));
    half->advance(1e9, 150);
    // stopping and going on changes nothing
    for (const int steps : {1, 2, 40, 107}) full.advance(1e9, steps);
    EXPECT_EQ(half->time(), full.time());
    const DemState a = half->particles(), b = full.particles();
    for (std::size_t i = 0; i < a.id.size(); ++i)
        for (int d = 0; d < 2; ++d)
        {
            EXPECT_NEAR(a.position[3*i + d], b.position[3*find(b, a.id[i]) + d], 1e-7);
            EXPECT_NEAR(a.force[3*i + d], b.force[3*find(b, a.id[i]) + d], 1e-2);
        }
    EXPECT_NEAR(
        half->energy().total(), full.energy().total(), 1e-5*std::abs(full.energy().total()));
}

//- However many steps a call takes, the same bits: fused steps stop and go on in the middle
TEST(DemGather, CallsDoNotMatter)
{
    DemConfig c;
    const DemInput in = heap(c);
    const DemPlan plan = planDemScene(c, in);
    DemSolver<GpuLike, 3, Double> one(c, in, plan), many(c, in, plan);
    const DemReport r = one.advance(1e9, 60);
    ASSERT_EQ(r.stop, DemStop::none) << r.stopMessage;
    for (int k = 0; k < 60; k += 3) many.advance(1e9, 3);
    EXPECT_EQ(one.time(), many.time());
    const DemState a = one.particles(), b = many.particles();
    for (std::size_t i = 0; i < a.id.size(); ++i)
        for (int d = 0; d < 3; ++d)
            EXPECT_NEAR(a.position[3*i + d], b.position[3*find(b, a.id[i]) + d], 1e-12);
}

//- Saved in the middle and loaded into another: bit for bit
TEST(DemGather, RestartIsExact)
{
    DemConfig c;
    const DemInput in = heap(c);
    const DemPlan plan = planDemScene(c, in);
    DemSolver<GpuLike, 3, Double> first(c, in, plan), second(c, in, plan);
    first.advance(1e9, 250);
    const auto saved = first.saveState();
    second.loadState(saved);
    EXPECT_EQ(second.saveState(), first.saveState());
    first.advance(1e9, 150);
    second.advance(1e9, 150);
    EXPECT_EQ(first.time(), second.time());
    EXPECT_EQ(first.particles().position, second.particles().position);
    EXPECT_EQ(first.particles().spin, second.particles().spin);
}

} // namespace
} // namespace riprap

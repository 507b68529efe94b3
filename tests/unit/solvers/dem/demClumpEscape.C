/*  Rigid bodies that leave the domain: as one, while what stays goes on as if they had never been;
    energy and a restart know of it.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <algorithm>
#include "dem/demTest.hpp"

namespace riprap
{
namespace
{

using DemClumpEscape = DemTest;

//- Two dumbbells and a ball: the first flies up at 1 m/s, the other one and the ball towards each
//  other
DemInput two()
{
    DemInput in = oneMaterial(1e3);
    for (const double side : {1.0, -1.0})
    {
        DemClump k;
        k.mass = 0.02;
        k.inertia = {{1e-5, 1e-5, 1e-5}};
        k.position = {{0.2*side, side > 0 ? 0.4 : -0.2, 0}};
        k.velocity = side > 0 ? Vector3{{0, 1, 0}} : Vector3{{0.3, 0, 0}};
        for (const double x : {-0.02, 0.02})
        {
            addParticle(in, {{k.position[0] + x, k.position[1], 0}}, k.velocity, 0.015);
            in.particles.clump.push_back(int(in.clumps.size()));
        }
        in.clumps.push_back(k);
    }
    addParticle(in, {{-0.05, -0.195, 0}}, {{-0.3, 0, 0}});
    in.particles.clump.push_back(-1);
    return in;
}

//- The same without those particles
DemInput without(const DemInput& all, const std::vector<std::int32_t>& gone)
{
    DemInput in = all;
    in.particles = DemParticles();
    for (int i = 0; i < int(all.particles.size()); ++i)
    {
        if (std::count(gone.begin(), gone.end(), i)) continue;
        addParticle(in, at(all.particles.position, i), at(all.particles.velocity, i),
            all.particles.radius[i], all.particles.mass[i]);
        in.particles.clump.push_back(all.particles.clump[i]);
        in.particles.id.push_back(i);
    }
    return in;
}

TEST_P(DemClumpEscape, LeavesAsOne)
{
    for (const int D : {2, 3})
    {
        const DemConfig c = config(D);
        const DemInput in = two();
        auto scene = createDemScene(c, in);
        const double before = scene->energy().total();
        EXPECT_TRUE(scene->advance(0.09).escaped.empty()) << D;
        const DemReport r = scene->advance(0.12);
        EXPECT_EQ(r.stop, DemStop::none) << r.stopMessage;
        std::vector<std::int32_t> gone = r.escapedId;
        std::sort(gone.begin(), gone.end());
        EXPECT_EQ(gone, (std::vector<std::int32_t>{0, 1})) << D;
        EXPECT_EQ(r.particles, 3u);
        const DemClumpState bodies = scene->clumps();
        EXPECT_TRUE(bodies.left[0]);
        EXPECT_FALSE(bodies.left[1]);
        EXPECT_NEAR(bodies.position[1], 0.5, 0.01) << "it stays where it left";
        EXPECT_NEAR(scene->energy().total(), before - 0.5*0.02, 1e-6*before) << D;

        // what stays does what it does alone
        auto alone = createDemScene(c, without(in, gone));
        EXPECT_TRUE(alone->clumps().left[0]);
        for (const double t : {0.09, 0.12}) alone->advance(t);      // the same steps
        scene->advance(0.4);
        alone->advance(0.4);
        const DemState a = scene->particles(), b = alone->particles();
        ASSERT_EQ(a.id.size(), 3u);
        for (const int id : {2, 3, 4})
            for (int d = 0; d < 3; ++d)
                EXPECT_NEAR(at(a.position, find(a, id))[d], at(b.position, find(b, id))[d],
                    mixed() ? 1e-5 : 1e-9)
                    << D << ' ' << id;
        EXPECT_LT(at(a.velocity, find(a, 2))[0], 0.2) << "they have met";
    }
}

TEST_P(DemClumpEscape, GoesOnToTheBit)
{
    const DemConfig c = config(3);
    const DemInput in = two();
    auto scene = createDemScene(c, in);
    scene->advance(0.12);
    const auto saved = scene->saveState();
    auto other = createDemScene(c, without(in, {0, 1}));
    other->loadState(saved);
    scene->advance(0.4);
    other->advance(0.4);
    EXPECT_EQ(other->saveState(), scene->saveState());
}

RIPRAP_DEM_CASES(DemClumpEscape);

} // namespace
} // namespace riprap

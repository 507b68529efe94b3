/*  What is summed on the device is what a loop over all particles finds.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "dem/demTest.hpp"

namespace riprap
{
namespace
{

using DemSums = DemTest;

//- Spheres of many sizes in two groups that fly about in a box, and a body of two
DemInput flying(int dimensions)
{
    DemInput in = oneMaterial();
    in.groups.assign(2, DemGroup());
    in.groups[1].gravity = false;
    in.groups[1].viscousDamping = 2;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> among(-1, 1);
    const int across = 6;
    for (int k = 0; k < (dimensions == 3 ? across : 1); ++k)
        for (int j = 0; j < across; ++j)
            for (int i = 0; i < across; ++i)
            {
                const Vector3 x{
                    {0.12*(i - 2.5), 0.12*(j - 2.5), dimensions == 3 ? 0.12*(k - 2.5) : 0}};
                addParticle(in, x,
                    {{among(random), among(random), dimensions == 3 ? among(random) : 0}},
                    0.03 + 0.02*std::abs(among(random)));
                in.particles.group.push_back((i + j + k) % 2);
                in.particles.clump.push_back(-1);
                for (int d = 0; d < 3; ++d)
                    in.particles.spin[in.particles.spin.size() - 1 - d] = dimensions == 3 || d == 0
                        ? 5*among(random)
                        : 0;
            }
    in.particles.clump[0] = in.particles.clump[2] = 0;
    DemClump body;
    body.mass = 0.02;
    for (int d = 0; d < 3; ++d)
    {
        body.inertia[d] = 1e-4;
        body.position[d] = 0.5*(in.particles.position[d] + in.particles.position[6 + d]);
    }
    in.clumps.push_back(body);
    addBox(in, dimensions);
    return in;
}

TEST_P(DemSums, AreThoseOfALoop)
{
    for (const int D : {2, 3})
    {
        DemConfig c = config(D);
        c.gravity = Vector3{{0.5, -9.81, 0}};
        const DemInput in = flying(D);
        const auto scene = createDemScene(c, in);
        scene->advance(1e30, 400);
        const DemState s = scene->motion();
        ASSERT_EQ(s.id.size(), in.particles.size());
        const double eps = mixed() ? 1e-6 : 1e-12;
        DemMomentum all;
        for (int group = 0; group < 2; ++group)
        {
            DemGroupSums r;
            for (int d = 0; d < D; ++d) { r.min[d] = 1e300; r.max[d] = -1e300; }
            for (std::size_t i = 0; i < s.id.size(); ++i)
            {
                if (s.group[i] != group) continue;
                r.particles += 1;
                const double m = s.mass[i];
                for (int d = 0; d < D; ++d)
                {
                    r.min[d] = std::min(r.min[d], s.position[3*i + d] - s.radius[i]);
                    r.max[d] = std::max(r.max[d], s.position[3*i + d] + s.radius[i]);
                }
                if (s.clump[i] >= 0) continue;
                r.mass += m;
                const Vector3 x = at(s.position, i), u = at(s.velocity, i);
                for (int d = 0; d < D; ++d)
                {
                    r.massPosition[d] += m*x[d];
                    r.momentum[d] += m*u[d];
                    all.linear[d] += m*u[d];
                }
                for (int d = D == 2 ? 2 : 0; d < 3; ++d)
                    all.angular[d] += m
                            *(x[(d + 1) % 3]*u[(d + 2) % 3] - x[(d + 2) % 3]*u[(d + 1) % 3])
                        + (D == 2 ? 0.5 : 0.4)*m*s.radius[i]*s.radius[i]*s.spin[3*i + d];
            }
            const DemGroupSums found = scene->groupSums(group);
            EXPECT_EQ(found.particles, r.particles);
            EXPECT_NEAR(found.mass, r.mass, eps*r.mass);
            for (int d = 0; d < 3; ++d)
            {
                EXPECT_NEAR(found.massPosition[d], r.massPosition[d], eps) << D << " " << d;
                EXPECT_NEAR(found.momentum[d], r.momentum[d], eps) << D << " " << d;
                EXPECT_NEAR(found.min[d], r.min[d], eps);
                EXPECT_NEAR(found.max[d], r.max[d], eps);
            }
        }
        const DemMomentum found = scene->momentum();
        for (int d = 0; d < 3; ++d)
        {
            EXPECT_NEAR(found.linear[d], all.linear[d], eps) << D << " " << d;
            EXPECT_NEAR(found.angular[d], all.angular[d], eps) << D << " " << d;
        }
        EXPECT_GT(std::abs(found.angular[2]), 1e-3);
    }
}

RIPRAP_DEM_CASES(DemSums);

} // namespace
} // namespace riprap

/*  A rigid body of more members than a block of the GPU sums at once: a ball hits its corner.
    Momentum and moment of momentum of both, energy, the same bits again.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "dem/demTest.hpp"

namespace riprap
{
namespace
{

using DemLargeClump = DemTest;

struct Blow
{
    DemConfig config;
    DemInput in;
    double inertia = 0;
};

//- `across` spheres a side about the origin, and a ball on its way to the corner with the lowest x
//  and the highest y (and z)
Blow blow(const DemConfig& c, int D, int across)
{
    const double size = 0.02, offset = 0.5*(across - 1)*size;
    Blow b{c, oneMaterial()};
    DemClump body;
    for (int k = 0; k < (D == 3 ? across : 1); ++k)
        for (int j = 0; j < across; ++j)
            for (int i = 0; i < across; ++i)
            {
                const double x = i*size - offset, y = j*size - offset,
                             z = D == 3 ? k*size - offset : 0;
                addParticle(b.in, {{x, y, z}}, {{0, 0, 0}}, 0.5*size);
                body.mass += 0.01;
                b.inertia += 0.01*(x*x + y*y);
            }
    // a cube: the same about every axis
    for (int d = 0; d < 3; ++d) body.inertia[d] = b.inertia;
    b.in.particles.clump.assign(b.in.particles.size(), 0);
    b.in.clumps.push_back(body);
    addParticle(
        b.in, {{-offset - 1.2*size, offset, D == 3 ? offset : 0}}, {{1, 0, 0}}, 0.5*size, 0.3);
    b.in.particles.clump.push_back(-1);
    return b;
}

//- Momentum, and moment of momentum about the origin, of ball and body
std::array<double, 6> momenta(DemScene& scene, const Blow& b)
{
    std::array<double, 6> r{};
    const auto add = [&](double mass, const double* x, const double* v)
    {
        for (int d = 0; d < 3; ++d)
        {
            const int e = (d + 1)%3, f = (d + 2)%3;
            r[d] += mass*v[d];
            r[3 + d] += mass*(x[e]*v[f] - x[f]*v[e]);
        }
    };
    const DemState s = scene.particles();
    const std::size_t ball = find(s, int(b.in.particles.size()) - 1);
    add(0.3, &s.position[3*ball], &s.velocity[3*ball]);
    const DemClumpState c = scene.clumps();
    add(b.in.clumps[0].mass, c.position.data(), c.velocity.data());
    for (int d = 0; d < 3; ++d) r[3 + d] += b.inertia*c.spin[d];
    return r;
}

TEST_P(DemLargeClump, KeepsWhatABallBrings)
{
    for (const int D : {2, 3})
        for (const int across : {3, D == 3 ? 7 : 19})
        {
            SCOPED_TRACE(std::to_string(D) + "D, " + std::to_string(across) + " a side");
            const Blow b = blow(config(D), D, across);
            std::vector<double> bits[2];
            for (auto& now : bits)
            {
                auto scene = createDemScene(b.config, b.in);
                const auto before = momenta(*scene, b);
                const double energy = scene->energy().total();
                scene->advance(0.03, 100000);
                ASSERT_EQ(scene->contacts().a.size(), 0u) << "they must have parted again";
                const auto after = momenta(*scene, b);
                const DemClumpState c = scene->clumps();
                EXPECT_GT(c.velocity[0], 0.1*0.3/b.in.clumps[0].mass) << "the ball must have hit";
                EXPECT_LT(c.spin[2], -0.01) << "and turned it";
                for (int k = 0; k < 6; ++k)
                    EXPECT_NEAR(after[k], before[k], (mixed() ? 1e-6 : 1e-12)*0.3) << k;
                EXPECT_NEAR(scene->energy().total(), energy, 1e-3*energy);
                now = c.velocity;
                now.insert(now.end(), c.spin.begin(), c.spin.end());
            }
            EXPECT_EQ(bits[0], bits[1]);
        }
}

RIPRAP_DEM_CASES(DemLargeClump);

} // namespace
} // namespace riprap

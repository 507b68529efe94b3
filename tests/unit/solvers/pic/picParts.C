/*  Parts of the solver of water in cells by themselves (solvers/pic/parts, solvers/pic/driver):
    particles that come in, what openings remember, who is near a seed.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <gtest/gtest.h>
#include <stdexcept>
#include "solvers/pic/driver/fluidSeeding.hpp"

namespace riprap
{
namespace
{

//- A unit square of n cells a side, gravity along -y
PicConfig square(int n)
{
    PicConfig c;
    c.dimensions = 2;
    c.cells[0] = c.cells[1] = n;
    c.cellSize = 1.0/n;
    c.spacing = 0.5*c.cellSize;
    c.density = 1000;
    c.gravity = Vector3{{0, -9.81, 0}};
    return c;
}

using Setting = PicSetting<Cpu, 2, Double>;
using Particles = PicParticleFields<Cpu, 2, Double>;
using Openings = OpenSides<Cpu, 2, Double>;

TEST(PicParticleFields, KeepWhatTheyHaveWhenMoreComeIn)
{
    Setting set(square(8));
    Particles particles(set);
    particles.fill({0.1, 0.2, -3, 0.4}, {1, 2, 3, 4}, std::vector<double>(8, 0.0), {7, 5});
    std::vector<EnteringParticle<2>> more(100, {{{0.5, 0.6}}, {{5, 6}}, 0, 0});
    for (int k = 0; k < 100; ++k) more[k].id = 8 + k;
    particles.append(more);
    ASSERT_EQ(particles.n, 102);
    const PicParticles<2, double> view = particles.view();
    EXPECT_EQ(view.x[0][0], 0.1);
    EXPECT_GT(view.x[0][1], 0);             // of one outside: at the side it was beyond
    EXPECT_LT(view.x[0][1], 0.01*set.grid.h);
    EXPECT_EQ(view.v[1][1], 4);
    EXPECT_EQ(view.id[0], 7);
    EXPECT_EQ(view.id[1], 5);
    EXPECT_EQ(view.id[2], 8);
    EXPECT_EQ(view.id[101], 107);
    EXPECT_EQ(view.x[1][101], 0.6);
    EXPECT_EQ(view.v[0][101], 5);
    set.clock.particleVolume = 0.5;
    const Vec<2, double> momentum = particles.momentum();
    EXPECT_DOUBLE_EQ(momentum[0], 500*(1 + 3 + 100*5.0));
    EXPECT_DOUBLE_EQ(momentum[1], 500*(2 + 4 + 100*6.0));
}

//- The lower side along x belongs to opening 0, the upper one to 1
struct Channel
{
    Setting set{square(8)};
    Openings openings{set};

    Channel()
    {
        std::vector<int> opening[3];
        opening[0].assign(set.grid.faces(0), -1);
        for (int i = 0; i < set.grid.faces(0); ++i)
        {
            const int layer = set.grid.faceIndex(0, i).c[0];
            if (layer == 0 || layer == set.grid.n[0]) opening[0][i] = layer ? 1 : 0;
        }
        openings.faces = openFaces(set.grid, opening, Vec<2, double>{{0, 1}});
        for (int d = 0; d < 2; ++d) openings.number[d].assign(set.grid.faces(d), -1);
        for (const OpenFace<2>& f : openings.faces)
            openings.number[f.direction][f.face] = f.opening;
        openings.in = {3, 5};
        openings.out = {1, 2};
        openings.volume = {0.25, -0.5};
        openings.owed = {0, 0.125};
        openings.faces.front().kept = 0.0625;
        openings.faces.front().turn = 3;
    }
};

TEST(OpenSides, TellThroughWhichOpeningAParticleHasLeft)
{
    Channel c;
    c.set.clock.particleVolume = 0.0625;
    EXPECT_TRUE(c.openings.takeLeft(Vec<2, double>{{-1e-6, 0.5}}));
    EXPECT_EQ(c.openings.out, (std::vector<std::int64_t>{2, 2}));
    EXPECT_TRUE(c.openings.takeLeft(Vec<2, double>{{1 + 1e-6, 0.5}}));
    EXPECT_EQ(c.openings.out, (std::vector<std::int64_t>{2, 3}));
    EXPECT_FALSE(c.openings.takeLeft(Vec<2, double>{{0.5, 1.1}}));
    EXPECT_FALSE(c.openings.takeLeft(Vec<2, double>{{0.5, 0.5}}));
    EXPECT_EQ(c.openings.out, (std::vector<std::int64_t>{2, 3}));
    EXPECT_EQ(c.openings.volume, (std::vector<double>{0.1875, -0.5625}));
    EXPECT_EQ(c.openings.owed, (std::vector<double>{-0.0625, 0.0625}));
}

TEST(OpenSides, RememberWhatHasComeInAndGoneOut)
{
    const Channel from;
    Channel to;
    to.openings.in = to.openings.out = {0, 0};
    to.openings.volume = to.openings.owed = {0, 0};
    to.openings.faces.front().kept = 0;
    to.openings.faces.front().turn = 0;
    EXPECT_EQ(to.openings.balance(), 0);
    const std::vector<double> memory = from.openings.memory();
    ASSERT_EQ(memory.size(), from.openings.memorySize());
    to.openings.setMemory(memory.data());
    EXPECT_EQ(to.openings.memory(), memory);
    EXPECT_EQ(to.openings.in, from.openings.in);
    EXPECT_EQ(to.openings.out, from.openings.out);
    EXPECT_EQ(to.openings.faces.front().turn, 3);
    EXPECT_EQ(to.openings.balance(from.openings.faces.front().opening), 0.0625);
    EXPECT_EQ(to.openings.balance(1), -0.125);
    EXPECT_EQ(to.openings.balance(), 0.0625 - 0.125);
}

TEST(ParticleBoxes, FindEachParticleWithinTheirReachOnce)
{
    const Setting set(square(8));
    const double reach = 0.15;
    std::vector<double> x;
    for (int k = 0; k < 400; ++k)
    {
        x.push_back(std::fmod(0.754877666*k, 1));
        x.push_back(std::fmod(0.569840291*k, 1));
    }
    const ParticleBoxes<2> boxes(set.grid, reach, x);
    for (const Vec<2, double> at : {Vec<2, double>{{0.5, 0.5}}, Vec<2, double>{{0.001, 0.999}},
             Vec<2, double>{{0.81, 0.33}}, Vec<2, double>{{1, 0}}})
    {
        std::vector<int> found(x.size()/2, 0);
        boxes.eachAbout(at.c, [&](int p) { ++found[p]; });
        for (std::size_t p = 0; p < found.size(); ++p)
        {
            const bool near = std::hypot(x[2*p] - at.c[0], x[2*p + 1] - at.c[1]) < reach;
            EXPECT_LE(found[p], 1);
            EXPECT_TRUE(found[p] || !near) << p;
        }
        EXPECT_LT(std::count(found.begin(), found.end(), 1), 200);      // nor are all looked at
    }
}

} // namespace
} // namespace riprap

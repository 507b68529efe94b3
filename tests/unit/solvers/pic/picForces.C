/*  Forces of PIC scenes on parts of walls and on solids: shear between walls, water at rest, an
    obstacle that moves through the grid.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "picSolidScene.hpp"
#include "pic/grid/uniformGrid.hpp"

namespace riprap
{
namespace
{

class PicForces : public PicSolidScene
{
protected:

    //- Sides of the unit box, closed: part 2 d + 1 is the upper one along direction d
    PicWalls sides(const PicConfig& c) const
    {
        PicWalls w;
        UniformGrid<3> g;
        for (int d = 0; d < 3; ++d) g.n[d] = c.cells[d];
        for (int d = 0; d < D(); ++d)
        {
            w.part[d].assign(g.faces(d), -1);
            for (int f = 0; f < g.faces(d) && !c.periodic[d]; ++f)
            {
                const int layer = g.faceIndex(d, f).c[d];
                if (layer == 0 || layer == g.n[d]) w.part[d][f] = 2*d + (layer > 0);
            }
        }
        return w;
    }

    //- A box, part 9
    PicObstacle block(const Vector3& low, const Vector3& high) const
    {
        PicObstacle o;
        o.name = "block";
        o.part = 9;
        for (int k = 0; k < (D() == 2 ? 4 : 8); ++k)
        {
            const bool right = D() == 2 ? k == 1 || k == 2 : k & 1, top = D() == 2 ? k > 1 : k & 2,
                       back = k & 4;
            o.vertices.insert(o.vertices.end(),
                {right ? high[0] : low[0], top ? high[1] : low[1],
                    D() == 3 && back ? high[2] : low[2]});
        }
        if (D() == 2) o.elements = {0, 1, 1, 2, 2, 3, 3, 0};
        else
            o.elements = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0,
                4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
        return o;
    }

    //- Of each part
    static std::vector<FluidForce> sums(const std::vector<FluidForce>& forces)
    {
        std::vector<FluidForce> all(10);
        for (const FluidForce& f : forces)
            for (int k = 0; k < 3; ++k)
            {
                all[f.part].pressure[k] += f.pressure[k];
                all[f.part].viscous[k] += f.viscous[k];
            }
        return all;
    }

    static bool everywhere(double, double) { return true; }
};

RIPRAP_ALL_SETUPS(PicForces);

//- Couette flow from rest (Morris, Fox & Zhu 1997), nu = 0.1: mu du/dy at both walls. Velocities
//  are those of the middle of the last step
TEST_P(PicForces, ShearOnWallsThatSlide)
{
    if (D() == 3) GTEST_SKIP() << "a plane flow";
    PicConfig c = config(20);
    c.gravity = {{0, 0, 0}};
    c.viscosity = 100;
    c.noSlip = true;
    c.slide[1][1] = {{1, 0, 0}};
    c.periodic[0] = true;
    c.jitter = 0.5;
    const auto s = createPicScene(c, box(c, {{0, 0, 0}}, {{1, 1, 1}}, everywhere), sides(c));
    const double t = 1 - 0.5*s->advance(1).lastTimeStep;
    double below = 1, above = 1;
    for (int n = 1; n < 200; ++n)
    {
        below += 2*(n % 2 ? -1 : 1)*std::exp(-n*n*M_PI*M_PI*0.1*t);
        above += 2*std::exp(-n*n*M_PI*M_PI*0.1*t);
    }
    const auto f = sums(s->forcesOnWalls());
    // of second order over 20 cells
    EXPECT_NEAR(f[2].viscous[0], 100*below, 0.01*100*below);
    EXPECT_NEAR(f[3].viscous[0], -100*above, 0.01*100*above);
}

//- Each side by the depth, a block between the planes of the grid and a held ball by what they
//  displace
TEST_P(PicForces, InWaterAtRest)
{
    PicConfig c = config(16);
    const double depth = 0.75, weight = c.density*9.81;
    const auto pool = box(c, {{0, 0, 0}}, {{1, depth, 1}}, everywhere);
    const auto run = [&](PicInside inside)
    {
        auto s = createPicScene(c, pool, sides(c), nullptr, std::move(inside));
        EXPECT_TRUE(s->forcesOnWalls().empty()) << "nothing is known before the first step";
        s->advance(0.02);
        return s;
    };
    PicInside withBlock;
    withBlock.obstacles.push_back(block({{0.31, 0.22, 0.29}}, {{0.66, 0.47, 0.64}}));
    auto s = run(std::move(withBlock));
    const auto f = sums(s->forcesOnWalls());
    const double side = weight*depth*depth/2, volume = 0.35*0.25*(D() == 3 ? 0.35 : 1);
    // cells that the block cuts settle the surface by a little
    EXPECT_NEAR(f[0].pressure[0], -side, 0.003*side);
    EXPECT_NEAR(f[1].pressure[0], side, 0.003*side);
    EXPECT_NEAR(f[2].pressure[1], -weight*depth, 0.003*weight*depth);
    EXPECT_NEAR(f[9].pressure[1], weight*volume, 0.003*weight*volume);
    EXPECT_NEAR(f[9].pressure[0], 0, 0.003*weight*volume);
    EXPECT_EQ(f[9].viscous[0], 0);

    PicInside withBall;
    auto solids = balls(c, {{{0.51, 0.4, 0.48}}}, 0.2, 2000);
    solids->input.groups.resize(1);
    for (bool& held : solids->input.groups[0].held) held = true;
    solids->input.groups[0].heldSpin = true;
    withBall.solids = solids;
    s = run(std::move(withBall));
    const auto ball = s->forcesOnSolids();
    ASSERT_EQ(ball.size(), 1u);
    const double displaced = weight*(D() == 2 ? M_PI*0.04 : 4*M_PI/3*0.008);
    EXPECT_NEAR(ball[0].pressure[1], displaced, 0.03*displaced) << "3.2 cells of radius";
    EXPECT_NEAR(ball[0].pressure[1], s->coupling().force[1], 1e-9*displaced);
    EXPECT_EQ(ball[0].viscous[1], 0);
    EXPECT_NEAR(ball[0].place[0], 0.51, 1e-6);
}

//- Slowly through water at rest: as it passes cell after cell nothing is lost or counted twice
TEST_P(PicForces, OnABlockThatMoves)
{
    if (D() == 3 && !mixed()) GTEST_SKIP() << "seconds saved";
    PicConfig c = config(16);
    const double speed = 0.05, weight = c.density*9.81, volume = 0.3*0.25*(D() == 3 ? 0.3 : 1);
    PicInside inside;
    inside.obstacles.push_back(block({{0.3, 0.2, 0.3}}, {{0.6, 0.45, 0.6}}));
    inside.obstacles[0].body = 0;
    inside.motion = [&](int, double t) { WallPose p; p.translation = {{speed*t, 0, 0}}; return p; };
    const auto s = createPicScene(c,
        box(c, {{0, 0, 0}}, {{1, 0.75, 1}}, [](double, double) { return true; }), sides(c), nullptr,
        std::move(inside));
    s->advance(0.2);                        // it was set in motion at once
    for (int k = 0; k < 30; ++k)
    {
        s->advance(0.2 + 0.05*(k + 1));     // 1.2 cells in all
        const auto f = sums(s->forcesOnWalls());
        EXPECT_NEAR(f[9].pressure[1], weight*volume, 0.05*weight*volume) << k;
        EXPECT_NEAR(f[9].pressure[0], 0, 0.05*weight*volume) << k;
    }
}

} // namespace
} // namespace riprap

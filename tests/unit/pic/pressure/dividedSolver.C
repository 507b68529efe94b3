/*  The pressure of a block that ranks divide, threads here, against that of one process.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "pressureBlock.hpp"
#include "core/threadRanks.hpp"
#include "pic/ranks/haloExchange.hpp"

namespace riprap
{
namespace
{

struct Solved { std::vector<double> p; PressureReport report; };

//- Twice: with a surface and velocities, then with others and the same surface
template<int D, class R>
Solved divided(const Block<D, R>& first, const Block<D, R>& b, Transport& t, double tolerance)
{
    Context<Cpu> context;
    const GridBricks<D> bricks(t, b.grid, {}, 1);
    const HaloExchange<Cpu, D> halo(context, bricks);
    PressureFields<D, R> f{};
    f.grid = bricks.partGrid();
    f.timeStep = b.timeStep;
    f.density = b.density;
    Array<Cpu, R> phi, aperture[D], u[D];
    Array<Cpu, double> p;
    const auto load = [&](const Block<D, R>& from)
    {
        phi.upload(context, halo.partOf(from.phi, -1));
        p.upload(context, halo.partOf(from.p, -1));
        for (int d = 0; d < D; ++d)
        {
            aperture[d].upload(context, halo.partOf(from.aperture[d], d));
            u[d].upload(context, halo.partOf(from.u[d], d));
            f.aperture[d] = aperture[d].data();
            f.u[d] = u[d].data();
        }
        f.phi = phi.data();
        f.p = p.data();
    };
    PressureStep<Cpu, D, R> step;
    step.allocate(context, f.grid);
    step.divide(context, bricks);
    MultigridControls controls;
    controls.tolerance = tolerance;
    controls.maxIter = 100;
    Solved s;
    load(first);
    step.solveDivided(context, f, false, controls);
    load(b);
    s.report = step.solveDivided(context, f, true, controls);
    s.p = halo.gather(p, -1);
    return s;
}

//- Under waves, with a drop above them; velocities at random
template<int D, class R>
Block<D, R> waves(std::array<int, 3> n, std::array<bool, 3> ring, unsigned seed)
{
    Block<D, R> b(n, 1.0/32, ring);
    for (int i = 0; i < b.grid.cells(); ++i)
    {
        const Point x = b.centre(i);
        const double top = n[1]/32.0,
                     level = top*(0.5 + 0.3*std::sin(6*x[0]) + (D == 3 ? 0.1*std::cos(9*x[2]) : 0)),
                     drop = std::hypot(x[0] - 0.5, x[1] - 0.9*top) - 0.07;
        b.phi[i] = R(std::min(x[1] - level, drop));
    }
    std::mt19937 engine(seed);
    for (int d = 0; d < D; ++d)
        for (R& u : b.u[d]) u = R(engine()/4294967296.0 - 0.5);
    return b;
}

//- before: the same water with other velocities
template<int D, class R>
void compare(const Block<D, R>& before, const Block<D, R>& start, const std::vector<int>& ranks)
{
    const double tolerance = 1e-11;
    Block<D, R> one = start;
    auto solver = tight(tolerance);
    one.project(solver, &before);
    EXPECT_TRUE(one.report.converged);
    EXPECT_GT(one.report.iterations, 3);
    double most = 0;
    for (const double p : one.p) most = std::max(most, std::fabs(p));
    for (const int count : ranks)
        onRanks(count, [&](Transport& t)
        {
            const Solved s = divided(before, start, t, tolerance);
            EXPECT_TRUE(s.report.converged);
            EXPECT_EQ(s.report.wetCells, one.report.wetCells);
            EXPECT_NEAR(s.report.iterations, one.report.iterations, 1) << count << " ranks";
            double off = 0;
            for (std::size_t i = 0; i < s.p.size(); ++i)
                off = std::max(off, std::fabs(s.p[i] - one.p[i]));
            EXPECT_LT(off, 1e-9*most) << count << " ranks";
        });
}

template<int D, class R>
void compareWaves(std::array<int, 3> n, std::array<bool, 3> ring, const std::vector<int>& ranks)
{
    compare(waves<D, R>(n, ring, 1), waves<D, R>(n, ring, 2), ranks);
}

TEST(DividedSolver, plane)
{
    compareWaves<2, double>({96, 40, 1}, {}, {1, 2, 5});
    compareWaves<2, float>({70, 43, 1}, {}, {4});
}

TEST(DividedSolver, space)
{
    compareWaves<3, double>({32, 24, 24}, {}, {2, 5});
    compareWaves<3, float>({37, 29, 9}, {}, {3});
}

TEST(DividedSolver, rings)
{
    compareWaves<2, double>({64, 32, 1}, {true, false, false}, {3});
    compareWaves<2, double>({45, 40, 1}, {true, false, false}, {3});
    compareWaves<3, double>({64, 24, 9}, {false, false, true}, {2});
}

//- Closes the faces on the surface of a box of cells
template<int D, class R>
void enclose(Block<D, R>& b, const std::array<int, 3>& low, const std::array<int, 3>& high)
{
    for (int d = 0; d < D; ++d)
        b.eachFace(d, [&](int f, const auto& x)
        {
            bool beside = x.c[d] == low[d] || x.c[d] == high[d];
            for (int e = 0; e < D; ++e)
                beside = beside && (e == d || (x.c[e] >= low[e] && x.c[e] < high[e]));
            if (beside) b.aperture[d][f] = 0;
        });
}

//- Opens the faces between two rows of cells again, along direction 1, or closes them
template<int D, class R>
void setRow(Block<D, R>& b, int from, int to, int row, R open)
{
    b.eachFace(1, [&](int f, const auto& x)
    {
        if (x.c[1] == row && x.c[0] >= from && x.c[0] < to) b.aperture[1][f] = open;
    });
}

//- Under waves: a room in one brick, one in several, one whose two floors are joined in another
//  brick alone, one whose way out is there, and a small one
template<int D, class R>
Block<D, R> rooms(std::array<int, 3> n, unsigned seed)
{
    Block<D, R> b = waves<D, R>(n, {}, seed);
    for (int i = 0; i < b.grid.cells(); ++i) b.phi[i] = R(b.centre(i)[1] - (n[1] - 5.3)/32);
    const int deep = n[2], front = D == 3 ? 1 : 0;
    enclose(b, {3, 2, front}, {9, 6, deep});
    const int end = D == 2 ? 90 : 44;
    enclose(b, {D == 2 ? 12 : 26, 3, front}, {end, 7, deep});
    setRow(b, 12, end - 2, 5, R(0));        // two floors, joined at the end
    enclose(b, {10, 9, front}, {70, 21, deep});
    enclose(b, {72, 10, front}, {80, 24, deep});
    setRow(b, 72, 80, 24, R(0.5));          // whose lid is open
    enclose(b, {92, 20, front}, {94, 21, D == 3 ? 2 : 1});
    return b;
}

//- Under a flat surface two rooms that are closed in the middle brick. Their ways out, to the left
//  of one and to the right of the other, are in the others, and nothing else joins the bricks
template<class R>
Block<2, R> waysOut(unsigned seed)
{
    Block<2, R> b = waves<2, R>({96, 8, 1}, {}, seed);
    for (int i = 0; i < b.grid.cells(); ++i) b.phi[i] = R(b.centre(i)[1] - 6.3/32);
    const auto set = [&](int column, int row, int value)
    { b.aperture[0][b.grid.face(0, {{column, row, 0}})] = R(value); };
    enclose(b, {20, 3, 0}, {45, 5, 1});
    set(20, 3, 1);
    enclose(b, {50, 0, 0}, {80, 2, 1});
    set(80, 1, 1);
    for (int row = 0; row < 8; ++row)
    {
        if (row < 3 || row > 4) set(32, row, 0);
        if (row > 1) set(64, row, 0);
    }
    return b;
}

//- Pockets are the same ones, and what their sides squeeze is spread alike
TEST(DividedSolver, pockets)
{
    compare(rooms<2, double>({96, 32, 1}, 1), rooms<2, double>({96, 32, 1}, 2), {5});
    compare(rooms<3, double>({96, 32, 3}, 1), rooms<3, double>({96, 32, 3}, 2), {3});
    compare(waysOut<double>(1), waysOut<double>(2), {3});
    compare(waysOut<float>(1), waysOut<float>(2), {3});
}

TEST(DividedSolver, waterWithoutASurface)
{
    Block<2, double> b = waves<2, double>({64, 32, 1}, {}, 3),
                     c = waves<2, double>({64, 32, 1}, {}, 4);
    for (Block<2, double>* block : {&b, &c}) block->phi.assign(block->phi.size(), -1.0);
    compare(b, c, {3});
}

} // namespace
} // namespace riprap

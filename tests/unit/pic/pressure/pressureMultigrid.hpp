/*  The multigrid-preconditioned solver on plain arrays: against a solution that is known, on open,
    closed, periodic and random domains; iterations that do not grow with the grid; the same bits
    with any number of threads.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <functional>
#include "backendTest.hpp"
#include "pic/projection/multigridSolver.hpp"

namespace riprap
{
namespace
{

//- A system on the host, in the solver's layout
template<int D>
struct GridSystem
{
    GridShape<D> shape;
    std::vector<double> a[D], s, rhs, x, exact;

    explicit GridSystem(const GridShape<D>& g) : shape(g)
    {
        for (auto& v : a) v.assign(g.cells, 0);
        for (auto* v : {&s, &rhs, &x, &exact}) v->assign(g.cells, 0);
    }

    template<class F>
    void eachCell(const F& f) const
    {
        for (int i = 0; i < shape.cells; ++i)
        {
            const Place<D> p = shape.place(i);
            if (shape.inside(p)) f(p);
        }
    }

    //- Faces between wet cells get coefficient(), those to dry ones tie() to p = 0
    template<class Wet, class Face, class Tie>
    void fill(const bool* periodic, const Wet& wet, const Face& coefficient, const Tie& tie)
    {
        eachCell([&](const Place<D>& p)
        {
            for (int d = 0; d < D; ++d)
            {
                if (p.x[d] == 0 && !periodic[d]) continue;
                Place<D> n = p;
                n.c = shape.below(p, d);
                n.x[d] = p.x[d] == 0 ? shape.n[d] - 1 : p.x[d] - 1;
                if (wet(p) && wet(n)) a[d][p.c] = coefficient(d, p);
                else if (wet(p)) s[p.c] += tie();
                else if (wet(n)) s[n.c] += tie();
            }
        });
    }

    double apply(const Place<D>& p, const std::vector<double>& v) const
    {
        double sum = s[p.c]*v[p.c];
        for (int d = 0; d < D; ++d)
        {
            const int below = shape.below(p, d), above = shape.above(p, d);
            if (a[d][p.c] != 0) sum += a[d][p.c]*(v[p.c] - v[below]);
            if (above < shape.cells && a[d][above] != 0) sum += a[d][above]*(v[p.c] - v[above]);
        }
        return sum;
    }

    double diagonal(const Place<D>& p) const
    {
        double sum = s[p.c];
        for (int d = 0; d < D; ++d)
        {
            const int above = shape.above(p, d);
            sum += a[d][p.c] + (above < shape.cells ? a[d][above] : 0);
        }
        return sum;
    }

    void makeRhs()
    {
        eachCell(
            [&](const Place<D>& p)
            {
                if (diagonal(p) > 0) rhs[p.c] = apply(p, exact);
                else exact[p.c] = 0;
            });
    }
};

template<int D>
struct Solved
{
    PressureReport report;
    std::vector<double> x;
};

template<int D>
Solved<D> solveGrid(const int* n, const bool* periodic,
    const std::function<void(GridSystem<D>&)>& fill, MultigridControls controls,
    GridSystem<D>* keep = nullptr)
{
    Context<Backend> context;
    MultigridSolver<Backend, D> solver;
    solver.allocate(context, n, periodic);
    GridSystem<D> g(solver.fine().shape);
    fill(g);
    const std::size_t bytes = g.s.size()*sizeof(double);
    for (int d = 0; d < D; ++d) context.toDevice(solver.fine().a[d], g.a[d].data(), bytes);
    context.toDevice(solver.fine().s, g.s.data(), bytes);
    context.toDevice(solver.fine().rhs, g.rhs.data(), bytes);
    context.toDevice(solver.fine().x, g.x.data(), bytes);
    solver.setUp(context);
    Solved<D> r;
    r.report = solver.solve(context, controls);
    r.x.resize(g.s.size());
    context.toHost(r.x.data(), solver.fine().x, bytes);
    if (keep) *keep = g;
    return r;
}

//- Water below a wavy surface with holes, or anything: rough coefficients in 0.05 .. 1
template<int D>
void roughSea(GridSystem<D>& g, const bool* periodic, bool closed)
{
    Random random(7);
    const auto wet = [&](const Place<D>& p)
    {
        if (closed) return true;
        const double u = (p.x[0] + 0.5)/g.shape.n[0], w = (p.x[D - 1] + 0.5)/g.shape.n[D - 1];
        const double hole = (u - 0.4)*(u - 0.4) + (w - 0.2)*(w - 0.2);
        return w < 0.5 + 0.2*std::sin(6*u) && hole > 0.01;
    };
    g.fill(
        periodic, wet, [&](int, const Place<D>&) { return random(0.05, 1); },
        [&] { return random(0.5, 3); });
    g.eachCell([&](const Place<D>& p) { g.exact[p.c] = random(-1, 1) + p.x[0]; });
    g.makeRhs();
}

template<class C> struct MultigridCase : BackendTest {};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
struct DimensionNames
{
    template<class C> static std::string GetName(int)
    {
        return std::string(Backend::gpu ? "Gpu" : "Cpu") + char('0' + C::value);
    }
};
#ifdef __CUDACC__
template<class C> struct GpuMultigrid : MultigridCase<C> {};
#define MULTIGRID_TEST(name) TYPED_TEST(GpuMultigrid, name)
TYPED_TEST_SUITE(GpuMultigrid, Dimensions, DimensionNames);
#else
template<class C> struct CpuMultigrid : MultigridCase<C> {};
#define MULTIGRID_TEST(name) TYPED_TEST(CpuMultigrid, name)
TYPED_TEST_SUITE(CpuMultigrid, Dimensions, DimensionNames);
#endif

MULTIGRID_TEST(FindsTheKnownSolution)
{
    constexpr int D = TypeParam::value;
    const int sizes[][3] = {{1, 1, 1}, {2, 3, 2}, {17, 9, 5}, {33, 31, 8}, {64, 32, 10}};
    for (const auto& n : sizes)
        for (int ring = 0; ring < 3; ++ring)
        {
            // a cell that is its own neighbour has no equation
            if (n[0] == 1 && ring) continue;
            const bool periodic[3] = {ring > 0, ring > 1, ring > 1};
            MultigridControls controls;
            controls.tolerance = 1e-13;
            controls.maxIter = 60;
            GridSystem<D> g{GridShape<D>{}};
            const auto r = solveGrid<D>(
                n, periodic, [&](GridSystem<D>& s) { roughSea(s, periodic, false); }, controls, &g);
            EXPECT_TRUE(r.report.converged) << n[0] << " x " << n[1] << " ring " << ring
                                            << " residual " << r.report.finalResidual;
            double worst = 0;
            g.eachCell([&](const Place<D>& p)
                { worst = std::max(worst, std::fabs(r.x[p.c] - g.exact[p.c])); });
            // the residual's 1e-13 times the condition of the matrix, about (2 n)^2
            EXPECT_LT(worst, 1e-13*4*64*64*n[0]) << n[0] << " x " << n[1] << " ring " << ring;
        }
}

MULTIGRID_TEST(ClosedTankIsSolvedUpToAConstant)
{
    constexpr int D = TypeParam::value;
    const int n[3] = {40, 24, 12};
    for (int ring = 0; ring < 2; ++ring)
    {
        const bool periodic[3] = {ring > 0, ring > 0, ring > 0};
        MultigridControls controls;
        controls.tolerance = 1e-12;
        controls.maxIter = 60;
        GridSystem<D> g{GridShape<D>{}};
        const auto r = solveGrid<D>(
            n, periodic, [&](GridSystem<D>& s) { roughSea(s, periodic, true); }, controls, &g);
        EXPECT_TRUE(r.report.converged) << r.report.finalResidual;
        double low = 1e30, high = -1e30;
        g.eachCell([&](const Place<D>& p)
        {
            const double e = r.x[p.c] - g.exact[p.c];
            low = std::min(low, e);
            high = std::max(high, e);
        });
        EXPECT_LT(high - low, 1e-12*4*64*64*n[0]);
    }
}

MULTIGRID_TEST(IterationsDoNotGrowWithTheGrid)
{
    constexpr int D = TypeParam::value;
    int before = 10;
    for (const int side : {16, 32, D == 2 ? 256 : 64})
    {
        const int n[3] = {side, side, side};
        const bool periodic[3] = {};
        const auto r = solveGrid<D>(n, periodic, [&](GridSystem<D>& g)
        {
            // unit coefficients below a surface that lies at a third of a cell above the last row
            // but one
            const auto wet = [&](const Place<D>& p) { return p.x[D - 1] < side - 2; };
            g.fill(periodic, wet, [](int, const Place<D>&) { return 1.0; }, [] { return 3.0; });
            Random random(3);
            g.eachCell([&](const Place<D>& p) { g.exact[p.c] = random(-1, 1); });
            g.makeRhs();
        }, MultigridControls{});
        EXPECT_TRUE(r.report.converged);
        // 8 to 13 in the measurements that the coarsening was chosen by
        EXPECT_LE(r.report.iterations, 13) << side;
        EXPECT_LE(r.report.iterations, before + 3) << side;
        before = r.report.iterations;
    }
}

MULTIGRID_TEST(RepeatsBitForBit)
{
    constexpr int D = TypeParam::value;
    const int n[3] = {50, 41, 12};
    const bool periodic[3] = {};
    std::vector<double> first;
    withThreads(
        [&](int threads)
        {
            const auto r = solveGrid<D>(
                n, periodic, [&](GridSystem<D>& s) { roughSea(s, periodic, false); },
                MultigridControls{});
            if (first.empty()) first = r.x;
            EXPECT_TRUE(first == r.x) << threads << " threads";
        });
}

//- A V-cycle with the sweeps of a level in one launch (2D) and small levels near, or in eight and
//  where they are, closed and around rings of even and odd length, over two tiled levels
template<int D>
void sweepsTogetherAsApart()
{
    for (const int ring : {0, 1, 2})
    {
        const int n[3] = {ring == 2 ? 151 : 152, D == 2 ? 131 : 51, 12};
        const bool periodic[3] = {ring > 0, false, false};
        std::vector<float> z[2];
        for (const bool together : {false, true})
        {
            Context<Backend> context;
            MultigridSolver<Backend, D> solver;
            solver.sweepTogether(together && D == 2);
            solver.bringNear(together);
            solver.allocate(context, n, periodic);
            GridSystem<D> g(solver.fine().shape);
            roughSea(g, periodic, false);
            const std::size_t bytes = g.s.size()*sizeof(double);
            for (int d = 0; d < D; ++d) context.toDevice(solver.fine().a[d], g.a[d].data(), bytes);
            context.toDevice(solver.fine().s, g.s.data(), bytes);
            context.toDevice(solver.fine().x, g.x.data(), bytes);
            solver.setUp(context);
            for (int pass = 0; pass < 2; ++pass)            // the second time there are leftovers
            {
                std::vector<float> b(g.rhs.begin(), g.rhs.end());
                for (float& v : b) v *= 1 + pass;
                context.toDevice(solver.fine().b, b.data(), b.size()*sizeof(float));
                solver.precondition(context, 2);
            }
            z[together].resize(g.s.size());
            context.toHost(z[together].data(), solver.fine().z, g.s.size()*sizeof(float));
        }
        float largest = 0;
        for (const float v : z[0]) largest = std::max(largest, std::abs(v));
        EXPECT_GT(largest, 1);
        for (std::size_t i = 0; i < z[0].size(); ++i)
            ASSERT_NEAR(z[1][i], z[0][i], 1e-5*largest) << ring << " " << i;
    }
}

MULTIGRID_TEST(SweepsTogetherAsApart)
{
    sweepsTogetherAsApart<TypeParam::value>();
}

MULTIGRID_TEST(NothingToSolve)
{
    constexpr int D = TypeParam::value;
    const int n[3] = {20, 20, 20};
    const bool periodic[3] = {};
    const auto dry = solveGrid<D>(n, periodic, [](GridSystem<D>&) {}, MultigridControls{});
    EXPECT_TRUE(dry.report.converged);
    EXPECT_EQ(dry.report.wetCells, 0);
    EXPECT_EQ(dry.report.iterations, 0);
    for (const double x : dry.x) ASSERT_EQ(x, 0);
    const auto still = solveGrid<D>(n, periodic, [&](GridSystem<D>& s)
    {
        roughSea(s, periodic, false);
        std::fill(s.rhs.begin(), s.rhs.end(), 0.0);
    }, MultigridControls{});
    EXPECT_EQ(still.report.iterations, 0);
    for (const double x : still.x) ASSERT_EQ(x, 0);
}

} // namespace
} // namespace riprap

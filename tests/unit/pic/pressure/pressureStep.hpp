/*  The pressure step: manufactured solutions, water at rest, fluxes that balance whatever the
    apertures, pockets, lone cells, and the host's way against the device's.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "pressureBlock.hpp"

namespace riprap
{
namespace
{

template<class C> struct PressureStepCase : BackendTest {};
#ifdef __CUDACC__
template<class C> struct GpuPressure : PressureStepCase<C> {};
#define PRESSURE_TEST(name) TYPED_TEST(GpuPressure, name)
TYPED_TEST_SUITE(GpuPressure, AllCases, CaseNames);
#else
template<class C> struct CpuPressure : PressureStepCase<C> {};
#define PRESSURE_TEST(name) TYPED_TEST(CpuPressure, name)
TYPED_TEST_SUITE(CpuPressure, AllCases, CaseNames);
#endif

//- Root mean square error of p against p = phi (1 + x^3 + y^3) with u* = dt/rho grad p, which
//  leaves no flow at all
template<class C>
double manufacturedError(int cells, const Point& normal, double offset)
{
    constexpr int D = C::D;
    using R = typename C::real;
    const double h = 1.0/cells;
    Block<D, R> b({cells, cells, cells}, h);
    const auto distance = [&](const Point& x)
    {
        double s = -offset;
        for (int d = 0; d < D; ++d) s += normal[d]*x[d];
        return s;
    };
    const auto exact = [&](const Point& x)
    { return distance(x)*(1 + std::pow(x[0], 3) + std::pow(x[1], 3)); };
    for (int i = 0; i < b.grid.cells(); ++i) b.phi[i] = R(distance(b.centre(i)));
    for (int d = 0; d < D; ++d)
        b.eachFace(d, [&](int f, const auto&)
        {
            const Point x = b.faceCentre(d, f);
            const double slope = normal[d]*(1 + std::pow(x[0], 3) + std::pow(x[1], 3))
                + (d < 2 ? distance(x)*3*x[d]*x[d] : 0);
            b.u[d][f] = R(b.timeStep/b.density*slope);
        });
    auto solver = tight();
    b.project(solver);
    EXPECT_TRUE(b.report.converged);
    double sum = 0;
    for (int i = 0; i < b.grid.cells(); ++i)
        if (b.wet(i)) sum += std::pow(b.p[i] - exact(b.centre(i)), 2)/b.report.wetCells;
    return std::sqrt(sum);
}

// (the largest error has a part of 0.01 h |grad p|, where theta is clamped)
PRESSURE_TEST(SecondOrderWithFlatAndInclinedSurface)
{
    constexpr int D = TypeParam::D;
    if (TypeParam::mixed)
        GTEST_SKIP() << "the velocities that drive it are rounded: only double shows an order";
    const Point flat = D == 2 ? Point{0, 1, 0} : Point{0, 0, 1},
                inclined = D == 2 ? Point{0.6, 0.8, 0} : Point{0.36, 0.48, 0.8};
    for (const Point& n : {flat, inclined})
    {
        const int coarse = D == 2 ? 16 : 10;
        const double e0 = manufacturedError<TypeParam>(coarse, n, 0.63),
                     e2 = manufacturedError<TypeParam>(4*coarse, n, 0.63);
        EXPECT_GT(std::log2(e0/e2)/2, 1.8) << "from " << e0 << " to " << e2;
    }
}

PRESSURE_TEST(WaterAtRestAtAnyLevel)
{
    constexpr int D = TypeParam::D;
    using R = typename TypeParam::real;
    const double h = 0.05, g = 9.81;
    for (const double level : {0.5025, 0.512, 0.5249, 0.5251, 0.5256, 0.549})
    {
        Block<D, R> b({9, 14, 14}, h);
        for (int i = 0; i < b.grid.cells(); ++i) b.phi[i] = R(b.centre(i)[D - 1] - level);
        for (R& u : b.u[D - 1]) u = R(-g*b.timeStep);
        auto solver = tight();
        b.project(solver);
        EXPECT_LT(b.largestSpeed(), 1e-11 + 8*TypeParam::epsilon*g*b.timeStep) << level;
        // theta 0.002 is taken as 0.01: at rest, with p higher by its share of a cell
        if (level == 0.5251) continue;
        for (int i = 0; i < b.grid.cells(); ++i)
            if (b.wet(i))
            {
                const double expected = b.density*g*(level - b.centre(i)[D - 1]);
                ASSERT_NEAR(b.p[i], expected,
                    1e-8*b.density*g + 20*TypeParam::epsilon*b.density*g)
                    << level;
            }
    }
}

PRESSURE_TEST(FluxesBalanceWhateverTheApertures)
{
    constexpr int D = TypeParam::D;
    using R = typename TypeParam::real;
    for (int ring = 0; ring < 3; ++ring)
    {
        Random random(5 + ring);
        Block<D, R> b({23, 18, 9}, 0.1, {ring > 0, ring > 1, ring > 1});
        for (R& phi : b.phi) phi = R(random(-1, 0.4));
        for (int d = 0; d < D; ++d)
            b.eachFace(d, [&](int f, const auto& x)
            {
                const bool end = !b.grid.periodic[d] && (x.c[d] == 0 || x.c[d] == b.grid.n[d]);
                // open above
                if (end) b.aperture[d][f] = R(d == D - 1 && x.c[d] > 0 ? 1 : 0);
                else b.aperture[d][f] = R(random(-0.3, 1));
                if (b.aperture[d][f] < 0) b.aperture[d][f] = 0;
                b.u[d][f] = R(random(-1, 1));
                b.wall[d][f] = R(random(-1, 1));
            });
        for (int d = 0; d < D; ++d)
            if (b.grid.periodic[d])
                b.eachFace(d, [&](int f, auto x)
                {
                    if (x.c[d] != b.grid.n[d]) return;
                    x.c[d] = 0;
                    const int first = b.grid.face(d, x);
                    b.aperture[d][f] = b.aperture[d][first];
                    b.u[d][f] = b.u[d][first];
                    b.wall[d][f] = b.wall[d][first];
                });
        auto solver = tight(1e-13);
        b.project(solver);
        EXPECT_TRUE(b.report.converged) << b.report.finalResidual;
        // no pocket is expected to be squeezed here: each wet cell has a dry neighbour or a way to
        // one
        if (b.pocketCells == 0) EXPECT_LT(b.largestImbalance(), 1e-9 + 2e3*TypeParam::epsilon);
        else ADD_FAILURE() << b.pocketCells << " cells in pockets";
        EXPECT_LT(b.report.iterations, 60);
    }
}

//- Two tanks side by side: one full to a lid that a piston squeezes, one with a surface
PRESSURE_TEST(PocketsDoNotDisturbOthers)
{
    constexpr int D = TypeParam::D;
    using R = typename TypeParam::real;
    const double h = 0.1, g = 9.81;
    Block<D, R> b({16, 11, 11}, h);
    const int wallAt = 7;
    b.eachFace(0, [&](int f, const auto& x)
    {
        if (x.c[0] == wallAt) b.aperture[0][f] = 0;
        if (x.c[0] == 0) b.wall[0][f] = R(0.3);
    });
    const double level = 0.73;
    for (int i = 0; i < b.grid.cells(); ++i)
        if (b.grid.cellIndex(i).c[0] >= wallAt) b.phi[i] = R(b.centre(i)[D - 1] - level);
    for (R& u : b.u[D - 1]) u = R(-g*b.timeStep);
    auto solver = tight();
    b.project(solver);
    EXPECT_TRUE(b.report.converged) << b.report.finalResidual;
    EXPECT_EQ(b.pocketCells, wallAt*11*(D == 2 ? 1 : 11));
    double mean = 0;
    double squeezed = 0;
    for (int i = 0; i < b.grid.cells(); ++i)
    {
        ASSERT_TRUE(std::isfinite(b.p[i]));
        if (b.grid.cellIndex(i).c[0] < wallAt)
        {
            mean += b.p[i]/b.pocketCells;
            squeezed += b.imbalance(i);
        }
        else if (b.wet(i))
        {
            ASSERT_NEAR(b.p[i], b.density*g*(level - b.centre(i)[D - 1]),
                1e-6*b.density*g + 20*TypeParam::epsilon*b.density*g);
            ASSERT_NEAR(b.imbalance(i), 0, 1e-9 + 100*TypeParam::epsilon);
        }
    }
    EXPECT_NEAR(mean, 0, 1e-6*b.density*g*h);
    // what the piston pushes in has nowhere to go: it is found spread over the pocket
    EXPECT_NEAR(squeezed, -0.3*11*(D == 2 ? 1 : 11), 1e-5);
}

//- A second projection of the same water keeps the coefficients of the first: to the bit what it is
//  by itself. With a tank without a surface, and drops
PRESSURE_TEST(SameWaterNeedsNoNewCoefficients)
{
    constexpr int D = TypeParam::D;
    using R = typename TypeParam::real;
    Random random(17);
    Block<D, R> b({40, 17, 6}, 0.1);
    b.eachFace(0, [&](int f, const auto& x) { if (x.c[0] == 9) b.aperture[0][f] = 0; });
    for (int i = 0; i < b.grid.cells(); ++i)
    {
        const auto x = b.grid.cellIndex(i);
        if (x.c[0] >= 9) b.phi[i] = R(x.c[0] > 24 ? random(-1, 2) : b.centre(i)[D - 1] - 0.4);
    }
    Block<D, R> other = b;
    other.timeStep = 3e-3;
    for (int d = 0; d < D; ++d)
        for (std::size_t f = 0; f < b.u[d].size(); ++f)
        {
            b.u[d][f] = R(random(-1, 1));
            other.u[d][f] = R(random(-1, 1));
        }
    for (double& p : b.p) p = random(-100, 100);
    Block<D, R> alone = b;
    auto solver = tight();
    alone.project(solver);
    b.project(solver, &other);
    EXPECT_GT(b.pocketCells, 0);
    EXPECT_EQ(b.report.iterations, alone.report.iterations);
    EXPECT_EQ(b.p, alone.p);
    for (int d = 0; d < D; ++d) { EXPECT_EQ(b.u[d], alone.u[d]); }
}

PRESSURE_TEST(LoneCellsFallFreely)
{
    constexpr int D = TypeParam::D;
    using R = typename TypeParam::real;
    Block<D, R> b({12, 12, 6}, 0.1);
    for (R& phi : b.phi) phi = R(1);
    const auto cell = [&](int i, int j, int k) { return b.grid.cell({{i, j, D == 3 ? k : 0}}); };
    b.phi[cell(4, 5, 3)] = R(-0.01);        // a drop
    b.phi[cell(8, 8, 2)] = R(-1);           // water walled in on all sides: no unknown
    for (int d = 0; d < D; ++d)
        for (int side = 0; side < 2; ++side)
            b.aperture[d][b.grid.faceOf(d, b.grid.cellIndex(cell(8, 8, 2)), side)] = 0;
    const R fall = R(-9.81e-3);
    for (R& u : b.u[1]) u = fall;
    auto solver = tight();
    b.project(solver);
    EXPECT_EQ(b.report.wetCells, 1);
    for (const R u : b.u[1]) ASSERT_EQ(u, fall);
    for (const double p : b.p) ASSERT_EQ(p, 0);
}

//- Conjugate gradients with the diagonal, on the host: another solver for the reduced system
class HostSolver : public LinearSolver
{
public:
    int calls = 0;

    PressureReport solve(ReducedSystem& s) override
    {
        ++calls;
        const int n = s.rows();
        const auto apply = [&](const std::vector<double>& v)
        {
            std::vector<double> r(n);
            for (int i = 0; i < n; ++i) r[i] = s.diagonal[i]*v[i];
            for (std::size_t f = 0; f < s.owner.size(); ++f)
            {
                EXPECT_LT(s.owner[f], s.neighbour[f]);
                const std::size_t b = f ? f - 1 : 0;
                EXPECT_TRUE(f == 0
                    || std::make_pair(s.owner[b], s.neighbour[b])
                        < std::make_pair(s.owner[f], s.neighbour[f]));
                r[s.owner[f]] += s.offDiagonal[f]*v[s.neighbour[f]];
                r[s.neighbour[f]] += s.offDiagonal[f]*v[s.owner[f]];
            }
            return r;
        };
        std::vector<double> r = apply(s.x), p(n, 0.0);
        for (int i = 0; i < n; ++i) r[i] = s.rhs[i] - r[i];
        double before = 0, first = 0;
        PressureReport report;
        for (report.iterations = 0; report.iterations < 4000; ++report.iterations)
        {
            double rz = 0;
            for (int i = 0; i < n; ++i) rz += r[i]*r[i]/s.diagonal[i];
            if (report.iterations == 0) first = rz;
            if (rz <= 1e-28*first) break;
            for (int i = 0; i < n; ++i)
                p[i] = r[i]/s.diagonal[i] + (before > 0 ? rz/before*p[i] : 0);
            before = rz;
            const std::vector<double> q = apply(p);
            double pq = 0;
            for (int i = 0; i < n; ++i) pq += p[i]*q[i];
            for (int i = 0; i < n; ++i) { s.x[i] += rz/pq*p[i]; r[i] -= rz/pq*q[i]; }
        }
        return report;
    }
};

PRESSURE_TEST(HostAndDeviceAgree)
{
    constexpr int D = TypeParam::D;
    using R = typename TypeParam::real;
    for (int ring = 0; ring < 3; ++ring)
    {
        const std::array<int, 3> n = ring == 2 ? std::array<int, 3>{2, 15, 1}
                                               : std::array<int, 3>{13, 15, 6};
        Block<D, R> a(n, 0.1, {ring > 0, false, ring > 1});
        Random random(11);
        for (int i = 0; i < a.grid.cells(); ++i)
            a.phi[i] = R(a.centre(i)[1] - 1.03 + 0.2*a.centre(i)[0]);
        for (R& u : a.u[1]) u = R(random(-1, 1));
        Block<D, R> b = a;
        auto multigrid = tight(1e-14);
        HostSolver host;
        a.project(multigrid);
        b.project(host);
        EXPECT_EQ(host.calls, 1);
        EXPECT_EQ(a.report.wetCells, b.report.wetCells);
        double largest = 0, worst = 0;
        for (int i = 0; i < a.grid.cells(); ++i)
        {
            largest = std::max(largest, std::fabs(a.p[i]));
            worst = std::max(worst, std::fabs(a.p[i] - b.p[i]));
        }
        EXPECT_GT(largest, 1);
        EXPECT_LT(worst, 1e-8*largest) << "ring " << ring;
    }
}

} // namespace
} // namespace riprap

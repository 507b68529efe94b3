/*  Maps between particles and grid: splines, conservation, exactness for constant and linear fields, angular momentum, orders of the motion.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "backendTest.hpp"
#include "core/cellSort.hpp"
#include "pic/transfer/gridToParticle.hpp"
#include "pic/transfer/moveParticles.hpp"
#include "pic/transfer/particleToGrid.hpp"

namespace riprap
{
namespace
{

template<class C> struct PicTransferCase : BackendTest {};
#ifdef __CUDACC__
template<class C> struct GpuPicTransfer : PicTransferCase<C> {};
#define PIC_TEST(name) TYPED_TEST(GpuPicTransfer, name)
TYPED_TEST_SUITE(GpuPicTransfer, AllCases, CaseNames);
#else
template<class C> struct CpuPicTransfer : PicTransferCase<C> {};
#define PIC_TEST(name) TYPED_TEST(CpuPicTransfer, name)
TYPED_TEST_SUITE(CpuPicTransfer, AllCases, CaseNames);
#endif

//- A block of cells with particles anywhere in it, sorted, on the device
template<class C>
struct Cloud
{
    static constexpr int D = C::D;
    using R = typename C::real;

    Context<Backend> context;
    UniformGrid<D> grid;
    FieldSet<Backend> set;
    CellSort<Backend> sort;
    ParticleToGrid<Backend, D, R> map;
    ActiveRows<Backend, D> rows;
    Array<Backend, PlaceInCell<R>> place;
    Array<Backend, R> water;
    int n;
    Array<Backend, R> u[D], mass[D];
    std::vector<double> x[D];

    //- velocity(x, d); margin: empty cells at the sides
    template<class F>
    Cloud(int cells, int perCell, int margin, const F& velocity, bool periodic = false) : grid(), n(0)
    {
        grid.h = 0.125;
        for (int d = 0; d < D; ++d) { grid.n[d] = cells + d; grid.origin[d] = 0; grid.periodic[d] = periodic; }
        Random random(7);
        n = perCell*grid.cells();
        std::vector<R> v[D];
        for (int i = 0; i < n; ++i)
        {
            Vec<D, double> at;
            for (int d = 0; d < D; ++d)
            {
                at.c[d] = grid.h*random(margin, grid.n[d] - margin);
                x[d].push_back(at.c[d]);
            }
            for (int d = 0; d < D; ++d) v[d].push_back(R(velocity(at, d)));
        }
        for (int d = 0; d < D; ++d) set.template add<double>("x");
        for (int d = 0; d < D; ++d) set.template add<R>("v");
        for (int d = 0; d < D*D; ++d) set.template add<R>("c");
        set.template add<std::int32_t>("id");
        set.allocate(context, n, true);
        sort.allocate(context, n, grid.cells());
        std::vector<std::int32_t> id(n);
        for (int i = 0; i < n; ++i) id[i] = i;
        for (int d = 0; d < D; ++d) { set.upload(context, d, x[d]); set.upload(context, D + d, v[d]); }
        for (int k = 0; k < D*D; ++k) set.upload(context, 2*D + k, std::vector<R>(n, R(0)));
        set.upload(context, 2*D + D*D, id);
        order();
        for (int d = 0; d < D; ++d)
        {
            u[d].allocate(context, grid.faces(d));
            mass[d].allocate(context, grid.faces(d));
        }
    }

    PicParticles<D, R> view(bool spare = false)
    {
        const auto field = [&](auto type, int k) { using T = decltype(type); return spare ? set.template spare<T>(k) : set.template data<T>(k); };
        PicParticles<D, R> p{};
        p.count = n;
        for (int d = 0; d < D; ++d) { p.x[d] = field(double(), d); p.v[d] = field(R(), D + d); }
        for (int k = 0; k < D*D; ++k) p.affine[k] = field(R(), 2*D + k);
        p.id = field(std::int32_t(), 2*D + D*D);
        p.place = place.data();
        p.start = sort.start();
        return p;
    }

    void order()
    {
        forEach(context, n, PicCellKeys<D, R>{grid, view(), sort.keys(), sort.indices()});
        sort.sort(context, n);
        place.allocate(context, n);
        forEach(context, n, PutInOrder<D, R>{1/grid.h, sort.order(), view(), view(true), place.data()});
        set.takeSpares();
    }

    template<int Order>
    void toGrid(bool affine = false)
    {
        map.prepare(context, grid, sort);
        water.upload(context, std::vector<R>(grid.cells(), R(-1)));
        rows.find(context, grid, map.occupied(), water.data(), sort);
        for (int d = 0; d < D; ++d) map.template map<Order>(context, grid, rows, view(), d, affine, nullptr, u[d].data(), mass[d].data());
    }

    Vec<D, double> faceAt(int d, int i) const
    {
        const auto f = grid.faceIndex(d, i);
        Vec<D, double> at;
        for (int a = 0; a < D; ++a) at.c[a] = grid.h*(f.c[a] + (a == d ? 0.0 : 0.5));
        return at;
    }

    //- Velocity of the particles from the grid, by PIC with the affine part
    template<int Order>
    void toParticles()
    {
        Array<Backend, unsigned char> near;
        near.upload(context, std::vector<unsigned char>(grid.cells(), 1));
        GridToParticle<Order, D, R> f{};
        f.grid = grid;
        f.particles = view();
        for (int d = 0; d < D; ++d) f.u[d] = f.du[d] = u[d].data();
        f.nearWater = near.data();
        f.picPart = 1;
        f.affine = true;
        forEach(context, n, f);
        context.synchronise();
    }
};

template<class F> void forOrders(const F& f)
{
    f(std::integral_constant<int, 1>());
    f(std::integral_constant<int, 2>());
    f(std::integral_constant<int, 3>());
}

PIC_TEST(SplinesSumToOneAndAreLinear)
{
    forOrders([](auto order)
    {
        using Spline = BSpline<decltype(order)::value>;
        Random random(3);
        for (int k = 0; k < 200; ++k)
        {
            const double s = random(-5, 5);
            double w[Spline::nodes], slope[Spline::nodes], sum = 0, first = 0, slopes = 0, firstSlope = 0;
            const int base = Spline::first(s);
            Spline::weights(s - base, w);
            Spline::slopes(s - base, slope);
            for (int i = 0; i < Spline::nodes; ++i)
            {
                sum += w[i];
                first += w[i]*(base + i);
                slopes += slope[i];
                firstSlope += slope[i]*(base + i);
                EXPECT_NEAR(w[i], Spline::value(s - base - i), 1e-14);
            }
            EXPECT_NEAR(sum, 1, 1e-14);
            EXPECT_NEAR(first, s, 1e-14);
            EXPECT_NEAR(slopes, 0, 1e-13);
            EXPECT_NEAR(firstSlope, 1, 1e-13);
        }
    });
}

//- Sums over faces are those over particles, to round-off of sums of that many numbers
PIC_TEST(MassAndMomentumAreConserved)
{
    using C = TypeParam;
    Random random(11);
    Cloud<C> cloud(8, 5, 2, [&](const Vec<C::D, double>&, int) { return random(-1, 1); });
    for (const bool affine : {false, true})
        forOrders([&](auto order)
        {
            if (affine) { cloud.template toGrid<decltype(order)::value>(); cloud.template toParticles<decltype(order)::value>(); }
            cloud.template toGrid<decltype(order)::value>(affine);
            for (int d = 0; d < C::D; ++d)
            {
                const auto u = cloud.u[d].download(), m = cloud.mass[d].download();
                const auto v = cloud.set.template download<typename C::real>(cloud.context, C::D + d);
                double mass = 0, momentum = 0, given = 0, size = 0;
                for (std::size_t i = 0; i < u.size(); ++i) { mass += m[i]; momentum += double(m[i])*u[i]; }
                for (const auto a : v) { given += a; size += std::abs(a); }
                EXPECT_NEAR(mass/cloud.n, 1, 100*C::epsilon);
                EXPECT_NEAR(momentum/size, given/size, 100*C::epsilon);
            }
        });
}

//- Mass and momentum of each face are the sums over all particles, seen directly and, beyond the sides, from the face's images
PIC_TEST(SumsAreThoseOverAllParticles)
{
    using C = TypeParam;
    constexpr int D = C::D;
    Random random(13);
    for (const bool periodic : {false, true})
    {
        Cloud<C> cloud(5, 3, 0, [&](const Vec<D, double>&, int) { return random(-1, 1); }, periodic);
        const UniformGrid<D>& g = cloud.grid;
        std::vector<double> x[D];
        for (int d = 0; d < D; ++d) x[d] = cloud.set.template download<double>(cloud.context, d);
        forOrders([&](auto order)
        {
            using Spline = BSpline<decltype(order)::value>;
            cloud.template toGrid<decltype(order)::value>();
            for (int d = 0; d < D; ++d)
            {
                const auto u = cloud.u[d].download(), m = cloud.mass[d].download();
                const auto v = cloud.set.template download<typename C::real>(cloud.context, D + d);
                for (int f = 0; f < g.faces(d); ++f)
                {
                    const Vec<D, double> at = cloud.faceAt(d, f);
                    double mass = 0, momentum = 0;
                    for (int p = 0; p < cloud.n; ++p)
                    {
                        double even = 1, odd = 1;       // products over the axes; odd: images turn the component round
                        for (int a = 0; a < D; ++a)
                        {
                            const double s = at.c[a]/g.h, xp = x[a][p]/g.h, n = g.n[a];
                            double direct = Spline::value(s - xp), image = 0;
                            if (periodic) direct += Spline::value(s + n - xp) + Spline::value(s - n - xp);
                            else if (s > 1e-9 && s < n - 1e-9) image = Spline::value(-s - xp) + Spline::value(2*n - s - xp);
                            even *= direct + image;
                            odd *= a == d ? direct - image : direct + image;
                        }
                        mass += even;
                        momentum += odd*v[p];
                    }
                    EXPECT_NEAR(m[f], mass, 200*C::epsilon);
                    EXPECT_NEAR(m[f]*u[f], momentum, 200*C::epsilon);
                }
            }
        });
    }
}

//- A constant comes through both ways, whatever the particles; beside walls, too, for what runs along them
PIC_TEST(ConstantsAreReproduced)
{
    using C = TypeParam;
    Cloud<C> cloud(8, 20, 0, [](const Vec<C::D, double>&, int d) { return 1.5 - d; }, true);
    forOrders([&](auto order)
    {
        cloud.template toGrid<decltype(order)::value>();
        for (int d = 0; d < C::D; ++d)
            for (const auto u : cloud.u[d].download()) EXPECT_NEAR(u, 1.5 - d, 200*C::epsilon);    // sums of up to 700 products
        cloud.template toParticles<decltype(order)::value>();
        for (int d = 0; d < C::D; ++d)
            for (const auto v : cloud.set.template download<typename C::real>(cloud.context, C::D + d)) EXPECT_NEAR(v, 1.5 - d, 50*C::epsilon);
    });
}

//- A linear field on the grid gives particles its values and, with all orders, its gradient
PIC_TEST(LinearFieldsAreReproduced)
{
    using C = TypeParam;
    constexpr int D = C::D;
    const auto linear = [](const Vec<D, double>& x, int d)
    {
        double value = 0.3;
        for (int a = 0; a < D; ++a) value += (0.7*d - 0.4*a + 0.2)*x.c[a];
        return value;
    };
    Cloud<C> cloud(8, 5, 2, linear);
    for (int d = 0; d < D; ++d)
    {
        std::vector<typename C::real> u(cloud.grid.faces(d));
        for (std::size_t i = 0; i < u.size(); ++i) u[i] = linear(cloud.faceAt(d, int(i)), d);
        cloud.u[d].upload(cloud.context, u);
    }
    forOrders([&](auto order)
    {
        cloud.template toParticles<decltype(order)::value>();
        std::vector<double> x[D];
        for (int d = 0; d < D; ++d) x[d] = cloud.set.template download<double>(cloud.context, d);
        for (int d = 0; d < D; ++d)
        {
            const auto v = cloud.set.template download<typename C::real>(cloud.context, D + d);
            for (int i = 0; i < cloud.n; ++i)
            {
                Vec<D, double> at;
                for (int a = 0; a < D; ++a) at.c[a] = x[a][i];
                EXPECT_NEAR(v[i], linear(at, d), 50*C::epsilon);
            }
            for (int a = 0; a < D; ++a)
                for (const auto c : cloud.set.template download<typename C::real>(cloud.context, 2*D + d*D + a))
                    EXPECT_NEAR(c, 0.7*d - 0.4*a + 0.2, 2000*C::epsilon);
        }
    });
    // and with it they give the grid the same field, wherever they lie about a face
    cloud.template toGrid<2>(true);
    for (int d = 0; d < D; ++d)
    {
        const auto u = cloud.u[d].download(), m = cloud.mass[d].download();
        for (std::size_t i = 0; i < u.size(); ++i)
            if (m[i] > 0.01) { EXPECT_NEAR(u[i], linear(cloud.faceAt(d, int(i)), d), 5000*C::epsilon); }
    }
}

//- Angular momentum about the origin after grid and back: kept by APIC (Jiang et al. 2015, section 5.3: x v + D C), lost by PIC
PIC_TEST(AffineTransferKeepsAngularMomentum)
{
    using C = TypeParam;
    constexpr int D = C::D;
    Random random(5);
    Cloud<C> cloud(9, 4, 2, [&](const Vec<D, double>& x, int d) { return (d == 0 ? -x.c[1] : (d == 1 ? x.c[0] : 0.0)) + random(-0.1, 0.1); });
    cloud.template toGrid<2>();
    double onGrid = 0, pic = 0, affine = 0;
    for (int d = 0; d < 2; ++d)
    {
        const auto u = cloud.u[d].download(), m = cloud.mass[d].download();
        for (std::size_t i = 0; i < u.size(); ++i)
            onGrid += (d == 1 ? 1 : -1)*cloud.faceAt(d, int(i)).c[1 - d]*double(m[i])*u[i];
    }
    cloud.template toParticles<2>();
    const double moment = BSpline<2>::secondMoment*cloud.grid.h*cloud.grid.h;
    for (int d = 0; d < 2; ++d)
    {
        const auto x = cloud.set.template download<double>(cloud.context, 1 - d);
        const auto v = cloud.set.template download<typename C::real>(cloud.context, D + d);
        const auto c = cloud.set.template download<typename C::real>(cloud.context, 2*D + d*D + 1 - d);
        for (int i = 0; i < cloud.n; ++i)
        {
            pic += (d == 1 ? 1 : -1)*x[i]*v[i];
            affine += (d == 1 ? 1 : -1)*(x[i]*v[i] + moment*c[i]);
        }
    }
    EXPECT_NEAR(affine/onGrid, 1, 1000*C::epsilon);
    EXPECT_GT(std::abs(pic/onGrid - 1), 1e-4);
}

struct MarkCell
{
    static constexpr const char* name = "markCell";
    unsigned char* to;
    HD void operator()(int i) const { to[i] = 1; }
};

//- Rows about the water are visited, those that it has left once more, and no others
PIC_TEST(RowsAreThoseAboutTheWater)
{
    using C = TypeParam;
    using R = typename C::real;
    constexpr int D = C::D;
    Context<Backend> context;
    UniformGrid<D> g{};
    g.h = 0.1;
    g.n[0] = 128;
    for (int d = 1; d < D; ++d) g.n[d] = 8;
    CellSort<Backend> sort;
    sort.allocate(context, 1, g.cells());
    sort.sort(context, 0);
    OccupiedTiles<Backend, D> particles;
    particles.find(context, g, sort);
    ActiveRows<Backend, D> rows;
    Array<Backend, R> phi;
    const auto visited = [&](bool both)
    {
        Array<Backend, unsigned char> marks;
        marks.upload(context, std::vector<unsigned char>(g.cells(), 0));
        if (both) rows.eachCellOfBoth(context, MarkCell{marks.data()});
        else rows.eachCell(context, MarkCell{marks.data()});
        return marks.download();
    };
    const auto cover = [&](const std::vector<unsigned char>& marks, int columns)
    {
        for (int i = 0; i < g.cells(); ++i) if (bool(marks[i]) != (g.cellIndex(i).c[0] < columns)) return false;
        return true;
    };
    const auto find = [&](int wet)
    {
        std::vector<R> distance(g.cells());
        for (int i = 0; i < g.cells(); ++i) distance[i] = g.cellIndex(i).c[0] < wet ? R(-1) : R(1);
        phi.upload(context, distance);
        rows.find(context, g, particles, phi.data(), sort);
    };
    find(20);
    EXPECT_TRUE(cover(visited(false), 32));
    EXPECT_TRUE(cover(visited(true), 128)) << "all count as listed before";
    find(40);
    EXPECT_TRUE(cover(visited(false), 64)) << "8 cells beyond the water";
    EXPECT_TRUE(cover(visited(true), 64));
    find(20);
    EXPECT_TRUE(cover(visited(false), 32));
    EXPECT_TRUE(cover(visited(true), 64));
    find(20);
    EXPECT_TRUE(cover(visited(true), 32));
}

//- Values and gradients from a block of nodes, images beyond the sides folded onto it, are those node by node: beside walls that water slides along
//  and that it sticks to, around periodic ends, and in a block that is narrower than a cubic spline
PIC_TEST(WindowsAreTheNodes)
{
    using C = TypeParam;
    using R = typename C::real;
    constexpr int D = C::D;
    Random random(23);
    int whole = 0, folded = 0, inner = 0;
    for (int kind = 0; kind < 4; ++kind)
    {
        UniformGrid<D> g{};
        g.h = 0.125;
        for (int d = 0; d < D; ++d)
        {
            g.n[d] = kind == 3 && d == 1 ? 2 : 6 + d;
            g.periodic[d] = kind == 2 && d == 0;
            for (bool& side : g.sticks[d]) side = kind == 1;
        }
        std::vector<R> u[D];
        for (int d = 0; d < D; ++d)
            for (int i = 0; i < g.faces(d); ++i) u[d].push_back(R(random(-1, 1)));
        for (int p = 0; p < 300; ++p)
        {
            Vec<D, double> x;
            for (int d = 0; d < D; ++d)
            {
                const double s = random(0, g.n[d]);
                x.c[d] = g.h*(p % 3 ? s : (s < 0.5*g.n[d] ? 0.1*s : g.n[d] - 0.1*(g.n[d] - s)));       // a third of them beside the sides
            }
            forOrders([&](auto order)
            {
                constexpr int Order = decltype(order)::value;
                for (int d = 0; d < D; ++d)
                {
                    const Window<Order, D, R, true> window(g, d, InCell<D, R>(g, x));
                    if (!window.whole) { EXPECT_TRUE(needsAround(g, Order)); continue; }
                    ++whole;
                    const Stencil<Order, D, R> nodes(g, d, x);
                    for (int a = 0; a < D; ++a) folded += nodes.first.c[a] < 0;
                    Vec<D, R> expected;
                    R gradient[D];
                    const R value = window.sum(u[d].data(), gradient), exact = sampleAffineAround<Order>(g, u[d].data(), d, x, expected);
                    EXPECT_NEAR(value, exact, 100*C::epsilon);
                    EXPECT_NEAR(window.sum(u[d].data()), exact, 100*C::epsilon);
                    for (int a = 0; a < D; ++a) { EXPECT_NEAR(gradient[a]/g.h, expected.c[a], 1000*C::epsilon/g.h); }
                    const InCell<D, R> at(g, x);
                    if (!InnerNodes<Order, D, R>::has(g, at.c)) continue;
                    ++inner;
                    const InnerNodes<Order, D, R> block(at.t);
                    EXPECT_NEAR(block.sum(g, at.c, d, u[d].data()), exact, 100*C::epsilon);
                }
            });
        }
    }
    EXPECT_GT(whole, 1000);
    EXPECT_GT(folded, 100);
    EXPECT_GT(inner, 100);
}

//- A path whose points lie well within the block is the same whichever way they are sampled
PIC_TEST(PathsInsideAreThoseAnywhere)
{
    using C = TypeParam;
    using R = typename C::real;
    constexpr int D = C::D;
    Random random(29);
    UniformGrid<D> g{};
    g.h = 0.125;
    for (int d = 0; d < D; ++d) g.n[d] = 9 + d;
    std::vector<R> u[D];
    for (int d = 0; d < D; ++d)
        for (int i = 0; i < g.faces(d); ++i) u[d].push_back(R(random(-1, 1)));
    Vec<3, const R*> field{};
    for (int d = 0; d < 3; ++d) field.c[d] = u[d < D ? d : D - 1].data();
    for (int p = 0; p < 300; ++p)
    {
        Vec<D, double> x;
        for (int d = 0; d < D; ++d) x.c[d] = g.h*random(0, g.n[d]);
        for (const int order : {2, 3})
        {
            const Vec<D, double> to = carried<2>(g, field.c, x, 0.1, order), anywhere = carriedAnywhere<2, true>(g, field, x, 0.1, order);
            for (int d = 0; d < D; ++d) { EXPECT_NEAR(to.c[d], anywhere.c[d], 100*C::epsilon*g.h); }
        }
    }
}

//- A turn about the middle of the block: the end of the path is off by dt^2 or dt^3
PIC_TEST(MotionHasItsOrder)
{
    using C = TypeParam;
    if (C::mixed) GTEST_SKIP() << "the errors that are compared are smaller than float's";
    constexpr int D = C::D;
    Cloud<C> cloud(8, 1, 3, [](const Vec<D, double>&, int) { return 0.0; });
    const auto& g = cloud.grid;
    double middle[2] = {0.5*g.n[0]*g.h, 0.5*g.n[1]*g.h};
    std::vector<typename C::real> u[D];
    for (int d = 0; d < D; ++d)
    {
        u[d].assign(g.faces(d), 0);
        for (int i = 0; d < 2 && i < g.faces(d); ++i)
        {
            const auto at = cloud.faceAt(d, i);
            u[d][i] = d == 0 ? -(at.c[1] - middle[1]) : at.c[0] - middle[0];
        }
    }
    const typename C::real* field[D];
    for (int d = 0; d < D; ++d) field[d] = u[d].data();
    for (const int order : {2, 3})
    {
        double error[2];
        for (int fine = 0; fine < 2; ++fine)
        {
            const int steps = fine ? 20 : 10;
            Vec<D, double> x = filled<D, double>(0.5);
            x.c[0] = middle[0] + 0.1;
            x.c[1] = middle[1];
            for (int s = 0; s < steps; ++s) x = carried<2>(g, field, x, 1.0/steps, order);
            error[fine] = std::hypot(x.c[0] - middle[0] - 0.1*std::cos(1), x.c[1] - middle[1] - 0.1*std::sin(1));
        }
        EXPECT_NEAR(std::log2(error[0]/error[1]), order, 0.1);
    }
}

//- The same bits with any number of threads
PIC_TEST(SumsRepeat)
{
    using C = TypeParam;
    Random random(2);
    Cloud<C> cloud(12, 6, 0, [&](const Vec<C::D, double>&, int) { return random(-1, 1); });
    std::vector<typename C::real> before;
    withThreads([&](int)
    {
        cloud.template toGrid<2>();
        const auto now = cloud.u[0].download();
        if (!before.empty()) { EXPECT_EQ(now, before); }
        before = now;
    });
}

} // namespace
} // namespace riprap

/*  Rows about the water, nodes about a point, paths through the velocity of the grid: the quick
    ways against the plain ones, orders of the motion.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "picCloud.hpp"

namespace riprap
{
namespace
{

struct MarkCell
{
    static constexpr const char* name = "markCell";
    unsigned char* to;
    HD void operator()(int i) const { to[i] = 1; }
};

//- Velocities of the faces, at random
template<int D, class R>
void fillFaces(const UniformGrid<D>& g, Random& random, std::vector<R> (&u)[D])
{
    for (int d = 0; d < D; ++d)
        for (int i = 0; i < g.faces(d); ++i) u[d].push_back(R(random(-1, 1)));
}

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
        for (int i = 0; i < g.cells(); ++i)
            if (bool(marks[i]) != (g.cellIndex(i).c[0] < columns)) return false;
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

//- Values and gradients from a block of nodes, images beyond the sides folded onto it, are those
//  node by node: beside walls that water slides along and that it sticks to, around periodic ends,
//  and in a block that is narrower than a cubic spline
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
        fillFaces(g, random, u);
        for (int p = 0; p < 300; ++p)
        {
            Vec<D, double> x;
            for (int d = 0; d < D; ++d)
            {
                const double s = random(0, g.n[d]);
                // a third of them beside the sides
                x.c[d] = g.h*(p % 3 ? s : (s < 0.5*g.n[d] ? 0.1*s : g.n[d] - 0.1*(g.n[d] - s)));
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
                    const R value = window.sum(u[d].data(), gradient),
                            exact = sampleAffineAround<Order>(g, u[d].data(), d, x, expected);
                    EXPECT_NEAR(value, exact, 100*C::epsilon);
                    EXPECT_NEAR(window.sum(u[d].data()), exact, 100*C::epsilon);
                    for (int a = 0; a < D; ++a)
                    {
                        EXPECT_NEAR(gradient[a]/g.h, expected.c[a], 1000*C::epsilon/g.h);
                    }
                    const InCell<D, R> at(g, x);
                    if (!InnerNodes<Order, D, R>::has(g, at.c)) continue;
                    ++inner;
                    const InnerNodes<Order, D, R> block(g, at.c, at.t);
                    EXPECT_NEAR(block.sum(g, at.c, d, u[d].data()), exact, 100*C::epsilon);
                    const InnerNodes<Order, D, R, true> sloped(g, at.c, at.t);
                    EXPECT_NEAR(sloped.window(g, at.c, d).sum(u[d].data(), gradient), exact,
                        100*C::epsilon);
                    for (int a = 0; a < D; ++a)
                    {
                        EXPECT_NEAR(gradient[a]/g.h, expected.c[a], 1000*C::epsilon/g.h);
                    }
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
    fillFaces(g, random, u);
    Vec<3, const R*> field{};
    for (int d = 0; d < 3; ++d) field.c[d] = u[d < D ? d : D - 1].data();
    for (int p = 0; p < 300; ++p)
    {
        Vec<D, double> x;
        for (int d = 0; d < D; ++d) x.c[d] = g.h*random(0, g.n[d]);
        for (const int order : {2, 3})
        {
            const Vec<D, double> to = carried<2>(g, field.c, x, 0.1, order),
                                 anywhere = carriedAnywhere<2, true>(g, field, x, 0.1, order);
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
            error[fine] = std::hypot(
                x.c[0] - middle[0] - 0.1*std::cos(1), x.c[1] - middle[1] - 0.1*std::sin(1));
        }
        EXPECT_NEAR(std::log2(error[0]/error[1]), order, 0.1);
    }
}

//- What is known of the field about a point is the field and its derivatives there, whichever way
//  it was found, and at the sides
PIC_TEST(LocalFieldHasTheDerivatives)
{
    using C = TypeParam;
    using R = typename C::real;
    constexpr int D = C::D;
    Random random(31);
    UniformGrid<D> g{};
    g.h = 0.125;
    for (int d = 0; d < D; ++d) g.n[d] = 7 + d;
    g.sticks[1][0] = true;
    std::vector<R> u[D];
    const R* field[D];
    fillFaces(g, random, u);
    for (int d = 0; d < D; ++d) field[d] = u[d].data();
    int inner = 0, beside = 0;
    const auto check = [&](auto order)
    {
        constexpr int Order = decltype(order)::value;
        for (int p = 0; p < 300; ++p)
        {
            // far enough from where the pieces of a spline meet that both ends of a difference are
            // on the same
            constexpr double off = 0.02;
            Vec<D, double> x;
            for (int d = 0; d < D; ++d)
                x.c[d] = 0.5*g.h
                    *(std::floor(random(0, 2*g.n[d])) + random(2*off, 1 - 2*off));
            const InCell<D, R> at(g, x);
            LocalVelocity<Order, D, R> local, other;
            ASSERT_TRUE((findAnywhere(local, g, field, at)));
            const bool inside = InnerNodes<Order, D, R>::inside(g, at.c),
                       has = InnerNodes<Order, D, R>::has(g, at.c);
            // NOLINTNEXTLINE(bugprone-branch-clone): branches differ where Order is 2
            if (inside) other.template find<false>(g, field, at);
            else if (has) other.template find<(Order == 2)>(g, field, at);
            ++(inside ? inner : beside);
            for (int d = 0; d < D; ++d)
            {
                EXPECT_NEAR(
                    local.of[d].value, sampleFace<Order>(g, field[d], d, x), 100*C::epsilon);
                for (int a = 0; a < D; ++a)
                {
                    R s[D] = {}, back[D] = {};
                    s[a] = R(off);
                    back[a] = R(-off);
                    Vec<D, double> ahead = x, behind = x;
                    ahead.c[a] += off*g.h;
                    behind.c[a] -= off*g.h;
                    // what the polynomial leaves out along an axis
                    const double third = Order == 3 ? 8*off*off*off : 0;
                    EXPECT_NEAR(local.of[d].at(s), sampleFace<Order>(g, field[d], d, ahead),
                        third + 200*C::epsilon);
                    EXPECT_NEAR(local.of[d].at(back), sampleFace<Order>(g, field[d], d, behind),
                        third + 200*C::epsilon);
                    for (int b = 0; b < a; ++b)
                    {
                        s[b] = R(off);
                        ahead.c[b] = x.c[b] + off*g.h;
                        EXPECT_NEAR(local.of[d].at(s), sampleFace<Order>(g, field[d], d, ahead),
                            40*off*off*off + 200*C::epsilon);
                        s[b] = 0;
                        ahead.c[b] = x.c[b];
                    }
                }
                if (!has) continue;
                R s[D];
                for (int a = 0; a < D; ++a) s[a] = R(0.3*(a + 1));
                EXPECT_NEAR(local.of[d].at(s), other.of[d].at(s), 200*C::epsilon);
            }
        }
    };
    check(std::integral_constant<int, 2>());
    check(std::integral_constant<int, 3>());
    EXPECT_GT(inner, 20);
    EXPECT_GT(beside, 20);
}

//- Where a stage leaves the block the velocity is that at its side, and nothing beside the field is
//  read: there are no numbers there
PIC_TEST(StagesBeyondSidesAreAtThem)
{
    using C = TypeParam;
    using R = typename C::real;
    constexpr int D = C::D, beside = 512;
    UniformGrid<D> g{};
    g.h = 0.1;
    for (int d = 0; d < D; ++d) g.n[d] = 6;
    for (const double speed : {4.0, -4.0})
    {
        std::vector<R> u[D];
        Vec<3, const R*> field{{nullptr, nullptr, nullptr}};
        Vec<D, double> x, v;
        for (int d = 0; d < D; ++d)
        {
            v.c[d] = speed*(1 + 0.25*d);
            x.c[d] = 0.31 + 0.01*d;
            u[d].assign(g.faces(d) + 2*beside, std::numeric_limits<R>::quiet_NaN());
            std::fill(u[d].begin() + beside, u[d].end() - beside, R(v.c[d]));
            field.c[d] = u[d].data() + beside;
        }
        field.c[2] = field.c[D - 1];
        const double dt = 0.3;
        for (const int order : {2, 3})
        {
            const Vec<D, double> to = carriedAnywhere<2, false>(g, field, x, dt, order);
            for (int d = 0; d < D; ++d)
                EXPECT_NEAR(to.c[d], x.c[d] + dt*v.c[d], 100*C::epsilon*std::abs(speed))
                    << order << ' ' << d;
        }
    }
}

//- Paths in a vortex by one look a step and by one a stage: both off by dt^3, the one by up to
//  twice the other's
PIC_TEST(OneLookAStepKeepsTheOrder)
{
    using C = TypeParam;
    using R = typename C::real;
    if (C::mixed) GTEST_SKIP() << "the errors that are compared are smaller than float's";
    constexpr int D = C::D;
    UniformGrid<D> g{};
    g.h = 1.0/16;
    for (int d = 0; d < D; ++d) g.n[d] = 16;
    const double k = std::acos(-1.0);
    std::vector<R> u[D];
    const R* field[D];
    for (int d = 0; d < D; ++d)
    {
        u[d].assign(g.faces(d), 0);
        for (int i = 0; d < 2 && i < g.faces(d); ++i)
        {
            const auto f = g.faceIndex(d, i);
            const double x = g.h*(f.c[0] + (d == 0 ? 0.0 : 0.5)),
                         y = g.h*(f.c[1] + (d == 1 ? 0.0 : 0.5));
            u[d][i] = d == 0 ? std::sin(k*x)*std::cos(k*y) : -std::cos(k*x)*std::sin(k*y);
        }
        field[d] = u[d].data();
    }
    const double time = 0.5;
    const auto path = [&](Vec<D, double> x, int steps, int order, bool near)
    {
        for (int s = 0; s < steps; ++s)
        {
            const InCell<D, R> at(g, x);
            x = near ? carriedNear<2>(g, 1/g.h, field, at, x, time/steps, order)
                     : carried<2>(g, 1/g.h, field, at, x, time/steps, order);
        }
        return x;
    };
    Random random(37);
    std::vector<Vec<D, double>> starts(100), ends;
    for (auto& x : starts)
    {
        for (int d = 0; d < D; ++d) x.c[d] = random(0.02, 0.98);
        ends.push_back(path(x, 2000, 3, false));
    }
    const auto error = [&](int steps, int order, bool near)
    {
        double sum = 0;
        for (std::size_t p = 0; p < starts.size(); ++p)
        {
            const Vec<D, double> x = path(starts[p], steps, order, near);
            for (int d = 0; d < D; ++d) sum += (x.c[d] - ends[p].c[d])*(x.c[d] - ends[p].c[d]);
        }
        return std::sqrt(sum/starts.size());
    };
    for (const int order : {2, 3})
    {
        // Courant numbers of 0.5 and 0.125
        const double coarse = error(16, order, true), fine = error(64, order, true),
                     plain = error(16, order, false);
        EXPECT_GT(std::log2(coarse/fine)/2, order - 0.2);
        EXPECT_LT(coarse, 2.5*plain);
    }
}

} // namespace
} // namespace riprap

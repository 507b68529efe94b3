/*  What each transfer scheme of the table does, with all splines that it goes with, with and
    without the particles' gradients: momentum to the grid and back, linear fields, energy, spray,
    particles without water. A scheme that is added to the table is tested by these; what is its own
    by a test beside them.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <algorithm>
#include "pic/picCloud.hpp"
#include "solvers/pic/transfer/gridToParticles.hpp"
#include "solvers/pic/transfer/picSplines.hpp"

namespace riprap
{
namespace
{

template<class C> struct PicSchemesCase : BackendTest {};
#ifdef __CUDACC__
template<class C> struct GpuPicSchemes : PicSchemesCase<C> {};
#define SCHEME_TEST(name) TYPED_TEST(GpuPicSchemes, name)
TYPED_TEST_SUITE(GpuPicSchemes, AllCases, CaseNames);
#else
template<class C> struct CpuPicSchemes : PicSchemesCase<C> {};
#define SCHEME_TEST(name) TYPED_TEST(CpuPicSchemes, name)
TYPED_TEST_SUITE(CpuPicSchemes, AllCases, CaseNames);
#endif

//- A scheme with its typical numbers and splines of an order
struct Choice
{
    PicConfig config;
    TransferCard card;
    bool gradient;
    double step;            // that it bears [s]

    std::string name() const
    {
        return config.transfer + " of order " + std::to_string(config.splineOrder)
            + (gradient ? ", affine" : "");
    }
};

//- f(choice) for all there are
template<class F>
void eachChoice(F f)
{
    for (const TransferCard& card : transfers())
        for (const int order : card.orders)
            for (const bool affine : {false, true})
            {
                PicConfig c;
                c.transfer = card.word;
                c.splineOrder = order;
                for (const TransferEntry& e : card.entries)
                    if (!e.yesNo) e.set(c.transferNumbers, e.typical);
                c.transferNumbers.affine = affine;
                const bool gradient = keepsGradient(card, c.transferNumbers);
                if (gradient == affine)
                    f(Choice{
                        c, card, gradient, 0.5*std::min(card.timeStep(c.transferNumbers), 0.02)});
            }
}

//- A cloud whose grid gets velocities and changes, and that takes by a scheme
template<class C>
struct Taking
{
    static constexpr int D = C::D;
    using R = typename C::real;
    using Place = Vec<D, double>;

    Choice choice;
    Cloud<C> cloud;
    GridToParticles<Backend, D, R> scheme;
    Array<Backend, R> du[D];
    Array<Backend, unsigned char> near;
    double fall[D] = {};

    template<class F>
    Taking(const Choice& c, int cells, int perCell, int margin, const F& velocity,
        bool periodic = false)
        : choice(c), cloud(cells, perCell, margin, velocity, periodic), scheme(c.config)
    {
        cloud.map.prepare(cloud.context, cloud.grid, cloud.sort);
        setNear(allWater);
        EXPECT_EQ(scheme.gradient(), c.gradient);
    }

    void setNear(unsigned char water)
    {
        near.upload(cloud.context, std::vector<unsigned char>(cloud.grid.cells(), water));
    }

    //- The particles' velocities on the grid
    void toGrid()
    {
        withSpline(choice.config.splineOrder,
            [&](auto order) { cloud.template toGrid<decltype(order)::value>(choice.gradient); });
    }

    //- u = velocity(x, d, its number) at faces; change: du
    template<class F>
    void set(bool change, const F& velocity)
    {
        for (int d = 0; d < D; ++d)
        {
            std::vector<R> u(cloud.grid.faces(d));
            for (std::size_t i = 0; i < u.size(); ++i)
                u[i] = R(velocity(cloud.faceAt(d, int(i)), d, int(i)));
            (change ? du : cloud.u)[d].upload(cloud.context, u);
        }
    }

    GridVelocities<D, R> velocities()
    {
        GridVelocities<D, R> v{};
        v.grid = cloud.grid;
        v.particles = cloud.view();
        if (!choice.gradient) for (R*& a : v.particles.affine) a = nullptr;
        for (int k = scheme.memory(); k < D*mostMemory; ++k) v.particles.memory[k] = nullptr;
        for (int d = 0; d < D; ++d)
        {
            v.u[d] = cloud.u[d].data();
            v.du[d] = du[d].data();
            v.fall[d] = R(fall[d]);
        }
        v.nearWater = near.data();
        return v;
    }

    void take()
    {
        scheme.take(cloud.context, velocities(), cloud.map.occupied(), choice.step);
        cloud.context.synchronise();
    }

    std::vector<R> real(int field) { return cloud.set.template download<R>(cloud.context, field); }
    std::vector<R> v(int d) { return real(D + d); }
    std::vector<R> gradient(int k) { return real(2*D + k); }
    std::vector<R> memory(int k) { return real(2*D + D*D + 1 + k); }

    std::vector<Place> places()
    {
        std::vector<Place> all(cloud.n);
        for (int d = 0; d < D; ++d)
        {
            const auto x = cloud.set.template download<double>(cloud.context, d);
            for (int i = 0; i < cloud.n; ++i) all[i].c[d] = x[i];
        }
        return all;
    }

    double energy()
    {
        double sum = 0;
        for (int d = 0; d < D; ++d) for (const R u : v(d)) sum += 0.5*double(u)*u;
        return sum;
    }
};

//- The grid has the particles' momentum; the step adds to it; the particles then have all of it. To
//  round-off of sums of that many numbers
SCHEME_TEST(MomentumIsConserved)
{
    using C = TypeParam;
    using R = typename C::real;
    static constexpr int D = C::D;
    eachChoice([](const Choice& choice)
    {
        Random random(11);
        Taking<C> t(choice, 8, 5, 2, [&](const Vec<D, double>&, int) { return random(-1, 1); });
        for (int step = 0; step < 3; ++step)
        {
            double before[D], mass[D];
            for (int d = 0; d < D; ++d) { before[d] = 0; for (const R v : t.v(d)) before[d] += v; }
            t.toGrid();
            std::vector<R> u[D], m[D];
            for (int d = 0; d < D; ++d)
            {
                u[d] = t.cloud.u[d].download();
                m[d] = t.cloud.mass[d].download();
                double momentum = 0, size = 0;
                mass[d] = 0;
                for (std::size_t i = 0; i < u[d].size(); ++i)
                {
                    mass[d] += m[d][i];
                    momentum += double(m[d][i])*u[d][i];
                    size += std::abs(double(m[d][i])*u[d][i]);
                }
                EXPECT_NEAR(mass[d]/t.cloud.n, 1, 100*C::epsilon) << choice.name();
                EXPECT_NEAR(momentum, before[d], 200*C::epsilon*(size + t.cloud.n))
                    << choice.name();
            }
            t.set(true, [&](const auto&, int, int) { return random(-0.5, 1); });
            double expected[D] = {};
            for (int d = 0; d < D; ++d)
            {
                const auto du = t.du[d].download();
                for (std::size_t i = 0; i < du.size(); ++i)
                {
                    u[d][i] += du[i];
                    expected[d] += double(m[d][i])*u[d][i];
                }
                t.cloud.u[d].upload(t.cloud.context, u[d]);
            }
            t.take();
            for (int d = 0; d < D; ++d)
            {
                double now = 0;
                for (const R v : t.v(d)) now += v;
                EXPECT_NEAR(now/t.cloud.n, expected[d]/t.cloud.n, 200*C::epsilon) << choice.name();
                EXPECT_GT(std::abs(expected[d] - before[d])/t.cloud.n, 0.05) << "nothing was added";
            }
        }
    });
}

//- A velocity linear in space, changed by one that is linear too, in a block that ends at walls or
//  in itself: what particles and their gradients then are, and what with these the grid gets back
SCHEME_TEST(LinearFieldsAreKept)
{
    using C = TypeParam;
    using R = typename C::real;
    static constexpr int D = C::D;
    const auto slope = [](int d, int a) { return 0.7*d - 0.4*a + 0.2; };
    const auto linear = [&](const Vec<D, double>& x, int d, double factor)
    {
        double value = 0.3;
        for (int a = 0; a < D; ++a) value += slope(d, a)*x.c[a];
        return factor*value;
    };
    eachChoice([&](const Choice& choice)
    {
        if (!choice.gradient || !choice.card.keepsLinear) return;
        for (const bool periodic : {false, true})
        {
            Taking<C> t(
                choice, 8, 5, 2, [&](const auto& x, int d) { return linear(x, d, 1); }, periodic);
            t.set(false, [&](const auto& x, int d, int) { return linear(x, d, 1.5); });
            t.set(true, [&](const auto& x, int d, int) { return linear(x, d, 0.5); });
            t.take();
            const auto places = t.places();
            for (int d = 0; d < D; ++d)
            {
                const auto v = t.v(d);
                for (int i = 0; i < t.cloud.n; ++i)
                    ASSERT_NEAR(v[i], linear(places[i], d, 1.5), 100*C::epsilon) << choice.name();
                for (int a = 0; a < D; ++a)
                    for (const R c : t.gradient(d*D + a))
                        ASSERT_NEAR(c, 1.5*slope(d, a), 3000*C::epsilon) << choice.name();
            }
            t.toGrid();
            for (int d = 0; d < D; ++d)
            {
                const auto u = t.cloud.u[d].download(), m = t.cloud.mass[d].download();
                for (std::size_t i = 0; i < u.size(); ++i)
                    if (m[i] > 0.01)
                    {
                        ASSERT_NEAR(
                            u[i], linear(t.cloud.faceAt(d, int(i)), d, 1.5), 8000*C::epsilon)
                            << choice.name();
                    }
            }
        }
    });
}

//- Where the grid changes nothing the particles have no more energy than before
SCHEME_TEST(NoChangeGivesNoEnergy)
{
    using C = TypeParam;
    eachChoice([](const Choice& choice)
    {
        Random random(3);
        Taking<C> t(choice, 8, 5, 2, [&](const Vec<C::D, double>&, int) { return random(-1, 1); });
        withSpline(choice.config.splineOrder,
            [&](auto order) { t.cloud.template toGrid<decltype(order)::value>(false); });
        t.set(true, [](const auto&, int, int) { return 0; });
        const double before = t.energy();
        t.take();
        EXPECT_LE(t.energy(), before*(1 + 100*C::epsilon)) << choice.name();
        EXPECT_GT(t.energy(), 0.001*before) << choice.name();
    });
}

//- Beside the surface no particle becomes faster than it was, having fallen, or than the grid there
//  is
SCHEME_TEST(SprayIsBounded)
{
    using C = TypeParam;
    using R = typename C::real;
    static constexpr int D = C::D;
    eachChoice([](const Choice& choice)
    {
        Random random(23);
        const auto velocity = [&](const Vec<D, double>&, int) { return random(-1, 1); };
        Taking<C> t(choice, 8, 3, 0, velocity, true);
        t.setNear(someWater);
        t.fall[1] = -0.1;
        t.set(false, [&](const auto&, int, int) { return random(-1, 1); });
        t.set(true, [&](const auto&, int, int) { return random(-1, 1); });
        std::vector<double> fallen(t.cloud.n, 0.0), speed(t.cloud.n, 0.0), grid(t.cloud.n, 0.0);
        for (int d = 0; d < D; ++d)
        {
            const auto v = t.v(d);
            for (int i = 0; i < t.cloud.n; ++i) fallen[i] += (v[i] + t.fall[d])*(v[i] + t.fall[d]);
        }
        t.take();
        for (int d = 0; d < D; ++d)
        {
            const auto v = t.v(d);
            for (int i = 0; i < t.cloud.n; ++i) speed[i] += double(v[i])*v[i];
        }
        withSpline(choice.config.splineOrder,
            [&](auto order) { t.cloud.template toParticles<decltype(order)::value>(); });
        for (int d = 0; d < D; ++d)
        {
            const auto v = t.v(d);
            for (int i = 0; i < t.cloud.n; ++i) grid[i] += double(v[i])*v[i];
        }
        for (int i = 0; i < t.cloud.n; ++i)
            ASSERT_LE(speed[i],
                std::max(fallen[i], grid[i])*(1 + 200*C::epsilon) + R(1e-6)*C::epsilon)
                << choice.name();
    });
}

//- Particles that come in, the last of all, have the grid's velocity and gradient whatever the
//  scheme
SCHEME_TEST(WhatComesInTakesTheGrid)
{
    using C = TypeParam;
    static constexpr int D = C::D;
    const auto linear = [](const Vec<D, double>& x, int d)
    { return 0.3 + 0.5*x.c[0] - 0.25*(d + 1)*x.c[1]; };
    eachChoice([&](const Choice& choice)
    {
        Taking<C> t(choice, 8, 3, 2, [](const Vec<D, double>&, int) { return 7; });
        t.set(false, [&](const auto& x, int d, int) { return linear(x, d); });
        t.set(true, [](const auto&, int, int) { return 3; });
        const int first = t.cloud.n/3;
        t.scheme.enter(t.cloud.context, t.velocities(), first, t.cloud.n - first);
        t.cloud.context.synchronise();
        const auto places = t.places();
        for (int d = 0; d < D; ++d)
        {
            const auto v = t.v(d), x = t.gradient(d*D);
            for (int i = 0; i < t.cloud.n; ++i)
            {
                ASSERT_NEAR(v[i], i < first ? 7 : linear(places[i], d), 100*C::epsilon)
                    << choice.name();
                if (choice.gradient && i >= first)
                {
                    ASSERT_NEAR(x[i], 0.5, 3000*C::epsilon) << choice.name();
                }
            }
        }
    });
}

//- Particles without water about them fall, and forget
SCHEME_TEST(WithoutWaterParticlesFall)
{
    using C = TypeParam;
    using R = typename C::real;
    static constexpr int D = C::D;
    eachChoice([](const Choice& choice)
    {
        Random random(29);
        Taking<C> t(
            choice, 8, 3, 0, [&](const Vec<D, double>&, int) { return random(-1, 1); }, true);
        t.set(false, [&](const auto&, int, int) { return random(-1, 1); });
        t.set(true, [&](const auto&, int, int) { return random(-1, 1); });
        t.take();
        const int memory = t.scheme.memory();
        double remembered = 0;
        for (int k = 0; k < memory; ++k) for (const R m : t.memory(k)) remembered += std::abs(m);
        EXPECT_EQ(remembered > 0, memory > 0) << choice.name();
        t.setNear(0);
        t.fall[1] = -0.25;
        std::vector<R> before[D];
        for (int d = 0; d < D; ++d) before[d] = t.v(d);
        t.take();
        for (int d = 0; d < D; ++d)
        {
            const auto v = t.v(d);
            for (int i = 0; i < t.cloud.n; ++i)
                ASSERT_EQ(v[i], before[d][i] + R(t.fall[d])) << choice.name();
        }
        for (int k = 0; k < memory; ++k)
            for (const R m : t.memory(k)) ASSERT_EQ(m, R(0)) << choice.name();
        for (int k = 0; choice.gradient && k < D*D; ++k)
            for (const R c : t.gradient(k)) ASSERT_EQ(c, R(0)) << choice.name();
    });
}

} // namespace
} // namespace riprap

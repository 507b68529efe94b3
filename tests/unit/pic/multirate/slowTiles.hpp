/*  Tiles whose particles wait: what the faces get from them, who enters, and which tiles wait.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "../picCloud.hpp"
#include "pic/multirate/slowTiles.hpp"

namespace riprap
{
namespace
{

#ifdef __CUDACC__
template<class C> struct GpuSlowTiles : BackendTest {};
#define SLOW_TEST(name) TYPED_TEST(GpuSlowTiles, name)
TYPED_TEST_SUITE(GpuSlowTiles, AllCases, CaseNames);
#else
template<class C> struct CpuSlowTiles : BackendTest {};
#define SLOW_TEST(name) TYPED_TEST(CpuSlowTiles, name)
TYPED_TEST_SUITE(CpuSlowTiles, AllCases, CaseNames);
#endif

//- A cloud, fields of its faces, and slow tiles where the water is slower than a limit
template<class C>
struct Waiting
{
    static constexpr int D = C::D, cells = D == 3 ? 24 : 48;
    using R = typename C::real;

    Cloud<C> cloud;
    SlowTiles<Backend, D, R> slow;
    Array<Backend, unsigned char> near;
    Array<Backend, R> field[D];

    //- Particles and faces have a velocity along x that is as large as x
    Waiting() : cloud(cells, 4, 0, [](const Vec<D, double>& x, int d) { return d ? 0.0 : x.c[0]; })
    {
        near.upload(cloud.context, std::vector<unsigned char>(cloud.grid.cells(), allWater));
        for (int d = 0; d < D; ++d)
        {
            std::vector<R> u(cloud.grid.faces(d));
            for (int i = 0; i < int(u.size()); ++i) u[i] = d ? R(0) : R(cloud.faceAt(d, i).c[0]);
            field[d].upload(cloud.context, u);
        }
        slow.allocate(cloud.context, cloud.grid, std::vector<unsigned char>());
    }

    FindFastTiles<D, R> fast(double limit)
    {
        FindFastTiles<D, R> f{};
        f.start = cloud.sort.start();
        f.nearWater = near.data();
        for (int d = 0; d < D; ++d) f.u[d] = f.aperture[d] = field[d].data();
        f.limit = R(limit);
        return f;
    }

    std::vector<double> states()
    {
        const std::vector<double> all = slow.memory();
        return std::vector<double>(all.begin() + 2, all.end());
    }

    //- A change of the faces' velocities that varies
    void change()
    {
        for (int d = 0; d < D; ++d)
        {
            std::vector<R> du(cloud.grid.faces(d));
            Random random(5 + d);
            for (R& v : du) v = R(random(-1, 1));
            slow.change[d].upload(cloud.context, du);
        }
    }

    //- With slow tiles
    template<int Order>
    void toGrid()
    {
        cloud.map.prepare(cloud.context, cloud.grid, cloud.sort);
        cloud.water.upload(cloud.context, std::vector<R>(cloud.grid.cells(), R(-1)));
        cloud.rows.find(
            cloud.context, cloud.grid, cloud.map.occupied(), cloud.water.data(), cloud.sort);
        slow.find(cloud.context, cloud.map.occupied(), cloud.sort);
        for (int d = 0; d < D; ++d)
        {
            const SlowSums<D, R> sums = slow.sums(
                cloud.context, d, SeenFaces<Order>::template allOfTile<D>());
            cloud.map.template map<Order>(cloud.context, cloud.grid, cloud.rows, cloud.view(), d,
                true, nullptr, cloud.u[d].data(), cloud.mass[d].data(), &sums);
        }
        slow.endSums();
        cloud.context.synchronise();
    }

    //- Of velocities, and of what is still to come
    Vec<D, double> momentum()
    {
        Vec<D, double> sum{};
        for (int d = 0; d < D; ++d)
            for (const R v : cloud.set.template download<R>(cloud.context, D + d)) sum.c[d] += v;
        SumPending<2, D, R> pending{cloud.view(), cloud.grid, slow.in(slowTile), {}};
        for (int d = 0; d < D; ++d) pending.change[d] = slow.change[d].data();
        const auto sums = sumOver<D>(cloud.context, cloud.n, pending);
        for (int d = 0; d < D; ++d) sum.c[d] += sums[d];
        return sum;
    }
};

//- Tiles are slow whose neighbours, too, have no face that is faster
SLOW_TEST(SlowTilesAreFarFromFastOnes)
{
    constexpr int D = TypeParam::D;
    Waiting<TypeParam> w;
    const double h = w.cloud.grid.h;
    const CellTiles<D> tiles(w.cloud.grid);
    const double limit = (1.5*tiles.side)*h;        // reached in the second layer of tiles
    w.slow.choose(w.cloud.context, w.fast(limit), w.cloud.sort);
    EXPECT_FALSE(w.slow.any());
    w.slow.choose(w.cloud.context, w.fast(limit + tiles.side*h), w.cloud.sort);
    EXPECT_TRUE(w.slow.any());
    const std::vector<double> found = w.states();
    for (int t = 0; t < tiles.count(); ++t)
        EXPECT_EQ(found[t], t % tiles.n[0] == 0 ? slowTile : currentTile) << t;
    EXPECT_EQ(w.slow.particles(w.cloud.context, w.cloud.sort.start()),
        [&]
        {
            int in = 0;
            for (const double x : w.cloud.x[0]) in += x < tiles.side*h;
            return in;
        }());
    // nothing is fast any more; then all is
    w.slow.wake(w.cloud.context, w.fast(1e3), false, w.cloud.sort);
    EXPECT_EQ(w.slow.due(), 0);
    w.slow.wake(w.cloud.context, w.fast(1e-9), false, w.cloud.sort);
    EXPECT_EQ(w.slow.due(), tiles.count()/tiles.n[0]);
    w.slow.endStep(w.cloud.context);
    for (const double s : w.states()) EXPECT_EQ(s, currentTile);
}

//- Faces get the same from particles that wait, and m_s du more
SLOW_TEST(FacesHaveTheChangesOfSlowTiles)
{
    constexpr int D = TypeParam::D;
    using R = typename TypeParam::real;
    forOrders([&](auto order)
    {
        Waiting<TypeParam> w;
        w.cloud.template toGrid<decltype(order)::value>(true);
        std::vector<R> u[D], mass[D];
        for (int d = 0; d < D; ++d)
        {
            u[d] = w.cloud.u[d].download();
            mass[d] = w.cloud.mass[d].download();
        }
        // the lower half along x waits
        w.slow.choose(w.cloud.context, w.fast(0.6*w.cells*w.cloud.grid.h), w.cloud.sort);
        ASSERT_TRUE(w.slow.any());
        w.template toGrid<decltype(order)::value>();
        for (int d = 0; d < D; ++d)
        {
            EXPECT_EQ(w.cloud.u[d].download(), u[d]);
            EXPECT_EQ(w.cloud.mass[d].download(), mass[d]);
        }
        w.change();
        w.template toGrid<decltype(order)::value>();
        const CellTiles<D> tiles(w.cloud.grid);
        const std::vector<double> state = w.states();
        int all = 0, none = 0;
        for (int d = 0; d < D; ++d)
        {
            const std::vector<R> now = w.cloud.u[d].download(),
                                 du = w.slow.change[d].download();
            for (int i = 0; i < int(now.size()); ++i)
            {
                // all that see the face wait, or none
                const auto f = w.cloud.grid.faceIndex(d, i);
                bool slow = true, current = true;
                for (const int by : {-4, 3})
                {
                    auto c = f;
                    for (int a = 0; a < D; ++a)
                        c.c[a] = std::max(0,
                            std::min(c.c[a] + (a ? 0 : by), w.cloud.grid.n[a] - 1));
                    (state[tiles.of(c)] == slowTile ? current : slow) = false;
                }
                if (!slow && !current) continue;
                ++(slow ? all : none);
                EXPECT_NEAR(now[i], u[d][i] + (slow ? du[i] : R(0)),
                    slow ? 32*TypeParam::epsilon : 0.0);
            }
        }
        EXPECT_GT(all, 100);
        EXPECT_GT(none, 100);
    });
}

//- Particles that come to slow tiles from others lose no momentum, and are summed with those there
SLOW_TEST(WhoEntersASlowTileGivesWhatItWillBeGiven)
{
    constexpr int D = TypeParam::D;
    using R = typename TypeParam::real;
    Waiting<TypeParam> w;
    w.slow.choose(w.cloud.context, w.fast(0.6*w.cells*w.cloud.grid.h), w.cloud.sort);
    w.template toGrid<2>();
    w.change();
    const double mass = [&]
    {
        double sum = 0;
        for (const R m : w.cloud.mass[0].download()) sum += m;
        return sum;
    }();
    const Vec<D, double> before = w.momentum();
    // those that do not wait drift a cell, but not those whose images count
    const TileChoice<D> waits = w.slow.in(slowTile);
    std::vector<double> x[D];
    for (int d = 0; d < D; ++d)
        x[d] = w.cloud.set.template download<double>(w.cloud.context, d);
    const std::vector<double> state = w.states();
    const double h = w.cloud.grid.h;
    for (int i = 0; i < w.cloud.n; ++i)
    {
        typename UniformGrid<D>::Index c{{0, 0, 0}};
        for (int d = 0; d < D; ++d) c.c[d] = int(x[d][i]/h);
        if (state[waits.tiles.of(c)] != slowTile && x[0][i] < 0.8*w.cells*h) x[0][i] -= h;
    }
    w.cloud.set.upload(w.cloud.context, 0, x[0]);
    const double slowBefore = w.slow.particles(w.cloud.context, w.cloud.sort.start());
    EnterSlowTiles<2, D, R> enter{w.cloud.grid, waits.tiles, w.cloud.view(), waits.state, {}};
    for (int d = 0; d < D; ++d) enter.change[d] = w.slow.change[d].data();
    w.cloud.rows.eachCell(w.cloud.context, enter);
    const Vec<D, double> after = w.momentum();
    for (int d = 0; d < D; ++d)
        EXPECT_NEAR(after.c[d], before.c[d], 64*w.cloud.n*TypeParam::epsilon);
    w.cloud.order();
    EXPECT_GT(w.slow.particles(w.cloud.context, w.cloud.sort.start()), slowBefore + 20);
    w.template toGrid<2>();
    double sum = 0;
    for (const R m : w.cloud.mass[0].download()) sum += m;
    EXPECT_NEAR(sum, mass, 64*w.cloud.n*TypeParam::epsilon);
}

} // namespace
} // namespace riprap

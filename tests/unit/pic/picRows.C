/*  What the CPU does in registers against the same one by one: particles of a cell, pairs of the
    correction of positions, rows of cells and faces.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "picCloud.hpp"
#include "pic/transfer/positionCorrection.hpp"
#include "pic/projection/project.hpp"
#include "pic/surface/redistance.hpp"
#include "pic/transfer/cellLanes.hpp"
#include "pic/grid/wetCells.hpp"
#include "solvers/pic/transfer/picFamilies.hpp"

namespace riprap
{
namespace
{

template<class C> struct PicRows : BackendTest {};
TYPED_TEST_SUITE(PicRows, AllCases, CaseNames);

//- Particles in and out of the water, at its surface, and fields without any smoothness
template<class C>
struct Splash
{
    static constexpr int D = C::D;
    using R = typename C::real;

    Cloud<C> cloud;
    std::vector<unsigned char> near;
    std::vector<R> u[D], du[D], shift[D], phi;
    const double dt = 0.05;

    explicit Splash(double speed)
        : cloud(9, 6, 0,
            [&](const Vec<D, double>& x, int d) { return std::sin(40*x.c[0] + 50*x.c[1] + d); })
    {
        Random random(5);
        const UniformGrid<D>& g = cloud.grid;
        for (int i = 0; i < g.cells(); ++i)
        {
            near.push_back(static_cast<unsigned char>(random(0, 2.999)));
            phi.push_back(R(g.h*random(-5, 1)));
        }
        for (int d = 0; d < D; ++d)
        {
            for (int i = 0; i < g.faces(d); ++i)
            {
                u[d].push_back(R(speed*random(-1, 1)));
                du[d].push_back(R(random(-1, 1)));
            }
            shift[d].assign(cloud.n, R(0));
        }
        cloud.map.prepare(cloud.context, g, cloud.sort);
    }

    template<class Formula>
    GridToParticle<2, D, R, false, Formula> taking(const Formula& formula, bool affine)
    {
        GridToParticle<2, D, R, false, Formula> f{};
        f.grid = cloud.grid;
        f.inverse = 1/cloud.grid.h;
        f.particles = cloud.view();
        for (int d = 0; d < D; ++d)
        {
            f.u[d] = u[d].data();
            f.du[d] = du[d].data();
            f.fall[d] = R(-0.1*d);
        }
        f.nearWater = near.data();
        f.formula = formula;
        f.affine = affine;
        return f;
    }

    MoveParticles<2, D, R, false> moving(int order)
    {
        MoveParticles<2, D, R, false> f{};
        f.grid = cloud.grid;
        f.inverse = 1/cloud.grid.h;
        f.particles = cloud.view();
        for (int d = 0; d < D; ++d)
        {
            f.u[d] = u[d].data();
            f.aperture[d] = closed(d);
            f.shift[d] = shift[d].data();
        }
        f.nearWater = near.data();
        f.timeStep = dt;
        f.order = order;
        f.margin = 1e-4*cloud.grid.h;
        return f;
    }

    const R* closed(int d)
    {
        walls[d].assign(cloud.grid.faces(d), R(0));
        return walls[d].data();
    }

    std::vector<double> state()
    {
        std::vector<double> all;
        for (int d = 0; d < D; ++d)
        {
            for (const double x : cloud.set.template download<double>(cloud.context, d))
                all.push_back(x);
            for (const R v : cloud.set.template download<R>(cloud.context, D + d)) all.push_back(v);
            for (const R s : shift[d]) all.push_back(s);
        }
        for (int k = 0; k < D*D; ++k)
            for (const R c : cloud.set.template download<R>(cloud.context, 2*D + k))
                all.push_back(c);
        for (int k = 0; k < D*mostMemory; ++k)
            for (const R m : cloud.set.template download<R>(cloud.context, 2*D + D*D + 1 + k))
                all.push_back(m);
        return all;
    }

    std::vector<R> walls[D];
};

//- Largest difference over the largest number
double apart(const std::vector<double>& a, const std::vector<double>& b)
{
    double most = 0, size = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        most = std::max(most, std::abs(a[i] - b[i]));
        size = std::max(size, std::abs(a[i]));
    }
    return a.size() == b.size() ? most/size : 1;
}

TYPED_TEST(PicRows, ParticlesTakeInLanesWhatTheyTakeOneByOne)
{
    using C = TypeParam;
    if constexpr (C::D == 2)
    {
        // once more, where there is something to remember
        const auto agree = [](const auto& formula, const std::string& name)
        {
            for (const bool affine : {false, true})
            {
                Splash<C> one(1), lanes(1);
                const auto before = one.state();
                const auto& tiles = lanes.cloud.map.occupied();
                for (int k = 0; k < 2; ++k)
                {
                    forEach(one.cloud.context, one.cloud.n, one.taking(formula, affine));
                    forEachRow(lanes.cloud.context, tiles.count(),
                        cellsOf(lanes.taking(formula, affine), tiles.tiles(), tiles.list()));
                }
                EXPECT_GT(apart(before, one.state()), 0.01);
                EXPECT_LT(apart(one.state(), lanes.state()), 100*C::epsilon) << name << affine;
            }
        };
        Transfers::each([&](auto scheme)
        {
            using Scheme = typename decltype(scheme)::type;
            TransferProperties numbers;
            for (const TransferEntry& e : Scheme::entries) if (!e.yesNo) e.set(numbers, e.typical);
            agree(Scheme::template make<typename C::real>(
                      numbers, 0.5*std::min(Scheme::timeStep(numbers), 1.0)),
                Scheme::word);
        });
        agree(FlipPic::of(typename C::real(1)), "a share of 1");
    }
    else GTEST_SKIP() << "in 2D alone";
}

//- speed: with the second some go farther than a cell
TYPED_TEST(PicRows, ParticlesMoveInLanesAsOneByOne)
{
    using C = TypeParam;
    if constexpr (C::D == 2)
        for (const int order : {2, 3})
            for (const double speed : {1.0, 6.0})
            {
                Splash<C> one(speed), lanes(speed);
                const auto before = one.state();
                forEach(one.cloud.context, one.cloud.n, one.moving(order));
                const auto& tiles = lanes.cloud.map.occupied();
                forEachRow(lanes.cloud.context, tiles.count(),
                    MoveCells<typename C::real, false>{
                        lanes.moving(order), tiles.tiles(), tiles.list()});
                EXPECT_GT(apart(before, one.state()), 0.001);
                EXPECT_LT(apart(one.state(), lanes.state()), 100*C::epsilon)
                    << order << " at " << speed;
            }
    else GTEST_SKIP() << "in 2D alone";
}

TYPED_TEST(PicRows, PairsPushInLanesAsOneByOne)
{
    using C = TypeParam;
    using R = typename C::real;
    Splash<C> one(1), lanes(1);
    const auto correct = [](Splash<C>& s, auto f)
    {
        f.grid = s.cloud.grid;
        f.inverse = 1/s.cloud.grid.h;
        f.particles = s.cloud.view();
        f.phi = s.phi.data();
        f.nearWater = s.near.data();
        for (int d = 0; d < C::D; ++d) f.shift[d] = s.shift[d].data();
        f.strength = R(0.01);
        f.spacing = R(0.5*s.cloud.grid.h);
        forEach(s.cloud.context, s.cloud.n, f);
    };
    correct(one, CorrectPositions<C::D, R>{});
    correct(lanes, CorrectPositions<C::D, R, true>{});
    double pushed = 0;
    for (const R s : one.shift[0]) pushed = std::max(pushed, double(std::abs(s)));
    EXPECT_GT(pushed, 0.001*one.cloud.grid.h);
    for (int d = 0; d < C::D; ++d)
        for (int i = 0; i < one.cloud.n; ++i)
            ASSERT_NEAR(one.shift[d][i], lanes.shift[d][i], 300*C::epsilon*pushed) << i;
}

//- Wet cells at random in a block that rows do not divide; every other face all but closed
template<class C>
struct Patches
{
    static constexpr int D = C::D;
    using R = typename C::real;
    UniformGrid<D> grid{};
    std::vector<R> phi, far, carried, u[D], aperture[D];
    std::vector<unsigned char> wet, near, layer[D];
    std::vector<int> wetNumbers;
    std::vector<double> p;

    Patches()
    {
        Random random(9);
        const int n[3] = {70, 9, D == 3 ? 8 : 1};
        grid.h = 0.1;
        for (int d = 0; d < 3; ++d) grid.n[d] = n[d];
        for (int i = 0; i < grid.cells(); ++i)
        {
            const bool dry = grid.cellIndex(i).c[0] > 33 && grid.cellIndex(i).c[0] < 66;
            phi.push_back(R(dry ? 0.4 : grid.h*random(-3, 3)));
            carried.push_back(R(phi.back()*random(0.9, 1.1)));
            wetNumbers.push_back(random(0, 1) < 0.6);
            p.push_back(wetNumbers.back() ? random(1, 2) : 0);
        }
        far.assign(grid.cells(), R(0));
        wet.assign(grid.cells(), 0);
        near.assign(grid.cells(), 9);
        for (int d = 0; d < D; ++d)
            for (int i = 0; i < grid.faces(d); ++i)
            {
                u[d].push_back(R(random(-1, 1)));
                aperture[d].push_back(R(i % 5 == 0 ? 0 : (i % 7 == 0 ? 0.03 : random(0.1, 1))));
                layer[d].push_back(
                    random(0, 1) < 0.3 ? 0 : (i % 11 == 0 ? closedFace : unknownFace));
            }
    }

    PressureFields<D, R> fields()
    {
        PressureFields<D, R> f{};
        f.grid = grid;
        f.phi = phi.data();
        f.p = p.data();
        for (int d = 0; d < D; ++d) { f.u[d] = u[d].data(); f.aperture[d] = aperture[d].data(); }
        f.timeStep = 0.01;
        f.density = 1000;
        return f;
    }
};

//- All rows of a block
template<int D, class F>
void overRows(const UniformGrid<D>& grid, const F& f)
{
    const CellRows<D> rows(grid);
    for (int r = 0; r < rows.count(); ++r)
    {
        const auto c = rows.first(r);
        f(c, std::min(c.c[0] + rows.length, grid.n[0]));
    }
}

TYPED_TEST(PicRows, RowsOfCellsAreMarkedAsCells)
{
    using C = TypeParam;
    using R = typename C::real;
    constexpr int D = C::D;
    Patches<C> a, b;
    const R band = R(0.35);
    for (int i = 0; i < a.grid.cells(); ++i) MarkWetCells<D, R>{a.fields(), a.wet.data()}(i);
    for (int i = 0; i < a.grid.cells(); ++i)
        MarkNearWater<D>{a.grid, a.wet.data(), a.near.data()}(i);
    for (int i = 0; i < a.grid.cells(); ++i)
        SpreadDistance<D, R>{a.grid, a.carried.data(), a.phi.data(), a.far.data(), band}(i);
    overRows<D>(b.grid,
        [&](const auto& c, int end) {
            OverCells<D, MarkWetCells<D, R>>{b.grid, {b.fields(), b.wet.data()}}.row(c, end);
        });
    overRows<D>(b.grid,
        [&](const auto& c, int end) {
            OverCells<D, MarkNearWater<D>>{b.grid, {b.grid, b.wet.data(), b.near.data()}}.row(
                c, end);
        });
    overRows<D>(b.grid,
        [&](const auto& c, int end) {
            SpreadDistance<D, R>{b.grid, b.carried.data(), b.phi.data(), b.far.data(), band}.row(
                c, end);
        });
    EXPECT_TRUE(a.wet == b.wet);
    EXPECT_TRUE(a.near == b.near);
    EXPECT_TRUE(a.far == b.far);
    EXPECT_GT(std::count(a.wet.begin(), a.wet.end(), 1), 50);
    EXPECT_GT(std::count(a.near.begin(), a.near.end(), someWater), 50);
}

//- To the bit, but for the arithmetic of corrected velocities, which is contracted as the compiler
//  likes
TYPED_TEST(PicRows, RowsOfFacesAreDoneAsFaces)
{
    using C = TypeParam;
    using R = typename C::real;
    constexpr int D = C::D;
    Patches<C> a, b;
    for (int i = 0; i < a.grid.cells(); ++i)
        a.wet[i] = b.wet[i] = static_cast<unsigned char>(a.wetNumbers[i]);
    const auto original = a.u[0];
    const auto velocities = [](Patches<C>& s)
    {
        Extrapolate<D, R> f{};
        f.grid = s.grid;
        f.pass = 1;
        f.fields = 1;
        for (int d = 0; d < D; ++d)
        {
            f.layer[d] = s.layer[d].data();
            f.field[0][d] = s.u[d].data();
        }
        return f;
    };
    for (int d = 0; d < D; ++d)
        for (int i = 0; i < a.grid.faces(d); ++i)
            CorrectVelocity<D, R>{a.fields(), a.wetNumbers.data(), d}(i);
    overRows<D>(b.grid,
        [&](const auto& c, int end)
        {
            for (int d = 0; d < D; ++d)
                rowOfFaces(
                    b.grid, d, c, end, CorrectVelocity<D, R>{b.fields(), b.wetNumbers.data(), d});
        });
    EXPECT_TRUE(a.u[0] != original);
    for (int d = 0; d < D; ++d)
        for (int i = 0; i < a.grid.faces(d); ++i)
            ASSERT_NEAR(a.u[d][i], b.u[d][i], 4*C::epsilon) << d << ' ' << i;

    b.u[0] = a.u[0]; b.u[1] = a.u[1]; b.u[D - 1] = a.u[D - 1];
    for (int i = 0; i < a.grid.cells(); ++i) velocities(a)(a.grid.cellIndex(i));
    overRows<D>(b.grid, [&](const auto& c, int end) { velocities(b).row(c, end); });
    for (int d = 0; d < D; ++d)
    {
        EXPECT_TRUE(a.layer[d] == b.layer[d]);
        EXPECT_TRUE(a.u[d] == b.u[d]);
        EXPECT_GT(std::count(a.layer[d].begin(), a.layer[d].end(), 1), 50);
    }

    for (int d = 0; d < D; ++d)
        for (int i = 0; i < a.grid.faces(d); ++i)
            MarkByWetCells<D, R>{
                a.grid, a.wet.data(), a.aperture[d].data(), nullptr, d, a.layer[d].data()}(i);
    overRows<D>(b.grid,
        [&](const auto& c, int end)
        {
            for (int d = 0; d < D; ++d)
                rowOfFaces(b.grid, d, c, end,
                    MarkByWetCells<D, R>{
                        b.grid, b.wet.data(), b.aperture[d].data(), nullptr, d, b.layer[d].data()});
        });
    for (int d = 0; d < D; ++d) EXPECT_TRUE(a.layer[d] == b.layer[d]);
}

} // namespace
} // namespace riprap

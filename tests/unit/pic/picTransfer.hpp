/*  Maps between particles and grid: splines, conservation, exactness for constant and linear
    fields, angular momentum.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "picCloud.hpp"
#include "core/loops/reduceMax.hpp"
#include "pic/cutCells/pushOut.hpp"
#include "pic/grid/speed.hpp"

namespace riprap
{
namespace
{

PIC_TEST(SplinesSumToOneAndAreLinear)
{
    forOrders([](auto order)
    {
        using Spline = BSpline<decltype(order)::value>;
        Random random(3);
        for (int k = 0; k < 200; ++k)
        {
            const double s = random(-5, 5);
            double w[Spline::nodes], slope[Spline::nodes], sum = 0, first = 0, slopes = 0,
                                                           firstSlope = 0;
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
        forOrders(
            [&](auto order)
            {
                if (affine)
                {
                    cloud.template toGrid<decltype(order)::value>();
                    cloud.template toParticles<decltype(order)::value>();
                }
                cloud.template toGrid<decltype(order)::value>(affine);
                for (int d = 0; d < C::D; ++d)
                {
                    const auto u = cloud.u[d].download(), m = cloud.mass[d].download();
                    const auto v = cloud.set.template download<typename C::real>(
                        cloud.context, C::D + d);
                    double mass = 0, momentum = 0, given = 0, size = 0;
                    for (std::size_t i = 0; i < u.size(); ++i)
                    {
                        mass += m[i];
                        momentum += double(m[i])*u[i];
                    }
                    for (const auto a : v)
                    {
                        given += a;
                        size += std::abs(a);
                    }
                    EXPECT_NEAR(mass/cloud.n, 1, 100*C::epsilon);
                    EXPECT_NEAR(momentum/size, given/size, 100*C::epsilon);
                }
            });
}

//- Mass and momentum of each face are the sums over all particles, seen directly and, beyond the
//  sides, from the face's images
PIC_TEST(SumsAreThoseOverAllParticles)
{
    using C = TypeParam;
    constexpr int D = C::D;
    Random random(13);
    for (const bool periodic : {false, true})
    {
        Cloud<C> cloud(
            5, 3, 0, [&](const Vec<D, double>&, int) { return random(-1, 1); }, periodic);
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
                        // products over the axes; odd: images turn the component round
                        double even = 1, odd = 1;
                        for (int a = 0; a < D; ++a)
                        {
                            const double s = at.c[a]/g.h, xp = x[a][p]/g.h, n = g.n[a];
                            double direct = Spline::value(s - xp), image = 0;
                            if (periodic)
                                direct += Spline::value(s + n - xp) + Spline::value(s - n - xp);
                            else if (s > 1e-9 && s < n - 1e-9)
                                image = Spline::value(-s - xp) + Spline::value(2*n - s - xp);
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

//- A constant comes through both ways, whatever the particles; beside walls, too, for what runs
//  along them
PIC_TEST(ConstantsAreReproduced)
{
    using C = TypeParam;
    Cloud<C> cloud(8, 20, 0, [](const Vec<C::D, double>&, int d) { return 1.5 - d; }, true);
    forOrders([&](auto order)
    {
        cloud.template toGrid<decltype(order)::value>();
        for (int d = 0; d < C::D; ++d)
            // sums of up to 700 products
            for (const auto u : cloud.u[d].download()) EXPECT_NEAR(u, 1.5 - d, 200*C::epsilon);
        cloud.template toParticles<decltype(order)::value>();
        for (int d = 0; d < C::D; ++d)
            for (const auto v :
                cloud.set.template download<typename C::real>(cloud.context, C::D + d))
                EXPECT_NEAR(v, 1.5 - d, 50*C::epsilon);
    });
}

//- Beside the surface FLIP's change is that of the water: what moves with it gets all of it, spray
//  becomes no faster than it was or the water is; inside all get it
PIC_TEST(SprayGainsNoEnergy)
{
    using C = TypeParam;
    using R = typename C::real;
    constexpr int D = C::D;
    const auto before = [](int d) { return 0.5 - d; };
    const auto change = [](int d) { return d ? 0.25 : 2.0; };
    const auto spray = [&](const Vec<D, double>& x, int d)
    { return before(d) + (x.c[0] < 0.5 ? 0 : std::sin(40*x.c[D - 1] + d)); };
    for (const unsigned char water : {someWater, allWater})
    {
        Cloud<C> cloud(8, 5, 0, spray, true);
        std::vector<double> x[D];
        for (int d = 0; d < D; ++d) x[d] = cloud.set.template download<double>(cloud.context, d);
        Array<Backend, R> du[D];
        Array<Backend, unsigned char> near;
        near.upload(cloud.context, std::vector<unsigned char>(cloud.grid.cells(), water));
        GridToParticle<2, D, R, true, Flip::Formula<R>> f{};
        f.grid = cloud.grid;
        f.inverse = 1/cloud.grid.h;
        f.particles = cloud.view();
        for (int d = 0; d < D; ++d)
        {
            cloud.u[d].upload(
                cloud.context, std::vector<R>(cloud.grid.faces(d), R(before(d) + change(d))));
            du[d].upload(cloud.context, std::vector<R>(cloud.grid.faces(d), R(change(d))));
            f.u[d] = cloud.u[d].data();
            f.du[d] = du[d].data();
            f.fall[d] = R(d == 1 ? -0.1 : 0);
        }
        f.nearWater = near.data();
        forEach(cloud.context, cloud.n, f);
        std::vector<R> v[D];
        for (int d = 0; d < D; ++d) v[d] = cloud.set.template download<R>(cloud.context, D + d);
        int slowed = 0;
        for (int i = 0; i < cloud.n; ++i)
        {
            Vec<D, double> at;
            for (int a = 0; a < D; ++a) at.c[a] = x[a][i];
            double speed2 = 0, fallen2 = 0, grid2 = 0, off = 0;
            for (int d = 0; d < D; ++d)
            {
                const double own = spray(at, d);
                speed2 += v[d][i]*double(v[d][i]);
                fallen2 += (own + double(f.fall[d]))*(own + double(f.fall[d]));
                grid2 += (before(d) + change(d))*(before(d) + change(d));
                off = std::max(off, std::abs(v[d][i] - own - change(d)));
            }
            const bool untouched = off < 100*C::epsilon;
            if (water == someWater)
            {
                EXPECT_LE(speed2, std::max(fallen2, grid2)*(1 + 100*C::epsilon));
            }
            if (water == allWater || at.c[0] < 0.5) { EXPECT_TRUE(untouched); }
            slowed += !untouched;
        }
        EXPECT_EQ(slowed > cloud.n/10, water == someWater);
    }
}

//- A step of 1 s between faces that are open or closed; shift: what positions were corrected by, or
//  nullptr
template<class C>
void moveBetweenFaces(Cloud<C>& cloud, const Array<Backend, typename C::real>* aperture,
    Array<Backend, typename C::real>* shift, const Array<Backend, unsigned char>& near,
    double margin)
{
    using R = typename C::real;
    MoveParticles<2, C::D, R> f{};
    f.grid = cloud.grid;
    f.inverse = 1/cloud.grid.h;
    f.particles = cloud.view();
    for (int d = 0; d < C::D; ++d)
    {
        f.u[d] = cloud.u[d].data();
        f.aperture[d] = aperture[d].data();
        f.shift[d] = shift ? shift[d].data() : nullptr;
    }
    f.nearWater = near.data();
    f.timeStep = 1;
    f.order = 3;
    f.inside = true;
    f.margin = margin;
    forEach(cloud.context, cloud.n, f);
}

//- The correction has pushed particles by so much, and given each the velocity of where it would
//  be, by the gradient that it knows: where sides, closed faces and solids keep it from going there
//  it has that of where it is, v + A dx, less what it loses into the wall
PIC_TEST(WallsTakeBackWhatTheCorrectionGave)
{
    using C = TypeParam;
    using R = typename C::real;
    constexpr int D = C::D;
    constexpr double margin = 1e-3, surface = 0.3;
    Random random(17);
    for (const bool solid : {false, true})
    {
        Cloud<C> cloud(6, 5, 0, [&](const Vec<D, double>&, int) { return random(-1, 1); });
        const UniformGrid<D>& g = cloud.grid;
        auto& context = cloud.context;
        std::vector<double> x[D];
        std::vector<R> v0[D], v[D], push[D], gradient[D*D];
        for (int d = 0; d < D; ++d)
        {
            x[d] = cloud.set.template download<double>(context, d);
            for (double& at : x[d])         // not nearer to a wall than it would leave them
            {
                const double cell = std::floor(at/g.h)*g.h;
                at = std::max(cell + 2*margin, std::min(at, cell + g.h - 2*margin));
            }
            v[d] = v0[d] = cloud.set.template download<R>(context, D + d);
            push[d].assign(cloud.n, R(0));
        }
        for (int k = 0; k < D*D; ++k)
            for (int i = 0; i < cloud.n; ++i) gradient[k].push_back(R(random(-20, 20)));
        for (int i = 0; i < cloud.n; ++i)
        {
            const int along = solid ? 0 : i % D;
            if (solid) x[0][i] = std::max(x[0][i], surface + margin);
            push[along][i] = R((solid ? -1 : 1)*random(-0.6, 0.6)*g.h);
            for (int a = 0; a < D; ++a) v[a][i] += gradient[a*D + along][i]*push[along][i];
        }
        Array<Backend, R> shift[D], aperture[D];
        Array<Backend, unsigned char> near, sealed[D];
        near.upload(context, std::vector<unsigned char>(g.cells(), allWater));
        std::vector<double> to = x[0];
        if (solid) for (int i = 0; i < cloud.n; ++i) to[i] += push[0][i];
        for (int d = 0; d < D; ++d)
        {
            std::vector<R> open(g.faces(d), R(1));
            for (int f = 0; f < g.faces(d); ++f)
            {
                const int at = g.faceIndex(d, f).c[d];
                if (at == 0 || at == g.n[d] || (d == 0 && at == 3)) open[f] = 0;
            }
            aperture[d].upload(context, open);
            sealed[d].upload(context, std::vector<unsigned char>(g.faces(d), 0));
            shift[d].upload(context, push[d]);
            // nothing is carried anywhere
            cloud.u[d].upload(context, std::vector<R>(g.faces(d), R(0)));
            cloud.set.upload(context, d, d == 0 ? to : x[d]);
            cloud.set.upload(context, D + d, v[d]);
        }
        for (int k = 0; k < D*D; ++k) cloud.set.upload(context, 2*D + k, gradient[k]);
        std::vector<double> distance;
        for (int i = 0; i < NodeGrid<D>{g}.count(); ++i)
            distance.push_back(g.h*(i % (g.n[0] + 1)) - surface);
        Array<Backend, double> distances;
        distances.upload(context, distance);
        if (solid)
        {
            PushOut<D, R> f{};
            f.solids.grid = g;
            f.solids.distance = distances.data();
            f.particles = cloud.view();
            f.margin = margin;
            for (int d = 0; d < D; ++d)
            {
                f.solids.aperture[d] = aperture[d].data();
                f.solids.sealed[d] = sealed[d].data();
                f.shift[d] = shift[d].data();
            }
            forEach(context, cloud.n, f);
        }
        else
        {
            moveBetweenFaces<C>(cloud, aperture, shift, near, margin);
        }
        int stopped = 0;
        std::vector<double> after[D];
        for (int d = 0; d < D; ++d)
        {
            after[d] = cloud.set.template download<double>(context, d);
            v[d] = cloud.set.template download<R>(context, D + d);
        }
        for (int i = 0; i < cloud.n; ++i)
        {
            const int along = solid ? 0 : i % D;
            const double went = after[along][i] - x[along][i], kept = went - push[along][i];
            if (std::abs(kept) > 1e-6) ++stopped;
            for (int a = 0; a < D; ++a)
            {
                const double own = double(v0[a][i]) + double(gradient[a*D + along][i])*went;
                // into the wall
                const bool lost = a == along && std::abs(kept) > 1e-6 && own*kept < 0;
                EXPECT_NEAR(v[a][i], lost ? 0 : own, 200*C::epsilon)
                    << i << " " << a << " " << solid;
            }
        }
        EXPECT_GT(stopped, cloud.n/40);
    }
}

//- Who flies counts for as much of its speed as it may go farther
PIC_TEST(FlyingOnesLimitTheStepLess)
{
    using C = TypeParam;
    constexpr int D = C::D;
    constexpr double part = 0.25;
    Random random(9);
    for (const bool fastestFlies : {true, false})
    {
        Cloud<C> cloud(6, 2, 0, [&](const Vec<D, double>&, int) { return random(-1, 1); });
        const UniformGrid<D>& g = cloud.grid;
        std::vector<unsigned char> water(g.cells(), someWater);
        double flying = 0, carried = 0;
        std::vector<typename C::real> v[D];
        for (int d = 0; d < D; ++d)
            v[d] = cloud.set.template download<typename C::real>(cloud.context, D + d);
        const auto x = cloud.set.template download<double>(cloud.context, 0);
        for (int i = 0; i < g.cells(); ++i) if (i % g.n[0] < 3) water[i] = 0;
        for (int i = 0; i < cloud.n; ++i)
        {
            const bool flies = x[i] < 3*g.h;
            double speed = 0;
            for (int d = 0; d < D; ++d)
            {
                if (flies == fastestFlies) v[d][i] *= 8;
                speed += double(v[d][i])*v[d][i];
            }
            (flies ? flying : carried) = std::max(flies ? flying : carried, std::sqrt(speed));
        }
        for (int d = 0; d < D; ++d) cloud.set.upload(cloud.context, D + d, v[d]);
        Array<Backend, unsigned char> near;
        near.upload(cloud.context, water);
        const double most = reduceMax(cloud.context, cloud.n,
            CarriedSpeed<D, typename C::real>{g, {cloud.view()}, near.data(), part});
        EXPECT_NEAR(most, fastestFlies ? part*flying : carried, 1e-12*most);
        EXPECT_GT(most, fastestFlies ? carried : part*flying);
    }
}

//- Free flights of several cells a step: as straight as in one piece; not through closed faces,
//  however thin; in the water they go with the water, for what is left of the step
PIC_TEST(FlightsAreFollowedCellByCell)
{
    using C = TypeParam;
    using R = typename C::real;
    constexpr int D = C::D;
    constexpr double margin = 1e-3, carrier = 0.5;
    constexpr int n = 12, wall = 4, waterFrom = 8;      // cells along the first axis
    Random random(5);
    Cloud<C> cloud(n, 2, 0, [&](const Vec<D, double>&, int) { return 0.0; });
    const UniformGrid<D>& g = cloud.grid;
    auto& context = cloud.context;
    std::vector<double> x[D];
    std::vector<R> v[D];
    for (int d = 0; d < D; ++d)
    {
        x[d] = cloud.set.template download<double>(context, d);
        for (int i = 0; i < cloud.n; ++i) v[d].push_back(R(random(-4, 4)*g.h));
    }
    Array<Backend, R> aperture[D];
    Array<Backend, unsigned char> near;
    std::vector<unsigned char> water(g.cells(), 0);
    for (int i = 0; i < g.cells(); ++i) if (i % g.n[0] >= waterFrom) water[i] = allWater;
    near.upload(context, water);
    for (int d = 0; d < D; ++d)
    {
        std::vector<R> open(g.faces(d), R(1));
        for (int k = 0; k < g.faces(d); ++k)
        {
            const int at = g.faceIndex(d, k).c[d];
            if (at == 0 || at == g.n[d] || (d == 0 && at == wall)) open[k] = 0;
        }
        aperture[d].upload(context, open);
        cloud.u[d].upload(context, std::vector<R>(g.faces(d), R(d == 0 ? carrier*g.h : 0)));
        cloud.set.upload(context, D + d, v[d]);
    }
    moveBetweenFaces<C>(cloud, aperture, nullptr, near, margin);
    std::vector<double> to[D];
    for (int d = 0; d < D; ++d) to[d] = cloud.set.template download<double>(context, d);
    int straight = 0, stopped = 0, landed = 0;
    for (int i = 0; i < cloud.n; ++i)
    {
        const double begin = x[0][i]/g.h, end = begin + v[0][i]/g.h;
        if (begin >= waterFrom) continue;
        bool inside = true;
        for (int d = 0; d < D; ++d)
            inside = inside && x[d][i] + v[d][i] > margin && x[d][i] + v[d][i] < n*g.h - margin;
        if (!inside) continue;
        if (std::floor(begin) < wall ? end >= wall : end < wall)
        {
            EXPECT_NEAR(to[0][i], wall*g.h + (begin < wall ? -margin : margin), 1e-6*g.h);
            ++stopped;
        }
        else if (end < waterFrom)
        {
            for (int d = 0; d < D; ++d) EXPECT_NEAR(to[d][i], x[d][i] + v[d][i], 1e-6*g.h);
            ++straight;
        }
        else
        {
            // carried from within the piece, a cell at most, in which it came to the water
            const double time = (waterFrom - begin)/(end - begin);
            double most = 0;
            for (int d = 0; d < D; ++d) most = std::max(most, std::abs(double(v[d][i]))/g.h);
            const double piece = 1/std::floor(1 + most),
                         flown = std::min(1.0, piece*std::ceil(time/piece - 1e-6));
            EXPECT_NEAR(to[0][i]/g.h, begin + flown*(end - begin) + carrier*(1 - flown), 1e-4)
                << begin << " " << end;
            ++landed;
        }
    }
    EXPECT_GT(straight, cloud.n/20);
    EXPECT_GT(stopped, cloud.n/20);
    EXPECT_GT(landed, cloud.n/40);
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
                for (const auto c :
                    cloud.set.template download<typename C::real>(cloud.context, 2*D + d*D + a))
                    EXPECT_NEAR(c, 0.7*d - 0.4*a + 0.2, 2000*C::epsilon);
        }
    });
    // and with it they give the grid the same field, wherever they lie about a face
    cloud.template toGrid<2>(true);
    for (int d = 0; d < D; ++d)
    {
        const auto u = cloud.u[d].download(), m = cloud.mass[d].download();
        for (std::size_t i = 0; i < u.size(); ++i)
            if (m[i] > 0.01)
            {
                EXPECT_NEAR(u[i], linear(cloud.faceAt(d, int(i)), d), 5000*C::epsilon);
            }
    }
}

//- Angular momentum about the origin after grid and back: kept by APIC (Jiang et al. 2015, section
//  5.3: x v + D C), lost by PIC
PIC_TEST(AffineTransferKeepsAngularMomentum)
{
    using C = TypeParam;
    constexpr int D = C::D;
    Random random(5);
    Cloud<C> cloud(9, 4, 2,
        [&](const Vec<D, double>& x, int d)
        { return (d == 0 ? -x.c[1] : (d == 1 ? x.c[0] : 0.0)) + random(-0.1, 0.1); });
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
        const auto c = cloud.set.template download<typename C::real>(
            cloud.context, 2*D + d*D + 1 - d);
        for (int i = 0; i < cloud.n; ++i)
        {
            pic += (d == 1 ? 1 : -1)*x[i]*v[i];
            affine += (d == 1 ? 1 : -1)*(x[i]*v[i] + moment*c[i]);
        }
    }
    EXPECT_NEAR(affine/onGrid, 1, 1000*C::epsilon);
    EXPECT_GT(std::abs(pic/onGrid - 1), 1e-4);
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

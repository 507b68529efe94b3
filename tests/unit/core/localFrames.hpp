/*  LocalFrames: while every particle is within its bounds, no two that were farther apart than
    support and skin have met.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "backendTest.hpp"
#include "core/neighbours/localFrames.hpp"

namespace riprap
{
namespace
{

template<class C>
struct IncludeAll
{
    static constexpr const char* name = "includeAll";
    static constexpr int D = C::D;
    using P = typename C::P;

    Box<D, P> box;
    LocalFrames<D, P> frames;
    const Vec<D, typename P::position>* from;
    const Vec<D, typename C::real>* v;
    int still;                  // the first so many are points at rest

    HD void operator()(int i) const
    {
        if (i < still) frames.includeStill(box, from[i]);
        else frames.include(box, from[i], v[i]);
    }
};

//- 1 where a particle has gone too far
template<class C>
struct FindFar
{
    static constexpr const char* name = "findFar";
    static constexpr int D = C::D;
    using P = typename C::P;
    using real = typename C::real;

    Box<D, P> box;
    LocalFrames<D, P> frames;
    const Vec<D, typename P::position>* from;
    const Vec<D, typename P::position>* now;
    const Vec<D, real>* v;
    real halfSkin, time;
    int still;
    int* far;

    HD void operator()(int i) const
    {
        if (i < still) { far[i] = 0; return; }
        const WaySince<real> w = frames.since(box, from[i], now[i], v[i], time, real(0));
        far[i] = w.relative > halfSkin || w.whole > w.limit;
    }
};

//- Particles that fly straight on
template<class C>
struct Swarm
{
    static constexpr int D = C::D;
    using P = typename C::P;
    using real = typename C::real;
    using Places = std::vector<Vec<D, typename P::position>>;

    Box<D, P> box;
    double support = 0.06, skin = 0.02, stillSkin = 0.05;
    int still = 0;
    std::vector<Vec<D, double>> x, v;

    Swarm() { for (int d = 0; d < D; ++d) box.set(d, 0, 1, d == 0); }

    void add(const Vec<D, double>& where, const Vec<D, double>& velocity)
    {
        x.push_back(where);
        v.push_back(velocity);
    }

    Places places(double t) const
    {
        Places r(x.size());
        for (std::size_t i = 0; i < x.size(); ++i)
            for (int d = 0; d < D; ++d)
                r[i].c[d] = box.pairPosition(d, box.toFixedInside(d, x[i].c[d] + t*v[i].c[d]));
        return r;
    }

    double apart(const Places& p, std::size_t i, std::size_t j) const
    {
        double r2 = 0;
        for (int d = 0; d < D; ++d)
        {
            const double s = box.template separation<real>(d, p[i].c[d], p[j].c[d]);
            r2 += s*s;
        }
        return std::sqrt(r2);
    }

    //- The last of the times at which all are within their bounds
    double holdsUntil(double dt) const
    {
        Context<Backend> context;
        const int n = int(x.size());
        LocalFrameMemory<Backend, D, P> memory;
        memory.set(context, box, 2*(support + skin), 1e5);
        Array<Backend, Vec<D, typename P::position>> from, now;
        Array<Backend, Vec<D, real>> velocity;
        Array<Backend, int> far;
        from.upload(context, places(0));
        std::vector<Vec<D, real>> u(n);
        for (int i = 0; i < n; ++i) for (int d = 0; d < D; ++d) u[i].c[d] = real(v[i].c[d]);
        velocity.upload(context, u);
        far.allocate(context, n);
        memory.clear(context);
        memory.clearStill(context);
        runEach(context, n, IncludeAll<C>{box, memory.view(), from.data(), velocity.data(), still});
        memory.settle(context, 0.5*(memory.width() - support), stillSkin);
        for (int k = 1;; ++k)
        {
            now.upload(context, places(k*dt));
            runEach(context, n,
                FindFar<C>{box, memory.view(), from.data(), now.data(), velocity.data(),
                    real(0.5*skin), real(k*dt), still, far.data()});
            for (const int f : far.download()) if (f) return (k - 1)*dt;
            if (k > 1000) return 1e300;
        }
    }

    //- Pairs that came within the support by then, but were beyond it and the skin at the search;
    //  of points at rest beyond theirs
    int missed(double t) const
    {
        const Places begin = places(0), end = places(t);
        int count = 0;
        for (std::size_t i = 0; i < x.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
            {
                const double listed = support + (int(j) < still ? stillSkin : skin);
                if (int(i) >= still && apart(end, i, j) < support*(1 - 1e-5)
                    && apart(begin, i, j) > listed)
                    ++count;
            }
        return count;
    }
};

template<class C> class LocalFramesTest : public BackendCase<C> { };
TYPED_TEST_SUITE(LocalFramesTest, AllCases, CaseNames);

TYPED_TEST(LocalFramesTest, NobodyIsMissed)
{
    constexpr int D = TypeParam::D;
    for (const double noise : {0.0, 0.05, 1.0})
        for (const bool walls : {false, true})
        {
            Random random(7);
            Swarm<TypeParam> s;
            if (walls)
                for (int k = 0; k < 60; ++k)
                {
                    Vec<D, double> x{};
                    for (int d = 0; d < D; ++d) x.c[d] = random(0.3, 0.7);
                    x.c[1] = 0.28;
                    s.add(x, Vec<D, double>{});
                }
            s.still = int(s.x.size());
            for (int k = 0; k < (D == 2 ? 400 : 1200); ++k)
            {
                Vec<D, double> x{}, v{};
                for (int d = 0; d < D; ++d) x.c[d] = random(0.3, 0.7);
                // a stretching flow that drifts along the periodic axis
                for (int d = 0; d < D; ++d)
                    v.c[d] = (d == 0 ? 2 + x.c[0] : (d == 1 ? -x.c[1] : 0)) + random(-noise, noise);
                s.add(x, v);
            }
            const double until = s.holdsUntil(2e-4);
            ASSERT_LT(until, 1);
            EXPECT_EQ(s.missed(until), 0) << "noise " << noise;
            // a bound that is far too narrow is no use: the way of the fastest against half the
            // skin
            if (noise < 0.1 && !walls) { EXPECT_GT(until, 4*0.5*s.skin/3) << "noise " << noise; }
            EXPECT_GT(s.missed(1.0), noise > 0 ? 0 : -1) << "the test would see them";
        }
}

TYPED_TEST(LocalFramesTest, WhoMeetsCountsInFull)
{
    constexpr int D = TypeParam::D;
    // two that fly at each other, in one block and in two: together they may use up the skin
    for (const double where : {0.5, 0.56, 0.62})
    {
        Swarm<TypeParam> s;
        Vec<D, double> a{}, b{}, v{};
        for (int d = 0; d < D; ++d) a.c[d] = b.c[d] = 0.5;
        a.c[1] = where - 0.04001;
        b.c[1] = where + 0.04001;
        v.c[1] = 1;
        s.add(a, v);
        s.add(b, -1.0*v);
        const double until = s.holdsUntil(1e-4);
        EXPECT_GT(until, 0.4*s.skin/2);
        EXPECT_LE(until, 0.5*s.skin*1.001);
        EXPECT_EQ(s.missed(until), 0);
    }
}

} // namespace
} // namespace riprap

/*  Nobody is missed: the pairs that a scene's passes look at, while neighbours grow old, are all
    that there are. Flows in which they change fast, pairs by brute force. The second test follows
    the same flows step by step beside the rule by which neighbours are kept on the GPU, on any
    device.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "core/neighbours/localFrames.hpp"
#include "flows.hpp"
#include "sph/state/clock.hpp"

namespace riprap
{
namespace
{

class Neighbours : public FlowTest
{
protected:

    void expectAll(const Flow& f, SphScene& s) const
    {
        const Places p = placesOf(s);
        const NeighbourCounts found = s.countNeighbours();
        const auto expectBetween = [&](const char* what, std::int64_t n,
                                       const std::vector<double>& a, const std::vector<double>& b)
        {
            const Bounds bounds = pairsWithin(f.c, a, b);
            EXPECT_GE(n, bounds.least) << what;
            EXPECT_LE(n, bounds.most) << what;
        };
        expectBetween("fluid", found.fluid, p.fluid, p.fluid);
        expectBetween("walls", found.walls, p.fluid, p.walls);
        if (f.walls.nBodies || f.c.wallModel == "extrapolated")
            expectBetween("about walls", found.aboutWalls, p.walls, p.fluid);
        expectBetween("solids", found.solids, p.fluid, p.solids);
        expectBetween("about solids", found.aboutSolids, p.solids, p.fluid);
        if (!f.walls.size()) { EXPECT_EQ(found.walls, 0); }
    }
};

RIPRAP_ALL_SETUPS(Neighbours);

TEST_P(Neighbours, AllAreFoundWhileTheyGrowOld)
{
    for (const Flow& f : allFlows())
    {
        SCOPED_TRACE(f.name);
        const auto s = make(f);
        expectAll(f, *s);
        for (const int steps : {3, 7, 12, 18, 29, 5, 23, 11})
        {
            const SphReport r = s->advance(s->time() + 0.2, steps);
            ASSERT_EQ(r.stop, StopReason::none) << r.stopValue << " at " << r.time;
            ASSERT_EQ(r.steps, steps);
            ASSERT_TRUE(r.escaped.empty());
            EXPECT_FALSE(r.skinExceeded);
            SCOPED_TRACE(r.time);
            expectAll(f, *s);
        }
    }
}

//- Single fast particles, each on its own line towards one at rest, or towards one that comes as
//  fast, which it comes near at another age of the neighbours than the others
TEST_P(Neighbours, FastOnesAreFound)
{
    const double spacing = D() == 3 ? 0.1 : 0.05, support = 2*1.25*spacing, line = 1.1*support;
    const int lines = 60;
    for (const double other : {0.0, 1.0})
    {
        SCOPED_TRACE(other);
        Flow f{"fast", flowConfig({{3, lines*line, 0.9}}, false), {}, {}, {}, {}};
        f.c.viscosityModel = "none";
        ASSERT_DOUBLE_EQ(2*f.c.smoothingRatio*f.c.spacing, support);
        std::mt19937 engine(7);
        for (int k = 0; k < lines; ++k)
        {
            const double at = uniform(engine, 1, 2), away = support*(1 + uniform(engine, 0, 0.3));
            for (const double x : {at, at + away})
            {
                for (const double p : {x, (k + 0.5)*line, deep(0.45)})
                    f.fluid.position.push_back(p);
                for (const double u : {x > at ? -1.0 : other, 0.0, 0.0})
                    f.fluid.velocity.push_back(u);
                f.fluid.density.push_back(f.c.density);
            }
        }
        const auto start = make(f);
        expectAll(f, *start);
        std::int64_t oldest = 0;
        for (int steps = 1; steps <= 30; ++steps)
        {
            SCOPED_TRACE(steps);
            const auto s = make(f);
            const SphReport r = s->advance(1, steps);
            ASSERT_EQ(r.steps, steps);
            EXPECT_FALSE(r.skinExceeded);
            if (s->device() == DeviceKind::cpu)
                oldest = std::max(oldest, r.steps/std::max(r.rebuilds, std::int64_t(1)));
            expectAll(f, *s);
        }
        if (start->device() == DeviceKind::cpu)
        {
            EXPECT_GE(oldest, 2) << "neighbours did not grow old: nothing was tested";
        }
    }
}

//- What the GPU does with the ways of particles, in double steps beside a scene
template<int Dim>
class Follower
{
public:

    using Position = Vec<Dim, Mixed::position>;

    Follower(const SphConfig& c, const Places& start)
        : config_(c), support_(2*c.smoothingRatio*c.spacing), skin_(c.skin*support_),
          walls_(start.walls)
    {
        const double radius = support_ + skin_;
        for (int d = 0; d < Dim; ++d)
        {
            const double margin = c.periodic[d] ? 0 : radius;
            box_.set(d, c.domainMin[d] - margin, c.domainMax[d] - c.domainMin[d] + 2*margin,
                c.periodic[d]);
        }
        frames_.set(context_, box_, 2*radius, 2e6);
        const auto view = frames_.view();
        for (std::size_t i = 0; i < walls_.size(); i += 3)
            view.includeStill(box_, pair(&walls_[i]));
        now_ = together(start);
    }

    // pairs within the support that were not listed, as long as the lists were said to hold
    std::size_t missed = 0;
    int searches = 0, oldSearches = 0;
    bool tooFar = false;        // a step went farther than it was thought to

    //- Neighbours are sought with what is known of velocities
    void search(double time, const std::vector<double>& v)
    {
        ++searches;
        clock_.time = time;
        clock_.search();
        from_ = now_;
        frames_.clear(context_);
        const auto view = frames_.view();
        for (std::size_t i = 0; i < now_.size(); i += 3)
            view.include(box_, pair(&now_[i]), velocity(&v[i]));
        frames_.settle(context_, 0.5*(frames_.width() - support_), wallSkin()*support_);
        listed_ = within(support_ + skin_);
        listedWalls_ = withinWalls(support_*(1 + wallSkin()));
    }

    //- After a step
    void step(const Places& places, double time, double dt)
    {
        const std::vector<double> before = now_;
        now_ = together(places);
        std::vector<double> v(now_.size(), 0.0);
        for (std::size_t i = 0; i < now_.size(); ++i)
        {
            const int d = int(i % 3);
            double way = now_[i] - before[i];
            const double length = config_.domainMax[d] - config_.domainMin[d];
            if (d < Dim && config_.periodic[d]) way -= length*std::round(way/length);
            if (d < Dim) v[i] = way/dt;
        }
        if (searches == 0) { search(time, v); oldFrom_ = now_; return; }
        clock_.time = time;
        const auto view = frames_.view();
        const float half = float(0.5*skin_);
        bool old = false;
        for (std::size_t i = 0; i < now_.size(); i += 3)
        {
            const Position p = pair(&now_[i]);
            // as much again as the last step has pushed it
            double pushed2 = 0;
            for (int d = 0; d < Dim; ++d)
                pushed2 += before_.empty() ? 0 : std::pow(v[i + d] - before_[i + d], 2);
            const float pushed = float(1.25*dt*std::sqrt(pushed2));
            const auto since = [&](const std::vector<double>& from)
            {
                WaySince<float> w = view.since(box_, pair(&from[i]), p, velocity(&v[i]),
                    float(time - clock_.searched), float(1.25*dt));
                w.relativeNext += pushed;
                w.wholeNext += pushed;
                return w;
            };
            clock_.notice(since(from_), half);
            old = old || since(oldFrom_).wholeNext > half;
        }
        if (old) { ++oldSearches; oldFrom_ = now_; }
        before_ = v;
        clock_.settleAge();
        tooFar = tooFar || clock_.skinViolations;
        // where they are oldest, and now and then
        if (!clock_.skinViolations && (clock_.needRebuild || ++steps_ % 5 == 0))
        {
            const std::vector<bool> near = within(support_*(1 - 1e-5)),
                                    nearWalls = withinWalls(support_*(1 - 1e-5));
            for (std::size_t k = 0; k < near.size(); ++k) missed += near[k] && !listed_[k];
            for (std::size_t k = 0; k < nearWalls.size(); ++k)
                missed += nearWalls[k] && !listedWalls_[k];
        }
        if (clock_.needRebuild) search(time, v);
    }

private:

    static constexpr double wallSkin() { return Dim == 2 ? 0.5 : 0.2; }
    SphConfig config_;
    double support_, skin_;
    std::vector<double> walls_, now_, from_, oldFrom_, before_;
    Context<Cpu> context_;
    Box<Dim, Mixed> box_;
    LocalFrameMemory<Cpu, Dim, Mixed> frames_;
    ClockData clock_;
    std::vector<bool> listed_, listedWalls_;
    int steps_ = 0;

    static std::vector<double> together(const Places& p)
    {
        std::vector<double> r(p.fluid);
        r.insert(r.end(), p.solids.begin(), p.solids.end());
        return r;
    }

    Position pair(const double* x) const
    {
        Position p;
        for (int d = 0; d < Dim; ++d) p.c[d] = box_.pairPosition(d, box_.toFixedInside(d, x[d]));
        return p;
    }

    static Vec<Dim, float> velocity(const double* v)
    {
        Vec<Dim, float> r;
        for (int d = 0; d < Dim; ++d) r.c[d] = float(v[d]);
        return r;
    }

    std::vector<bool> pairs(const std::vector<double>& others, double distance) const
    {
        const std::size_t n = now_.size()/3, m = others.size()/3;
        std::vector<bool> r(n*m);
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < m; ++j)
            {
                double r2 = 0;
                for (int d = 0; d < Dim; ++d)
                {
                    double s = now_[3*i + d] - others[3*j + d];
                    const double length = config_.domainMax[d] - config_.domainMin[d];
                    if (config_.periodic[d]) s -= length*std::rint(s/length);
                    r2 += s*s;
                }
                r[i*m + j] = r2 < distance*distance;
            }
        return r;
    }

    std::vector<bool> within(double distance) const { return pairs(now_, distance); }
    std::vector<bool> withinWalls(double distance) const { return pairs(walls_, distance); }
};

class NeighbourRule : public FlowTest
{
protected:

    template<int Dim>
    void follow(const Flow& f) const
    {
        SCOPED_TRACE(f.name);
        const auto s = make(f);
        Follower<Dim> follower(f.c, placesOf(*s));
        // few particles: as long as it takes until they meet
        const int steps = f.fluid.size() < 100 ? 250 : (Dim == 3 ? 40 : 80);
        for (int k = 0; k < steps; ++k)
        {
            const SphReport r = s->advance(1e9, 1);
            ASSERT_EQ(r.stop, StopReason::none);
            follower.step(placesOf(*s), r.time, r.lastTimeStep);
        }
        EXPECT_EQ(follower.missed, 0u);
        EXPECT_FALSE(follower.tooFar);
        EXPECT_GT(follower.searches, 1) << "neighbours did not grow old: nothing was tested";
        EXPECT_LE(follower.searches, follower.oldSearches + 1)
            << "ways alone hold at least as long";
        const std::string name = f.name;
        if (name == "sheared" || name == "carried")
        {
            EXPECT_LT(2*follower.searches, follower.oldSearches)
                << "what moves together does not come nearer";
        }
    }
};

INSTANTIATE_TEST_SUITE_P(, NeighbourRule,
    testing::Values(Setup{DeviceKind::cpu, 2, PrecisionKind::mixed},
        Setup{DeviceKind::cpu, 3, PrecisionKind::mixed}),
    setupName);

TEST_P(NeighbourRule, HoldsInFlowsThatBreak)
{
    for (const Flow& f : allFlows())
    {
        if (f.walls.nBodies) continue;      // moving walls have a rule of their own
        if (D() == 2) follow<2>(f); else follow<3>(f);
    }
}

} // namespace
} // namespace riprap

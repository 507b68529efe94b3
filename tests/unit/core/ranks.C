/*  Particles that ranks share, without any physics: pieces of rows, bricks, and who goes where.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <map>
#include <numeric>
#include <random>
#include <gtest/gtest.h>
#include "core/ranks/idSlots.hpp"
#include "core/ranks/joinRanks.hpp"
#include "randomWalks.hpp"
#include "threadRanks.hpp"

namespace riprap
{
namespace
{

WalkSum walkOnRanks(const Tank& tank, int ranks, int n, int rebuilds, const Walk& walk,
    double imbalance, int comparePairsEvery, double within = 1)
{
    WalkSum sum;
    onRanks(ranks,
        [&](Transport& transport)
        {
            const WalkSum here = walkOnRank(
                transport, tank, n, rebuilds, walk, imbalance, comparePairsEvery, within);
            if (transport.rank() == 0) sum = here;
        });
    return sum;
}

constexpr std::array<bool, 3> closed{{false, false, false}}, wraps{{true, true, true}},
    wrapsX{{true, false, true}};

TEST(ranks, piecesAreConsecutiveCells)
{
    for (const bool zFirst : {false, true})
    {
        const Tank tank(3, 1.1, 0.7, closed, {0.03, 0.07}, zFirst);
        RowPieces pieces;
        pieces.set(tank.grids, walkReach);
        ASSERT_EQ(pieces.cells(), tank.cells());
        int piece = 0, cells = 0;
        for (int c = 0; c < tank.cells(); ++c, ++cells)
        {
            const int p = pieces.of(c);
            if (p != piece) { ASSERT_EQ(p, piece + 1); EXPECT_GE(cells, 4); piece = p; cells = 0; }
        }
        EXPECT_EQ(piece + 1, pieces.count());
    }
}

TEST(ranks, pointsOfAPieceAreAroundItsCentre)
{
    for (const bool zFirst : {false, true})
    {
        const Tank tank(2, 1.1, 0.7, closed, {0.03, 0.07}, zFirst);
        RowPieces pieces;
        pieces.set(tank.grids, walkReach);
        for (const Walker& w : crowd(tank, 2000))
        {
            const auto c = pieces.centre(pieces.of(int(tank.cellOf(w.x, w.size))));
            for (int d = 1; d < 3; ++d)
                EXPECT_LE(std::abs(w.x[d] - c[d]), 0.5001*tank.grids[w.size].size[d]);
            EXPECT_LE(std::abs(w.x[0] - c[0]), 4.0*tank.grids[w.size].size[0]);
        }
    }
}

TEST(ranks, nearPiecesHaveAllThatTouches)
{
    for (const auto& periodic : {closed, wraps, wrapsX})
    {
        const Tank tank(1.3, 0.9, 0.6, periodic, {0.03, 0.05, 0.08});
        RowPieces pieces;
        pieces.set(tank.grids, walkReach);
        const std::vector<Walker> all = crowd(tank, 4000);
        std::size_t pairs = 0, fewer = 0;
        for (const Walker& a : all)
        {
            const int p = pieces.of(int(tank.cellOf(a.x, a.size)));
            const std::vector<int> near = pieces.near(p);
            EXPECT_TRUE(std::binary_search(near.begin(), near.end(), p));
            fewer += near.size() < std::size_t(pieces.count());
            for (const Walker& b : all)
            {
                const double touch = tank.grids[a.size].radius + tank.grids[b.size].radius
                    + walkReach;
                if (!(tank.distance2(a.x, b.x) < touch*touch)) continue;
                ++pairs;
                EXPECT_TRUE(std::binary_search(
                    near.begin(), near.end(), pieces.of(int(tank.cellOf(b.x, b.size)))));
            }
        }
        EXPECT_GT(pairs, 3*all.size());
        EXPECT_EQ(fewer, all.size());
    }
}

TEST(ranks, boxAroundHasTheCentresOfNearPieces)
{
    for (const auto& periodic : {closed, wraps, wrapsX})
    {
        const Tank tank(1.3, 0.9, 0.6, periodic, {0.03, 0.05, 0.08});
        for (const int least : {1, 4})
        {
            RowPieces pieces;
            pieces.set(tank.grids, walkReach, least);
            int wrapped = 0;
            for (int p = 0; p < pieces.count(); ++p)
            {
                RowPieces::Point low, high;
                if (!pieces.boxAround(p, low, high)) { ++wrapped; continue; }
                for (const int near : pieces.near(p))
                {
                    const RowPieces::Point c = pieces.centre(near);
                    for (int d = 0; d < 3; ++d)
                        ASSERT_TRUE(c[d] > low[d] && c[d] < high[d]) << p << " " << near;
                }
            }
            EXPECT_EQ(wrapped > 0, periodic != closed);
        }
    }
}

TEST(ranks, bricksShareTheCost)
{
    std::vector<Bricks::Point> points;
    std::vector<std::int64_t> costs;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> u(0, 1);
    for (int k = 0; k < 4000; ++k)
    {
        points.push_back({{u(random)*u(random), 3*u(random), u(random)}});
        costs.push_back(k % 7);
    }
    const double all = double(std::accumulate(costs.begin(), costs.end(), std::int64_t(0)));
    for (const int ranks : {1, 2, 3, 5, 8, 13})
    {
        const Bricks bricks(ranks, points, costs);
        std::vector<double> load(ranks, 0);
        for (std::size_t k = 0; k < points.size(); ++k)
            load[bricks.rankOf(points[k])] += double(costs[k]);
        // each cut is exact to half a point's cost
        for (const double l : load) EXPECT_NEAR(l, all/ranks, 6*std::log2(2.0*ranks));
    }
}

TEST(ranks, bricksOfFewerPointsThanRanks)
{
    const std::vector<Bricks::Point> points(5, Bricks::Point{{0.1, 0.2, 0.3}});
    const Bricks none(4, {}, {}), one(4, points, {1, 0, 2, 1, 1});
    EXPECT_EQ(none.ranks(), 4);
    const int owner = one.rankOf(points[0]);
    EXPECT_TRUE(owner >= 0 && owner < 4);
    for (const double x : {-1e9, 0.0, 1e9}) EXPECT_LT(none.rankOf({{x, x, x}}), 4);
}

//- More than a million changes of owner in all
TEST(ranks, aMillionMigrations)
{
    const Tank tank(1.5, 1.2, 0.9, wrapsX, {0.03, 0.06});
    const WalkSum o = walkOnRanks(tank, 4, 6000, 300, Walk{tank, 0.6, 0}, 0.1, 50);
    EXPECT_GT(o.arrivals, 1000000);
    EXPECT_EQ(o.leftOver, 6000);
}

TEST(ranks, shortWaysAcrossPeriodicSides)
{
    const Tank tank(1, 1, 1, wraps, {0.04});
    for (const int ranks : {2, 3, 8})
    {
        const WalkSum o = walkOnRanks(tank, ranks, 900, 60, Walk{tank, 0.01, 0}, 0.1, 6);
        EXPECT_GT(o.arrivals, 300);
        EXPECT_EQ(o.leftOver, 900);
    }
}

TEST(ranks, particlesLeaveTheDomain)
{
    const Tank tank(1, 1.5, 0.8, closed, {0.03, 0.05});
    const WalkSum o = walkOnRanks(tank, 3, 2000, 60, Walk{tank, 0.1, 0.05}, 0.1, 10);
    EXPECT_LT(o.leftOver, 200);
}

//- All particles in a corner at first, that fits into one piece; then everywhere
TEST(ranks, oneRankWithEverything)
{
    const Tank tank(1.5, 1.2, 0.9, closed, {0.03});
    const WalkSum o = walkOnRanks(tank, 4, 400, 80, Walk{tank, 0.05, 0}, 0.1, 3, 1e-4);
    EXPECT_GT(o.divisions, 2);
}

TEST(ranks, moreRanksThanParticles)
{
    const Tank tank(1.5, 1.2, 0.9, wrapsX, {0.03});
    walkOnRanks(tank, 7, 3, 200, Walk{tank, 0.3, 0}, 0.1, 1);
}

//- Two dimensions: one cell along the third axis
TEST(ranks, aPlane)
{
    const Tank tank(2, 1, 0.01, closed, {0.02});
    const WalkSum o = walkOnRanks(tank, 4, 1500, 40, Walk{tank, 0.2, 0.001}, 0.1, 5);
    EXPECT_GT(o.arrivals, 1000);
}

//- Ids that are far apart, and such as fall on one place
TEST(ranks, slotsOfIds)
{
    std::mt19937 engine(5);
    std::map<std::int32_t, int> slotOf;
    for (int i = 0; i < 500; ++i) slotOf.emplace(1 << (i % 31) | i << (i % 20), i);
    for (int i = 0; i < 500; ++i) slotOf.emplace(std::int32_t(engine() >> 1), i);
    IdSlots table(slotOf.size());
    for (const auto& s : slotOf) table.put(s.first, s.second);
    for (const auto& s : slotOf) EXPECT_EQ(table(s.first), s.second) << s.first;
    for (std::int32_t id = 0; id < 20000; ++id) EXPECT_EQ(table(id) >= 0, slotOf.count(id) > 0);
    EXPECT_EQ(IdSlots(0)(7), -1);
}

//- Bricks that never change: the load may do what it likes
TEST(ranks, bricksStayUnlessTheLoadIsUneven)
{
    const Tank tank(1.5, 1.2, 0.9, wrapsX, {0.03});
    EXPECT_EQ(walkOnRanks(tank, 4, 3000, 30, Walk{tank, 0.3, 0}, 1e9, 0).divisions, 1);
}

//- What is done between steps, and waiting for others, are no cost
TEST(ranks, costOfAParticle)
{
    onRanks(4, [](Transport& transport)
    {
        const int me = transport.rank();
        const double seconds[] = {1, 4, 3, 0}, expected[] = {0.75, 1.5, 0.75, 1};
        const std::int64_t particles[] = {100, 200, 300, 0};
        double now = 7;
        RankCosts costs(transport, [&] { return now; });
        for (int k = 0; k < 3; ++k)
        {
            now += 5;
            costs.work(true);
            now += seconds[me];
            costs.work(false);
            now += 20*(me + 1);
            ASSERT_TRUE(costs.measure(particles[me]));
            for (int r = 0; r < 4; ++r) EXPECT_NEAR(costs.perParticle()[r], expected[r], 1e-12);
            EXPECT_NEAR(costs.atWork(), (k + 1)*seconds[me], 1e-12);
        }
        // too little to say anything
        costs.work(true);
        now += 0.01*seconds[me];
        EXPECT_FALSE(costs.measure(particles[me]));
        now += seconds[me];
        std::vector<double> wait(1, 0.0);
        std::this_thread::sleep_for(std::chrono::milliseconds(me == 0 ? 50 : 0));
        transport.largest(wait);
        EXPECT_TRUE(costs.measure(particles[me]));
        if (me) { EXPECT_LE(costs.atWork(), 4.01*seconds[me] - (seconds[me] > 0 ? 0.02 : 0)); }
    });
}

//- Particles at one end cost five times as much as others: bricks that follow their time are even,
//  those that follow their number are not
TEST(ranks, bricksFollowWhatParticlesCost)
{
    const Tank tank(2, 1, 1, closed, {0.03});
    for (const bool measured : {true, false})
    {
        onRanks(4, [&](Transport& transport)
        {
            double now = 0, seconds = 0;
            PieceOwners owners(transport, 0.1, measured, [&] { return now; });
            owners.set(tank.grids, walkReach);
            const RowPieces& pieces = owners.pieces();
            const auto cost = [&](int p)
            { return pieces.centre(p)[0] < tank.lower[0] + 0.25*tank.length[0] ? 5.0 : 1.0; };
            const std::vector<std::int64_t> all(pieces.count(), 10);
            for (int k = 0; k < 40; ++k)
            {
                std::vector<std::int64_t> here(all);
                for (int p = 0; k && p < pieces.count(); ++p)
                    if (owners.owner(p) != transport.rank()) here[p] = 0;
                owners.count(here, k == 0);
                ASSERT_EQ(owners.total(), 10*pieces.count());
                seconds = 0;
                for (int p = 0; p < pieces.count(); ++p)
                    if (owners.owner(p) == transport.rank()) seconds += 1e-3*cost(p);
                owners.work(true);
                now += seconds;
                owners.work(false);
            }
            std::vector<double> most(1, seconds), sum(1, seconds);
            transport.largest(most);
            addByRank(transport, sum);
            const double uneven = 4*most[0]/sum[0];
            if (measured)
            {
                EXPECT_LT(uneven, 1.15);
                EXPECT_GT(owners.unevenBefore(), 1.1);
                EXPECT_LT(owners.unevenAfter(), owners.unevenBefore());
                EXPECT_LT(owners.cuts(), 15);
            }
            else EXPECT_GT(uneven, 1.8);
        });
    }
}

//- Messages that break the agreement end the run: a lost particle, and one that is there twice
TEST(ranks, whatIsLostOrDoubleIsFound)
{
    const Tank tank(1.5, 1.2, 0.9, closed, {0.03});
    const std::vector<Walker> all = crowd(tank, 500);
    for (const bool lose : {true, false})
        EXPECT_THROW(onRanks(3, [&](Transport& transport)
        {
            struct Faulty : Transport
            {
                Transport& inner;
                bool lose;
                Faulty(Transport& t, bool l) : inner(t), lose(l) {}
                int rank() const override { return inner.rank(); }
                int size() const override { return inner.size(); }
                void exchange(
                    const std::vector<RankBytes>& out, std::vector<RankBytes>& in) override
                {
                    inner.exchange(out, in);
                    if (rank() != 0) return;
                    const std::size_t one = 16 + sizeof(Walker);
                    // the first that comes: away with it, or once more
                    for (RankBytes& b : in)
                    {
                        if (b.size() < one) continue;
                        std::int32_t whole;
                        std::memcpy(&whole, b.data() + 12, 4);
                        const std::size_t size = one + (whole ? 8 : 0);
                        if (lose) b.erase(b.begin(), b.begin() + size);
                        else
                        {
                            const RankBytes first(b.begin(), b.begin() + size);
                            b.insert(b.end(), first.begin(), first.end());
                        }
                        return;
                    }
                }
                void swap(
                    const std::vector<RankMessage>& out, std::vector<RankMessage>& in) override
                {
                    inner.swap(out, in);
                }
                void sum(std::vector<std::int64_t>& v) override { inner.sum(v); }
                void largest(std::vector<double>& v) override { inner.largest(v); }
            };
            Faulty faulty(transport, lose);
            Here here(tank, faulty, all, 0.1);
            for (int k = 0; k < 5; ++k) { here.rebuild(); here.step(Walk{tank, 0.3, 0}, k); }
        }), std::logic_error);
}

} // namespace
} // namespace riprap

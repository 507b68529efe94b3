/*  Runs on several ranks, threads here, beside the same on one, piece by piece. What is seen of a
    scene is the test's: a struct `Seen`, with Seen::of(scene, report) and one.expectSame(other).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <utility>
#include "dem/demTest.hpp"
#include "core/ranks/joinRanks.hpp"
#include "core/threadRanks.hpp"
#include "api/wholeDemScene.hpp"

namespace riprap
{
namespace
{

//- Particles in the order of ids
DemState particlesById(DemScene& scene)
{
    DemState p = scene.particles();
    const auto byId = orderBy(
        p.id.size(), [&](std::size_t a, std::size_t b) { return p.id[a] < p.id[b]; });
    for (auto* v : {&p.position, &p.velocity, &p.spin, &p.force, &p.moment}) arrange(*v, 3, byId);
    arrange(p.orientation, 4, byId);
    for (auto* v : {&p.id, &p.contacts, &p.brokenBonds, &p.clump, &p.group}) arrange(*v, 1, byId);
    return p;
}

//- The same bits: zeros have a sign. name(k): whose the k-th row of `each` is
template<class T, class Name>
void expectBits(const std::vector<T>& a, const std::vector<T>& b, std::size_t each,
    const Name& name, const char* what)
{
    ASSERT_EQ(a.size(), b.size()) << what;
    for (std::size_t k = 0; k < a.size(); ++k)
        ASSERT_TRUE(sameBytes(&a[k], &b[k], sizeof(T)))
            << what << " of " << name[k/each] << ": " << a[k] << " and " << b[k];
}

//- What ranks did besides
struct Traffic
{
    std::int64_t arrivals = 0, divisions = 0;
    std::size_t ghosts = 0, least = 1u << 30;
};

//- Seen after each of some pieces of a run
template<class Seen> using PiecesOf = std::vector<Seen>;

template<class Seen>
PiecesOf<Seen> runAlone(const DemConfig& c, const DemInput& in, std::int64_t steps, int pieces)
{
    PiecesOf<Seen> run;
    auto scene = createDemScene(c, in);
    for (int k = 0; k < pieces; ++k)
    {
        const DemReport r = scene->advance(1e9, steps);
        run.push_back(Seen::of(*scene, r));
    }
    return run;
}

//- The same on several, of which each sees all
template<class Seen>
Traffic compareOn(int ranks, const DemConfig& c, const DemInput& in, std::int64_t steps,
    const PiecesOf<Seen>& one)
{
    SCOPED_TRACE(std::to_string(ranks) + " ranks");
    Traffic traffic;
    std::mutex mutex;
    std::vector<PiecesOf<Seen>> runs(ranks);
    onRanks(ranks, [&](Transport& transport)
    {
        DemConfig own(c);
        own.ranks = &transport;
        auto part = createDemScene(own, in);
        auto scene = wholeDemScene(*part, transport);
        for (std::size_t k = 0; k < one.size(); ++k)
        {
            const DemReport r = scene->advance(1e9, steps);
            runs[transport.rank()].push_back(Seen::of(*scene, r));
        }
        const DemRankReport& r = scene->lastReport().rank;
        std::lock_guard<std::mutex> lock(mutex);
        traffic.arrivals += r.arrivals;
        traffic.divisions = r.divisions;
        traffic.ghosts += r.ghosts;
        traffic.least = std::min(traffic.least, r.owned);
    });
    for (const PiecesOf<Seen>& run : runs)
        for (std::size_t k = 0; k < one.size() && !testing::Test::HasFatalFailure(); ++k)
        {
            SCOPED_TRACE("piece " + std::to_string(k));
            one[k].expectSame(run[k]);
        }
    return traffic;
}

//- So many ranks go on from a state (empty: from the beginning) for some steps, and save theirs; 1:
//  one process, without ranks
template<class Seen>
Seen goOn(int ranks, const DemConfig& c, const DemInput& in, std::vector<std::int32_t>& state,
    std::int64_t steps)
{
    const std::vector<std::int32_t> from(state);
    std::vector<Seen> seen(ranks);
    const auto run = [&](DemScene& scene, int rank)
    {
        // others are told by the first
        if (!from.empty()) scene.loadState(rank == 0 ? from : std::vector<std::int32_t>());
        DemReport r = scene.advance(1e9, steps);
        const std::vector<std::int32_t> words = scene.saveState();
        if (rank == 0) state = words;
        // how often neighbours were sought in another way is no matter
        r.rebuilds = 0;
        seen[rank] = Seen::of(scene, r);
    };
    if (ranks == 1) run(*createDemScene(c, in), 0);
    else
        onRanks(ranks, [&](Transport& transport)
        {
            DemConfig own(c);
            own.ranks = &transport;
            auto part = createDemScene(own, in);
            run(*wholeDemScene(*part, transport), transport.rank());
        });
    for (int rank = 1; rank < ranks; ++rank) seen[0].expectSame(seen[rank]);
    return seen[0];
}

//- Pieces of a run, each of which ends with a saved state: the words and what is seen of three
//  ranks are those of one. \return what is seen at the end, and the ranks' last state
template<class Seen>
std::pair<Seen, std::vector<std::int32_t>> sameWithStates(
    const DemConfig& c, const DemInput& in, std::int64_t steps, int pieces)
{
    std::vector<PiecesOf<Seen>> runs(4);
    std::vector<std::vector<std::int32_t>> states(2);
    std::vector<std::int32_t> last;
    const auto go = [&](DemScene& scene, PiecesOf<Seen>& run, std::vector<std::int32_t>* words)
    {
        for (int k = 0; k < pieces; ++k)
        {
            const DemReport r = scene.advance(1e9, steps);
            const std::vector<std::int32_t> now = scene.saveState();
            if (words) words->insert(words->end(), now.begin(), now.end());
            if (words == &states[1]) last = now;
            run.push_back(Seen::of(scene, r));
        }
    };
    go(*createDemScene(c, in), runs[3], &states[0]);
    onRanks(3, [&](Transport& transport)
    {
        DemConfig own(c);
        own.ranks = &transport;
        auto part = createDemScene(own, in);
        const int rank = transport.rank();
        go(*wholeDemScene(*part, transport), runs[rank], rank ? nullptr : &states[1]);
    });
    EXPECT_EQ(states[0], states[1]);
    for (int rank = 0; rank < 3; ++rank)
        for (std::size_t k = 0; k < runs[3].size(); ++k) runs[3][k].expectSame(runs[rank][k]);
    return {runs[3].back(), last};
}

} // namespace
} // namespace riprap

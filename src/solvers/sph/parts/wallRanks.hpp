/*  Points of walls of a scene on several ranks (CPU).

    Each rank has all points, and moves those that move by the same motion: where they are, and
    their order, are the same bits everywhere. What the fluid about a point gives it (pressure, the
    work that it does) is worked out by the rank that has the point's cell, and sent to those whose
    fluid may see it. Points that move get other ranks where neighbours are sought; what has been
    added up for a point since the start goes with it.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/ranks/slotShares.hpp"
#include "solvers/sph/fluidRanks.hpp"
#include "solvers/sph/parts/wallPoints.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class WallRanks
{
    using real = typename P::real;

public:

    WallRanks(FluidRanks<Backend, D, P>& fluid, WallPoints<Backend, D, P>& walls)
        : fluid_(fluid), walls_(walls)
    {}

    //- Neighbours are new, and points in their places: which rank works out each of them, and who
    //  is told
    void settle();

    //- Is the point in this slot worked out by another rank?
    bool ghost(int i) const { return ghosts_[i]; }
    GhostMarks<Backend> marks() const { return ghostMarks<Backend>(ghosts_); }

    //- What the fluid gave the points. Their h is that of the start
    void share();

    //- What has been added up for each point, on the first rank
    void gather();

    std::int64_t bytesShared() const { return bytes_; }

private:

    // slots by rank
    using Slots = std::vector<std::vector<int>>;

    void sendAddedUp(Slots to, Slots from);

    FluidRanks<Backend, D, P>& fluid_;
    WallPoints<Backend, D, P>& walls_;
    SlotShares shares_;
    std::vector<char> ghosts_;
    std::vector<int> owner_;                // by id; empty: points have not been divided
    std::int64_t divided_ = -1, bytes_ = 0;     // ParticleExchange::divisions() when they were
};

namespace detail
{

inline void setShares(SlotShares& shares, std::vector<std::vector<int>>& to,
    std::vector<std::vector<int>>& from)
{
    shares.clear();
    for (int rank = 0; rank < int(to.size()); ++rank)
    {
        shares.send(rank, std::move(to[rank]));
        shares.receive(rank, std::move(from[rank]));
    }
}

} // namespace detail

template<class Backend, int D, class P>
void WallRanks<Backend, D, P>::settle()
{
    if constexpr (!Backend::gpu)
    {
        ParticleExchange& cells = fluid_.particles();
        if (!walls_.count || (!walls_.bodies && cells.divisions() == divided_)) return;
        divided_ = cells.divisions();
        const int me = cells.transport().rank(), size = cells.transport().size();
        const RecordsView<Backend, D, P> records = walls_.records.view();
        const std::int32_t* id = walls_.values.template data<std::int32_t>(walls_.at.id);
        Slots to(size), from(size), leave(size), arrive(size);
        const bool first = owner_.empty();
        owner_.resize(walls_.count);
        ghosts_.resize(walls_.count);
        for (int i = 0; i < walls_.count; ++i)
        {
            const std::uint32_t cell = fluid_.cellOf(records.loadPosition(i));
            const int owner = cells.ownerOf(cell), before = first ? owner : owner_[id[i]];
            for (const int rank : cells.ghostsOf(cell))
            {
                if (owner == me) to[rank].push_back(i);
                else if (rank == me) from[owner].push_back(i);
            }
            if (before != owner && before == me) leave[owner].push_back(i);
            if (before != owner && owner == me) arrive[before].push_back(i);
            owner_[id[i]] = owner;
            ghosts_[i] = owner != me;
        }
        detail::setShares(shares_, to, from);
        sendAddedUp(std::move(leave), std::move(arrive));
    }
}

template<class Backend, int D, class P>
void WallRanks<Backend, D, P>::sendAddedUp(
    [[maybe_unused]] Slots to, [[maybe_unused]] Slots from)
{
    if constexpr (!Backend::gpu)
    {
        if (!walls_.bodies) return;
        constexpr std::size_t word = sizeof(double);
        double* const sums[] = {walls_.values.template data<double>(walls_.at.work),
            walls_.values.template data<double>(walls_.at.pressureWork)};
        SlotShares moving;
        detail::setShares(moving, to, from);
        bytes_ += moving.share(fluid_.particles().transport(), 2*word,
            [&](int i, unsigned char* at)
            { for (const double* s : sums) { std::memcpy(at, s + i, word); at += word; } },
            [&](int i, const unsigned char* at)
            { for (double* s : sums) { std::memcpy(s + i, at, word); at += word; } });
    }
}

template<class Backend, int D, class P>
void WallRanks<Backend, D, P>::gather()
{
    if constexpr (!Backend::gpu)
    {
        Transport& ranks = fluid_.particles().transport();
        const std::int32_t* id = walls_.values.template data<std::int32_t>(walls_.at.id);
        Slots to(ranks.size()), from(ranks.size());
        for (int i = 0; i < walls_.count; ++i)
        {
            const int owner = owner_[id[i]];
            if (owner == 0) continue;
            if (ranks.rank() == 0) from[owner].push_back(i);
            else if (ranks.rank() == owner) to[0].push_back(i);
        }
        sendAddedUp(std::move(to), std::move(from));
    }
}

template<class Backend, int D, class P>
void WallRanks<Backend, D, P>::share()
{
    if constexpr (!Backend::gpu)
    {
        const RecordsView<Backend, D, P> r = walls_.records.view();
        constexpr std::size_t word = sizeof(real);
        bytes_ += shares_.share(fluid_.particles().transport(), word*(D + 2),
            [&](int i, unsigned char* to)
        {
            const auto put = [&](const auto* from) { std::memcpy(to, from + i, word); to += word; };
            for (int d = 0; d < D; ++d) put(r.velocity[d]);
            put(r.pressureTerm);
            put(r.density);
        },
        [&](int i, const unsigned char* from)
        {
            const auto take = [&](auto* to) { std::memcpy(to + i, from, word); from += word; };
            for (int d = 0; d < D; ++d) take(r.velocity[d]);
            take(r.pressureTerm);
            take(r.density);
        });
    }
}

} // namespace riprap

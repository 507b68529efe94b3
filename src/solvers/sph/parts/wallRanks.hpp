/*  Points of walls of a scene on several ranks.

    Each rank has all points, and moves those that move by the same motion: where they are, and
    their order, are the same bits everywhere. What the fluid about a point gives it (pressure, the
    work that it does) is worked out by the rank that has the point's cell, and sent to those whose
    fluid may see it. Points that move get other ranks where neighbours are sought; what has been
    added up for a point since the start goes with it.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/ranks/deviceShares.hpp"
#include "core/containers/ghostMarks.hpp"
#include "solvers/sph/parts/fluidRanks.hpp"
#include "solvers/sph/parts/wallPoints.hpp"

namespace riprap
{

//- What the fluid gave a point, as bytes for another rank; its h is that of the start
template<class Backend, int D, class P>
struct PutWall
{
    RecordsView<Backend, D, P> records;

    HD void operator()(int i, unsigned char* to) const
    {
        const auto p = records.template load<false>(i);
        for (int d = 0; d < D; ++d) putWord(to, p.velocity.c[d]);
        putWord(to, p.pressureTerm);
        putWord(to, p.density);
    }
};

template<class Backend, int D, class P>
struct TakeWall
{
    RecordsView<Backend, D, P> records;

    HD void operator()(int i, const unsigned char* from) const
    {
        auto p = records.h ? records.template load<true>(i) : records.template load<false>(i);
        for (int d = 0; d < D; ++d) takeWord(from, p.velocity.c[d]);
        takeWord(from, p.pressureTerm);
        takeWord(from, p.density);
        records.store(i, p);
    }
};

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
    bool ghost(int i) const { return ghosts_(i); }
    GhostMarks<Backend> marks() const { return ghosts_.view(); }

    //- What the fluid gave the points
    void share();

    //- What has been added up for each point, on the first rank
    void gather();

    std::int64_t bytesShared() const { return bytes_; }

private:

    // slots by rank
    using Slots = std::vector<std::vector<int>>;

    std::vector<std::int32_t> ids();
    std::vector<std::uint32_t> cellsOfPoints();
    void sendAddedUp(Slots to, Slots from);

    FluidRanks<Backend, D, P>& fluid_;
    WallPoints<Backend, D, P>& walls_;
    DeviceShares<Backend> shares_;
    GhostMemory<Backend> ghosts_;
    std::vector<int> owner_;                // by id; empty: points have not been divided
    std::int64_t divided_ = -1, bytes_ = 0;     // PieceOwners::divisions() when they were
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
    SlotExchange<Backend>& cells = fluid_.particles();
    if (!walls_.count || (!walls_.bodies && cells.owners().divisions() == divided_)) return;
    divided_ = cells.owners().divisions();
    const int me = cells.transport().rank(), size = cells.transport().size();
    const std::vector<std::uint32_t> cellOf = cellsOfPoints();
    const std::vector<std::int32_t> id = ids();
    Slots to(size), from(size), leave(size), arrive(size);
    const bool first = owner_.empty();
    owner_.resize(walls_.count);
    std::vector<char> marks(walls_.count);
    for (int i = 0; i < walls_.count; ++i)
    {
        const std::uint32_t cell = cellOf[i];
        const int owner = cells.ownerOf(cell), before = first ? owner : owner_[id[i]];
        for (const int rank : cells.ghostsOf(cell))
        {
            if (owner == me) to[rank].push_back(i);
            else if (rank == me) from[owner].push_back(i);
        }
        if (before != owner && before == me) leave[owner].push_back(i);
        if (before != owner && owner == me) arrive[before].push_back(i);
        owner_[id[i]] = owner;
        marks[i] = owner != me;
    }
    ghosts_.set(fluid_.context(), std::move(marks));
    SlotShares lists;
    detail::setShares(lists, to, from);
    shares_.set(
        fluid_.context(), cells.transport(), cells.peers, lists, sizeof(real)*(D + 2));
    sendAddedUp(std::move(leave), std::move(arrive));
}

template<class Backend, int D, class P>
std::vector<std::int32_t> WallRanks<Backend, D, P>::ids()
{
    return walls_.values.template download<std::int32_t>(fluid_.context(), walls_.at.id);
}

template<class Backend, int D, class P>
std::vector<std::uint32_t> WallRanks<Backend, D, P>::cellsOfPoints()
{
    std::vector<std::int64_t> x[D];
    for (int d = 0; d < D; ++d)
        x[d] = walls_.values.template download<std::int64_t>(fluid_.context(), walls_.at.x + d);
    std::vector<std::uint32_t> cells(walls_.count);
    for (int i = 0; i < walls_.count; ++i)
    {
        Vec<D, std::int64_t> point;
        for (int d = 0; d < D; ++d) point.c[d] = x[d][i];
        cells[i] = fluid_.cellOf(point);
    }
    return cells;
}

template<class Backend, int D, class P>
void WallRanks<Backend, D, P>::sendAddedUp(Slots to, Slots from)
{
    if (!walls_.bodies) return;
    constexpr std::size_t word = sizeof(double);
    Context<Backend>& context = fluid_.context();
    const int fields[] = {walls_.at.work, walls_.at.pressureWork};
    const auto any = [](const Slots& slots)
    { return std::any_of(slots.begin(), slots.end(), [](const auto& s) { return !s.empty(); }); };
    const bool sends = any(to), receives = any(from);
    std::vector<double> sums[2];
    if (sends || receives)
        for (int f = 0; f < 2; ++f)
            sums[f] = walls_.values.template download<double>(context, fields[f]);
    SlotShares moving;
    detail::setShares(moving, to, from);
    bytes_ += moving.share(fluid_.particles().transport(), 2*word,
        [&](int i, unsigned char* at)
        { for (const auto& s : sums) { std::memcpy(at, &s[i], word); at += word; } },
        [&](int i, const unsigned char* at)
        { for (auto& s : sums) { std::memcpy(&s[i], at, word); at += word; } });
    if (receives)
        for (int f = 0; f < 2; ++f) walls_.values.upload(context, fields[f], sums[f]);
}

template<class Backend, int D, class P>
void WallRanks<Backend, D, P>::gather()
{
    Transport& ranks = fluid_.particles().transport();
    const std::vector<std::int32_t> id = ids();
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

template<class Backend, int D, class P>
void WallRanks<Backend, D, P>::share()
{
    const RecordsView<Backend, D, P> r = walls_.records.view();
    bytes_ += shares_.share(fluid_.context(), fluid_.particles().transport(), sizeof(real)*(D + 2),
        PutWall<Backend, D, P>{r}, TakeWall<Backend, D, P>{r});
}

} // namespace riprap

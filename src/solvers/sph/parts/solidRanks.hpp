/*  Points of solids in the water of a scene on several ranks.

    Each rank has the whole scene of the solids and moves it by the same steps: where solids are,
    and the order of their points, are the same bits everywhere. What the fluid about a point gives
    it is worked out by the rank that has the point's cell: pressures go to those whose fluid may
    see the point, forces to all, as each moves all solids. Points without fluid near are not sent.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/sph/parts/coupledSolids.hpp"
#include "solvers/sph/parts/wallRanks.hpp"
#include "sph/boundary/bodyContact.hpp"

namespace riprap
{

//- Force on the point in a slot, as bytes for another rank
template<int D, class P>
struct PutForce
{
    SolidPoints<D, P> points;

    HD void operator()(int i, unsigned char* to) const
    {
        for (int d = 0; d < D; ++d) putWord(to, points.force[std::size_t(points.key[i])*D + d]);
    }
};

template<int D, class P>
struct TakeForce
{
    SolidPoints<D, P> points;

    HD void operator()(int i, const unsigned char* from) const
    {
        for (int d = 0; d < D; ++d) takeWord(from, points.force[std::size_t(points.key[i])*D + d]);
    }
};

template<class Backend, int D, class P>
class SolidRanks
{
    using real = typename P::real;

public:

    SolidRanks(FluidRanks<Backend, D, P>& fluid, CoupledSolids<Backend, D, P>& solids)
        : fluid_(fluid), solids_(solids)
    {}

    //- Points are sorted: which rank works out each of them
    void settle();

    //- Which of its points a rank found fluid near (CoupledSolids::meets): who sends what until the
    //  next sort. \return whether any rank found some
    bool agreeOnMeeting();

    //- Is the point in this slot worked out by another rank?
    bool ghost(int i) const { return ghosts_(i); }
    GhostMarks<Backend> marks() const { return ghosts_.view(); }

    //- What the fluid gave the points
    void sharePressures();
    void shareForces(const SolidPoints<D, P>&);
    //- What the faces of bodies gave to the fluid of all ranks
    void sumBlows(FaceBlow*, int bodies);

    std::int64_t bytesShared() const { return bytes_; }

private:

    Transport& transport() const { return fluid_.particles().transport(); }

    FluidRanks<Backend, D, P>& fluid_;
    CoupledSolids<Backend, D, P>& solids_;
    DeviceShares<Backend> pressures_, forces_;
    GhostMemory<Backend> ghosts_;
    std::vector<std::uint32_t> cells_;      // of slots in use
    std::int64_t bytes_ = 0;
};

template<class Backend, int D, class P>
void SolidRanks<Backend, D, P>::settle()
{
    int active = 0;
    Context<Backend>& context = fluid_.context();
    context.toHost(&active, solids_.sort.active(), sizeof(int));
    const SolidPoints<D, P> points = solids_.points();
    std::vector<std::int64_t> x[D];
    for (int d = 0; d < D; ++d)
    {
        x[d].resize(active);
        if (active) context.toHost(x[d].data(), points.last[d], active*sizeof(std::int64_t));
    }
    cells_.resize(active);
    std::vector<char> marks(active);
    for (int i = 0; i < active; ++i)
    {
        Vec<D, std::int64_t> point;
        for (int d = 0; d < D; ++d) point.c[d] = x[d][i];
        cells_[i] = fluid_.cellOf(point);
        marks[i] = fluid_.particles().ownerOf(cells_[i]) != transport().rank();
    }
    ghosts_.set(context, std::move(marks));
}

template<class Backend, int D, class P>
bool SolidRanks<Backend, D, P>::agreeOnMeeting()
{
    SlotExchange<Backend>& cells = fluid_.particles();
    const int me = transport().rank(), size = transport().size();
    const std::vector<int> meets = solids_.meets.download();
    std::vector<int> mine;
    for (int i = 0; i < int(cells_.size()); ++i) if (meets[i] && !ghost(i)) mine.push_back(i);
    RankBytes own;
    putValues(own, mine.data(), mine.size());
    const std::vector<RankBytes> all = toAll(transport(), own);
    std::vector<std::vector<int>> to(size), from(size), nearTo(size), nearFrom(size);
    bool any = false;
    for (int rank = 0; rank < size; ++rank)
    {
        any = any || !all[rank].empty();
        if (rank == me) continue;
        to[rank] = mine;
        from[rank].resize(all[rank].size()/sizeof(int));
        const unsigned char* bytes = all[rank].data();
        takeValues(bytes, from[rank].data(), from[rank].size());
        for (const int i : from[rank])
        {
            const std::vector<int>& seen = cells.ghostsOf(cells_[i]);
            if (std::find(seen.begin(), seen.end(), me) != seen.end()) nearFrom[rank].push_back(i);
        }
    }
    for (const int i : mine) for (const int rank : cells.ghostsOf(cells_[i]))
        if (rank != me) nearTo[rank].push_back(i);
    SlotShares shares;
    detail::setShares(shares, to, from);
    forces_.set(fluid_.context(), transport(), cells.peers, shares, sizeof(real)*D);
    detail::setShares(shares, nearTo, nearFrom);
    pressures_.set(fluid_.context(), transport(), cells.peers, shares, sizeof(real)*(D + 2));
    return any;
}

template<class Backend, int D, class P>
void SolidRanks<Backend, D, P>::sharePressures()
{
    const RecordsView<Backend, D, P> r = solids_.records.view();
    bytes_ += pressures_.share(fluid_.context(), transport(), sizeof(real)*(D + 2),
        PutWall<Backend, D, P>{r}, TakeWall<Backend, D, P>{r});
}

template<class Backend, int D, class P>
void SolidRanks<Backend, D, P>::shareForces(const SolidPoints<D, P>& points)
{
    bytes_ += forces_.share(fluid_.context(), transport(), sizeof(real)*D,
        PutForce<D, P>{points}, TakeForce<D, P>{points});
}

//- In whole units: the sum does not depend on who adds what
template<class Backend, int D, class P>
void SolidRanks<Backend, D, P>::sumBlows(FaceBlow* blow, int bodies)
{
    constexpr std::size_t each = sizeof(FaceBlow)/sizeof(std::int64_t);
    std::vector<std::int64_t> sums(bodies*each);
    fluid_.context().toHost(sums.data(), blow, bodies*sizeof(FaceBlow));
    transport().sum(sums);
    fluid_.context().toDevice(blow, sums.data(), bodies*sizeof(FaceBlow));
    bytes_ += std::int64_t(bodies*sizeof(FaceBlow));
}

} // namespace riprap

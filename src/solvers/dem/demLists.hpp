/*  DemSolver: sorting, contact lists, and walls near particles.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "api/particleLimit.hpp"
#include "solvers/dem/demSolver.hpp"

namespace riprap
{

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::rebuild(bool fresh, [[maybe_unused]] bool inPlace)
{
    collectForces();
    if (nClumps_) forEach(context_, n_, MarkLeavers<D, P>{mover(), clumps_.data()});
    SolidKeys<D, P> keys{mover(), classes_, sort_.keys(), sort_.indices()};
    forEach(context_, n_, keys);
    if (others_) regroup();
    sort_.sort(context_, n_);
    bool forcesHold = true;
    if constexpr (Backend::gpu)
    {
        findPlaces(fresh, inPlace);
        forcesHold = !parts_.moved;
        parts_.frames.clear(context_);
    }
    if (!inPlace) fields_.permute(context_, newOrder(), n_, fField_, forcesHold ? fField_ : mField_ + S);
    if (others_) settleRanks();
    forEach(context_, n_, PlaceSolids<D, P>{mover(), slotOf_.data()});
    settleFrames();
    if (nBonds_) forEach(context_, nBonds_, LoseBonds<D, P>{bondFields()});
    if constexpr (Backend::gpu) buildFullLists(fresh);
    else
    {
        buildContacts(fresh);
        if (nWalls_) buildWalls(fresh);
    }
    if (nBonds_) forEach(context_, nBonds_, RestBonds<Backend, D, P>{bondFields(), list_.view()});
    blockContacts();
}

//- Which particle goes where
template<class Backend, int D, class P>
const std::uint32_t* DemSolver<Backend, D, P>::newOrder() const
{
    if constexpr (Backend::gpu) return parts_.order.data();
    else return sort_.order();
}

//- On the GPU: lists are counted where particles still are, since their order follows from that
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::findPlaces([[maybe_unused]] bool fresh, [[maybe_unused]] bool inPlace)
{
    if constexpr (Backend::gpu)
    {
        DemParts<Backend, D, P>& g = parts_;
        for (Array<Backend, int>* a : {&g.place, &g.found, &g.foundNear, &g.cost, &g.nearCount}) if (a->size() == 0) a->allocate(context_, n_);
        if (g.order.size() == 0) g.order.allocate(context_, n_);
        oldList_.allocate(context_, n_);                // the new shape, for now
        if (fresh) forEach(context_, n_, RecordPlaces<D, P>{box_, fields(), records_.view()});
        const int* cellOrder = reinterpret_cast<const int*>(sort_.order());
        if (nWalls_) countWalls();
        const int* walls = nWalls_ ? g.foundWalls.data() : nullptr;
        forEach(context_, n_, CountNeighbours<Backend, D, P>
        {search(cellOrder), sort_.active(), walls, g.found.data(), g.foundNear.data(), g.cost.data()});
        forEach(context_, n_, LikeWithLike
        {
            n_, sort_.active(), cellOrder, g.found.data(), g.foundNear.data(), walls, g.foundElements.data(), g.cost.data(), inPlace,
            g.place.data(), inverse_.data(), g.order.data(), oldList_.count(), g.nearCount.data(), wallMemory_.entryFirst.data(),
            wallMemory_.elementFirst.data()
        });
    }
}

//- place: where the particles are that cells have side by side
template<class Backend, int D, class P>
ContactSearch<Backend, D, P> DemSolver<Backend, D, P>::search(const int* place)
{
    const SolidFields<D, P> f = fields();
    return ContactSearch<Backend, D, P>
    {
        // ghosts are as one body: what they do to each other is others' business
        box_, classes_, records_.view(), sort_.start(), place, others_ ? f.calm : f.clump, f.id, bondTable(), real(reach_),
        // what a quarter of the skin is between will mostly have touched before the next rebuild
        real(largestGap_ + 0.5*double(halfSkin_))
    };
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::buildContacts([[maybe_unused]] bool fresh)
{
    if constexpr (!Backend::gpu)
    {
        list_.swap(oldList_);
        list_.allocate(context_, n_);
        forEach(context_, n_, CountContacts<Backend, D, P>{search(), sort_.active(), list_.count()});
        const int blocks = list_.blocks();
        forEach(context_, blocks, BlockEntries{list_.count(), list_.base(), list_.width});
        exclusiveScan(context_, scan_, list_.base(), blocks + 1);
        int entries = 0;
        context_.toHost(&entries, list_.base() + blocks, sizeof(int));
        list_.reserve(context_, requireListed(entries, "solid particles"), histories_, nBonds_ > 0);
        forEach(context_, n_, WriteContacts<Backend, D, P>
        {search(), sort_.active(), list_.view(), ContactListView<Backend, real>::historyWords(histories_)});
        if (fresh) return;
        forEach(context_, n_, InvertOrder{sort_.order(), inverse_.data()});
        withLaw(laws_, [&](auto law)
        {
            using Law = decltype(law);
            forEach(context_, n_, HandOver<Backend, Law::template history<D>, Law::template turnsFrom<D>, real>
            {oldList_.view(), list_.view(), sort_.order(), inverse_.data(), sort_.active()});
        });
        if (others_) takeContacts();
    }
}

//- Full lists and walls: everything is counted first, so that the host looks on once
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::buildFullLists([[maybe_unused]] bool fresh)
{
    if constexpr (Backend::gpu)
    {
        DemParts<Backend, D, P>& g = parts_;
        list_.allocate(context_, n_);
        g.keptFirst.allocate(context_, std::size_t(n_) + 1);
        g.totals.allocate(context_, 5);
        const int blocks = list_.blocks();
        const ContactListView<Backend, real> old = list_.view();
        if (!fresh)
        {
            forEach(context_, n_, KeepContacts<Backend, real, false>
            {old, histories_, newOrder(), inverse_.data(), sort_.active(), g.keptFirst.data(), nullptr, nullptr});
            exclusiveScan(context_, scan_, g.keptFirst.data(), n_ + 1);
        }
        forEach(context_, blocks, BlockEntries{oldList_.count(), oldList_.base(), list_.width});
        exclusiveScan(context_, scan_, oldList_.base(), blocks + 1);
        if (nWalls_)
        {
            g.wallListFirst.allocate(context_, std::size_t(n_) + 1);
            forEach(context_, n_, FlagNearWalls{wallMemory_.entryFirst.data(), g.wallListFirst.data()});
            for (int* sums : {g.wallListFirst.data(), wallMemory_.entryFirst.data(), wallMemory_.elementFirst.data()})
                exclusiveScan(context_, scan_, sums, n_ + 1);
        }
        forEach(context_, 1, CollectTotals
        {
            fresh ? nullptr : g.keptFirst.data() + n_, oldList_.base() + blocks, nWalls_ ? wallMemory_.entryFirst.data() + n_ : nullptr,
            nWalls_ ? wallMemory_.elementFirst.data() + n_ : nullptr, nWalls_ ? g.wallListFirst.data() + n_ : nullptr, g.totals.data()
        });
        int total[5];
        context_.toHost(total, g.totals.data(), sizeof(total));
        if (!fresh)
        {
            const std::size_t room = std::size_t(total[0]) + total[0]/16 + 64;
            if (std::size_t(total[0]) > g.keptPartner.size())
            {
                g.keptPartner.allocate(context_, room);
                g.keptHistory.allocate(context_, room*std::max(1, old.historyWords(histories_)));
            }
            forEach(context_, n_, KeepContacts<Backend, real, true>
            {
                old, histories_, newOrder(), inverse_.data(), sort_.active(), g.keptFirst.data(), g.keptPartner.data(),
                g.keptHistory.data()
            });
        }
        list_.swapShape(oldList_);
        list_.reserve(context_, requireListed(total[1], "solid particles"), histories_, nBonds_ > 0);
        forEach(context_, n_, WriteFullLists<Backend, D, P>
        {
            search(g.place.data()), sort_.active(), list_.view(), histories_, g.nearCount.data(), fresh ? nullptr : g.keptFirst.data(),
            g.keptPartner.data(), g.keptHistory.data()
        });
        if (!nWalls_) return;
        wallMemory_.entries = total[2];
        writeWalls(fresh, total[3]);
        const std::size_t nearWalls = total[4];
        if (g.wallList.size() < nearWalls) g.wallList.allocate(context_, nearWalls + nearWalls/8 + 32);
        forEach(context_, n_, ListNearWalls{wallMemory_.entryFirst.data(), g.wallListFirst.data(), g.wallList.data()});
    }
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::countWalls()
{
    std::swap(wallMemory_, oldWallMemory_);
    WallMemoryArrays<Backend, real>& m = wallMemory_;
    if (wallMotions_) forEach(context_, nWalls_, KeepWallReference{walls_.data()});
    m.entryFirst.allocate(context_, std::size_t(n_) + 1);
    m.elementFirst.allocate(context_, std::size_t(n_) + 1);
    if constexpr (Backend::gpu)
    {
        // where particles still are: their order follows
        for (Array<Backend, int>* a : {&parts_.foundWalls, &parts_.foundElements}) if (a->size() == 0) a->allocate(context_, n_);
        forEach(context_, n_, FindWalls<D, P, false>
        {
            wallSearch(), parts_.foundWalls.data(), parts_.foundElements.data(), nullptr, nullptr,
            reinterpret_cast<const int*>(sort_.order())
        });
        return;
    }
    forEach(context_, n_, FindWalls<D, P, false>{wallSearch(), m.entryFirst.data(), m.elementFirst.data(), nullptr, nullptr, nullptr});
    exclusiveScan(context_, scan_, m.entryFirst.data(), n_ + 1);
    exclusiveScan(context_, scan_, m.elementFirst.data(), n_ + 1);
}

template<class Backend, int D, class P>
WallSearch<D, P> DemSolver<Backend, D, P>::wallSearch()
{ return WallSearch<D, P>{box_, fields(), walls_.data(), nWalls_, surface(), wallReach(), sort_.active()}; }

//- Walls are listed from farther away where a particle's way is measured against others that move with it: walls do not
template<class Backend, int D, class P>
double DemSolver<Backend, D, P>::wallReach() const
{
    if constexpr (Backend::gpu) if (parts_.frames.on()) return reach_ + (wallSkins - 1)*2*double(halfSkin_);
    return reach_;
}

//- How far particles may go, now that they are in their places
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::settleFrames()
{
    if constexpr (Backend::gpu)
    {
        if (!parts_.frames.on()) return;
        const double skin = 2*double(halfSkin_), touch = 2*radii_.largest + largestGap_;
        double way = wallSkins*skin;
        if (wallMotions_) way -= double(halfSkin_);
        way = std::min(way, 0.5*(parts_.frames.width() - touch));
        parts_.frames.settle(context_, way, way);
    }
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::writeWalls(bool fresh, int elements)
{
    WallMemoryArrays<Backend, real>& m = wallMemory_;
    const int H = std::max(histories_, 1);
    // a little more than now: pointers that stay keep recorded steps
    const std::size_t room = std::size_t(m.entries) + m.entries/8 + 1;
    if (m.entry.size() < std::size_t(m.entries) + 1)
    {
        m.entry.allocate(context_, room);
        m.on.allocate(context_, room*wallTouches);
        m.normal.allocate(context_, room*wallTouches*D);
        m.history.allocate(context_, room*wallTouches*H);
        m.force.allocate(context_, room*wallWords<D>);
    }
    if (m.element.size() < std::size_t(elements) + 1) m.element.allocate(context_, std::size_t(elements) + elements/8 + 1);
    forEach(context_, n_, FindWalls<D, P, true>
    {wallSearch(), m.entryFirst.data(), m.elementFirst.data(), m.entry.data(), m.element.data(), nullptr});
    withLaw(laws_, [&](auto law)
    {
        forEach(context_, n_, HandOverWalls<D, real, decltype(law)::template history<D>>
        {wallMemory(oldWallMemory_), wallMemory(m), newOrder(), sort_.active(), fresh});
    });
    if (others_ && !fresh) takeWallContacts();
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::buildWalls(bool fresh)
{
    countWalls();
    int elements = 0;
    context_.toHost(&wallMemory_.entries, wallMemory_.entryFirst.data() + n_, sizeof(int));
    context_.toHost(&elements, wallMemory_.elementFirst.data() + n_, sizeof(int));
    writeWalls(fresh, elements);
}

//- On the CPU: which forces blocks of particles leave to each other
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::blockContacts()
{
#ifndef __CUDACC__
    if constexpr (!Backend::gpu)
    {
        parts_.sums.allocate(context_, std::size_t(n_)*DeferredForces<D, real>::width);
        // of those in the scene: a scene that is continued without those that left must cut alike
        parts_.deferred.set(activeSolids(), list_.view(), others_ ? blockCuts() : std::vector<int>());
        setRanges();
    }
#endif
}

//- On the CPU: entries between sleepers are passed over
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::setRanges()
{
#ifndef __CUDACC__
    if constexpr (!Backend::gpu)
    {
        const SolidFields<D, P> f = fields();
        parts_.deferred.setRanges(list_.view(), sleeps(), [&](int i) { return f.asleep(i); });
    }
#endif
}

} // namespace riprap

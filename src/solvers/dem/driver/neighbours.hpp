/*  Who is near whom: particles in the order of cells, lists of contacts and walls, and how far
    beyond contact they reach.

    Lists hold until a particle has gone half the skin. What a scene has by default lasts for many
    steps where bodies are stiff. Soft bodies have long steps: where lists last for a few steps
    alone the skin becomes what the fastest needs for `stepsOfList`, and less again once speeds have
    fallen. A function of the exact state: the same run has the same skins, saved and continued or
    not. Lists that hold for no step at all cost time and nothing else: the step then seeks
    neighbours before its forces (solidStepper.hpp).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <array>
#include "api/particleLimit.hpp"
#include "solvers/dem/driver/wallContacts.hpp"
#include "solvers/dem/parts/demRebuild.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class Neighbours
{
public:

    using real = typename P::real;
    static constexpr int S = spins<D>;

    Neighbours(DemParts<Backend, D, P>& parts, ContactForces<Backend, D, P>& forces,
        RankedSolids<Backend, D, P>& ranks)
        : p_(parts), forces_(forces), ranks_(ranks), walls_(parts, forces, ranks)
    {}

    //- Neighbours anew. fresh: nothing is remembered; inPlace: particles stay where they are
    void rebuild(bool fresh = false, bool inPlace = false);

    //- Before a rebuild: the skin that speeds and steps ask for
    void adaptSkin();
    void setSkin(double skin);
    void setFrames();

    //- On the CPU: entries between sleepers are passed over
    void setRanges();

    double largestSpeed();

private:

    void findPlaces(bool fresh, bool inPlace);
    ContactSearch<Backend, D, P> search(const int* place = nullptr);
    void buildContacts(bool fresh);
    void buildFullLists(bool fresh);
    std::array<int, 5> countFullLists(bool fresh);
    void settleFrames();
    void blockContacts();

    DemParts<Backend, D, P>& p_;
    ContactForces<Backend, D, P>& forces_;
    RankedSolids<Backend, D, P>& ranks_;
    WallContacts<Backend, D, P> walls_;
};

template<class Backend, int D, class P>
void Neighbours<Backend, D, P>::rebuild(bool fresh, [[maybe_unused]] bool inPlace)
{
    forces_.collectForces();
    if (p_.clumps.any())
        forEach(
            p_.set.context, p_.particles.n, MarkLeavers<D, P>{forces_.mover(), p_.clumps.data()});
    if (ranks_.others) ranks_.bodies.agreeOnLeavers();
    SolidKeys<D, P> keys{
        forces_.mover(), p_.reach.classes, p_.order.sort.keys(), p_.order.sort.indices()};
    forEach(p_.set.context, p_.particles.n, keys);
    if (ranks_.others) ranks_.regroup();
    p_.order.sort.sort(p_.set.context, p_.particles.n);
    bool forcesHold = true;
    if constexpr (Backend::gpu)
    {
        findPlaces(fresh, inPlace);
        forcesHold = !p_.memory.moved;
        p_.memory.frames.clear(p_.set.context);
    }
    const SolidFieldNumbers& at = p_.particles.at;
    if (!inPlace)
        p_.particles.values.permute(
            p_.set.context, p_.newOrder(), p_.particles.n, at.f, forcesHold ? at.f : at.m + S);
    if (ranks_.others) ranks_.settle(p_.newOrder());
    forEach(
        p_.set.context, p_.particles.n, PlaceSolids<D, P>{forces_.mover(), p_.order.slotOf.data()});
    settleFrames();
    if (ranks_.others) ranks_.bonds.settle(*ranks_.others);
    else if (p_.bonds.count())
        forEach(p_.set.context, p_.bonds.count(),
            LoseBonds<D, P>{p_.bonds.view(p_.order.slotOf.data())});
    if constexpr (Backend::gpu) buildFullLists(fresh);
    else
    {
        buildContacts(fresh);
        if (p_.walls.count) walls_.build(fresh);
    }
    if (p_.bonds.count())
        forEach(p_.set.context, p_.bonds.count(),
            RestBonds<Backend, D, P>{p_.bonds.view(p_.order.slotOf.data()), p_.order.list.view()});
    blockContacts();
}

//- On the GPU: lists are counted where particles still are, since their order follows from that
template<class Backend, int D, class P>
void Neighbours<Backend, D, P>::findPlaces(
    [[maybe_unused]] bool fresh, [[maybe_unused]] bool inPlace)
{
    if constexpr (Backend::gpu)
    {
        BackendMemory<Backend, D, P>& g = p_.memory;
        for (Array<Backend, int>* a : {&g.place, &g.found, &g.foundNear, &g.cost, &g.nearCount})
            if (a->size() == 0) a->allocate(p_.set.context, p_.particles.n);
        if (g.order.size() == 0) g.order.allocate(p_.set.context, p_.particles.n);
        // the new shape, for now
        p_.order.oldList.allocate(p_.set.context, p_.particles.n);
        if (fresh)
            forEach(p_.set.context, p_.particles.n,
                RecordPlaces<D, P>{p_.set.box, p_.particles.view(), p_.order.records.view()});
        const int* cellOrder = reinterpret_cast<const int*>(p_.order.sort.order());
        if (p_.walls.count) walls_.count();
        const int* walls = p_.walls.count ? g.foundWalls.data() : nullptr;
        forEach(p_.set.context, p_.particles.n,
            CountNeighbours<Backend, D, P>{search(cellOrder), p_.order.sort.active(), walls,
                g.found.data(), g.foundNear.data(), g.cost.data()});
        forEach(p_.set.context, p_.particles.n,
            SortByWork{p_.particles.n, p_.order.sort.active(), cellOrder, g.found.data(),
                g.foundNear.data(), walls, g.foundElements.data(), g.cost.data(), inPlace,
                g.place.data(), p_.order.inverse.data(), g.order.data(), p_.order.oldList.count(),
                g.nearCount.data(), p_.walls.memory.entryFirst.data(),
                p_.walls.memory.elementFirst.data()});
    }
}

//- place: where the particles are that cells have side by side
template<class Backend, int D, class P>
ContactSearch<Backend, D, P> Neighbours<Backend, D, P>::search(const int* place)
{
    const SolidFields<D, P> f = p_.particles.view();
    return ContactSearch<Backend, D, P>
    {
        p_.set.box, p_.reach.classes, p_.order.records.view(), p_.order.sort.start(), place,
        f.clump, ranks_.others ? f.calm : nullptr, f.id, p_.bonds.table(), real(p_.reach.reach),
        // what a quarter of the skin is between will mostly have touched before the next rebuild
        real(p_.pairs.largestGap() + 0.5*double(p_.reach.halfSkin))
    };
}

template<class Backend, int D, class P>
void Neighbours<Backend, D, P>::buildContacts([[maybe_unused]] bool fresh)
{
    if constexpr (!Backend::gpu)
    {
        p_.order.list.swap(p_.order.oldList);
        p_.order.list.allocate(p_.set.context, p_.particles.n);
        forEach(p_.set.context, p_.particles.n,
            CountContacts<Backend, D, P>{search(), p_.order.sort.active(), p_.order.list.count()});
        const int blocks = p_.order.list.blocks();
        forEach(p_.set.context, blocks,
            BlockEntries{p_.order.list.count(), p_.order.list.base(), p_.order.list.width});
        exclusiveScan(p_.set.context, p_.order.scan, p_.order.list.base(), blocks + 1);
        int entries = 0;
        p_.set.context.toHost(&entries, p_.order.list.base() + blocks, sizeof(int));
        p_.order.list.reserve(p_.set.context, requireListed(entries, "solid particles"),
            p_.pairs.histories(), p_.bonds.any());
        forEach(p_.set.context, p_.particles.n,
            WriteContacts<Backend, D, P>{search(), p_.order.sort.active(), p_.order.list.view(),
                ContactListView<Backend, real>::historyWords(p_.pairs.histories())});
        if (fresh) return;
        forEach(p_.set.context, p_.particles.n,
            InvertOrder{p_.order.sort.order(), p_.order.inverse.data()});
        withLaw(p_.set.laws, [&](auto law)
        {
            using Law = decltype(law);
            forEach(p_.set.context, p_.particles.n,
                HandOver<Backend, Law::template history<D>, Law::template turnsFrom<D>, real>{
                    p_.order.oldList.view(), p_.order.list.view(), p_.order.sort.order(),
                    p_.order.inverse.data(), p_.order.sort.active()});
        });
        if (ranks_.others) ranks_.takeContacts();
    }
}

//- Full lists and walls
template<class Backend, int D, class P>
void Neighbours<Backend, D, P>::buildFullLists([[maybe_unused]] bool fresh)
{
    if constexpr (Backend::gpu)
    {
        BackendMemory<Backend, D, P>& g = p_.memory;
        const std::array<int, 5> total = countFullLists(fresh);
        const ContactListView<Backend, real> old = p_.order.list.view();
        if (!fresh)
        {
            const std::size_t room = std::size_t(total[0]) + total[0]/16 + 64;
            if (std::size_t(total[0]) > g.keptPartner.size())
            {
                g.keptPartner.allocate(p_.set.context, room);
                g.keptHistory.allocate(
                    p_.set.context, room*std::max(1, old.historyWords(p_.pairs.histories())));
            }
            forEach(p_.set.context, p_.particles.n,
                KeepContacts<Backend, real, true>{old, p_.pairs.histories(), p_.newOrder(),
                    p_.order.inverse.data(), p_.order.sort.active(), g.keptFirst.data(),
                    g.keptPartner.data(), g.keptHistory.data()});
        }
        p_.order.list.swapShape(p_.order.oldList);
        p_.order.list.reserve(p_.set.context, requireListed(total[1], "solid particles"),
            p_.pairs.histories(), p_.bonds.any());
        forEach(p_.set.context, p_.particles.n,
            WriteFullLists<Backend, D, P>{search(g.place.data()), p_.order.sort.active(),
                p_.order.list.view(), p_.pairs.histories(), g.nearCount.data(),
                fresh ? nullptr : g.keptFirst.data(), g.keptPartner.data(), g.keptHistory.data()});
        if (!p_.walls.count) return;
        p_.walls.memory.entries = total[2];
        walls_.write(fresh, total[3]);
        const std::size_t nearWalls = total[4];
        if (g.wallList.size() < nearWalls)
            g.wallList.allocate(p_.set.context, nearWalls + nearWalls/8 + 32);
        forEach(p_.set.context, p_.particles.n,
            ListNearWalls{
                p_.walls.memory.entryFirst.data(), g.wallListFirst.data(), g.wallList.data()});
    }
}

//- Everything is counted first, so that the host looks on once
template<class Backend, int D, class P>
std::array<int, 5> Neighbours<Backend, D, P>::countFullLists([[maybe_unused]] bool fresh)
{
    std::array<int, 5> total{};
    if constexpr (Backend::gpu)
    {
        BackendMemory<Backend, D, P>& g = p_.memory;
        p_.order.list.allocate(p_.set.context, p_.particles.n);
        g.keptFirst.allocate(p_.set.context, std::size_t(p_.particles.n) + 1);
        g.totals.allocate(p_.set.context, 5);
        const int blocks = p_.order.list.blocks();
        const ContactListView<Backend, real> old = p_.order.list.view();
        if (!fresh)
        {
            forEach(p_.set.context, p_.particles.n,
                KeepContacts<Backend, real, false>{old, p_.pairs.histories(), p_.newOrder(),
                    p_.order.inverse.data(), p_.order.sort.active(), g.keptFirst.data(), nullptr,
                    nullptr});
            exclusiveScan(p_.set.context, p_.order.scan, g.keptFirst.data(), p_.particles.n + 1);
        }
        forEach(p_.set.context, blocks,
            BlockEntries{p_.order.oldList.count(), p_.order.oldList.base(), p_.order.list.width});
        exclusiveScan(p_.set.context, p_.order.scan, p_.order.oldList.base(), blocks + 1);
        if (p_.walls.count)
        {
            g.wallListFirst.allocate(p_.set.context, std::size_t(p_.particles.n) + 1);
            forEach(p_.set.context, p_.particles.n,
                FlagNearWalls{p_.walls.memory.entryFirst.data(), g.wallListFirst.data()});
            for (int* sums : {g.wallListFirst.data(), p_.walls.memory.entryFirst.data(),
                     p_.walls.memory.elementFirst.data()})
                exclusiveScan(p_.set.context, p_.order.scan, sums, p_.particles.n + 1);
        }
        forEach(p_.set.context, 1, CollectTotals
        {
            fresh ? nullptr : g.keptFirst.data() + p_.particles.n, p_.order.oldList.base() + blocks,
            p_.walls.count ? p_.walls.memory.entryFirst.data() + p_.particles.n : nullptr,
            p_.walls.count ? p_.walls.memory.elementFirst.data() + p_.particles.n : nullptr,
            p_.walls.count ? g.wallListFirst.data() + p_.particles.n : nullptr, g.totals.data()
        });
        p_.set.context.toHost(total.data(), g.totals.data(), sizeof(total));
    }
    return total;
}

//- How far particles may go, now that they are in their places
template<class Backend, int D, class P>
void Neighbours<Backend, D, P>::settleFrames()
{
    if constexpr (Backend::gpu)
    {
        if (!p_.memory.frames.on()) return;
        const double skin = 2*double(p_.reach.halfSkin),
                     touch = 2*p_.reach.radii.largest + p_.pairs.largestGap();
        double way = SearchReach<Backend, D, P>::wallSkins*skin;
        if (p_.motion.walls()) way -= double(p_.reach.halfSkin);
        way = std::min(way, 0.5*(p_.memory.frames.width() - touch));
        p_.memory.frames.settle(p_.set.context, way, way);
    }
}

//- On the CPU: which forces blocks of particles leave to each other
template<class Backend, int D, class P>
void Neighbours<Backend, D, P>::blockContacts()
{
#ifndef __CUDACC__
    if constexpr (!Backend::gpu)
    {
        p_.memory.sums.allocate(
            p_.set.context, std::size_t(p_.particles.n)*DeferredForces<D, real>::width);
        // of those in the scene: a scene that is continued without those that left must cut alike
        p_.memory.deferred.set(p_.order.active(), p_.order.list.view(),
            ranks_.others ? ranks_.blockCuts() : std::vector<int>());
        setRanges();
    }
#endif
}

template<class Backend, int D, class P>
void Neighbours<Backend, D, P>::setRanges()
{
#ifndef __CUDACC__
    if constexpr (!Backend::gpu)
    {
        const SolidFields<D, P> f = p_.particles.view();
        p_.memory.deferred.setRanges(
            p_.order.list.view(), p_.sleeps(), [&](int i) { return f.asleep(i); });
        const bool walls = p_.walls.count && p_.walls.memory.entries;
        p_.memory.deferred.awake.setWalls(
            p_.order.active(), walls ? p_.walls.memory.entryFirst.data() : nullptr);
    }
#endif
}

//- Where steps are fused a particle's way is measured against what is around it. Who sleeps does
//  not look where others go
template<class Backend, int D, class P>
void Neighbours<Backend, D, P>::setFrames()
{
    if constexpr (Backend::gpu)
        if (p_.fuses() && !p_.sleeps())
            p_.memory.frames.set(
                p_.set.context, p_.set.box, 3*(2*p_.reach.radii.largest + p_.reach.reach), 2e6);
}

//- New cells for it; lists are those of before until the next rebuild
template<class Backend, int D, class P>
void Neighbours<Backend, D, P>::setSkin(double skin)
{
    p_.reach.set(skin);
#ifdef __CUDACC__
    p_.memory.graphs.clear();                  // they hold on to the cells' and walls' numbers
#endif
    p_.reach.setDomain();
    if (ranks_.others) ranks_.setPieces();
    setFrames();
    p_.order.setCells(p_.particles.n, p_.reach.classes.cells(), p_.order.active());
}

template<class Backend, int D, class P>
void Neighbours<Backend, D, P>::adaptSkin()
{
    constexpr std::int64_t few = 8, many = 64;
    constexpr double stepsOfList = 16;
    if (p_.set.config.skin >= 0 || p_.reach.driven) return;
    DemClockData now = p_.clock.now;
    if constexpr (!Backend::gpu) now = *p_.clock.data();
    const std::int64_t lasted = now.step - p_.reach.searchedAt;
    p_.reach.searchedAt = now.step;
    if (lasted >= few && !(p_.reach.skin > p_.reach.leastSkin() && lasted > many)) return;
    const double speed = std::max(
        largestSpeed(), (p_.motion.walls() ? p_.walls.largestSpeed() : 0));
    const double wanted = std::min(
        std::max(2*1.25*stepsOfList*speed*now.fullDt, p_.reach.leastSkin()),
        p_.reach.mostSkin(p_.walls.surfaces));
    if (lasted < few ? wanted > 1.1*p_.reach.skin : wanted < 0.5*p_.reach.skin) setSkin(wanted);
}

template<class Backend, int D, class P>
double Neighbours<Backend, D, P>::largestSpeed()
{
    using Kernel = LargestSpeed<D, P>;
    Array<Backend, float> largest;
    largest.allocate(p_.set.context, Kernel::shares);
    forEach(p_.set.context, Kernel::shares,
        Kernel{p_.particles.view(), p_.order.sort.active(), largest.data()});
    float most = 0;
    for (const float v2 : largest.download()) most = v2 > most || v2 != v2 ? v2 : most;
    return ranks_.largest(std::sqrt(double(most)));
}

} // namespace riprap

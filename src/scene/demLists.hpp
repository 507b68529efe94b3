/*  DemSolver: sorting, contact lists, and walls near particles.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "scene/demSolver.hpp"

namespace riprap
{

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::rebuild(bool fresh)
{
    SolidKeys<D, P> keys{mover(), classes_, sort_.keys(), sort_.indices()};
    forEach(context_, n_, keys);
    sort_.sort(context_, n_);
    fields_.permute(context_, sort_.order(), n_);
    forEach(context_, n_, PlaceSolids<D, P>{mover(), slotOf_.data()});
    if (nBonds_) forEach(context_, nBonds_, LoseBonds<D, P>{bondFields()});
    list_.swap(oldList_);
    buildContacts();
    if (!fresh && histories_ >= 0)
    {
        forEach(context_, n_, InvertOrder{sort_.order(), inverse_.data()});
        withLaw(config_, [&](auto law)
        {
            forEach(context_, n_, HandOver<Backend, decltype(law), D, real>
            {oldList_.view(), list_.view(), sort_.order(), inverse_.data(), sort_.active()});
        });
    }
    if (nBonds_) forEach(context_, nBonds_, RestBonds<Backend, D, P>{bondFields(), list_.view()});
    if (nWalls_) buildWalls(fresh);
    blockContacts();
}

template<class Backend, int D, class P>
ContactSearch<Backend, D, P> DemSolver<Backend, D, P>::search()
{
    const SolidFields<D, P> f = fields();
    return ContactSearch<Backend, D, P>
    {box_, classes_, records_.view(), sort_.start(), f.clump, f.id, bondTable(), real(reach_)};
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::buildContacts()
{
    list_.allocate(context_, n_);
    forEach(context_, n_, CountContacts<Backend, D, P>{search(), sort_.active(), list_.count()});
    const int blocks = list_.blocks();
    forEach(context_, blocks, BlockEntries{list_.count(), list_.base(), list_.width});
    exclusiveScan(context_, scan_, list_.base(), blocks + 1);
    int entries = 0;
    context_.toHost(&entries, list_.base() + blocks, sizeof(int));
    list_.reserve(context_, entries, histories_, nBonds_ > 0);
    forEach(context_, n_, WriteContacts<Backend, D, P>{search(), sort_.active(), list_.view()});
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::buildWalls(bool fresh)
{
    std::swap(wallMemory_, oldWallMemory_);
    WallMemoryArrays<Backend, real>& m = wallMemory_;
    const int H = std::max(histories_, 1);
    if (wallMotions_) forEach(context_, nWalls_, KeepWallReference{walls_.data()});
    WallSearch<D, P> search{box_, fields(), walls_.data(), nWalls_, surface(), reach_, sort_.active()};
    m.entryFirst.allocate(context_, std::size_t(n_) + 1);
    m.elementFirst.allocate(context_, std::size_t(n_) + 1);
    FindWalls<D, P, false> count{search, m.entryFirst.data(), m.elementFirst.data(), nullptr, nullptr};
    forEach(context_, n_, count);
    exclusiveScan(context_, scan_, m.entryFirst.data(), n_ + 1);
    exclusiveScan(context_, scan_, m.elementFirst.data(), n_ + 1);
    int elements = 0;
    context_.toHost(&m.entries, m.entryFirst.data() + n_, sizeof(int));
    context_.toHost(&elements, m.elementFirst.data() + n_, sizeof(int));
    const std::size_t room = std::size_t(m.entries) + 1;
    m.entry.allocate(context_, room);
    m.element.allocate(context_, std::size_t(elements) + 1);
    m.on.allocate(context_, room*wallTouches);
    m.normal.allocate(context_, room*wallTouches*D);
    m.history.allocate(context_, room*wallTouches*H);
    m.force.allocate(context_, room*wallWords<D>);
    FindWalls<D, P, true> write{search, m.entryFirst.data(), m.elementFirst.data(), m.entry.data(), m.element.data()};
    forEach(context_, n_, write);
    withLaw(config_, [&](auto law)
    {
        forEach(context_, n_, HandOverWalls<D, real, decltype(law)::template history<D>>
        {wallMemory(oldWallMemory_), wallMemory(m), sort_.order(), sort_.active(), fresh});
    });
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
        parts_.deferred.set(activeSolids(), list_.view());
    }
#endif
}

} // namespace riprap

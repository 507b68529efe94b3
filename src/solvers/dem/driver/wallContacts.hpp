/*  Which particles are near which walls, and what their contacts remember.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/dem/driver/contactForces.hpp"
#include "solvers/dem/driver/rankedSolids.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class WallContacts
{
public:

    using real = typename P::real;

    WallContacts(DemParts<Backend, D, P>& parts, ContactForces<Backend, D, P>& forces,
        RankedSolids<Backend, D, P>& ranks)
        : p_(parts), forces_(forces), ranks_(ranks)
    {}

    //- In a rebuild; on the GPU in two, before and after particles are in their new places. fresh:
    //  nothing is remembered
    void build(bool fresh);
    void count();
    void write(bool fresh, int elements);

private:

    WallSearch<D, P> search();

    DemParts<Backend, D, P>& p_;
    ContactForces<Backend, D, P>& forces_;
    RankedSolids<Backend, D, P>& ranks_;
};

template<class Backend, int D, class P>
WallSearch<D, P> WallContacts<Backend, D, P>::search()
{
    return WallSearch<D, P>{p_.set.box, p_.particles.view(), p_.walls.walls.data(), p_.walls.count,
        p_.walls.surface(), forces_.wallReach(), p_.order.sort.active()};
}

template<class Backend, int D, class P>
void WallContacts<Backend, D, P>::count()
{
    std::swap(p_.walls.memory, p_.walls.oldMemory);
    WallMemoryArrays<Backend, real>& m = p_.walls.memory;
    if (p_.motion.walls())
        forEach(p_.set.context, p_.walls.count, KeepWallReference{p_.walls.walls.data()});
    m.entryFirst.allocate(p_.set.context, std::size_t(p_.particles.n) + 1);
    m.elementFirst.allocate(p_.set.context, std::size_t(p_.particles.n) + 1);
    if constexpr (Backend::gpu)
    {
        // where particles still are: their order follows
        for (Array<Backend, int>* a : {&p_.memory.foundWalls, &p_.memory.foundElements})
            if (a->size() == 0) a->allocate(p_.set.context, p_.particles.n);
        forEach(p_.set.context, p_.particles.n, FindWalls<D, P, false>
        {
            search(), p_.memory.foundWalls.data(), p_.memory.foundElements.data(), nullptr, nullptr,
            reinterpret_cast<const int*>(p_.order.sort.order())
        });
        return;
    }
    forEach(p_.set.context, p_.particles.n,
        FindWalls<D, P, false>{
            search(), m.entryFirst.data(), m.elementFirst.data(), nullptr, nullptr, nullptr});
    exclusiveScan(p_.set.context, p_.order.scan, m.entryFirst.data(), p_.particles.n + 1);
    exclusiveScan(p_.set.context, p_.order.scan, m.elementFirst.data(), p_.particles.n + 1);
}

template<class Backend, int D, class P>
void WallContacts<Backend, D, P>::write(bool fresh, int elements)
{
    WallMemoryArrays<Backend, real>& m = p_.walls.memory;
    const int H = std::max(p_.pairs.histories(), 1);
    // a little more than now: pointers that stay keep recorded steps
    const std::size_t room = std::size_t(m.entries) + m.entries/8 + 1;
    if (m.entry.size() < std::size_t(m.entries) + 1)
    {
        m.entry.allocate(p_.set.context, room);
        m.on.allocate(p_.set.context, room*wallTouches);
        m.normal.allocate(p_.set.context, room*wallTouches*D);
        m.history.allocate(p_.set.context, room*wallTouches*H);
        m.force.allocate(p_.set.context, room*wallWords<D>);
    }
    if (m.element.size() < std::size_t(elements) + 1)
        m.element.allocate(p_.set.context, std::size_t(elements) + elements/8 + 1);
    forEach(p_.set.context, p_.particles.n,
        FindWalls<D, P, true>{search(), m.entryFirst.data(), m.elementFirst.data(), m.entry.data(),
            m.element.data(), nullptr});
    withLaw(p_.set.laws,
        [&](auto law)
        {
            forEach(p_.set.context, p_.particles.n,
                HandOverWalls<D, real, decltype(law)::template history<D>>{
                    p_.walls.view(p_.walls.oldMemory), p_.walls.view(m), p_.newOrder(),
                    p_.order.sort.active(), fresh});
        });
    if (ranks_.others && !fresh) ranks_.takeWallContacts();
}

template<class Backend, int D, class P>
void WallContacts<Backend, D, P>::build(bool fresh)
{
    count();
    int elements = 0;
    p_.set.context.toHost(
        &p_.walls.memory.entries, p_.walls.memory.entryFirst.data() + p_.particles.n, sizeof(int));
    p_.set.context.toHost(
        &elements, p_.walls.memory.elementFirst.data() + p_.particles.n, sizeof(int));
    write(fresh, elements);
}

} // namespace riprap

/*  Particles in the order of their cells: what of them is read side by side, and lists of who is
    near whom.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/neighbours/cellSort.hpp"
#include "dem/lists/contactList.hpp"
#include "dem/lists/solidRecords.hpp"
#include "solvers/dem/parts/demSetting.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class SolidOrder
{
public:

    using real = typename P::real;

    SolidRecordMemory<Backend, D, P> records;
    // where particles were when neighbours were sought
    Array<Backend, typename P::position> reference;
    CellSort<Backend> sort;
    SortScratch<Backend> scan;
    Array<Backend, int> inverse;            // from the order before
    Array<Backend, int> slotOf;             // of keys; -1: it has left
    ContactList<Backend, real> list, oldList;

    explicit SolidOrder(DemSetting<Backend, D, P>& set) : set_(set) {}

    //- Memory for n particles in so many cells
    void allocate(int n, int cells);

    //- Particles in the scene
    int active();

    //- For the host: where blocks of the list begin, and how many entries each particle has
    struct ListShape { std::vector<int> base, count; };
    ListShape shape();

    //- Fresh cells for n particles, of which so many are in the scene
    void setCells(int n, int cells, int active);

private:

    DemSetting<Backend, D, P>& set_;
};

template<class Backend, int D, class P>
void SolidOrder<Backend, D, P>::allocate(int n, int cells)
{
    records.allocate(set_.context, n);
    reference.allocate(set_.context, std::size_t(n)*D);
    sort.allocate(set_.context, n, cells);
    inverse.allocate(set_.context, n);
    slotOf.allocate(set_.context, n);
}

template<class Backend, int D, class P>
int SolidOrder<Backend, D, P>::active()
{
    int active = 0;
    set_.context.toHost(&active, sort.active(), sizeof(int));
    return active;
}

template<class Backend, int D, class P>
typename SolidOrder<Backend, D, P>::ListShape SolidOrder<Backend, D, P>::shape()
{
    ListShape s{std::vector<int>(list.blocks() + 1),
        std::vector<int>(std::size_t(list.blocks())*list.width)};
    set_.context.toHost(s.base.data(), list.base(), s.base.size()*sizeof(int));
    set_.context.toHost(s.count.data(), list.count(), s.count.size()*sizeof(int));
    return s;
}

template<class Backend, int D, class P>
void SolidOrder<Backend, D, P>::setCells(int n, int cells, int active)
{
    sort.allocate(set_.context, n, cells);
    set_.context.toDevice(const_cast<int*>(sort.active()), &active, sizeof(int));
}

} // namespace riprap

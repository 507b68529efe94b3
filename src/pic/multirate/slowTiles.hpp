/*  Multirate time integration: particles of slow water are stepped once an interval of several
    steps, the grid in each.

    A tile of 64 cells is slow for an interval if neither in it nor in those about it water goes
    farther than a path L in so many steps as now, no particle flies and no solid moves. Its
    particles keep place and velocity, with the sums that they have at the faces. The grid goes on:
    to the sums of a mass m_s of slow particles at a face comes m_s times what its velocity has
    changed by since the interval began,

        m u = sum_p W v_p + m_s sum_n du^n

    so that forces and pressure act on slow water in each step, however weak they are. When the
    interval ends, or as soon as something fast is near, particles take all that at once, and go
    with the mean velocity:

        v_p = formula(v_p, sum_f W sum_n du^n, sum_f W u),   dx_p/dt = sum_n u^n dt^n/sum_n dt^n

    Momentum is lost nowhere. What is neglected is how water is carried within L. A particle that
    drifts into a slow tile waits there, too: it gives what it will be given,
    v_p -= sum_f W sum_n du^n; it will go up to L too far.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/grid/activeRows.hpp"
#include "pic/multirate/slowKernels.hpp"
#include "pic/transfer/particleToGrid.hpp"

namespace riprap
{

template<class Backend, int D, class R>
class SlowTiles
{
public:

    Array<Backend, R> change[D], mean[D];       // of faces, since the interval began
    double time = 0;                            // since then [s]
    int steps = 0;

    //- always: tiles that are never slow; empty: none
    void allocate(
        Context<Backend>&, const UniformGrid<D>&, const std::vector<unsigned char>& always);

    //- Do particles of any tile wait since the interval began?
    bool any() const { return slow_ > 0; }
    int due() const { return due_; }

    TileChoice<D> in(unsigned char state) const { return {state_.data(), tiles_, state}; }
    TileList<D> list(unsigned char state) const
    {
        return state == dueTile ? TileList<D>(tiles_, dueList_.data(), due_)
                                : TileList<D>(tiles_, currentList_.data(), current_);
    }

    //- Before particles are summed
    void find(Context<Backend>&, const OccupiedTiles<Backend, D>&, CellSort<Backend>&);
    //- Of direction d; each: faces that a tile's particles see
    SlowSums<D, R> sums(Context<Backend>&, int d, std::size_t each);
    void endSums() { summed_ = true; }

    //- Tiles near fast ones, or all, are due. fast: with all but tiles
    void wake(Context<Backend>&, FindFastTiles<D, R> fast, bool all, CellSort<Backend>&);
    void endStep(Context<Backend>&);
    //- An interval begins
    void choose(Context<Backend>&, FindFastTiles<D, R> fast, CellSort<Backend>&);

    double particles(Context<Backend>&, const int* start) const;

    //- For a saved state, with the arrays that are public
    std::vector<double> memory() const;
    std::size_t memorySize() const { return 2 + std::size_t(tiles_.count()); }
    void setMemory(Context<Backend>&, const double*, CellSort<Backend>&);

    std::size_t bytes() const;

private:

    void findNearFast(Context<Backend>&, FindFastTiles<D, R>);
    void listSlow(Context<Backend>&, CellSort<Backend>&);

    UniformGrid<D> grid_;
    CellTiles<D> tiles_;
    Array<Backend, unsigned char> state_, always_, fast_, nearFast_;
    Array<Backend, int> flag_, place_, count_, slot_;
    Array<Backend, int> currentList_, dueList_, summedList_, summedSlot_, counts_;
    Array<Backend, FaceSum<R>> sums_[D];
    int slow_ = 0, current_ = 0, due_ = 0, summing_ = 0;
    bool summed_ = false;                       // have slow tiles their sums?
};

template<class Backend, int D, class R>
void SlowTiles<Backend, D, R>::allocate(Context<Backend>& context, const UniformGrid<D>& grid,
    const std::vector<unsigned char>& always)
{
    grid_ = grid;
    tiles_ = CellTiles<D>(grid);
    const std::size_t n = tiles_.count();
    state_.upload(context, std::vector<unsigned char>(n, currentTile));
    if (!always.empty()) always_.upload(context, always);
    for (auto* a : {&fast_, &nearFast_}) a->allocate(context, n);
    flag_.allocate(context, 2*n + 1);
    for (auto* a :
        {&place_, &count_, &slot_, &currentList_, &dueList_, &summedList_, &summedSlot_})
        a->allocate(context, n);
    counts_.allocate(context, 2);
    for (int d = 0; d < D; ++d)
        for (auto* a : {&change[d], &mean[d]}) a->allocate(context, grid.faces(d));
}

template<class Backend, int D, class R>
void SlowTiles<Backend, D, R>::find(Context<Backend>& context,
    const OccupiedTiles<Backend, D>& occupied, CellSort<Backend>& sort)
{
    const int n = tiles_.count();
    forEach(context, n + 1,
        FlagSummedTiles<D>{grid_, tiles_, sort.start(), occupied.place(), state_.data(), !summed_,
            count_.data(), flag_.data()});
    sort.scan(context, flag_.data(), 2*n + 1);
    forEach(context, n,
        ListSummedTiles{n, flag_.data(), state_.data(), slot_.data(), place_.data(),
            currentList_.data(), summedList_.data(), summedSlot_.data(), counts_.data()});
    int counts[2];
    context.toHost(counts, counts_.data(), sizeof(counts));
    current_ = counts[0];
    summing_ = counts[1];
}

template<class Backend, int D, class R>
SlowSums<D, R> SlowTiles<Backend, D, R>::sums(
    Context<Backend>& context, int d, std::size_t each)
{
    // those that there are go by the slots of this interval
    if (!summed_ && sums_[d].size() < slow_*each) sums_[d].allocate(context, slow_*each);
    return {list(currentTile), TileList<D>(tiles_, summedList_.data(), summing_),
        summedSlot_.data(), place_.data(), sums_[d].data(), change[d].data()};
}

//- Which tiles have a fast one about them
template<class Backend, int D, class R>
void SlowTiles<Backend, D, R>::findNearFast(Context<Backend>& context, FindFastTiles<D, R> fast)
{
    fast.grid = grid_;
    fast.tiles = tiles_;
    fast.always = always_.size() ? always_.data() : nullptr;
    fast.fast = fast_.data();
    forEach(context, tiles_.count(), fast);
    IsNearWater<D> near{tiles_, {}, fast_.data(), nearFast_.data(), 1};
    for (int d = 0; d < D; ++d)
    {
        near.periodic[d] = grid_.periodic[d];
        // the last tile of a ring may be a short one
        if (grid_.periodic[d]) near.reach = 2;
    }
    forEach(context, tiles_.count(), near);
}

template<class Backend, int D, class R>
void SlowTiles<Backend, D, R>::wake(
    Context<Backend>& context, FindFastTiles<D, R> fast, bool all, CellSort<Backend>& sort)
{
    const int n = tiles_.count();
    if (!all) findNearFast(context, fast);
    forEach(context, n + 1, WakeTiles{n, nearFast_.data(), all, state_.data(), flag_.data()});
    sort.scan(context, flag_.data(), n + 1);
    // places are found anew before they are asked for
    forEach(context, n, ListOccupied{flag_.data(), place_.data(), dueList_.data()});
    context.toHost(&due_, flag_.data() + n, sizeof(int));
}

template<class Backend, int D, class R>
void SlowTiles<Backend, D, R>::endStep(Context<Backend>& context)
{
    if (due_) forEach(context, tiles_.count(), EndDueTiles{state_.data()});
    due_ = 0;
}

template<class Backend, int D, class R>
void SlowTiles<Backend, D, R>::choose(
    Context<Backend>& context, FindFastTiles<D, R> fast, CellSort<Backend>& sort)
{
    findNearFast(context, fast);
    forEach(context, tiles_.count() + 1,
        ChooseSlowTiles<D>{grid_, tiles_, sort.start(), nearFast_.data(), state_.data(),
            flag_.data()});
    listSlow(context, sort);
    for (int d = 0; d < D && slow_; ++d)
        for (auto* a : {&change[d], &mean[d]}) context.zero(a->data(), a->size()*sizeof(R));
    time = 0;
    steps = 0;
}

//- Flags are those of slow tiles
template<class Backend, int D, class R>
void SlowTiles<Backend, D, R>::listSlow(Context<Backend>& context, CellSort<Backend>& sort)
{
    const int n = tiles_.count();
    sort.scan(context, flag_.data(), n + 1);
    // the list is made anew before it is asked for
    forEach(context, n, ListOccupied{flag_.data(), slot_.data(), summedList_.data()});
    context.toHost(&slow_, flag_.data() + n, sizeof(int));
    summed_ = false;
}

//- That wait
template<class Backend, int D, class R>
double SlowTiles<Backend, D, R>::particles(Context<Backend>& context, const int* start) const
{
    return slow_ ? sumOver<1>(context, tiles_.count(),
               CountSlow<D>{grid_, tiles_, start, state_.data()})[0]
                 : 0;
}

template<class Backend, int D, class R>
std::vector<double> SlowTiles<Backend, D, R>::memory() const
{
    std::vector<double> all{time, double(steps)};
    for (const unsigned char s : state_.download()) all.push_back(s);
    return all;
}

template<class Backend, int D, class R>
void SlowTiles<Backend, D, R>::setMemory(
    Context<Backend>& context, const double* from, CellSort<Backend>& sort)
{
    const int n = tiles_.count();
    time = from[0];
    steps = int(from[1]);
    state_.upload(context, std::vector<unsigned char>(from + 2, from + 2 + n));
    forEach(context, n + 1, FlagSlowTiles{n, state_.data(), flag_.data()});
    listSlow(context, sort);
    due_ = 0;
}

template<class Backend, int D, class R>
std::size_t SlowTiles<Backend, D, R>::bytes() const
{
    std::size_t sum = state_.bytes() + always_.bytes() + fast_.bytes() + nearFast_.bytes();
    for (const auto* a : {&flag_, &place_, &count_, &slot_, &currentList_, &dueList_,
             &summedList_, &summedSlot_, &counts_})
        sum += a->bytes();
    for (int d = 0; d < D; ++d)
        sum += change[d].bytes() + mean[d].bytes() + sums_[d].bytes();
    return sum;
}

} // namespace riprap

/*  Sorts a set of particles into the cells of a grid and tabulates where each cell begins.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/neighbours/cellGrid.hpp"
#include "core/containers/fieldSet.hpp"
#include "core/loops/sort.hpp"

namespace riprap
{

struct ClearCounts
{
    static constexpr const char* name = "clearCells";
    int* counts;
    HD void operator()(int c) const { counts[c] = 0; }
};

struct CountCells
{
    static constexpr const char* name = "countCells";
    const std::uint32_t* keys;
    int* counts;

    HD void operator()([[maybe_unused]] int i) const
    {
#ifdef __CUDA_ARCH__
        atomicAdd(counts + keys[i], 1);
#elif !defined(__CUDACC__)
        #pragma omp atomic
        counts[keys[i]] += 1;
#endif
    }
};

template<class Backend>
class CellSort
{
public:

    //- Room for n particles in `cells` cells and one more for what is in no cell
    void allocate(Context<Backend>& context, std::size_t n, int cells)
    {
        cells_ = cells;
        for (auto& a : scratch_.keys) a.allocate(context, n);
        for (auto& a : scratch_.values) a.allocate(context, n);
        start_.allocate(context, std::size_t(cells) + 2);
        bits_ = 1;
        while ((std::int64_t(1) << bits_) <= cells) ++bits_;
        const int all = int(n);
        context.toDevice(start_.data() + cells, &all, sizeof(int));
    }

    std::uint32_t* keys() { return scratch_.keys[0].data(); }
    std::uint32_t* indices() { return scratch_.values[0].data(); }

    //- After keys() and indices() were filled: sort and tabulate. Then order() says which particle
    //  goes where.
    void sort(Context<Backend>& context, int n)
    {
        if (n > 0) sortPairs(context, scratch_, n, bits_);
        forEach(context, cells_ + 2, ClearCounts{start_.data()});
        forEach(context, n, CountCells{scratch_.keys[1].data(), start_.data()});
        exclusiveScan(context, scratch_, start_.data(), cells_ + 2);
    }

    //- data[i] becomes the sum of data[0 .. i-1], with the sort's scratch
    void scan(Context<Backend>& context, int* data, int n)
    {
        exclusiveScan(context, scratch_, data, n);
    }

    //- What sorting needs is given back: for sets that never move
    void releaseScratch() { scratch_ = SortScratch<Backend>(); }

    const std::uint32_t* order() const { return scratch_.values[1].data(); }
    const int* start() const { return start_.data(); }
    //- The cell of each of the set in its order, until the next sort
    const std::uint32_t* sortedKeys() const { return scratch_.keys[1].data(); }
    std::vector<int> starts(Context<Backend>& context) const
    {
        std::vector<int> all(std::size_t(cells_) + 1);
        context.toHost(all.data(), start_.data(), all.size()*sizeof(int));
        return all;
    }
    const int* active() const { return start_.data() + cells_; }    // particles that are in a cell
    std::size_t bytes() const
    {
        std::size_t b = start_.bytes() + scratch_.temporary.bytes();
        for (int k = 0; k < 2; ++k) b += scratch_.keys[k].bytes() + scratch_.values[k].bytes();
        return b;
    }

private:
    SortScratch<Backend> scratch_;
    Array<Backend, int> start_;         // counts, then their sums
    int cells_ = 0, bits_ = 1;
};

} // namespace riprap

/*  What the search of the cell grid finds about each particle of a set, kept until the next sort:
    ranges of neighbours, which lie side by side. Passes over pairs then need no search, which takes
    longer than the pairs that a short row holds. For the CPU; on a GPU there are lists.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#ifndef __CUDACC__

#include <algorithm>
#include <vector>
#include "core/backend/launch.hpp"
#include "core/containers/ghostMarks.hpp"
#include "core/containers/records.hpp"
#include "core/neighbours/cellGrid.hpp"

namespace riprap
{

struct ParticleRange { int begin, end; };

//- Of each target its ranges. Null: nothing is kept
struct RangesView
{
    //- Targets of a block have theirs side by side
    static constexpr int inBlock = 1024;

    const int* first = nullptr;         // of each target in its block, and each block's end
    const ParticleRange* const* block = nullptr;

    explicit operator bool() const { return first; }
    bool none(int i) const
    {
        const int* at = first + i + i/inBlock;
        return at[0] == at[1];
    }

    template<class F>
    void forEach(int i, const F& f) const
    {
        const int* at = first + i + i/inBlock;
        const ParticleRange* range = block[i/inBlock];
        for (int k = at[0]; k < at[1]; ++k) f(range[k].begin, range[k].end);
    }
};

class FoundRanges
{
public:

    static constexpr const char* name = "findRanges";

    //- About the first n particles of `targets` that are no ghosts, in a set of which `start` has
    //  the first of each cell
    template<int D, class P>
    void find(Context<Cpu>& context, const Box<D, P>& box, const CellGrid<D, P>& grid,
        const RecordsView<Cpu, D, P>& targets, int n, const int* start,
        const GhostMarks<Cpu>& ghosts)
    {
        constexpr int inBlock = RangesView::inBlock;
        profiled(context, name, [&]
        {
            const int blocks = (n + inBlock - 1)/inBlock;
            first_.resize(n + blocks);
            range_.resize(blocks);
            data_.resize(blocks);
            #pragma omp parallel for schedule(dynamic) if (blocks > 1)
            for (int b = 0; b < blocks; ++b)
            {
                std::vector<ParticleRange>& found = range_[b];
                found.clear();
                int* first = first_.data() + b*(inBlock + 1);
                for (int i = b*inBlock, end = std::min(n, i + inBlock); i < end; ++i)
                {
                    *first++ = int(found.size());
                    if (!ghosts(i)) findAbout(box, grid, targets.loadPosition(i), start, found);
                }
                *first = int(found.size());
                data_[b] = found.data();
            }
        });
    }

    RangesView view() const { return {first_.data(), data_.data()}; }

    std::size_t bytes() const
    {
        std::size_t sum = first_.capacity()*sizeof(int);
        for (const auto& range : range_) sum += range.capacity()*sizeof(ParticleRange);
        return sum;
    }

private:

    template<int D, class P>
    static void findAbout(const Box<D, P>& box, const CellGrid<D, P>& grid,
        const Vec<D, typename P::position>& x, const int* start, std::vector<ParticleRange>& found)
    {
        Vec<D, typename P::real> relative;
        for (int d = 0; d < D; ++d) relative.c[d] = box.pairRelative(d, x.c[d]);
        grid.forEachRange(relative, start,
            [&](int begin, int end) { found.push_back({begin, end}); });
    }

    std::vector<int> first_;
    std::vector<std::vector<ParticleRange>> range_;
    std::vector<const ParticleRange*> data_;
};

} // namespace riprap

#endif

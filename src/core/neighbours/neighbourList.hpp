/*  Builds and owns the neighbour lists of one ordered pair of sets (targets, sources). GPU only:
    the CPU walks cells.

    Two layouts of one list: a fixed block for each warp (dense sets: one traversal), or blocks cut
    from a pool to the warp's longest list (sets of which few targets have neighbours: counted
    first, then written).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/neighbours/gpuPairLoop.hpp"
#include "core/neighbours/searchReach.hpp"
#include "core/containers/ghostMarks.hpp"

namespace riprap
{

//- Raised on the device when lists do not fit; the step is then off until the host has made room
struct ListOverflow
{
    // 0: all fits; else entries (of four) a thread, or blocks of the pool
    int needed;
};

template<int D, class P>
struct ListBuild
{
    using real = typename P::real;

    Box<D, P> box;
    CellGrid<D, P> grid;
    RecordsView<Gpu, D, P> target, source;
    real radius;                // of the lists; the grid's or more
    SearchReach<real> reach;    // where it varies: the grid's or less
    const int* start;
    const int* targets;         // device count
    bool sameSet;
    int shift;
    int capacity;               // entries of four a thread (fixed), or blocks of 32 entries (pool)
    bool pooled;
    uint4* entries;
    unsigned* base;
    int* count;
    unsigned* poolUsed;
    int* overflow;
    GhostMarks<Gpu> ghosts;     // targets without a list

    template<class F>
    __device__ __forceinline__ void forEachNeighbour(int i, int lane, const F& f) const
    {
        const auto xi = target.loadPosition(i);
        Vec<D, real> relative;
        for (int d = 0; d < D; ++d) relative.c[d] = box.pairRelative(d, xi.c[d]);
        const real within = reach.radius(radius), r2max = within*within;
        const int lanes = 1 << shift;
        const auto look = [&](int begin, int end)
        {
            for (int j = begin + lane; j < end; j += lanes)
            {
                const auto xj = source.loadPosition(j);
                Vec<D, real> dx;
                for (int d = 0; d < D; ++d)
                    dx.c[d] = box.template separation<real>(d, xi.c[d], xj.c[d]);
                if (squaredNorm(dx) < r2max && !(sameSet && i == j)) f(unsigned(j));
            }
        };
        if (radius > grid.radius) grid.forEachRangeWithin(relative, radius, start, look);
        else grid.forEachRangeNear(relative, within, start, look);
    }
};

namespace detail
{

template<int D, class P>
__global__ void __launch_bounds__(pairBlock) listKernel(ListBuild<D, P> b)
{
    const int thread = blockIdx.x*pairBlock + threadIdx.x;
    const int i = thread >> b.shift, lane = thread & ((1 << b.shift) - 1);
    const bool valid = i < *b.targets && !b.ghosts(i);
    const int warp = thread >> 5;
    unsigned base = unsigned(warp)*b.capacity;
    int room = b.capacity*4;
    if (b.pooled)
    {
        int count = 0;
        if (valid) b.forEachNeighbour(i, lane, [&](unsigned) { ++count; });
        int longest = (count + 3)/4;
        for (int o = 16; o > 0; o /= 2)
            longest = max(longest, __shfl_xor_sync(0xffffffffu, longest, o));
        unsigned first = 0;
        if ((threadIdx.x & 31) == 0 && longest) first = atomicAdd(b.poolUsed, unsigned(longest));
        base = __shfl_sync(0xffffffffu, first, 0);
        room = longest*4;
        if (longest && base + longest > unsigned(b.capacity))
        {
            atomicMax(b.overflow, int(base + longest));
            room = 0;
        }
        if (room == 0)
        {
            if ((threadIdx.x & 31) == 0) b.base[warp] = 0;
            b.count[thread] = 0;
            return;
        }
    }
    if ((threadIdx.x & 31) == 0) b.base[warp] = base;
    uint4* entry = b.entries + std::size_t(base)*32 + (thread & 31);
    unsigned q[4] = {0, 0, 0, 0};
    int k = 0;
    if (valid) b.forEachNeighbour(i, lane, [&](unsigned j)
    {
        q[0] = q[1]; q[1] = q[2]; q[2] = q[3]; q[3] = j;
        if ((++k & 3) == 0 && k <= room)
        {
            *entry = make_uint4(q[0], q[1], q[2], q[3]);
            entry += 32;
        }
    });
    if (k > room)
    {
        atomicMax(b.overflow, (k + 3)/4);
        k = 0;
    }
    const int rest = k & 3;
    if (rest == 1) *entry = make_uint4(q[3], 0, 0, 0);
    if (rest == 2) *entry = make_uint4(q[2], q[3], 0, 0);
    if (rest == 3) *entry = make_uint4(q[1], q[2], q[3], 0);
    b.count[thread] = k;
}

} // namespace detail

template<int D, class P>
class NeighbourList
{
public:

    //- Room for lists of n targets; capacity as in ListBuild
    void allocate(Context<Gpu>& context, int n, int shift, bool pooled, int capacity)
    {
        const std::size_t threads = ((std::size_t(n) << shift) + detail::pairBlock - 1)
            /detail::pairBlock*detail::pairBlock;
        n_ = n;
        shift_ = shift;
        pooled_ = pooled;
        capacity_ = capacity;
        const std::size_t warps = threads/32 + 1;
        entries_.allocate(
            context, 32*(pooled ? std::size_t(capacity) : warps*std::size_t(capacity)));
        base_.allocate(context, warps);
        count_.allocate(context, threads);
        poolUsed_.allocate(context, 1);
    }

    //- Lists of all pairs within a radius, not below the grid's, or within what there is to reach;
    //  name: of the launch
    void build(Context<Gpu>& context, const Box<D, P>& box, const CellGrid<D, P>& grid,
        typename P::real radius, const RecordsView<Gpu, D, P>& target,
        const RecordsView<Gpu, D, P>& source, const int* start, const int* targets, bool sameSet,
        int* overflow, const char* name, const SearchReach<typename P::real>& reach = {},
        const GhostMarks<Gpu>& ghosts = {})
    {
        const ListBuild<D, P> b{box, grid, target, source, radius, reach, start, targets, sameSet,
            shift_, capacity_, pooled_, entries_.data(), base_.data(), count_.data(),
            poolUsed_.data(), overflow, ghosts};
        if (n_ == 0) return;
        if (pooled_) context.zero(poolUsed_.data(), sizeof(unsigned));
        const std::size_t threads = std::size_t(n_) << shift_;
        profiled(context, name,
            [&]
            {
                detail::listKernel<<<int((threads + detail::pairBlock - 1)/detail::pairBlock),
                    detail::pairBlock, 0, context.stream>>>(b);
            });
    }

    ListView view() const { return ListView{entries_.data(), base_.data(), count_.data()}; }
    int capacity() const { return capacity_; }
    bool pooled() const { return pooled_; }
    std::size_t bytes() const { return entries_.bytes() + base_.bytes() + count_.bytes(); }
    std::vector<int> counts() const { return count_.download(); }

private:
    Array<Gpu, uint4> entries_;
    Array<Gpu, unsigned> base_;
    Array<Gpu, int> count_;
    Array<Gpu, unsigned> poolUsed_;
    int n_ = 0, shift_ = 0, capacity_ = 0;
    bool pooled_ = false;
};

} // namespace riprap

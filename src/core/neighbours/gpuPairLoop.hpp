/*  The pair loop on the GPU: neighbour lists of four indices a load, and the kernel that folds a
    pass over them.

    A particle is served by `lanes` threads (1 for large scenes, up to 8 for small ones). Thread t
    of a particle owns a list of its own: entries [warp base + 32 k + lane] of four indices each, so
    that a warp's loads are coalesced.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <type_traits>
#include <vector_types.h>
#include "core/neighbours/cellGrid.hpp"
#include "core/backend/launch.hpp"
#include "core/containers/records.hpp"

namespace riprap
{

template<class Backend, int D, class P> struct Source;

//- Lists as kernels see them
struct ListView
{
    const uint4* entries;
    const unsigned* base;       // first entry of each warp's block, in units of 32 entries
    const int* count;           // neighbours of each thread
};

template<int D, class P>
struct Source<Gpu, D, P>
{
    RecordsView<Gpu, D, P> records;
    const int* start;
    ListView list;
};

namespace detail
{

static constexpr int pairBlock = 128;

template<int S, class Pass, class Self, class X>
__device__ __forceinline__ void addNeighbour
(const Pass& pass, const Self& self, const X& xi, unsigned j, typename Pass::real* sums)
{
    constexpr int D = Pass::dimensions;
    using real = typename Pass::real;
    X xj;
    PairParticle<D, real> other;
    pass.source[S].records.template loadAll<Pass::variableH>(int(j), xj, other);
    Vec<D, real> dx;
    for (int d = 0; d < D; ++d) dx.c[d] = pass.box.template separation<real>(d, xi.c[d], xj.c[d]);
    pass.template pair<S>(self, other, dx, squaredNorm(dx), int(j), sums);
}

template<int S, class Pass, class Self, class X>
__device__ __forceinline__ void addList
(const Pass& pass, const Self& self, const X& xi, int thread, typename Pass::real* sums)
{
    const ListView& list = pass.source[S].list;
    const int count = list.count[thread];
    const uint4* entry = list.entries + std::size_t(list.base[thread >> 5])*32 + (thread & 31);
    int k = 0;
    for (; k + 4 <= count; k += 4, entry += 32)
    {
        const uint4 q = *entry;
        addNeighbour<S>(pass, self, xi, q.x, sums);
        addNeighbour<S>(pass, self, xi, q.y, sums);
        addNeighbour<S>(pass, self, xi, q.z, sums);
        addNeighbour<S>(pass, self, xi, q.w, sums);
    }
    if (k < count)
    {
        const uint4 q = *entry;
        const unsigned rest[3] = {q.x, q.y, q.z};
        #pragma unroll
        for (int e = 0; e < 3; ++e)
            if (k + e < count) addNeighbour<S>(pass, self, xi, rest[e], sums);
    }
}

__device__ __forceinline__ void mergeMaximum(float* target, float value)
{
    // values are >= 0: their bits order as integers. NaN never gets here (finish reports it as
    // infinity).
    if (value > *target) atomicMax(reinterpret_cast<unsigned*>(target), __float_as_uint(value));
}

//- Maxima of a block into device memory
template<class Pass>
__device__ __forceinline__ void mergeMaxima(const Pass& pass, const float* maxima)
{
    for (int k = 0; k < maximaCount; ++k)
    {
        float m = maxima[k];
        for (int o = 16; o > 0; o /= 2) m = fmaxf(m, __shfl_xor_sync(0xffffffffu, m, o));
        if ((threadIdx.x & 31) == 0) mergeMaximum(pass.maxima() + k, m);
    }
}

//- Passes few of whose targets have neighbours (`static constexpr bool sparse = true`): warps
//  without any leave what was there, unless all targets are asked for (`HD bool all() const`)
template<class Pass, class = void> struct Sparse { static constexpr bool value = false; };
template<class Pass> struct Sparse<Pass, std::void_t<decltype(Pass::sparse)>>
{
    static constexpr bool value = Pass::sparse;
};

template<class Pass>
__device__ __forceinline__ auto wantsAll(const Pass& pass, int) -> decltype(pass.all())
{
    return pass.all();
}
template<class Pass> __device__ __forceinline__ bool wantsAll(const Pass&, long) { return false; }

//- Pass::skips(i), where there is one: a target that is left alone
template<class Pass>
__device__ __forceinline__ auto skips(const Pass& pass, int i, int) -> decltype(pass.skips(i))
{
    return pass.skips(i);
}
template<class Pass>
__device__ __forceinline__ bool skips(const Pass&, int, long) { return false; }

template<class Pass>
__global__ void __launch_bounds__(pairBlock, sizeof(typename Pass::real) == 4 ? 8 : 4)
    pairKernel(Pass pass, int shift)
{
    using real = typename Pass::real;
    if (!pass.enabled()) return;
    const int thread = blockIdx.x*pairBlock + threadIdx.x;
    const int i = thread >> shift;
    const bool valid = i < pass.targets() && !skips(pass, i, 0);
    if constexpr (Sparse<Pass>::value)
        if (!wantsAll(pass, 0)
            && !__any_sync(0xffffffffu, valid && pass.source[0].list.count[thread] > 0))
            return;
    real sums[Pass::channels];
    for (int k = 0; k < Pass::channels; ++k) sums[k] = 0;
    if (valid)
    {
        const auto self = pass.template self<real>(i);
        const auto xi = pass.position(i);
        addList<0>(pass, self, xi, thread, sums);
        if constexpr (Pass::sources > 1)
            if (pass.source[1].start) addList<1>(pass, self, xi, thread, sums);
    }
    for (int o = (1 << shift) >> 1; o > 0; o >>= 1)
        for (int k = 0; k < Pass::channels; ++k)
            sums[k] += __shfl_xor_sync(0xffffffffu, sums[k], o);
    float maxima[maximaCount] = {};
    if (valid && (thread & ((1 << shift) - 1)) == 0) pass.finish(i, sums, maxima);
    if constexpr (Pass::hasMaxima) mergeMaxima(pass, maxima);
}

//- Without lists: for targets that are no sorted set (sampling points)
template<class Pass>
__global__ void __launch_bounds__(pairBlock) directPairKernel(Pass pass)
{
    constexpr int D = Pass::dimensions;
    using real = typename Pass::real;
    const int i = blockIdx.x*pairBlock + threadIdx.x;
    if (i >= pass.targets() || skips(pass, i, 0)) return;
    real sums[Pass::channels];
    for (int k = 0; k < Pass::channels; ++k) sums[k] = 0;
    const auto self = pass.template self<real>(i);
    const auto xi = pass.position(i);
    Vec<D, real> relative;
    for (int d = 0; d < D; ++d) relative.c[d] = pass.box.pairRelative(d, xi.c[d]);
    pass.grid.forEachRange(relative, pass.source[0].start, [&](int begin, int end)
    {
        for (int j = begin; j < end; ++j) addNeighbour<0>(pass, self, xi, unsigned(j), sums);
    });
    float unused[maximaCount] = {};
    pass.finish(i, sums, unused);
}

} // namespace detail

//- shift: log2 of the lanes a particle; maxTargets: particles that the launch must cover
template<class Pass>
void pairLoop(Context<Gpu>& context, const Pass& pass, int shift, int maxTargets)
{
    const long long threads = (long long)maxTargets << shift;
    if (threads == 0) return;
    const int blocks = int((threads + detail::pairBlock - 1)/detail::pairBlock);
    profiled(context, Pass::name, [&]
    { detail::pairKernel<<<blocks, detail::pairBlock, 0, context.stream>>>(pass, shift); });
}

template<class Pass>
void directPairLoop(Context<Gpu>& context, const Pass& pass, int maxTargets)
{
    if (maxTargets <= 0) return;
    const int blocks = (maxTargets + detail::pairBlock - 1)/detail::pairBlock;
    profiled(context, Pass::name, [&]
    { detail::directPairKernel<<<blocks, detail::pairBlock, 0, context.stream>>>(pass); });
}

} // namespace riprap

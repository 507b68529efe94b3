/*  The one pair loop. A pass says what is accumulated over the neighbours of a particle and what is
    done with it:

      struct Pass
      {
          static constexpr const char* name;
          static constexpr int dimensions, channels, sources;      // accumulators, source sets
          static constexpr bool variableH, hasMaxima;
          using precision, Self<T>;
          Box box; CellGrid grid;
          Source<Backend, D, P> source[sources]; // records, cells and lists of each source set
          HD bool enabled() const; // false: the step is off, do nothing
          HD int targets() const;                                  // particles in use
          HD Vec position(int i) const;                            // as pairs see it
          HD Self<T> self(int i) const;                            // the target, broadcast into T
          template<int S, class T> HD void pair(Self<T>, PairParticle<D, T> j, Vec dx, T r2, int
          jIndex, T* sums) const;
          HD void finish(int i, const real* sums, float* maxima) const;   // one write a particle
          float* maxima() const; // device, maxima are merged into it
      };

    Gpu: gather over neighbour lists, one or several lanes a particle, no atomics on sums: bitwise
    repeatable. Cpu: packs of neighbours over ranges of the cell grid. A pass may have `bool
    skips(int i) const`: targets of other ranks.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/neighbours/cellGrid.hpp"
#include "core/neighbours/foundRanges.hpp"
#include "core/backend/launch.hpp"
#include "core/containers/records.hpp"
#ifdef __CUDACC__
    #include "core/neighbours/gpuPairLoop.hpp"
#endif

namespace riprap
{

#ifndef __CUDACC__

//- What a pass needs of a set whose particles act
template<class Backend, int D, class P> struct Source;

template<int D, class P>
struct Source<Cpu, D, P>
{
    RecordsView<Cpu, D, P> records;
    const int* start;           // first particle of each cell
    RangesView ranges;          // about each target; null: they are sought anew
};

namespace detail
{

//- Adds the neighbours of source S in [begin, end) to the packed sums
template<int S, class Pass, class Self, class X>
inline void addRange(const Pass& pass, const Self& self, const X& xi, int begin, int end,
    Pack<typename Pass::real>* sums)
{
    constexpr int D = Pass::dimensions;
    using P = typename Pass::precision;
    using real = typename Pass::real;
    using T = Pack<real>;
    for (int j = begin; j < end; j += T::width)
    {
        Vec<D, typename PositionPack<P>::type> xj;
        PairParticle<D, T> other;
        pass.source[S].records.template loadPack<Pass::variableH>(j, xj, other);
        Vec<D, T> dx;
        for (int d = 0; d < D; ++d) dx.c[d] = pass.box.template separation<T>(d, xi.c[d], xj.c[d]);
        const T r2 = keepFirst(squaredNorm(dx), end - j, real(1e18));
        pass.template pair<S>(self, other, dx, r2, j, sums);
    }
}

//- The neighbours of source S, of a target at that place above the box's corner
template<int S, class Pass, class Self, class X, class Place>
inline void addNeighbours(const Pass& pass, int i, const Self& self, const X& xi,
    const Place& relative, Pack<typename Pass::real>* sums)
{
    const auto& source = pass.source[S];
    if (!source.start) return;
    const auto add = [&](int begin, int end) { addRange<S>(pass, self, xi, begin, end, sums); };
    if (source.ranges) source.ranges.forEach(i, add);
    else pass.grid.forEachRange(relative, source.start, add);
}

//- Pass::skips(i), where there is one: a target that is left alone
template<class Pass>
inline auto skips(const Pass& pass, int i, int) -> decltype(pass.skips(i)) { return pass.skips(i); }
template<class Pass>
inline bool skips(const Pass&, int, long) { return false; }

} // namespace detail

template<class Pass>
void pairLoop(Context<Cpu>& context, const Pass& pass)
{
    constexpr int D = Pass::dimensions;
    using P = typename Pass::precision;
    using real = typename Pass::real;
    using T = Pack<real>;
    if (!pass.enabled()) return;
    profiled(context, Pass::name, [&]
    {
        const int n = pass.targets();
        #pragma omp parallel if (n > 64)
        {
            float maxima[maximaCount] = {};
            #pragma omp for schedule(dynamic, 128) nowait
            for (int i = 0; i < n; ++i)
            {
                if (detail::skips(pass, i, 0)) continue;
                const auto self = pass.template self<T>(i);
                const Vec<D, typename P::position> x = pass.position(i);
                Vec<D, typename PositionPack<P>::type> xi;
                Vec<D, real> relative;
                for (int d = 0; d < D; ++d)
                {
                    xi.c[d] = typename PositionPack<P>::type(x.c[d]);
                    relative.c[d] = pass.box.pairRelative(d, x.c[d]);
                }
                T sums[Pass::channels];
                for (int k = 0; k < Pass::channels; ++k) sums[k] = T(real(0));
                detail::addNeighbours<0>(pass, i, self, xi, relative, sums);
                if constexpr (Pass::sources > 1)
                    detail::addNeighbours<1>(pass, i, self, xi, relative, sums);
                real total[Pass::channels];
                for (int k = 0; k < Pass::channels; ++k) total[k] = sumLanes(sums[k]);
                pass.finish(i, total, maxima);
            }
            if constexpr (Pass::hasMaxima)
            {
                #pragma omp critical (riprapMaxima)
                for (int k = 0; k < maximaCount; ++k)
                    pass.maxima()[k] = std::max(pass.maxima()[k], maxima[k]);
            }
        }
    });
}

//- For targets that are no sorted set (sampling points)
template<class Pass>
void directPairLoop(Context<Cpu>& context, Pass pass, int)
{
    for (auto& source : pass.source) source.ranges = RangesView();
    pairLoop(context, pass);
}

#endif

} // namespace riprap

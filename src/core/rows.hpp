/*  Launches on the CPU whose items are rows of cells, which registers take several at a time: a few dozen of them are work enough for two threads.

    What is chosen between by a condition is found before, in arrays of its own: compilers do not speculate on arithmetic that may trap, and would take such a loop one by one.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/deviceSum.hpp"

//- Before a loop none of whose passes reads what another writes, as those of a kernel
#ifdef __CUDACC__
    #define INDEPENDENT
#else
    #define INDEPENDENT _Pragma("GCC ivdep")
#endif

namespace riprap
{

#ifndef __CUDACC__

//- So many rows are done by one thread: a team costs more
static constexpr int fewRows = 48;

template<class F>
void forEachRow(Context<Cpu>& context, int n, const F& f)
{
    if (n <= 0) return;
    profiled(context, F::name, [&]
    {
        if (n <= fewRows)
        {
            const F own(f);
            for (int i = 0; i < n; ++i) own(i);
            return;
        }
        #pragma omp parallel
        {
            const F own(f);             // of this thread: nothing that f writes can be thought to alias it
            #pragma omp for schedule(static)
            for (int i = 0; i < n; ++i) own(i);
        }
    });
}

//- As sumThen
template<int N, class F, class G>
void sumRowsThen(Context<Cpu>& context, int n, const F& f, double* partial, const G& finish)
{
    profiled(context, F::name, [&]
    {
        const auto chunk = [&](const F& own, int c)
        {
            const int begin = int((long long)n*c/sumChunks), end = int((long long)n*(c + 1)/sumChunks);
            double sums[N] = {};
            for (int i = begin; i < end; ++i) own.add(i, sums);
            for (int k = 0; k < N; ++k) partial[c*N + k] = sums[k];
        };
        if (n <= fewRows)
        {
            const F own(f);
            for (int c = 0; c < sumChunks; ++c) chunk(own, c);
            return;
        }
        #pragma omp parallel
        {
            const F own(f);
            #pragma omp for schedule(static)
            for (int c = 0; c < sumChunks; ++c) chunk(own, c);
        }
    });
    double total[N] = {};
    for (int c = 0; c < sumChunks; ++c) for (int k = 0; k < N; ++k) total[k] += partial[c*N + k];
    profiled(context, G::name, [&] { finish(total); });
}
#else
template<int N, class F, class G> void sumRowsThen(Context<Cpu>&, int, const F&, double*, const G&);
#endif
} // namespace riprap

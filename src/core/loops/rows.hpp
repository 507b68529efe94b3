/*  Launches on the CPU whose items are rows of cells, which registers take several at a time: a few
    dozen of them are work enough for two threads.

    What is chosen between by a condition is found before, in arrays of its own: compilers do not
    speculate on arithmetic that may trap, and would take such a loop one by one.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/loops/deviceReduce.hpp"

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
void forEachRow(Context<Cpu>& context, int n, const F& f) { forEach(context, n, f, fewRows); }

template<int N, class F, class G>
void sumRowsThen(Context<Cpu>& context, int n, const F& f, double* partial, const G& finish)
{
    sumThen<N>(context, n, f, partial, finish, fewRows);
}

#else
template<int N, class F, class G> void sumRowsThen(Context<Cpu>&, int, const F&, double*, const G&);
#endif
} // namespace riprap

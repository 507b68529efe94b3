/*  Those of n that a functor wants, brought to the host: f.wanted(i) and f.put(i, k), which writes
    number k of them.

    Their order is chance. Two passes: so many are counted first.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/launch.hpp"

namespace riprap
{

template<class F>
struct CountWanted
{
    static constexpr const char* name = "countWanted";
    F f;

    HD void add(int i, double* sums) const { sums[0] += f.wanted(i) ? 1 : 0; }
};

template<class F>
struct PutWanted
{
    static constexpr const char* name = "putWanted";
    F f;
    unsigned* count;

    HD void operator()(int i) const
    {
        if (!f.wanted(i)) return;
        unsigned k = 0;
#ifdef __CUDA_ARCH__
        k = atomicAdd(count, 1u);
#else
        k = __atomic_fetch_add(count, 1u, __ATOMIC_RELAXED);
#endif
        f.put(i, int(k));
    }
};

//- make(m) gives the functor room for m of them. \return m
template<class Backend, class F, class Make>
int collect(Context<Backend>& context, int n, const F& f, const Make& make)
{
    const int m = int(sumOver<1>(context, n, CountWanted<F>{f})[0]);
    if (!m) return 0;
    Array<Backend, unsigned> count;
    count.upload(context, std::vector<unsigned>(1, 0));
    forEach(context, n, PutWanted<F>{make(m), count.data()});
    return m;
}

} // namespace riprap

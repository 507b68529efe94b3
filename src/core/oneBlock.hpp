/*  Work small enough for one block of the GPU: several passes in one launch, with barriers in between.

    A functor with `static constexpr const char* name` and `HD void operator()(const Team&) const`. A pass over n items is
    team.each(n, f); the team waits for all of its members after it. On the CPU the team is one thread.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/launch.hpp"

namespace riprap
{

struct Team
{
    int index = 0, size = 1;

    HD void wait() const
    {
#ifdef __CUDA_ARCH__
        __syncthreads();
#endif
    }

    template<class F>
    HD void each(int n, const F& f) const
    {
        for (int i = index; i < n; i += size) f(i);
        wait();
    }
};

#ifdef __CUDACC__

static constexpr int teamThreads = 1024;

template<class F>
__global__ void __launch_bounds__(teamThreads) oneBlockKernel(F f)
{
    Team team;
    team.index = int(threadIdx.x);
    team.size = teamThreads;
    f(team);
}

template<class F>
void oneBlock(Context<Gpu>& context, const F& f)
{
    profiled(context, F::name, [&] { oneBlockKernel<<<1, teamThreads, 0, context.stream>>>(f); });
}

#else

template<class F>
void oneBlock(Context<Cpu>& context, const F& f)
{
    profiled(context, F::name, [&] { f(Team{}); });
}

#endif

} // namespace riprap

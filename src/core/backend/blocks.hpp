/*  Work by blocks of threads that share memory.

    A functor with `static constexpr const char* name`, `static constexpr int threads`, a type
    Shared without constructors and `HD void operator()(const Team&, Shared&, int block) const`, and
    perhaps `residentBlocks` (launch.hpp). Every thread of a team must come to each of its waits. On
    the CPU a block is one thread's work, and a team has one member.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/singleBlock.hpp"

namespace riprap
{

#ifdef __CUDACC__

template<class F>
__global__ void __launch_bounds__(F::threads) blocksKernel(F f)
{
    __shared__ typename F::Shared shared;
    Team team;
    team.index = int(threadIdx.x);
    team.size = F::threads;
    f(team, shared, int(blockIdx.x));
}

//- Registers held to what so many blocks on a processor leave to each
template<int resident, class F>
__global__ void __launch_bounds__(F::threads, resident) blocksResident(F f)
{
    __shared__ typename F::Shared shared;
    Team team;
    team.index = int(threadIdx.x);
    team.size = F::threads;
    f(team, shared, int(blockIdx.x));
}

template<class F>
void forEachBlock(Context<Gpu>& context, int blocks, const F& f)
{
    if (blocks <= 0) return;
    profiled(context, F::name, [&]
    {
        constexpr int resident = ResidentBlocks<F>::value;
        if constexpr (resident > 0)
            blocksResident<resident><<<blocks, F::threads, 0, context.stream>>>(f);
        else blocksKernel<<<blocks, F::threads, 0, context.stream>>>(f);
    });
}

#else

template<class F>
void forEachBlock(Context<Cpu>& context, int blocks, const F& f)
{
    if (blocks <= 0) return;
    profiled(context, F::name, [&]
    {
        #pragma omp parallel
        {
            const F own(f);
            typename F::Shared shared;
            #pragma omp for schedule(static)
            for (int b = 0; b < blocks; ++b) own(Team{}, shared, b);
        }
    });
}

#endif

} // namespace riprap

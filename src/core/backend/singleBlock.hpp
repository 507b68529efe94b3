/*  Work small enough for one block of the GPU: several passes in one launch, with barriers in
    between.

    A functor with `static constexpr const char* name` and `HD void operator()(const Team&) const`,
    or `(const Team&, float* memory)` with memory of the team's own, which is near. A pass over n
    items is team.each(n, f); the team waits for all of its members after it. On the CPU the team is
    one thread.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/launch.hpp"

namespace riprap
{

struct Team
{
    static constexpr int warp = 32;
    int index = 0, size = 1;
    bool few = false;           // of one warp

    HD void wait() const
    {
#ifdef __CUDA_ARCH__
        if (few) __syncwarp();
        else __syncthreads();
#endif
    }

    //- f(team of a warp), for which the others wait: cheaper where there is little to do
    template<class F>
    HD void byOneWarp(const F& f) const
    {
        if (index < warp) f(Team{index, size < warp ? size : warp, true});
        wait();
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

template<int threads, class F>
__global__ void __launch_bounds__(threads) singleBlockKernel(F f)
{
    Team team;
    team.index = int(threadIdx.x);
    team.size = threads;
    f(team);
}

template<int threads = teamThreads, class F>
void singleBlock(Context<Gpu>& context, const F& f)
{
    profiled(context, F::name,
        [&] { singleBlockKernel<threads><<<1, threads, 0, context.stream>>>(f); });
}

static constexpr int nearThreads = 512;

template<class F>
__global__ void __launch_bounds__(nearThreads) singleBlockNearKernel(F f)
{
    extern __shared__ float teamMemory[];
    Team team;
    team.index = int(threadIdx.x);
    team.size = nearThreads;
    f(team, teamMemory);
}

//- Floats that a team may have near
inline int nearRoom(Context<Gpu>&)
{
    int device = 0, bytes = 0;
    checkCuda(cudaGetDevice(&device), "device");
    checkCuda(cudaDeviceGetAttribute(&bytes, cudaDevAttrMaxSharedMemoryPerBlockOptin, device),
        "shared memory");
    return bytes/int(sizeof(float));
}

//- floats: at most nearRoom(). Each unit has a kernel of its own, which must be allowed the memory:
//  asked for where it is launched, so that linking cannot take the two from different units
template<class F>
void singleBlock(Context<Gpu>& context, const F& f, int floats)
{
    const int most = nearRoom(context)*int(sizeof(float));
    profiled(context, F::name, [&]
    {
        const auto kernel = &singleBlockNearKernel<F>;
        checkCuda(cudaFuncSetAttribute(kernel, cudaFuncAttributeMaxDynamicSharedMemorySize, most),
            F::name);
        kernel<<<1, nearThreads, floats*sizeof(float), context.stream>>>(f);
    });
}

#else

template<class F>
void singleBlock(Context<Cpu>& context, const F& f)
{
    profiled(context, F::name, [&] { f(Team{}); });
}

inline int nearRoom(Context<Cpu>&) { return 1 << 16; }

template<class F>
void singleBlock(Context<Cpu>& context, const F& f, int floats)
{
    std::vector<float> memory(floats);
    profiled(context, F::name, [&] { f(Team{}, memory.data()); });
}

#endif

} // namespace riprap

/*  forEach and sums over particles: the one place where kernels start.

    A kernel is a functor with `static constexpr const char* name` and `HD void operator()(int i)
    const`; on the GPU blocks are of 256 threads; `static constexpr int residentBlocks` asks for so
    many of 128 threads on a processor at a time.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <array>
#include <type_traits>
#include "core/backend/backend.hpp"
#ifndef __CUDACC__
    #include <omp.h>
#endif

namespace riprap
{

//- Largest values that a pass over pairs may report
static constexpr int maximaCount = 4;

#ifdef __CUDACC__

template<class F>
__global__ void __launch_bounds__(256) forEachKernel(int n, const OF_THE_GRID F f)
{
    const int i = blockIdx.x*256 + threadIdx.x;
    if (i < n) f(i);
}

//- For kernels that wait for memory: registers are held to what so many blocks leave to each. Small
//  blocks share a small scene out evenly
static constexpr int residentThreads = 128;

template<int blocks, class F>
__global__ void __launch_bounds__(residentThreads, blocks) forEachResident(
    int n, const OF_THE_GRID F f)
{
    const int i = blockIdx.x*residentThreads + threadIdx.x;
    if (i < n) f(i);
}

template<class F, class = void> struct ResidentBlocks { static constexpr int value = 0; };
template<class F> struct ResidentBlocks<F, std::void_t<decltype(F::residentBlocks)>>
{
    static constexpr int value = F::residentBlocks;
};

//- Runs a launch under the profile: counted, and timed when asked
template<class Launch>
void profiled(Context<Gpu>& context, const char* name, Launch launch)
{
    context.profile.count(name);
    const bool timing = context.profile.timing && !context.profile.capturing;
    if (timing) checkCuda(cudaEventRecord(context.start, context.stream), name);
    launch();
    checkCuda(cudaGetLastError(), name);
    if (timing)
    {
        float ms = 0;
        checkCuda(cudaEventRecord(context.stop, context.stream), name);
        checkCuda(cudaEventSynchronize(context.stop), name);
        checkCuda(cudaEventElapsedTime(&ms, context.start, context.stop), name);
        context.profile.addTime(name, 1e-3*ms);
    }
}

template<class F>
void forEach(Context<Gpu>& context, int n, const F& f)
{
    if (n <= 0) return;
    profiled(context, F::name, [&]
    {
        constexpr int resident = ResidentBlocks<F>::value;
        constexpr int threads = residentThreads;
        if constexpr (resident > 0)
            forEachResident<resident>
                <<<(n + threads - 1)/threads, threads, 0, context.stream>>>(n, f);
        else forEachKernel<<<(n + 255)/256, 256, 0, context.stream>>>(n, f);
    });
}

#endif

#ifndef __CUDACC__

template<class Launch>
void profiled(Context<Cpu>& context, const char* name, Launch launch)
{
    context.profile.count(name);
    const double start = context.profile.timing ? omp_get_wtime() : 0;
    launch();
    if (context.profile.timing) context.profile.addTime(name, omp_get_wtime() - start);
}

//- By one thread. Compiled once for all that call it: kernels are most of what there is to compile
template<class F>
[[gnu::noinline]] void eachOf(const F& f, int from, int end)
{
    // of this thread: nothing that f writes can be thought to alias it
    const F own(f);
    for (int i = from; i < end; ++i) own(i);
}

//- few: so many are done by one thread: a team, even of one, costs more
template<class F>
void forEach(Context<Cpu>& context, int n, const F& f, int few = 256)
{
    if (n <= 0) return;
    profiled(context, F::name, [&]
    {
        if (n <= few) return eachOf(f, 0, n);
        #pragma omp parallel
        {
            // as schedule(static) would
            const int threads = omp_get_num_threads(), t = omp_get_thread_num(),
                      each = n/threads, more = n % threads,
                      from = t*each + std::min(t, more);
            eachOf(f, from, from + each + (t < more));
        }
    });
}

#endif

#ifndef __CUDACC__

//- f(t) for a few large tasks, whichever thread is free. What a task writes must not depend on the
//  others
template<class F>
void forEachTask(Context<Cpu>& context, int tasks, const F& f)
{
    if (tasks <= 0) return;
    profiled(context, F::name, [&]
    {
        if (tasks == 1) return eachOf(f, 0, 1);
        #pragma omp parallel for schedule(dynamic, 1)
        for (int t = 0; t < tasks; ++t) eachOf(f, t, t + 1);
    });
}

#endif

//- Sums of N doubles over particles: f.add(i, sums). Fixed chunks, so that the result does not
//  depend on the number of threads; partial sums are added on the host in order.
static constexpr int sumChunks = 256, sumBlocks = 1024;     // on the CPU, on the GPU

#ifdef __CUDACC__

template<int N, class F>
__global__ void __launch_bounds__(256) sumKernel(int n, F f, double* partial)
{
    double sums[N] = {};
    for (int i = blockIdx.x*256 + threadIdx.x; i < n; i += gridDim.x*256) f.add(i, sums);
    __shared__ double shared[256];
    for (int k = 0; k < N; ++k)
    {
        shared[threadIdx.x] = sums[k];
        __syncthreads();
        for (int o = 128; o > 0; o /= 2)
        {
            if (int(threadIdx.x) < o) shared[threadIdx.x] += shared[threadIdx.x + o];
            __syncthreads();
        }
        if (threadIdx.x == 0) partial[blockIdx.x*N + k] = shared[0];
        __syncthreads();
    }
}

template<int N, class F>
std::array<double, N> sumOver(Context<Gpu>& context, int n, const F& f)
{
    double* partial = context.parts(sumBlocks*N);
    profiled(context, F::name,
        [&] { sumKernel<N><<<sumBlocks, 256, 0, context.stream>>>(n, f, partial); });
    double host[sumBlocks*N];
    context.toHost(host, partial, sizeof(host));
    std::array<double, N> total{};
    for (int c = 0; c < sumBlocks; ++c) for (int k = 0; k < N; ++k) total[k] += host[c*N + k];
    return total;
}

#else

template<int N, class F>
std::array<double, N> sumOver(Context<Cpu>& context, int n, const F& f)
{
    std::vector<double> partial(sumChunks*N, 0.0);
    profiled(context, F::name, [&]
    {
        #pragma omp parallel for schedule(static)
        for (int c = 0; c < sumChunks; ++c)
        {
            const int begin = int((long long)n*c/sumChunks),
                      end = int((long long)n*(c + 1)/sumChunks);
            double sums[N] = {};
            for (int i = begin; i < end; ++i) f.add(i, sums);
            for (int k = 0; k < N; ++k) partial[c*N + k] = sums[k];
        }
    });
    std::array<double, N> total{};
    for (int c = 0; c < sumChunks; ++c) for (int k = 0; k < N; ++k) total[k] += partial[c*N + k];
    return total;
}

#endif

} // namespace riprap

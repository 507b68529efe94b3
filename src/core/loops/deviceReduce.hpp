/*  Sums that stay on the device: sumThen(n, f, partial, finish) adds f.add(i, sums) over i and
    hands the totals to finish(totals), which one thread of the device runs. What follows may read
    what it wrote, without the host.

    Fixed chunks, added in a fixed order: the same bits whatever the number of threads.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/launch.hpp"

namespace riprap
{

//- Parts of a sum on the GPU, at most
static constexpr int deviceSumParts = 1024;

//- Doubles that the sum of so many numbers needs, zero before the first
constexpr int deviceReduceRoom(int numbers) { return numbers*deviceSumParts + 1; }

#ifdef __CUDACC__

//- Of a block of 256: thread 0 has them afterwards
template<int N>
__device__ void sumBlock(double (&shared)[N][256], double (&sums)[N])
{
    const int t = int(threadIdx.x);
    for (int k = 0; k < N; ++k) shared[k][t] = sums[k];
    for (int o = 128; o > 16; o /= 2)
    {
        __syncthreads();
        if (t < o) for (int k = 0; k < N; ++k) shared[k][t] += shared[k][t + o];
    }
    if (t >= 32) return;
    __syncwarp();
    for (int k = 0; k < N; ++k)
    {
        sums[k] = shared[k][t];
        for (int o = 16; o > 0; o /= 2) sums[k] += __shfl_down_sync(0xffffffffu, sums[k], o);
    }
}

//- The block that comes last adds what the blocks have left, in their order. The first double of
//  partial counts them, and is zero again at the end
template<int N, class F, class G>
__global__ void __launch_bounds__(256) sumThenKernel(int n, F f, double* partial, G finish)
{
    __shared__ double shared[N][256];
    __shared__ bool last;
    double* const parts = partial + 1;
    double sums[N] = {};
    for (int i = blockIdx.x*256 + threadIdx.x; i < n; i += gridDim.x*256) f.add(i, sums);
    sumBlock<N>(shared, sums);
    if (threadIdx.x == 0)
    {
        for (int k = 0; k < N; ++k) parts[blockIdx.x*N + k] = sums[k];
        __threadfence();
        last = atomicInc(reinterpret_cast<unsigned*>(partial), gridDim.x - 1) == gridDim.x - 1;
    }
    __syncthreads();
    if (!last) return;
    __threadfence();
    for (int k = 0; k < N; ++k)
    {
        const auto part = [&](int j)
        {
            const int b = int(threadIdx.x) + 256*j;
            return b < int(gridDim.x) ? __ldcg(parts + b*N + k) : 0.0;
        };
        sums[k] = (part(0) + part(2)) + (part(1) + part(3));
    }
    static_assert(deviceSumParts == 4*256, "four parts a thread");
    sumBlock<N>(shared, sums);
    if (threadIdx.x == 0) finish(sums);
}

//- partial: deviceReduceRoom(N) doubles
template<int N, class F, class G>
void sumThen(Context<Gpu>& context, int n, const F& f, double* partial, const G& finish)
{
    const int wanted = (n + 255)/256,
              blocks = wanted < 1 ? 1
        : wanted < deviceSumParts ? wanted
                                  : deviceSumParts;
    profiled(context, F::name,
        [&] { sumThenKernel<N><<<blocks, 256, 0, context.stream>>>(n, f, partial, finish); });
}

#else

//- few: so many are done by one thread: a team costs more
template<int N, class F, class G>
void sumThen(Context<Cpu>& context, int n, const F& f, double* partial, const G& finish,
    int few = 4*sumChunks)
{
    profiled(context, F::name,
        [&]
        {
            const auto chunk = [&](const F& own, int c)
            {
                const int begin = int((long long)n*c/sumChunks),
                          end = int((long long)n*(c + 1)/sumChunks);
                double sums[N] = {};
                for (int i = begin; i < end; ++i) own.add(i, sums);
                for (int k = 0; k < N; ++k) partial[c*N + k] = sums[k];
            };
            if (n <= few)
            {
                const F own(f);
                for (int c = 0; c < sumChunks; ++c) chunk(own, c);
            }
            else
            {
            #pragma omp parallel
                {
                    const F own(f);
                #pragma omp for schedule(static)
                    for (int c = 0; c < sumChunks; ++c) chunk(own, c);
                }
            }
        });
    double total[N] = {};
    for (int c = 0; c < sumChunks; ++c) for (int k = 0; k < N; ++k) total[k] += partial[c*N + k];
    finish(total);
}

#endif

} // namespace riprap

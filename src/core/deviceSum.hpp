/*  Sums that stay on the device: sumThen(n, f, partial, finish) adds f.add(i, sums) over i and hands the totals to
    finish(totals), which one thread of the device runs. What follows may read what it wrote, without the host.

    Fixed chunks, added in a fixed order: the same bits whatever the number of threads.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/launch.hpp"

namespace riprap
{

//- Doubles that a sum of one number needs; of N numbers, N times as many
static constexpr int deviceSumParts = 1024;

#ifdef __CUDACC__

template<int N, class G>
__global__ void __launch_bounds__(deviceSumParts) finishSumKernel(const double* partial, G finish)
{
    __shared__ double shared[deviceSumParts];
    double total[N];
    for (int k = 0; k < N; ++k)
    {
        shared[threadIdx.x] = partial[threadIdx.x*N + k];
        __syncthreads();
        for (int o = deviceSumParts/2; o > 0; o /= 2)
        {
            if (int(threadIdx.x) < o) shared[threadIdx.x] += shared[threadIdx.x + o];
            __syncthreads();
        }
        total[k] = shared[0];
        __syncthreads();
    }
    if (threadIdx.x == 0) finish(total);
}

//- partial: room for N*deviceSumParts doubles
template<int N, class F, class G>
void sumThen(Context<Gpu>& context, int n, const F& f, double* partial, const G& finish)
{
    profiled(context, F::name, [&] { sumKernel<N><<<deviceSumParts, 256, 0, context.stream>>>(n, f, partial); });
    profiled(context, G::name, [&] { finishSumKernel<N><<<1, deviceSumParts, 0, context.stream>>>(partial, finish); });
}

#else

template<int N, class F, class G>
void sumThen(Context<Cpu>& context, int n, const F& f, double* partial, const G& finish)
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
        if (n <= 4*sumChunks)           // a team costs more than these
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
    profiled(context, G::name, [&] { finish(total); });
}

#endif

} // namespace riprap

/*  The largest of a number over particles or cells: f.value(i), not below 0. A maximum does not depend on the order.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/launch.hpp"

namespace riprap
{

#ifdef __CUDACC__

template<class F>
__global__ void __launch_bounds__(256) largestKernel(int n, F f, double* partial)
{
    double most = 0;
    for (int i = blockIdx.x*256 + threadIdx.x; i < n; i += gridDim.x*256)
    {
        const double value = f.value(i);
        if (!(value <= most)) most = value;             // a NaN stays
    }
    __shared__ double shared[256];
    shared[threadIdx.x] = most;
    __syncthreads();
    for (int o = 128; o > 0; o /= 2)
    {
        if (int(threadIdx.x) < o && !(shared[threadIdx.x + o] <= shared[threadIdx.x])) shared[threadIdx.x] = shared[threadIdx.x + o];
        __syncthreads();
    }
    if (threadIdx.x == 0) partial[blockIdx.x] = shared[0];
}

template<class F>
double largestOver(Context<Gpu>& context, int n, const F& f)
{
    double* partial = context.parts(sumBlocks);
    profiled(context, F::name, [&] { largestKernel<<<sumBlocks, 256, 0, context.stream>>>(n, f, partial); });
    double host[sumBlocks], most = 0;
    context.toHost(host, partial, sizeof(host));
    for (const double value : host) if (!(value <= most)) most = value;
    return most;
}

#else

template<class F>
double largestOver(Context<Cpu>& context, int n, const F& f)
{
    std::vector<double> partial(sumChunks, 0.0);
    profiled(context, F::name, [&]
    {
        #pragma omp parallel for schedule(static)
        for (int c = 0; c < sumChunks; ++c)
        {
            const int begin = int((long long)n*c/sumChunks), end = int((long long)n*(c + 1)/sumChunks);
            double most = 0;
            for (int i = begin; i < end; ++i)
            {
                const double value = f.value(i);
                if (!(value <= most)) most = value;     // a NaN stays
            }
            partial[c] = most;
        }
    });
    double most = 0;
    for (const double value : partial) if (!(value <= most)) most = value;
    return most;
}

#endif

} // namespace riprap

/*  The largest of a number over particles or cells: f.value(i), not below 0. A maximum does not
    depend on the order.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/launch.hpp"

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
        if (int(threadIdx.x) < o && !(shared[threadIdx.x + o] <= shared[threadIdx.x]))
            shared[threadIdx.x] = shared[threadIdx.x + o];
        __syncthreads();
    }
    if (threadIdx.x == 0) partial[blockIdx.x] = shared[0];
}

//- Of so many partial results; one needs no more than a block
inline int largestBlocks(int n) { return n > 256*sumBlocks ? sumBlocks : (n + 255)/256; }

template<class F>
double reduceMax(Context<Gpu>& context, int n, const F& f)
{
    if (n <= 0) return 0;
    const int blocks = largestBlocks(n);
    double* partial = context.parts(sumBlocks);
    profiled(context, F::name,
        [&] { largestKernel<<<blocks, 256, 0, context.stream>>>(n, f, partial); });
    double host[sumBlocks], most = 0;
    context.toHost(host, partial, blocks*sizeof(double));
    for (int b = 0; b < blocks; ++b) if (!(host[b] <= most)) most = host[b];
    return most;
}

//- The same, asked for while the device goes on, and taken later
class LargestAhead
{
public:
    LargestAhead() = default;
    LargestAhead(const LargestAhead&) = delete;
    ~LargestAhead()
    {
        if (!partial_) return;
        cudaEventDestroy(done_);
        cudaFreeHost(partial_);
    }

    bool asked() const { return asked_; }

    template<class F>
    void ask(Context<Gpu>& context, int n, const F& f)
    {
        if (!partial_)
        {
            checkCuda(cudaMallocHost(&partial_, sumBlocks*sizeof(double)), "pinned memory");
            checkCuda(cudaEventCreateWithFlags(&done_, cudaEventDisableTiming), "event");
        }
        blocks_ = largestBlocks(n);
        asked_ = true;
        if (!blocks_) return;
        double* partial = context.parts(sumBlocks);
        profiled(context, F::name,
            [&] { largestKernel<<<blocks_, 256, 0, context.stream>>>(n, f, partial); });
        checkCuda(cudaMemcpyAsync(partial_, partial, blocks_*sizeof(double),
                      cudaMemcpyDeviceToHost, context.stream),
            "copy");
        checkCuda(cudaEventRecord(done_, context.stream), "event");
    }

    double take()
    {
        asked_ = false;
        if (!blocks_) return 0;
        checkCuda(cudaEventSynchronize(done_), "kernel");
        double most = 0;
        for (int b = 0; b < blocks_; ++b) if (!(partial_[b] <= most)) most = partial_[b];
        return most;
    }

private:
    double* partial_ = nullptr;
    cudaEvent_t done_ = {};
    int blocks_ = 0;
    bool asked_ = false;
};

#else

template<class F>
double reduceMax(Context<Cpu>& context, int n, const F& f)
{
    std::vector<double> partial(sumChunks, 0.0);
    profiled(context, F::name, [&]
    {
        #pragma omp parallel for schedule(static)
        for (int c = 0; c < sumChunks; ++c)
        {
            const int begin = int((long long)n*c/sumChunks),
                      end = int((long long)n*(c + 1)/sumChunks);
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

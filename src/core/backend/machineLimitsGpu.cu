// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/backend/machineLimits.hpp"

#include <algorithm>
#include <vector>

namespace riprap
{

namespace
{

constexpr int repeats = 5;

//- Shortest time of several launches [s], after one to warm up
template<class Launch>
double shortestTime(Context<Gpu>& context, const Launch& launch)
{
    float best = 1e30f;
    for (int r = 0; r <= repeats; ++r)
    {
        checkCuda(cudaEventRecord(context.start, context.stream), "event");
        launch();
        checkCuda(cudaGetLastError(), "machine limits");
        checkCuda(cudaEventRecord(context.stop, context.stream), "event");
        checkCuda(cudaEventSynchronize(context.stop), "machine limits");
        float ms = 0;
        checkCuda(cudaEventElapsedTime(&ms, context.start, context.stop), "event");
        if (r > 0) best = std::min(best, ms);
    }
    return 1e-3*best;
}

__global__ void __launch_bounds__(256)
    triadKernel(double2* a, const double2* b, const double2* c, int n)
{
    const int i = blockIdx.x*256 + threadIdx.x;
    if (i >= n) return;
    const double2 p = b[i], q = c[i];
    a[i] = make_double2(p.x + 3.0*q.x, p.y + 3.0*q.y);
}

template<class Real>
__global__ void __launch_bounds__(256) fmaKernel(Real* out, Real factor, Real term, int length)
{
    constexpr int chains = 8;
    Real x[chains];
    for (int k = 0; k < chains; ++k) x[k] = Real(threadIdx.x + k);
    #pragma unroll 16
    for (int i = 0; i < length; ++i)
    {
        #pragma unroll
        for (int k = 0; k < chains; ++k) x[k] = x[k]*factor + term;
    }
    Real sum = 0;
    for (int k = 0; k < chains; ++k) sum += x[k];
    // never so, but the compiler cannot know
    if (sum == Real(-1)) out[blockIdx.x] = sum;
}

//- One thread a particle; lists as NeighbourList lays them out
__global__ void __launch_bounds__(128, 8) gatherKernel
(const uint4* lists, const float4* a, const float4* b, int perParticle, float* out)
{
    const int i = blockIdx.x*128 + threadIdx.x;
    const uint4* entry = lists + std::size_t(i >> 5)*(perParticle/4)*32 + (i & 31);
    float sum = 0;
    for (int k = 0; k < perParticle; k += 4, entry += 32)
    {
        const uint4 q = *entry;
        const unsigned j[4] = {q.x, q.y, q.z, q.w};
        #pragma unroll
        for (int e = 0; e < 4; ++e)
        {
            const float4 p = a[j[e]], v = b[j[e]];
            sum += p.x + p.y + p.z + p.w + v.x + v.y + v.z + v.w;
        }
    }
    out[i] = sum;
}

} // namespace

double triadBandwidth(Gpu)
{
    constexpr int n = 1 << 25;          // 512 MB an array: ten times an L2 cache
    Context<Gpu> context;
    Array<Gpu, double2> a, b, c;
    for (auto* array : {&a, &b, &c}) array->allocate(context, n);
    const double time = shortestTime(context, [&]
    { triadKernel<<<n/256, 256, 0, context.stream>>>(a.data(), b.data(), c.data(), n); });
    return 48.0*n/time;
}

template<class Real>
double fmaPeak(Gpu)
{
    constexpr int blocks = 132*32, length = 4096;
    Context<Gpu> context;
    Array<Gpu, Real> out;
    out.allocate(context, blocks);
    const double time = shortestTime(context,
        [&]
        {
            fmaKernel<Real>
                <<<blocks, 256, 0, context.stream>>>(out.data(), Real(0.999), Real(0.001), length);
        });
    return 2.0*8*length*256*blocks/time;
}

template double fmaPeak<float>(Gpu);
template double fmaPeak<double>(Gpu);

double gatherRate(Gpu)
{
    // the 4 x 4 x 4 lattice sites around each of 2^20 particles, cells and particles x fastest
    constexpr int side = 128, layers = 64, n = side*side*layers, perParticle = 64;
    std::vector<std::uint32_t> lists(std::size_t(n)*perParticle);
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < perParticle; ++k)
        {
            const int offset = (k%4 - 2) + side*((k/4)%4 - 2) + side*side*(k/16 - 2);
            const std::size_t entry = (std::size_t(i >> 5)*(perParticle/4) + k/4)*32 + (i & 31);
            lists[4*entry + k%4] = std::uint32_t((i + offset + n)%n);
        }
    Context<Gpu> context;
    Array<Gpu, std::uint32_t> device;
    Array<Gpu, float4> a, b;
    Array<Gpu, float> out;
    device.upload(context, lists);
    a.allocate(context, n);
    b.allocate(context, n);
    out.allocate(context, n);
    const double time = shortestTime(context,
        [&]
        {
            gatherKernel<<<n/128, 128, 0, context.stream>>>(
                reinterpret_cast<const uint4*>(device.data()), a.data(), b.data(), perParticle,
                out.data());
        });
    return double(n)*perParticle/time;
}

} // namespace riprap

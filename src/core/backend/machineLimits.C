// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/backend/machineLimits.hpp"

#include <algorithm>
#include <omp.h>
#include "core/simd/pack.hpp"

namespace riprap
{

namespace
{

constexpr int repeats = 5;

template<class Work>
double shortestTime(const Work& work)
{
    double best = 1e30;
    for (int r = 0; r < repeats; ++r)
    {
        const double start = omp_get_wtime();
        work();
        best = std::min(best, omp_get_wtime() - start);
    }
    return best;
}

} // namespace

double triadBandwidth(Cpu)
{
    // 1.5 GB in all: beyond the last-level caches of today's servers
    constexpr std::size_t n = std::size_t(1) << 26;
    Context<Cpu> context;
    double* memory[3];
    for (double*& m : memory) m = static_cast<double*>(context.allocate(n*sizeof(double)));
    double *a = memory[0], *b = memory[1], *c = memory[2];
    // first touched by the thread that works on it
    #pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < n; ++i) { a[i] = 0; b[i] = 1; c[i] = double(i); }
    const double time = shortestTime([&]
    {
        #pragma omp parallel for simd schedule(static)
        for (std::size_t i = 0; i < n; ++i) a[i] = b[i] + 3.0*c[i];
    });
    for (double* m : memory) context.release(m);
    return 24.0*n/time;
}

template<class Real>
double fmaPeak(Cpu)
{
    using T = Pack<Real>;
    constexpr int chains = 10;          // enough to hide the latency of two units
    constexpr int length = 2000000;
    int threads = 1;
    Real kept = 0;
    const double time = shortestTime([&]
    {
        #pragma omp parallel reduction(+:kept)
        {
            #pragma omp single
            threads = omp_get_num_threads();
            T x[chains];
            for (int k = 0; k < chains; ++k) x[k] = T(Real(k + 1));
            T factor(Real(0.999)), term(Real(0.001));
            // opaque, so that nothing is computed before the program runs
            asm volatile("" : "+x"(factor.v), "+x"(term.v));
            for (int i = 0; i < length; ++i)
                for (int k = 0; k < chains; ++k) x[k] = x[k]*factor + term;
            for (int k = 0; k < chains; ++k) kept += sumLanes(x[k]);
        }
    });
    volatile Real sink = kept;
    (void)sink;
    return 2.0*T::width*chains*double(length)*threads/time;
}

template double fmaPeak<float>(Cpu);
template double fmaPeak<double>(Cpu);

#ifndef RIPRAP_CUDA
double triadBandwidth(Gpu) { return 0; }
template<class Real> double fmaPeak(Gpu) { return 0; }
template double fmaPeak<float>(Gpu);
template double fmaPeak<double>(Gpu);
double gatherRate(Gpu) { return 0; }
#endif

} // namespace riprap

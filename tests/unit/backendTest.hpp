/*  What tests of device code share. A body stands in x.hpp, once; x.C compiles it for the Cpu,
    xGpu.cu for the Gpu.

    Everything is in unnamed namespaces or templated on the backend: both units are linked into one
    program. Tests are typed over Case<Backend, D, P> and called e.g. Box/Cpu2Mixed.RoundTrip;
    without a GPU those of the Gpu are skipped, with the reason.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <type_traits>
#include <vector>
#include <gtest/gtest.h>
#include "core/backend/device.hpp"
#include "core/backend/launch.hpp"
#include "core/simd/precision.hpp"
#ifndef __CUDACC__
    #include <omp.h>
#endif

namespace riprap
{
namespace
{

#ifdef __CUDACC__
using Backend = Gpu;
#else
using Backend = Cpu;
#endif

template<int Dim, class Precision>
struct Case
{
    static constexpr int D = Dim;
    using P = Precision;
    using real = typename P::real;
    static constexpr bool mixed = sizeof(real) == 4;
    // half a unit in the last place
    static constexpr double epsilon = mixed ? 5.9604644775390625e-8 : 1.1102230246251565e-16;
};

using AllCases = testing::Types<Case<2, Mixed>, Case<2, Double>, Case<3, Mixed>, Case<3, Double>>;

struct CaseNames
{
    template<class C>
    static std::string GetName(int)
    {
        return std::string(Backend::gpu ? "Gpu" : "Cpu") + char('0' + C::D)
            + (C::mixed ? "Mixed" : "Double");
    }
};

//- Skips where there is no such device
class BackendTest : public testing::Test
{
protected:
    void SetUp() override
    {
        std::string why;
        if (Backend::gpu && !gpuCount(why)) GTEST_SKIP() << why;
    }
};

template<class C>
class BackendCase : public BackendTest
{
};

//- f(i) for i < n on the device; F writes to arrays
template<class F>
void runEach(Context<Backend>& context, int n, const F& f)
{
    forEach(context, n, f);
    context.synchronise();
}

//- Uniform deviates, the same on every machine
class Random
{
public:
    explicit Random(unsigned seed) : engine_(seed) {}
    double operator()(double low, double high)
    {
        return low + (high - low)*(engine_()/4294967296.0);
    }
    std::uint32_t bits() { return std::uint32_t(engine_()); }
private:
    std::mt19937 engine_;
};

//- Runs f with 1, 2 and 3 threads (once where threads mean nothing)
template<class F>
void withThreads(const F& f)
{
#ifdef __CUDACC__
    f(1);
#else
    const int before = omp_get_max_threads();
    for (int threads = 1; threads <= 3; ++threads)
    {
        omp_set_num_threads(threads);
        f(threads);
    }
    omp_set_num_threads(before);
#endif
}

} // namespace
} // namespace riprap

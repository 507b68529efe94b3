/*  The few functions that physics functors need, for float, double and (on the CPU) Pack alike.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cmath>
#include <cstdint>
#include "core/simd/macros.hpp"
#ifndef __CUDACC__
    #include "core/simd/pack.hpp"
#endif

namespace riprap
{

HD float squareRoot(float a) { return sqrtf(a); }
HD double squareRoot(double a) { return sqrt(a); }

//- 1/a, 1/sqrt(a) and sqrt(a/b): in single precision on the GPU an instruction or two, where a
//  division takes eight
HD float inverse(float a) { return 1.0f/a; }
HD double inverse(double a) { return 1.0/a; }
#ifdef __CUDA_ARCH__
HD float inverseRoot(float a) { return rsqrtf(a); }
HD double inverseRoot(double a) { return rsqrt(a); }
HD float rootOfRatio(float a, float b) { return sqrtf(a)*rsqrtf(b); }
#else
HD float inverseRoot(float a) { return 1.0f/sqrtf(a); }
HD double inverseRoot(double a) { return 1.0/sqrt(a); }
HD float rootOfRatio(float a, float b) { return sqrtf(a/b); }
#endif
HD double rootOfRatio(double a, double b) { return sqrt(a/b); }

HD float maximum(float a, float b) { return a > b ? a : b; }
HD double maximum(double a, double b) { return a > b ? a : b; }
HD float minimum(float a, float b) { return a < b ? a : b; }
HD double minimum(double a, double b) { return a < b ? a : b; }
HD float absolute(float a) { return fabsf(a); }
HD double absolute(double a) { return fabs(a); }
HD float selectGreater(float a, float b, float x, float y) { return a > b ? x : y; }
HD double selectGreater(double a, double b, double x, double y) { return a > b ? x : y; }
HD float sumLanes(float a) { return a; }
HD double sumLanes(double a) { return a; }

//- Fixed-point difference a - b (wrapping) as a number of units
HD float wrappedDifference(std::int32_t a, std::int32_t b)
{
    return float(std::int32_t(std::uint32_t(a) - std::uint32_t(b)));
}

//- One value for a scalar T, a register of neighbouring values for a Pack
template<class T, class R>
HD T loadLanes(const R* p)
{
    if constexpr (sizeof(T) == sizeof(R)) return *p;
    else return T::load(p);
}

HD int floorInt(float a) { return int(floorf(a)); }
HD int floorInt(double a) { return int(floor(a)); }

//- a^N by multiplication
template<int N, class T>
HD T power(T a)
{
    if constexpr (N == 0) return T(1);
    else if constexpr (N == 1) return a;
    else if constexpr (N % 2 == 0) { const T b = power<N/2>(a); return b*b; }
    else return a*power<N - 1>(a);
}

} // namespace riprap

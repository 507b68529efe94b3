/*  The lowest of several numbers that threads write to one place, whatever their order.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/simd/macros.hpp"

namespace riprap
{

//- Lowers a number to at most value: numbers of one sign are in the order of their bits, negative
//  ones against it
HD void atomicMinimum(double* at, double value)
{
    value += 0.0;               // no negative zero
#ifdef __CUDA_ARCH__
    const long long bits = __double_as_longlong(value);
    if (value < 0)
        atomicMax(reinterpret_cast<unsigned long long*>(at), static_cast<unsigned long long>(bits));
    else atomicMin(reinterpret_cast<long long*>(at), bits);
#else
    double old;
    __atomic_load(at, &old, __ATOMIC_RELAXED);
    while (old > value
        && !__atomic_compare_exchange(at, &old, &value, true, __ATOMIC_RELAXED, __ATOMIC_RELAXED))
    {}
#endif
}

} // namespace riprap

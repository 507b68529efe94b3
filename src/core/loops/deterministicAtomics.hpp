/*  Writes of several threads to one place, whose outcome does not depend on their order: integers
    only.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstdint>
#include "core/simd/macros.hpp"

namespace riprap
{

//- Sets a flag that others may set too
HD void raise(int* flag)
{
#ifdef __CUDA_ARCH__
    *static_cast<volatile int*>(flag) = 1;
#else
    __atomic_store_n(flag, 1, __ATOMIC_RELAXED);
#endif
}

//- The same where nearly everyone does: who finds it set leaves it alone, since as many writes to
//  one place would wait for each other
HD void raiseOnce(int* flag)
{
#ifdef __CUDA_ARCH__
    if (!*flag) raise(flag);
#else
    if (!__atomic_load_n(flag, __ATOMIC_RELAXED)) raise(flag);
#endif
}

HD void raise(std::int64_t* flag)
{
#ifdef __CUDA_ARCH__
    volatile long long* f = reinterpret_cast<long long*>(flag);
    if (!*f) *f = 1;            // many raise the same one
#else
    __atomic_store_n(flag, std::int64_t(1), __ATOMIC_RELAXED);
#endif
}

//- A number that others may lower meanwhile
HD int sharedRead(const int* at)
{
#ifdef __CUDA_ARCH__
    return *static_cast<const volatile int*>(at);
#else
    return __atomic_load_n(at, __ATOMIC_RELAXED);
#endif
}

//- Writes what others may read meanwhile, and none of them writes
HD void sharedWrite(int* at, int value)
{
#ifdef __CUDA_ARCH__
    *static_cast<volatile int*>(at) = value;
#else
    __atomic_store_n(at, value, __ATOMIC_RELAXED);
#endif
}

//- Lowers a number to at most value; returns what it was
HD int atomicMinimum(int* at, int value)
{
#ifdef __CUDA_ARCH__
    return atomicMin(at, value);
#else
    int old = __atomic_load_n(at, __ATOMIC_RELAXED);
    while (old > value
        && !__atomic_compare_exchange_n(at, &old, value, true, __ATOMIC_RELAXED, __ATOMIC_RELAXED))
    {}
    return old;
#endif
}

//- Raises a number above 0 to at least value; who finds it as high leaves it alone
HD void raiseTo(float* at, float value)
{
#ifdef __CUDA_ARCH__
    if (*static_cast<const volatile float*>(at) < value)
        atomicMax(reinterpret_cast<int*>(at), __float_as_int(value));
#else
    float old;
    __atomic_load(at, &old, __ATOMIC_RELAXED);
    while (old < value
        && !__atomic_compare_exchange(at, &old, &value, true, __ATOMIC_RELAXED, __ATOMIC_RELAXED))
    {}
#endif
}

HD void addShared(std::int64_t* at, std::int64_t value)
{
#ifdef __CUDA_ARCH__
    atomicAdd(reinterpret_cast<unsigned long long*>(at), static_cast<unsigned long long>(value));
#else
    __atomic_fetch_add(at, value, __ATOMIC_RELAXED);
#endif
}

//- The same where threads side by side mostly add to one place: they add up among themselves first,
//  in three parts of the number, each of which has room for a warp's sum
HD void addSharedTogether(std::int64_t* at, std::int64_t value)
{
#if defined(__CUDA_ARCH__) && __CUDA_ARCH__ >= 800
    const unsigned lanes = __activemask();
    int same = 0;
    __match_all_sync(lanes, reinterpret_cast<unsigned long long>(at), &same);
    if (same)
    {
        constexpr unsigned part = 0xffffff;
        const auto v = static_cast<unsigned long long>(value);
        const unsigned long long low = __reduce_add_sync(lanes, unsigned(v) & part),
                                 middle = __reduce_add_sync(lanes, unsigned(v >> 24) & part),
                                 high = __reduce_add_sync(lanes, unsigned(v >> 48));
        if (int(threadIdx.x & 31) == __ffs(int(lanes)) - 1)
            atomicAdd(
                reinterpret_cast<unsigned long long*>(at), low + (middle << 24) + (high << 48));
        return;
    }
#endif
    addShared(at, value);
}

} // namespace riprap

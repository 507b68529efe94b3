/*  Writes of several threads to one place, whose outcome does not depend on their order: integers only.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstdint>
#include "core/macros.hpp"

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

//- A number that others may lower meanwhile
HD int sharedRead(const int* at)
{
#ifdef __CUDA_ARCH__
    return *static_cast<const volatile int*>(at);
#else
    return __atomic_load_n(at, __ATOMIC_RELAXED);
#endif
}

//- Lowers a number to at most value; returns what it was
HD int lowerTo(int* at, int value)
{
#ifdef __CUDA_ARCH__
    return atomicMin(at, value);
#else
    int old = __atomic_load_n(at, __ATOMIC_RELAXED);
    while (old > value && !__atomic_compare_exchange_n(at, &old, value, true, __ATOMIC_RELAXED, __ATOMIC_RELAXED)) {}
    return old;
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

} // namespace riprap

/*  Memory that will be needed later is asked for now. No register waits for it.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/macros.hpp"

namespace riprap
{

HD void prefetch(const void* address)
{
#ifdef __CUDA_ARCH__
    asm volatile("prefetch.global.L2 [%0];" :: "l"(__cvta_generic_to_global(address)));
#else
    __builtin_prefetch(address);
#endif
}

} // namespace riprap

/*  Memory of the CPU's arrays holds NaN until somebody writes it: what is read before, or beyond
    what an array has zeroed, spoils a test.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <cstdlib>
#include <cstring>
#include <gtest/gtest.h>
#include "core/backend/backend.hpp"

//- In place of the C library's
extern "C" void* aligned_alloc(std::size_t alignment, std::size_t bytes) noexcept
{
    void* p = nullptr;
    if (posix_memalign(&p, alignment, bytes) != 0) return nullptr;
    return std::memset(p, 0xff, bytes);
}

namespace riprap
{
namespace
{

TEST(PoisonedMemory, IsNotANumberUntilItIsWritten)
{
    Context<Cpu> context;
    double* p = static_cast<double*>(context.allocate(1000*sizeof(double)));
    for (int i = 0; i < 1004; ++i) EXPECT_NE(p[i], p[i]) << i;
    context.release(p);
}

} // namespace
} // namespace riprap

/*  GPUs by number.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <cmath>
#include <gtest/gtest.h>
#include "core/backend/gpus.hpp"
#include "core/backend/machineMemory.hpp"

namespace riprap
{
namespace
{

TEST(Gpus, NumberThatIsNotThere)
{
    const std::vector<GpuInfo> two{{0, "first", 1, 1}, {1, "second", 1, 1}};
    EXPECT_EQ(gpuFault(0, two, ""), "");
    EXPECT_EQ(gpuFault(1, two, ""), "");
    EXPECT_EQ(gpuFault(2, two, ""), "is 2, and the GPUs of this machine are 0 (first), 1 (second)");
    EXPECT_EQ(gpuFault(0, {}, "there is no GPU"), "is 0, and there is no GPU");
}

TEST(Gpus, EachCanBeTaken)
{
    std::string why;
    const std::vector<GpuInfo> there = gpus(why);
    if (there.empty())
    {
        EXPECT_FALSE(why.empty());
        EXPECT_THROW(gpuInUse(), std::runtime_error);
        GTEST_SKIP() << why;
    }
    for (auto gpu = there.rbegin(); gpu != there.rend(); ++gpu)
    {
        useGpu(gpu->number);
        const GpuInfo taken = gpuInUse();
        EXPECT_EQ(taken.number, gpu->number);
        EXPECT_EQ(taken.name, gpu->name);
        EXPECT_GT(taken.free, 0);
        EXPECT_LE(taken.free, taken.memory);
        // two questions to the driver
        EXPECT_NEAR(taken.memory, gpu->memory, 0.05*gpu->memory);
    }
}

TEST(MachineMemory, FreeIsPartOfAll)
{
    EXPECT_GT(freeMemory(), 0);
    EXPECT_LE(freeMemory(), machineMemory());
    EXPECT_GT(machineMemory(), 1e8);
}

} // namespace
} // namespace riprap

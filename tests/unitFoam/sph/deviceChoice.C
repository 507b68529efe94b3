// SPDX-License-Identifier: GPL-3.0-or-later
/*  Entries device and gpu, and what the log says of them. */

#include "deviceChoice.H"
#include "scratchCase.hpp"
#include "timeWriter.H"
#include "core/backend/gpus.hpp"

#include <cstdlib>
#include <gtest/gtest.h>
#include <omp.h>

using namespace Foam;
using riprap::DeviceKind;

namespace
{
    std::string said(const std::string& text, DeviceKind asked)
    {
        return messageOf([&]() { useDevice(asked, 2, entries(text)); });
    }

    DeviceKind read(const std::string& text)
    {
        const dictionary dict(entries(text));
        checkedDictionary checked(dict);
        return readDevice(checked, DeviceKind::automatic);
    }

    std::string logOf(const std::vector<riprap::ArrayInfo>& arrays)
    {
        testing::internal::CaptureStdout();
        logDevice("a processor", "as asked", DeviceKind::cpu, arrays);
        return testing::internal::GetCapturedStdout();
    }

    //- Threads and their variable are as before in the end
    struct Threads
    {
        const int threads = omp_get_max_threads();
        const std::string variable;

        Threads() : variable(getEnv("OMP_NUM_THREADS")) {}

        ~Threads()
        {
            omp_set_num_threads(threads);
            if (!variable.empty()) setEnv("OMP_NUM_THREADS", variable, true);
        }
    };
}

TEST(DeviceChoice, entries)
{
    EXPECT_EQ(read(""), DeviceKind::automatic);
    EXPECT_EQ(read("device cpu;"), DeviceKind::cpu);
    EXPECT_EQ(read("device gpu; gpu 3;"), DeviceKind::gpu);
    EXPECT_EQ(messageOf([]() { read("device cuda;"); }),
        "Entry device has the unknown word cuda; valid are (auto cpu gpu)");
    EXPECT_EQ(messageOf([]() { read("gpu 1024;"); }),
        "Entry gpu is 1024: it must be from 0 to 1023");
    EXPECT_EQ(messageOf([]() { read("gpu 0.5;"); }), "Entry gpu is 0.5: it must be a whole number");
}

TEST(DeviceChoice, whatIsNotThere)
{
    std::string why;
    const auto there = riprap::gpus(why);
    EXPECT_EQ(said("", DeviceKind::cpu), "");
    EXPECT_EQ(said("", DeviceKind::automatic), "");
    EXPECT_EQ(said("gpu 0;", DeviceKind::cpu),
        "Entry gpu names a GPU, and device is cpu: leave gpu out, or take auto or gpu for device");
    EXPECT_EQ(said("gpu 1023;", DeviceKind::automatic),
        "Entry gpu " + riprap::gpuFault(1023, there, why));
    EXPECT_TRUE(holds(riprap::gpuFault(1023, there, why), "1023"));
    const std::string gpu(said("", DeviceKind::gpu));
    if (there.empty()) { EXPECT_EQ(gpu.find("Entry device: "), 0u) << gpu; }
    else { EXPECT_EQ(gpu, ""); }
}

TEST(DeviceChoice, threadsAndTheLog)
{
    const Threads before;
    setEnv("OMP_NUM_THREADS", "3", true);
    omp_set_num_threads(3);
    leaveCoresToWriting(DeviceKind::gpu);
    EXPECT_EQ(omp_get_max_threads(), 3);
    const std::string log(logOf({{"fluid", "x", 24, 3000000}, {"fluid", "u", 24, 1000000}}));
    EXPECT_TRUE(holds(log, "a processor (as asked)\n")) << log;
    EXPECT_TRUE(holds(log, "3 of the CPU (OMP_NUM_THREADS)\n")) << log;
    EXPECT_TRUE(holds(log, " 4 MB for the case's arrays; the device has ")) << log;

    unsetenv("OMP_NUM_THREADS");
    leaveCoresToWriting(DeviceKind::cpu);
    EXPECT_EQ(omp_get_max_threads(), 3);
    leaveCoresToWriting(DeviceKind::gpu);
    EXPECT_EQ(omp_get_max_threads(),
        std::max(1, omp_get_num_procs() - timeWriter::threadsBeside));
}

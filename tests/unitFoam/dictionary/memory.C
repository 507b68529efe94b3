// SPDX-License-Identifier: GPL-3.0-or-later
/*  What an entry asks for is compared with what there is. */

#include "requireMemory.H"
#include "testTime.H"
#include "error.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    std::string refusal(scalar count, scalar bytes)
    {
        const bool before = FatalIOError.throwExceptions();
        std::string said;
        try
        {
            requireMemory(
                entries(""), "Region tank would hold", count, "particles", bytes, "spacing");
        }
        catch (const IOerror& e)
        {
            said = e.message();
        }
        FatalIOError.throwExceptions(before);
        return said;
    }
}


TEST(Memory, IsComparedWithWhatThereIs)
{
    EXPECT_EQ(refusal(1e6, 1), "");
    EXPECT_NE(refusal(1e6, 1e12).find("about 1e+06 particles, and this machine has memory for 0"),
        std::string::npos)
        << refusal(1e6, 1e12);
}


TEST(Memory, CountsIn32Bits)
{
    EXPECT_EQ(refusal(5e8, 1e-3), "");
    EXPECT_NE(refusal(6e8, 1e-3).find("about 6e+08 particles, and a scene, which counts them in 32 "
                                      "bits, can have 5e+08: is the spacing meant?"),
        std::string::npos)
        << refusal(6e8, 1e-3);
}

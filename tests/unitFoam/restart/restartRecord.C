// SPDX-License-Identifier: GPL-3.0-or-later
/*  What a continued run must know: the same bits come back, and wrong files are told. */

#include "restartRecord.H"
#include "scratchCase.hpp"
#include "StringStream.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    restartRecord record()
    {
        restartRecord r;
        r.time = 0.1 + 0.2;
        r.particles = 123456789;
        r.initialParticles = int64_t(3) << 40;      // more than a label holds
        r.escaped = 17;
        r.outflow = 5;
        r.steps = (int64_t(1) << 53) - 1;
        r.device = "gpu";
        r.precision = "mixed";
        r.domain = scalarList({-1.0/3, 0, 1e-300, 2.0/3, 1, 1e20});
        return r;
    }

    struct Config
    {
        int dimensions = 2, axes[3] = {0, 2, 1};
        double domainMin[3], domainMax[3];
    };
}

TEST(RestartRecord, comesBackToTheBit)
{
    for (const bool domain : {true, false})
    {
        const auto written = record();
        dictionary dict;
        restartRecord r(written);
        if (!domain) r.domain.clear();
        r.write(dict);
        // as it is read from a file that has few digits
        OStringStream os;
        os.precision(6);
        dict.write(os, false);
        restartRecord back;
        back.read(entries(os.str()));
        EXPECT_EQ(back.time, written.time);
        EXPECT_EQ(back.particles, written.particles);
        EXPECT_EQ(back.initialParticles, written.initialParticles);
        EXPECT_EQ(back.escaped, written.escaped);
        EXPECT_EQ(back.outflow, written.outflow);
        EXPECT_EQ(back.steps, written.steps);
        EXPECT_EQ(back.device, written.device);
        EXPECT_EQ(back.precision, written.precision);
        EXPECT_EQ(back.domain, domain ? written.domain : scalarList());
    }
}

TEST(RestartRecord, wrongEntries)
{
    const auto said = [](const word& entry, const std::string& value)
    {
        dictionary dict;
        record().write(dict);
        dict.remove(entry);
        if (!value.empty()) dict.merge(entries(entry + ' ' + value + ';'));
        OStringStream os;
        dict.write(os, false);
        return messageOf([&]() { restartRecord().read(entries(os.str())); });
    };
    EXPECT_EQ(said("none", ""), "");
    EXPECT_EQ(said("outflow", ""), "");                 // of an earlier version
    EXPECT_TRUE(holds(said("steps", ""), "steps"));
    EXPECT_TRUE(holds(said("particles", "-1"), "not what riprapFoam wrote: particles -1"));
    EXPECT_TRUE(holds(said("domain", "\"1 2 3\""), "not what riprapFoam wrote"));
    EXPECT_EQ(said("domain", "\"1 2 x3 4 5 6\""), "Entry domain holds \"x3\", no number");
}

//- Fixed-point numbers of a domain: a continued run goes on in the earlier one if that holds its
//  own
TEST(RestartRecord, domainOfTheRunBefore)
{
    Config before{2, {0, 2, 1}, {-1, 0, -2}, {1, 0, 2}};
    restartRecord r;
    r.setDomain(before);
    Config now{2, {0, 2, 1}, {-0.5, 7, -1}, {0.5, 8, 2}};
    ASSERT_TRUE(r.keepDomain(now));
    EXPECT_EQ(now.domainMin[0], -1);
    EXPECT_EQ(now.domainMax[0], 1);
    EXPECT_EQ(now.domainMin[2], -2);
    EXPECT_EQ(now.domainMax[2], 2);
    EXPECT_EQ(now.domainMin[1], 7);                     // the empty axis
    Config wider{2, {0, 2, 1}, {-0.5, 0, -1}, {0.5, 0, 2.1}};
    EXPECT_FALSE(r.keepDomain(wider));
    EXPECT_EQ(wider.domainMin[0], -0.5);
    r.domain.clear();
    EXPECT_TRUE(r.keepDomain(wider));
    EXPECT_EQ(wider.domainMax[2], 2.1);
}

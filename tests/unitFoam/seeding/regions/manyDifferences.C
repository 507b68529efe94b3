// SPDX-License-Identifier: GPL-3.0-or-later
/*  Of entries that have changed since setParticles ran five are named, and the rest counted; bonds
    and entries beside the regions are compared, too. */

#include "scratchCase.hpp"
#include "setParticlesRecord.H"
#include "IOdictionary.H"

#include <gtest/gtest.h>

using namespace Foam;

TEST(ManyDifferences, fiveAreNamed)
{
    ScratchCase c;
    const auto text = [](const std::string& number, const std::string& type)
    {
        std::string all("spacing 0.1; overlapTolerance " + number + "; regions ( ");
        for (const char* name : {"a", "b", "c", "d", "e", "f"})
            all += std::string(name) + " { set solids; radius " + number + "; } ";
        return all + "); bonds ( n { type " + type + "; } );";
    };
    const auto said = [&](const std::string& now)
    {
        c.writeDict("system/setParticlesDict", now);
        return messageOf([&]() { requireSetParticles(c.time()); });
    };
    c.writeDict("system/setParticlesDict", text("1", "glue"));
    recordSetParticles(c.time(), IOdictionary(IOobject("setParticlesDict", "system", c.time(),
        IOobject::MUST_READ, IOobject::NO_WRITE, false)));
    EXPECT_EQ(said(text("1", "glue")), "");
    const std::string one(said(text("1", "cement")));
    EXPECT_TRUE(holds(one, ":\n    bonds/n/type: cement, was glue\nRun setParticles")) << one;
    const std::string all(said(text("2", "cement")));
    EXPECT_TRUE(holds(all,
        ":\n    overlapTolerance: 2, was 1\n    regions/a/radius: 2, was 1\n    regions/b/radius: "
        "2, was 1\n    regions/c/radius: 2, was 1\n    regions/d/radius: 2, was 1\n    and 3 "
        "more\nRun setParticles, or remove that file to take the particles as they are"))
        << all;
    // an entry that is a dictionary now
    const std::string other(said("spacing { a 1; } overlapTolerance 1; regions ( ); bonds ( );"));
    EXPECT_TRUE(holds(other, "\n    spacing: { .. }, was 0.1\n")) << other;
    EXPECT_TRUE(holds(other, "\n    regions/a: not there, was { .. }\n")) << other;
}

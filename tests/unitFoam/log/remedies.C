// What helps at a guard's stop
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remedies.H"
#include "solidRemedies.H"
#include <gtest/gtest.h>

namespace
{

TEST(Remedies, ThoseThatHoldComeFirst)
{
    Foam::remedies helps;
    EXPECT_EQ(helps.text("A shorter step helps"), "A shorter step helps");
    helps.when(false, "coupling implicit");
    helps.when(true, "impermeable yes");
    helps.above("forceCourant", 0.25, 0.25);
    helps.above("maxCo", 0.8, 0.5);
    EXPECT_EQ(helps.text("A shorter step helps"),
        "Try first: impermeable yes; maxCo 0.5 (is 0.8). A shorter step helps");
}

TEST(Remedies, BondsWithoutDashpotsInWater)
{
    Foam::demSettings settings;
    riprap::DemInput input;
    input.bondTypes.resize(1);
    input.bonds.a = {0};
    const auto text = [&](bool inFluid)
    {
        Foam::remedies helps;
        Foam::solidRemedies(helps, settings, input, inFluid);
        return helps.text("no more");
    };
    EXPECT_EQ(text(false), "no more");
    EXPECT_EQ(text(true), "Try first: dampingRatio 0.02 to 0.1 of the bonds (is 0). no more");

    input.bondTypes[0].dampingRatio = 0.05;
    settings.config.stepFraction = 0.4;
    settings.config.allowLargeStep = true;
    EXPECT_EQ(text(true), "Try first: allowLargeStep no of constant/solidProperties; "
        "stepFraction of constant/solidProperties 0.2 (is 0.4). no more");

    // a step that was given has no fraction
    settings.config.timeStep = 1e-5;
    settings.config.allowLargeStep = false;
    EXPECT_EQ(text(true), "no more");
}

} // namespace

// SPDX-License-Identifier: GPL-3.0-or-later
/*  Function objects of solids where the domain's ends are one place: what touches, holds or moves
    through them is seen as anywhere else. */

#include "lineFile.hpp"
#include "runningSolids.hpp"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    const std::string glue("bonds { glue { normalStiffness 1e7; shearStiffness 1e7; } } groups { "
                           "held { fixed all; } }");

    //- The unit cube, of which x ends where it begins
    BoxMesh ring()
    {
        BoxMesh box;
        box.sides(0, "cyclic");
        return box;
    }

    struct Ring : RunningSolids
    {
        explicit Ring(const std::string& more = "")
        :
            RunningSolids(rock(more, "patches ();"), ring(), "(0 0 0)")
        {}
    };

    //- Pulled by a millimetre; the force of the spring
    struct RingBond : Ring
    {
        const double pull = 1e7*std::acos(-1.0)*0.05*0.05*1e-3;

        RingBond() : Ring(glue)
        {
            add(point(0.95, 0.5, 0.5), 0.05, Zero, Zero, "held");
            add(point(0.051, 0.5, 0.5), 0.05, Zero, Zero, "held");
            bond(0, 1);
            solids.bonds.gap[0] = 0;
            start();
        }
    };
}

TEST(PeriodicEnds, particlesAreFollowed)
{
    Ring c;
    c.add(point(0.9, 0.5, 0.5), 0.05, vector(1, 0, 0));
    c.start();
    const std::string text("type particleDisplacement; origIds (0);");
    auto f = c.function(text);
    for (int i = 1; i <= 6; ++i)
    {
        c.run(0.4*i);
        c.sample(f());
        EXPECT_NEAR(c.table("particleDisplacement").last("0Dx"), 0.4*i, 1e-7);
    }
    EXPECT_NEAR(c.table("particleDisplacement").last("0X"), 0.3, 1e-7);
    // the dictionary was edited
    f->read(entries(text));
    c.run(2.5);
    c.sample(f());
    EXPECT_NEAR(c.table("particleDisplacement").last("0Dx"), 2.5, 1e-7);
}

//- Others than before: each has its own start
TEST(PeriodicEnds, whomADictionaryNamesNow)
{
    Ring c;
    c.add(point(0.9, 0.5, 0.5), 0.05, vector(1, 0, 0));
    c.add(point(0.2, 0.2, 0.2), 0.05);
    c.start();
    auto f = c.function("type particleDisplacement; origIds (0 1);");
    c.run(0.3);
    c.sample(f());
    f->read(entries("type particleDisplacement; origIds (1 0);"));
    c.run(0.6);
    c.sample(f());
    const FunctionTable table(c.table("particleDisplacement", "0.6"));
    EXPECT_NEAR(table.last("1Dx"), 0, 1e-9);
    EXPECT_NEAR(table.last("0Dx"), 0.6, 1e-7);
}

TEST(PeriodicEnds, forcesOfContactsPress)
{
    Ring c;
    c.add(point(0.951, 0.5, 0.5), 0.05);
    c.add(point(0.05, 0.5, 0.5), 0.05);
    c.start();
    c.function("type contactChains;");
    const LineFile lines(c.read("VTK/f/f_0.vtp"));
    EXPECT_NEAR(lines.of("overlap").at(0), 0.001, 1e-8);
    EXPECT_NEAR(lines.of("normalForce").at(0), 100, 1e-3);
}

TEST(PeriodicEnds, bondsThatArePulled)
{
    RingBond c;
    c.function("type brokenBonds;");
    EXPECT_NEAR(c.table("brokenBonds").last("maxTension"), c.pull, 1e-3);
    EXPECT_NEAR(c.table("brokenBonds").last("maxShear"), 0, 1e-3);
    writeBondLines(
        c.time(), c.settings.config, c.scene->motion(), riprap::DemBondState(c.scene->bonds()));
    const LineFile lines(c.read("VTK/bonds/bonds_0.vtp"));
    EXPECT_NEAR(lines.of("tension").at(0), c.pull, 1e-2);
}

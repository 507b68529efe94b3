// SPDX-License-Identifier: GPL-3.0-or-later
/*  Bonds that a scene writes: whole, broken and lost ones, as files and as lines; what later runs
    know of them. */

#include "lineFile.hpp"
#include "pictures.H"
#include "writtenSolids.hpp"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    const double pi = std::acos(-1.0);

    //- The bond of 0 and 1, of rubber, is pulled by 1 mm/s, and breaks after 0.2 s: 1e7 Pa/m times
    //  0.2 mm. That of 2 and 3 flies out through x = 1 after 0.1 s and 0.14 s
    struct Bonds : WrittenSolids
    {
        const double area = pi*0.05*0.05;

        explicit Bonds(const std::string& control = "adjustTimeStep yes; writeFormat binary;")
            : WrittenSolids(
                rock("bonds { plain { normalStiffness 1e7; shearStiffness 1e7; } rubber { "
                     "calibration moduli; E 1e6; G 1e6; tensileStrength 2000; } } groups { "
                     "free { gravity no; } held { fixed all; } drawn { motion { "
                     "solidBodyMotionFunction linearMotion; velocity (1e-3 0 0); } } }",
                    "patches ();"),
                control)
        {
            add(point(0.3, 0.5, 0.5), 0.05, Zero, Zero, "held");
            add(point(0.41, 0.5, 0.5), 0.05, Zero, Zero, "drawn");
            add(point(0.9, 0.5, 0.5), 0.02, vector(1, 0, 0));
            add(point(0.86, 0.5, 0.5), 0.02, vector(1, 0, 0));
            bond(0, 1);
            bond(2, 3);
            solids.bonds.type = {1, 0};
            startCloud();
        }

        //- Broken bonds by particle in the files of this time, -1: it is not there
        std::vector<int> brokenBonds() const
        {
            const particleCloud cloud(readParticleCloud(fv(), "solids"));
            std::vector<int> all(4, -1);
            forAll(cloud.position, k)
                all[cloud.labels["origId"][k]] = cloud.labels["brokenBonds"][k];
            return all;
        }

        //- As one goes on that has no state: from the cloud and the bonds that are whole
        void goOnFromCloud()
        {
            solids = readSolids(fv(), settings);
            record.brokenBefore = solids.dropBroken() + solids.lostBonds;
            startAnew();
        }
    };
}

TEST(WrittenBonds, filesOfThoseThatAreThere)
{
    Bonds c;
    c.writeAt(0.05);
    const solidSet whole(readSolids(c.fv(), c.settings));
    EXPECT_EQ(whole.bonds.a, (std::vector<std::int32_t>{0, 2}));
    EXPECT_EQ(whole.bonds.b, (std::vector<std::int32_t>{1, 3}));
    EXPECT_EQ(whole.bonds.type, (std::vector<std::int32_t>{1, 0}));
    EXPECT_NEAR(whole.bonds.gap[0], 0.01, 1e-12);       // at which they were made
    EXPECT_NEAR(whole.bonds.gap[1], 0, 1e-12);
    EXPECT_EQ(whole.brokenBond, (std::vector<bool>{false, false}));
    EXPECT_EQ(readDemRun(c.time()).brokenBefore, 0);

    c.writeAt(0.25);
    const solidSet later(readSolids(c.fv(), c.settings));
    EXPECT_EQ(later.bonds.a, (std::vector<std::int32_t>{0}));
    EXPECT_EQ(later.bonds.type, (std::vector<std::int32_t>{1}));
    EXPECT_EQ(later.brokenBond, (std::vector<bool>{true}));
    EXPECT_EQ(later.lostBonds, 0);
    // whose particles have left
    EXPECT_EQ(readDemRun(c.time()).brokenBefore, 1);
}

//- Field brokenBonds counts from the first start: with the state and without it
TEST(WrittenBonds, countsOverRestarts)
{
    for (const bool state : {true, false})
    {
        Bonds c;
        c.writeAt(0.12);
        EXPECT_EQ(c.brokenBonds(), (std::vector<int>{0, 0, -1, 1}));
        c.writeAt(0.25);
        EXPECT_EQ(c.brokenBonds(), (std::vector<int>{1, 1, -1, -1}));
        if (state) c.goOn();
        else c.goOnFromCloud();
        EXPECT_EQ(c.scene->bonds().a.size(), state ? 1u : 0u);
        c.writeAt(0.26);
        EXPECT_EQ(c.brokenBonds(), (std::vector<int>{1, 1, -1, -1}));
        // what the scene does not know: the lost bond, or the broken one
        EXPECT_EQ(readDemRun(c.time()).brokenBefore, 1);
    }
}

//- A bond that was lost before a run goes on
TEST(WrittenBonds, lostOverARestart)
{
    Bonds c;
    c.writeAt(0.12);
    c.goOnFromCloud();
    c.writeAt(0.13);
    EXPECT_EQ(c.brokenBonds(), (std::vector<int>{0, 0, -1, 1}));
    EXPECT_EQ(c.scene->bonds().a, (std::vector<std::int32_t>{0}));
}

TEST(WrittenBonds, lines)
{
    Bonds c;
    c.writeAt(0.05);
    c.writeAt(0.12);
    const LineFile first(c.read("VTK/bonds/bonds_0.05.vtp")), second(
        c.read("VTK/bonds/bonds_0.12.vtp"));
    ASSERT_EQ(first.of("tension").size(), 2u);
    ASSERT_EQ(first.of("Points").size(), 12u);
    for (int i = 0; i < 2; ++i)
    {
        // of rubber, the other
        const double stretch = i ? 0 : 5e-5, force = 1e7*c.area*stretch;
        EXPECT_NEAR(first.of("tension")[i], force, 1e-4);
        EXPECT_NEAR(first.of("stretch")[i], stretch, 1e-9);
        EXPECT_NEAR(first.of("force")[3*i], force, 1e-4);
        EXPECT_NEAR(first.of("moment")[3*i], 0, 1e-9);
        EXPECT_EQ(first.of("type")[i], 1 - i);
        EXPECT_EQ(first.of("broken")[i], 0);
        const int a = int(first.of("connectivity")[2*i]),
                  b = int(first.of("connectivity")[2*i + 1]);
        EXPECT_NEAR(first.of("Points")[3*a], i ? 0.95 : 0.3, 1e-6);
        EXPECT_NEAR(first.of("Points")[3*b], i ? 0.91 : 0.41005, 1e-6);
    }
    EXPECT_EQ(second.of("type"), std::vector<double>{1});
    EXPECT_NEAR(second.of("stretch")[0], 1.2e-4, 1e-9);
    const std::string series(c.read("VTK/bonds.vtp.series"));
    EXPECT_TRUE(holds(series,
        "{ \"name\" : \"bonds/bonds_0.05.vtp\", \"time\" : 0.05 },\n    { \"name\" : "
        "\"bonds/bonds_0.12.vtp\", \"time\" : 0.12 }\n"))
        << series;
}

//- A picture has lines, and neither state nor bonds
TEST(WrittenBonds, ofAPicture)
{
    Bonds c("adjustTimeStep yes; stateInterval 10; pictureFields (U);");
    c.run(0.05);
    pictures::ofRun().next(c.time(), false);
    ASSERT_TRUE(pictures::ofRun().now());
    c.write();
    EXPECT_EQ(LineFile(c.read("VTK/bonds/bonds_0.05.vtp")).of("broken").size(), 2u);
    EXPECT_FALSE(isDir(c.path()/"0.05/uniform/riprap"));
    EXPECT_FALSE(isDir(c.path()/"0.05/uniform/lagrangian/solids/bonds"));
    EXPECT_FALSE(isFile(c.path()/"0.05/lagrangian/solids/radius"));
    EXPECT_TRUE(isFile(c.path()/"0.05/lagrangian/solids/U"));
    pictures::ofRun().next(c.time(), true);
    EXPECT_FALSE(pictures::ofRun().now());
    c.write();
    EXPECT_TRUE(isDir(c.path()/"0.05/uniform/riprap"));
    EXPECT_TRUE(isDir(c.path()/"0.05/uniform/lagrangian/solids/bonds"));
}

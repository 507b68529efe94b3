/*  What a PIC scene does not use costs nothing: no kernel is launched for it, no array exists.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <map>
#include <set>
#include "picSceneTest.hpp"

namespace riprap
{
namespace
{

class PicEconomy : public PicSceneTest
{
protected:

    struct Cost
    {
        std::map<std::string, std::int64_t> launches;
        std::map<std::string, std::size_t> bytes;
        std::map<std::string, int> arrays;
    };

    //- Of a tank half full of water after three steps
    Cost cost(const PicConfig& c, PicInside inside = PicInside()) const
    {
        const auto s = scene(c,
            box(c, {{0, 0, 0}}, {{1, 0.5, 1}}, [](double, double) { return true; }),
            std::move(inside));
        s->advance(1, 3);
        Cost r;
        for (const KernelInfo& k : s->kernels()) r.launches[k.name] += k.launches;
        for (const ArrayInfo& a : s->arrays())
        {
            r.bytes[a.name] += a.bytes;
            r.arrays[a.name] += 1;
        }
        return r;
    }

    static int faces(const PicConfig& c)
    {
        int sum = 0;
        for (int d = 0; d < c.dimensions; ++d)
        {
            int n = 1;
            for (int e = 0; e < c.dimensions; ++e) n *= c.cells[e] + (e == d);
            sum += n;
        }
        return sum;
    }

    static void none(const Cost& c, const std::set<std::string>& kernels)
    {
        for (const std::string& k : kernels)
            EXPECT_EQ(c.launches.count(k) ? c.launches.at(k) : 0, 0) << k << " was launched";
    }

    const std::set<std::string> implicitViscosity{"viscousSource", "viscousResidual",
        "viscousProduct", "viscousDot", "viscousAdd", "setFaces"};
    const std::set<std::string> solids{"pushOut", "nodeDistances", "closeFaces", "openVolumes",
        "openWeights", "markKnownCells", "extendSurface", "faceDistances", "stickToSolids",
        "slowBetweenSolids"};
};

RIPRAP_ALL_SETUPS(PicEconomy);

TEST_P(PicEconomy, WhatIsOffCostsNothing)
{
    PicConfig c = config(8);
    const Cost plain = cost(c);
    none(plain, implicitViscosity);
    none(plain, solids);
    none(plain, {"diffuse", "copyPeriodic", "setOpenFaces", "pushOpenFaces", "readOpenFaces"});
    EXPECT_EQ(plain.arrays.count("absorb") + plain.arrays.count("viscosity")
            + plain.arrays.count("openings"),
        0u);
    // apertures of the faces alone: no velocities of walls, no distances, no open parts of cells
    EXPECT_EQ(plain.bytes.at("walls"), faces(c)*(mixed() ? sizeof(float) : sizeof(double)));

    c.noSlip = true;            // without viscosity nothing sticks
    none(cost(c), {"diffuse", "viscousSource"});
    EXPECT_EQ(cost(c).bytes.at("walls"), plain.bytes.at("walls"));
    c.viscosity = 1;
    c.viscousScheme = "explicit";
    const Cost viscous = cost(c);
    EXPECT_GT(viscous.launches.at("diffuse"), 0);
    none(viscous, implicitViscosity);
    EXPECT_EQ(viscous.arrays.count("viscosity"), 0u);
}

TEST_P(PicEconomy, EachFieldHasItsUse)
{
    PicConfig c = config(8);
    const Cost all = cost(c);
    EXPECT_EQ(all.arrays.at("x"), D());         // in 2D nothing has a third component
    EXPECT_EQ(all.arrays.at("v"), D());
    EXPECT_EQ(all.arrays.at("affine"), D()*D());

    c.transferNumbers.affine = false;
    EXPECT_EQ(cost(c).arrays.count("affine"), 0u);
    c.positionCorrection = 0;
    none(cost(c), {"correctPositions"});
    c.reflection = 0;
    const Cost plain = cost(c);
    none(plain, {"keepLast", "halfDrift"});
    EXPECT_LT(plain.bytes.at("u"), all.bytes.at("u"));
    c.absorbers = {{"beach", {{0, 0, 0}}, {{1, 0, 0}}, 1}};
    EXPECT_EQ(cost(c).bytes.at("absorb"), faces(c)*(mixed() ? sizeof(float) : sizeof(double)));
}

//- The same water in a box twice as high: the same kernels, as often
TEST_P(PicEconomy, DryCellsLaunchNothing)
{
    PicConfig c = config(8);
    const Cost small = cost(c);
    c.cells[1] = 16;
    c.domainMax[1] = 2;
    const Cost tall = cost(c);
    for (const auto& k : small.launches)
        if (k.first.compare(0, 8, "pressure"))
        {
            EXPECT_EQ(tall.launches.at(k.first), k.second) << k.first;
        }
}

} // namespace
} // namespace riprap

/*  What a scene of solids does not use is not there: no bonds, no bond list; no friction, no
    history; 2D without the third component; no walls, no clumps, no orientation: neither arrays nor
    kernels.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <algorithm>
#include <map>
#include <set>
#include "dem/demTest.hpp"

namespace riprap
{
namespace
{

class DemEconomy : public DemTest
{
protected:
    //- Nine bodies in touching rows
    static DemInput rows(int dimensions)
    {
        DemInput in = oneMaterial();
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                addParticle(in, {{0.02*i - 0.02, 0.02*j - 0.02, dimensions == 3 ? 0.1 : 0}},
                    {{0.01*i, 0, 0}});
        return in;
    }

    //- Bytes by set and name, and the kernels of 20 steps
    struct Counts { std::map<std::string, std::size_t> arrays; std::set<std::string> kernels; };

    static Counts counts(const DemConfig& c, const DemInput& in)
    {
        auto scene = createDemScene(c, in);
        scene->advance(1, 20);
        Counts r;
        for (const ArrayInfo& a : scene->arrays()) r.arrays[a.set + " " + a.name] += a.bytes;
        // on the GPU one kernel does it all
        if (scene->device() == DeviceKind::cpu)
            for (const KernelInfo& k : scene->kernels())
                if (k.launches > 0) r.kernels.insert(k.name);
        return r;
    }

    static bool any(const Counts& r, const std::string& word)
    {
        const auto has = [&](const std::string& name)
        { return name.find(word) != std::string::npos; };
        return std::any_of(
                   r.arrays.begin(), r.arrays.end(), [&](const auto& a) { return has(a.first); })
            || std::any_of(r.kernels.begin(), r.kernels.end(), has);
    }

    static std::size_t lists(const Counts& r)
    {
        return r.arrays.at("contacts lists and histories");
    }
};

TEST_P(DemEconomy, NoBondsNoBondList)
{
    for (const int D : {2, 3})
    {
        const DemConfig c = config(D);
        DemInput in = rows(D);
        const Counts none = counts(c, in);
        EXPECT_FALSE(any(none, "bond"));
        in.bondTypes.emplace_back();
        in.bondTypes[0].normalStiffness = in.bondTypes[0].shearStiffness = 1e6;
        in.bonds = bondsWithin(c, in.particles, 0, 1e-6);
        ASSERT_EQ(in.bonds.size(), 12u);
        const Counts some = counts(c, in);
        EXPECT_TRUE(some.arrays.count("bonds bonds"));
        if (GetParam().device == DeviceKind::cpu)
        {
            EXPECT_GT(some.kernels.size(), none.kernels.size());
        }
    }
}

//- A history spring takes memory in each list, and in 3D a rolling spring more of it; without
//  friction, or with the one-step spring, there is none
TEST_P(DemEconomy, NoFrictionNoHistory)
{
    for (const int D : {2, 3})
    {
        DemConfig c = config(D);
        DemInput in = rows(D);
        in.pairs[0].properties.friction = 0.5;
        const std::size_t smooth = lists(counts(c, in));
        c.tangential = "oneStep";
        EXPECT_EQ(lists(counts(c, in)), smooth);
        c.tangential = "history";
        const std::size_t spring = lists(counts(c, in));
        EXPECT_GT(spring, smooth);
        c.rolling = "spring";
        in.pairs[0].properties.rollingFriction = 0.1;
        if (D == 3) { EXPECT_GT(lists(counts(c, in)), spring); }
    }
}

TEST_P(DemEconomy, TwoDimensionsWithoutTheThird)
{
    const Counts flat = counts(config(2), rows(2)), deep = counts(config(3), rows(3));
    for (const char* name : {"position", "velocity", "force"})
        for (const char axis : {'x', 'y', 'z'})
        {
            const std::string field = std::string("solids ") + name + "." + axis;
            EXPECT_EQ(flat.arrays.count(field), axis == 'z' ? 0u : 1u) << field;
            EXPECT_EQ(deep.arrays.count(field), 1u) << field;
        }
    for (const char* name : {"spin", "moment"})
        for (const char axis : {'x', 'y', 'z'})
        {
            const std::string field = std::string("solids ") + name + "." + axis;
            EXPECT_EQ(flat.arrays.count(field), axis == 'z' ? 1u : 0u) << field;
            EXPECT_EQ(deep.arrays.count(field), 1u) << field;
        }
    EXPECT_LT(flat.arrays.at("solids records"), deep.arrays.at("solids records"));
}

TEST_P(DemEconomy, NoWallsClumpsOrientation)
{
    DemConfig c = config(3);
    DemInput in = rows(3);
    const Counts none = counts(c, in);
    for (const char* word : {"wall", "clump", "orientation"}) EXPECT_FALSE(any(none, word)) << word;
    in.walls.push_back(planeWall({{0, -0.4, 0}}, {{0, 1, 0}}));
    c.orientation = true;
    const Counts some = counts(c, in);
    EXPECT_TRUE(any(some, "walls"));
    EXPECT_TRUE(any(some, "orientation"));
}

//- Materials of walls alone, or of nobody, change neither a bit nor which numbers contacts between
//  particles read. Order does not matter
TEST_P(DemEconomy, MaterialsOfNoParticleChangeNothing)
{
    for (const int D : {2, 3})
    {
        DemConfig c = config(D);
        c.tangential = "history";
        DemInput in = rows(D);
        in.pairs[0].properties.friction = 0.5;
        in.walls.push_back(planeWall({{0, -0.04, 0}}, {{0, 1, 0}}));
        // rows that meet each other and the wall
        for (std::size_t i = 0; i < in.particles.size(); ++i)
            in.particles.velocity[3*i + 1] = -10*in.particles.position[3*i + 1] - 0.3;
        const auto positions = [&]
        {
            auto scene = createDemScene(c, in);
            scene->advance(1, 400);
            return scene->motion().position;
        };
        const std::vector<double> one = positions();
        const DemInput start = in;
        for (const int own : {0, 1})
        {
            in = start;
            in.materials.push_back(in.materials[0]);
            in.particles.material.assign(in.particles.size(), own);
            in.walls[0].material = 1 - own;
            in.pairs.resize(3, in.pairs[0]);
            for (int k = 0; k < 3; ++k) { in.pairs[k].a = k/2; in.pairs[k].b = (k + 1)/2; }
            EXPECT_EQ(positions(), one) << D << "D, material " << own;
        }
        // beside particles of another material each contact reads its own pair
        in.particles.material[0] = 0;
        EXPECT_EQ(positions(), one);
        in.pairs[1].properties.normalStiffness *= 2;
        EXPECT_NE(positions(), one);
    }
}

RIPRAP_DEM_CASES(DemEconomy);

} // namespace
} // namespace riprap

/*  Scenes with each combination of the contact laws in the tables: GPU against CPU, single
    precision against double.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "dem/demTest.hpp"
#include "dem/lawTables.hpp"

namespace riprap
{
namespace
{

class LawScenes : public DemTest {};

//- A handful of bodies that fall onto each other and a wall, each combination of laws: on each
//  device and in each precision as on the CPU in double, as far as chaos lets it within so few
//  impacts
TEST_P(LawScenes, AreAsOnTheCpu)
{
    eachLaw([&](auto law, const LawChoice& choice)
    {
        using Law = decltype(law);
        const auto run = [&](DemConfig c, double& deepest)
        {
            c.normal = Law::NormalLaw::word;
            c.tangential = Law::TangentialLaw::word;
            c.rolling = Law::RollingLaw::word;
            c.gravity = Vector3{{0, 0, -9.81}};
            DemInput in;
            in.materials.push_back(DemMaterial{"stone", 1e8, 0.25});
            DemPair pair;
            pair.properties = typical(lawEntries(choice), false);
            in.pairs.push_back(pair);
            for (int k = 0; k < 8; ++k)
            {
                const int layer = k/4;
                addParticle(in,
                    {{0.0101*(k % 2) + 0.0005*k, 0.019*(k/2 % 2), -0.4899 + 0.0205*layer}},
                    {{0.1*k, -0.05*k, -0.2}}, 0.01 - 0.0005*(k % 3));
            }
            in.walls.push_back(planeWall({{0, 0, -0.5}}, {{0, 0, 1}}));
            auto scene = createDemScene(c, in);
            scene->advance(0.005);
            deepest = scene->deepestOverlap();
            return scene->particles();
        };
        const DemConfig c = config(3);
        DemConfig reference = c;
        reference.device = DeviceKind::cpu;
        reference.precision = PrecisionKind::doubled;
        double deepest = 0, deepestThere = 0;
        const DemState s = run(c, deepest), there = run(reference, deepestThere);
        EXPECT_GT(deepestThere, 0) << nameOf(choice);
        EXPECT_NEAR(deepest, deepestThere, 1e-3*deepestThere) << nameOf(choice);
        for (int id = 0; id < 8; ++id)
            for (int d = 0; d < 3; ++d)
            {
                const double v = there.velocity[3*find(there, id) + d];
                EXPECT_NEAR(s.velocity[3*find(s, id) + d], v, mixed() ? 2e-3 : 1e-6)
                    << nameOf(choice) << " " << id << " " << d;
            }
    });
}

RIPRAP_DEM_CASES(LawScenes);

} // namespace
} // namespace riprap

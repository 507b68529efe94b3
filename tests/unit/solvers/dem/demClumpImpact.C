/*  Impacts of rigid bodies of many members on a plane: the step that they need, and their
    restitution.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "dem/demTest.hpp"

namespace riprap
{
namespace
{

using DemClumpImpact = DemTest;

enum class Shape {ball, flat, corner};

struct Drop { DemInput in; int touching = 0; };

//- A body of mass 1 kg on a lattice, 20 members (3D: 14) across, that falls at 1 m/s on a plane
//  from 0.1 mm above. corner: turned by 45 degrees, so that it lands on a corner (2D) or an edge
//  (3D)
Drop drop(int D, Shape shape, double e)
{
    const int across = D == 3 ? 14 : 20;
    const double size = 0.02, offset = 0.5*(across - 1)*size;
    std::vector<Vector3> at;
    double low = 1e9, inertia = 0;
    for (int k = 0; k < (D == 3 ? across : 1); ++k)
        for (int j = 0; j < across; ++j)
            for (int i = 0; i < across; ++i)
            {
                Vector3 x{{i*size - offset, j*size - offset, D == 3 ? k*size - offset : 0}};
                if (shape == Shape::ball
                    && x[0]*x[0] + x[1]*x[1] + x[2]*x[2] > offset*offset*1.0001)
                    continue;
                if (shape == Shape::corner)
                    x = Vector3{
                        {std::sqrt(0.5)*(x[0] - x[1]), std::sqrt(0.5)*(x[0] + x[1]), x[2]}};
                at.push_back(x);
                low = std::min(low, x[1]);
                inertia += x[0]*x[0] + x[1]*x[1];
            }
    Drop d;
    d.in = oneMaterial(1e6);
    d.in.pairs[0].properties.restitution = e;
    const double lift = -low + 0.5*size + 1e-4;
    for (const Vector3& x : at)
    {
        d.touching += x[1] < low + 1e-9;
        addParticle(
            d.in, {{x[0], x[1] + lift, x[2]}}, {{0, -1, 0}}, 0.5*size, 1.0/double(at.size()));
    }
    d.in.particles.clump.assign(at.size(), 0);
    DemClump body;
    body.mass = 1;
    body.position = Vector3{{0, lift, 0}};
    body.velocity = Vector3{{0, -1, 0}};
    for (double& I : body.inertia) I = inertia/double(at.size());
    d.in.clumps.push_back(body);
    d.in.walls.push_back(planeWall({{0, 0, 0}}, {{0, 1, 0}}));
    return d;
}

DemConfig openBox(DemConfig c)
{
    c.domainMin = Vector3{{-2, -2, -2}};
    c.domainMax = Vector3{{2, 2, 2}};
    c.stepFraction = 0.2;
    return c;
}

//- sqrt(M/(n k)) with all members of a face; single particles keep sqrt(m/k)
TEST(DemClumpPlan, StepOfAFace)
{
    for (const int D : {2, 3})
    {
        DemConfig c;
        c.dimensions = D;
        c.normal = "linear";
        c = openBox(c);
        DemInput in = drop(D, Shape::flat, 0.5).in;
        const double n = D == 3 ? 14*14 : 20;
        EXPECT_NEAR(planDemScene(c, in).limits.at(0).critical/std::sqrt(1/(n*1e6)), 1, 1e-12) << D;
        // turned by any angle, and moved since it was made
        DemClump& body = in.clumps[0];
        body.start = DemPose{{{7, 8, D == 3 ? 9.0 : 0}}, {{1, 0, 0, 0}}};
        body.moved = true;
        const double turn = 0.3;
        body.orientation = {{std::cos(turn/2), 0, 0, std::sin(turn/2)}};
        for (std::size_t i = 0; i < in.particles.size(); ++i)
        {
            double* x = &in.particles.position[3*i];
            const double u = x[0] - body.position[0], v = x[1] - body.position[1];
            x[0] = body.position[0] + std::cos(turn)*u - std::sin(turn)*v;
            x[1] = body.position[1] + std::sin(turn)*u + std::cos(turn)*v;
        }
        EXPECT_NEAR(planDemScene(c, in).limits.at(0).critical/std::sqrt(1/(n*1e6)), 1, 1e-12) << D;
        in.particles.clump.clear();
        in.clumps.clear();
        const double m = in.particles.mass[0];
        EXPECT_EQ(planDemScene(c, in).limits.at(0).critical, std::sqrt(m/1e6)) << D;
    }
}

//- Energy without dashpots, whatever lands
TEST_P(DemClumpImpact, ElasticBounce)
{
    for (const int D : {2, 3})
        for (const Shape shape : {Shape::ball, Shape::flat, Shape::corner})
        {
            const auto scene = createDemScene(openBox(config(D)), drop(D, shape, 1).in);
            const DemReport r = scene->advance(0.02);
            ASSERT_EQ(r.stop, DemStop::none) << r.stopMessage;
            EXPECT_NEAR(scene->clumps().velocity[1], 1, 0.02) << D << "D, shape " << int(shape);
        }
}

//- Dashpots know the body: with the mass of single members bodies bounced as if nothing braked them
//  (0.97 for 0.4). A share of what touches has no closed form where members join in one after the
//  other, or where fewer touch than share: bodies that land on a corner bounce more
TEST_P(DemClumpImpact, Restitution)
{
    for (const int D : {2, 3})
        for (const Shape shape : {Shape::ball, Shape::flat, Shape::corner})
        {
            const double e = 0.4;
            const auto scene = createDemScene(openBox(config(D)), drop(D, shape, e).in);
            const DemReport r = scene->advance(0.02);
            ASSERT_EQ(r.stop, DemStop::none) << r.stopMessage;
            const double u = scene->clumps().velocity[1];
            // a contact that begins as a step ends loses half of a step's dashpot: 0.2 zeta of the
            // speed, zeta = 0.35
            if (shape != Shape::corner)
            {
                EXPECT_NEAR(u, e, 0.07*e + 0.01) << D << "D, shape " << int(shape);
            }
            else
            {
                EXPECT_LT(u, 0.6)
                    << D << "D: one member, or an edge of them, with the share of a few more";
            }
            EXPECT_GT(u, 0.9*e);
        }
}

//- A body that would sink in by more than its members' radius
TEST(DemClumpPlan, WarnsOfSoftContacts)
{
    DemConfig c;
    c.normal = "linear";
    c.dimensions = 2;
    c = openBox(c);
    const Drop ball = drop(2, Shape::ball, 0.4);
    DemInput in = ball.in;
    EXPECT_TRUE(planDemScene(c, in).warnings.empty());
    // 11 sqrt(1 kg/1e6 N/m) = 11 mm, of radii of 10 mm
    in.clumps[0].velocity[1] = -11*std::sqrt(double(ball.touching));
    const auto warnings = planDemScene(c, in).warnings;
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("sinks in by 0.011"), std::string::npos) << warnings[0];
}

RIPRAP_DEM_CASES(DemClumpImpact);

} // namespace
} // namespace riprap

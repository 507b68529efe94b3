/*  Solids of the dem library in the water of a PIC scene.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "hostSolver.hpp"
#include "picSceneTest.hpp"

namespace riprap
{
namespace
{

class PicSolidScene : public PicSceneTest
{
protected:

    HostSolver solver;

    //- Balls of this density on a stiff linear contact law
    std::shared_ptr<PicSolids> balls(const PicConfig& c, const std::vector<Vector3>& at, double radius, double density, bool weak = false) const
    {
        auto s = std::make_shared<PicSolids>();
        s->weak = weak;
        s->config.domainMin = c.domainMin;
        s->config.domainMax = c.domainMax;
        s->config.normal = NormalKind::linear;
        s->config.tangential = TangentialKind::history;
        s->input.materials.resize(1);
        s->input.pairs.resize(1);
        s->input.pairs[0].properties.normalStiffness = 1e5;
        s->input.pairs[0].properties.restitution = 0.3;
        for (const Vector3& x : at)
        {
            s->input.particles.position.insert(s->input.particles.position.end(), x.begin(), x.end());
            s->input.particles.radius.push_back(radius);
            s->input.particles.mass.push_back(density*(D() == 2 ? M_PI*radius*radius : 4*M_PI/3*std::pow(radius, 3)));
        }
        return s;
    }

    std::unique_ptr<PicScene> withSolids(const PicConfig& c, const FluidInput& f, std::shared_ptr<PicSolids> solids)
    {
        PicInside inside;
        inside.solids = std::move(solids);
        return createPicScene(c, f, PicWalls(), &solver, std::move(inside));
    }
};

RIPRAP_ALL_SETUPS(PicSolidScene);

TEST_P(PicSolidScene, Dev)
{
    PicConfig c = config(D() == 2 ? 32 : 16);
    const double a = 5.0/32;
    for (const double ratio : {0.01, 0.5, 1.0, 2.7, 100.0})
    for (const bool weak : {false, true})
    {
        const auto s = withSolids(c, box(c, {{0, 0, 0}}, {{1, 0.75, 1}}, [](double, double) { return true; }), balls(c, {{{0.5, 0.4, 0.5}}}, a, 1000*ratio, weak));
        s->advance(0.002, 1);
        for (int k = 0; k < 6; ++k)
        {
            const DemState q = s->solids()->particles();
            const PicReport r = s->advance(0.03*(k + 1));
            std::printf("ratio %g weak %d t %.3f v/gt %.4f x %.5f y %.5f vol %.2e maxU %.3f steps %d it %d F %.4f\n", ratio, weak, r.time, q.velocity[1]/9.81/std::max(q.position.empty() ? 1 : s->time(), 1e-9),
                q.position[0], q.position[1], r.volumeError, r.maxSpeed, int(r.steps), int(r.pressureIterations/std::max<long>(r.steps,1)), s->coupling().force[1]/(q.mass[0]*9.81));
            if (r.stop != StopReason::none) { std::printf("stop %d\n", int(r.stop)); break; }
        }
    }
}

} // namespace
} // namespace riprap

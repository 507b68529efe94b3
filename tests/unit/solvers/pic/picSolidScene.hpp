/*  Scenes of PIC with solids of the dem library in the water.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/pressure/hostSolver.hpp"
#include "picSceneTest.hpp"

namespace riprap
{

class PicSolidScene : public PicSceneTest
{
protected:

    HostSolver solver;

    //- Balls of this density on a stiff linear contact law
    std::shared_ptr<PicSolids> balls(const PicConfig& c, const std::vector<Vector3>& at,
        double radius, double density, bool weak = false) const
    {
        auto s = noSolids(c, 1e6, 0.3);
        s->weak = weak;
        for (const Vector3& x : at)
        {
            s->input.particles.position.insert(
                s->input.particles.position.end(), x.begin(), x.end());
            s->input.particles.radius.push_back(radius);
            s->input.particles.mass.push_back(
                density*(D() == 2 ? M_PI*radius*radius : 4*M_PI/3*std::pow(radius, 3)));
        }
        return s;
    }

    std::unique_ptr<PicScene> withSolids(
        const PicConfig& c, const FluidInput& f, std::shared_ptr<PicSolids> solids)
    {
        PicInside inside;
        inside.solids = std::move(solids);
        return createPicScene(c, f, PicWalls(), &solver, std::move(inside));
    }
};

//- A round tank, full of water: solid outside
inline PicObstacle roundTank(int dimensions, double radius)
{
    PicObstacle o;
    o.name = "tank";
    o.solidOutside = true;
    if (dimensions == 2)
    {
        const int n = 400;
        for (int i = 0; i < n; ++i)
        {
            o.vertices.insert(o.vertices.end(),
                {0.5 + radius*std::cos(2*M_PI*i/n),
                    0.5 + radius*std::sin(2*M_PI*i/n), 0});
            o.elements.insert(o.elements.end(), {i, (i + 1) % n});
        }
        return o;
    }
    const int n = 30;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i < 2*n; ++i)
        {
            const double t = M_PI*j/n, f = M_PI*i/n;
            o.vertices.insert(o.vertices.end(),
                {0.5 + radius*std::sin(t)*std::cos(f), 0.5 + radius*std::sin(t)*std::sin(f),
                    0.5 + radius*std::cos(t)});
        }
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < 2*n; ++i)
        {
            const int k = (i + 1) % (2*n), a = j*2*n + i, b = j*2*n + k,
                      e = (j + 1)*2*n + i, f = (j + 1)*2*n + k;
            if (j > 0) o.elements.insert(o.elements.end(), {a, e, b});
            if (j < n - 1) o.elements.insert(o.elements.end(), {b, e, f});
        }
    return o;
}

} // namespace riprap

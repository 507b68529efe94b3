/*  What tests of whole PIC scenes share: a unit box of water, on every backend that is there, in 2D
    and 3D and both precisions.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "sceneTest.hpp"
#include "api/picScene.hpp"

namespace riprap
{

class PicSceneTest : public SceneTest
{
protected:

    //- The unit square or cube in n^D cells, gravity along -y
    PicConfig config(int n) const
    {
        PicConfig c;
        c.dimensions = D();
        c.device = GetParam().device;
        c.precision = GetParam().precision;
        for (int d = 0; d < 3; ++d) c.cells[d] = d < D() ? n : 1;
        c.cellSize = 1.0/n;
        c.spacing = 0.5*c.cellSize;
        c.density = 1000;
        c.gravity = {{0, -9.81, 0}};
        c.pressureTolerance = 1e-11;
        return c;
    }

    //- Particles on a lattice in a box, those where `open` says so
    template<class Open>
    static FluidInput box(
        const PicConfig& c, const Vector3& low, const Vector3& high, const Open& open)
    {
        FluidInput f;
        int n[3];
        for (int d = 0; d < 3; ++d)
            n[d] = d < c.dimensions ? int(std::lround((high[d] - low[d])/c.spacing)) : 1;
        for (int k = 0; k < n[2]; ++k)
            for (int j = 0; j < n[1]; ++j)
                for (int i = 0; i < n[0]; ++i)
                {
                    const int at[3] = {i, j, k};
                    double x[3];
                    for (int d = 0; d < 3; ++d)
                        x[d] = low[d] + (at[d] + 0.5)*(high[d] - low[d])/n[d];
                    if (!open(x[0], x[1])) continue;
                    f.position.insert(f.position.end(), x, x + 3);
                }
        f.velocity.assign(f.position.size(), 0.0);
        return f;
    }

    //- Solids of one material and a linear contact law, of which none is there yet
    static std::shared_ptr<PicSolids> noSolids(
        const PicConfig& c, double stiffness, double restitution)
    {
        auto s = std::make_shared<PicSolids>();
        s->config.domainMin = c.domainMin;
        s->config.domainMax = c.domainMax;
        s->config.normal = "linear";
        s->config.tangential = "history";
        s->input.materials.resize(1);
        s->input.pairs.resize(1);
        s->input.pairs[0].properties.normalStiffness = stiffness;
        s->input.pairs[0].properties.restitution = restitution;
        return s;
    }

    static std::unique_ptr<PicScene> scene(
        const PicConfig& c, const FluidInput& f, PicInside inside)
    { return createPicScene(c, f, PicWalls(), nullptr, std::move(inside)); }
};

} // namespace riprap

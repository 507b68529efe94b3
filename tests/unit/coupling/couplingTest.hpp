/*  What tests of fluid and solids together share: blocks of bonded particles and of rigid ones,
    water about them, momentum of both.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "sceneTest.hpp"
#include "api/sphDemScene.hpp"

namespace riprap
{

inline const std::string allKinds[] = {
    "stationary", "pressureGradient", "pressureApproximation", "extrapolated"};

class CouplingTest : public SceneTest
{
protected:

    //- A block of bonded particles, another spacing than the fluid's
    SolidInput block(const SphConfig& c, int across, double size, Vector3 corner) const
    {
        SolidInput s;
        s.config.domainMin = c.domainMin;
        s.config.domainMax = c.domainMax;
        for (int d = 0; d < 3; ++d) s.config.periodic[d] = c.periodic[d];
        s.config.normal = "linear";
        s.config.tangential = "none";
        s.config.integrator = "velocityVerlet";
        s.config.stepFraction = 0.3;
        DemInput& in = s.input;
        in.materials.push_back(DemMaterial{"rubber", 1e6, 0.3});
        DemPair p;
        p.properties.normalStiffness = 1e4;
        in.pairs.push_back(p);
        for (int k = 0; k < (D() == 3 ? across : 1); ++k)
            for (int j = 0; j < across; ++j)
                for (int i = 0; i < across; ++i)
                {
                    const int index[3] = {i, j, k};
                    for (int d = 0; d < 3; ++d)
                        in.particles.position.push_back(
                            corner[d] + (d < D() ? (index[d] + 0.5)*size : 0));
                    in.particles.radius.push_back(0.5*size);
                    in.particles.mass.push_back(800*std::pow(size, D()));
                    s.volume.push_back(std::pow(size, D()));
                }
        in.bondTypes.emplace_back();
        in.bondTypes[0].normalStiffness = 2e6/size;
        in.bondTypes[0].shearStiffness = 1e6/size;
        DemConfig known(s.config);
        known.dimensions = D();
        if (across > 1) in.bonds = bondsWithin(known, in.particles, 0, 1e-3*size);
        return s;
    }

    //- The same block as one rigid body
    SolidInput rigid(SolidInput s) const
    {
        DemInput& in = s.input;
        const std::size_t n = in.particles.size();
        DemClump body;
        for (std::size_t i = 0; i < n; ++i)
        {
            body.mass += in.particles.mass[i];
            for (int d = 0; d < 3; ++d)
                body.position[d] += in.particles.position[3*i + d]/double(n);
        }
        for (std::size_t i = 0; i < n; ++i)
            for (int d = 0; d < 3; ++d)
                for (int e = 0; e < 3; ++e)
                    if (e != d)
                        body.inertia[d] += in.particles.mass[i]
                            *std::pow(in.particles.position[3*i + e] - body.position[e], 2);
        in.clumps.push_back(body);
        in.particles.clump.assign(n, 0);
        in.bonds = DemBonds();
        in.bondTypes.clear();
        return s;
    }

    SphConfig waterBox() const
    {
        SphConfig c = config();
        if (D() == 3) { c.spacing = 0.1; c.skin = 0.1; }
        c.periodic[0] = c.periodic[1] = c.periodic[2] = true;
        c.wallSpacing = c.spacing;
        c.viscosity = 20;
        return c;
    }

    //- Fluid about a block that is left free of it
    FluidInput waterAround(const SphConfig& c, const Vector3& low, double side) const
    {
        FluidInput all = lattice(c, {{0, 0, 0}}, {{1, 1, D() == 3 ? 1.0 : 0.0}}), f;
        disturb(c, all, 0.1, 0.5, 0.01);
        for (std::size_t i = 0; i < all.size(); ++i)
        {
            bool inside = true;
            for (int d = 0; d < D(); ++d)
            {
                double& x = all.position[3*i + d];
                x -= std::floor(x);
                inside = inside && x > low[d] - 0.5*c.spacing && x < low[d] + side + 0.5*c.spacing;
            }
            if (inside) continue;
            f.position.insert(
                f.position.end(), all.position.begin() + 3*i, all.position.begin() + 3*i + 3);
            f.velocity.insert(
                f.velocity.end(), all.velocity.begin() + 3*i, all.velocity.begin() + 3*i + 3);
            f.density.push_back(all.density[i]);
        }
        return f;
    }

    struct Momentum { Vector3 sum{{0, 0, 0}}; double size = 0; };

    Momentum momentum(SphScene& s, const SphConfig& c) const
    {
        Momentum p;
        const auto add = [&](const std::vector<double>& v, std::size_t i, double m)
        {
            for (int d = 0; d < D(); ++d)
            {
                p.sum[d] += m*v[3*i + d];
                p.size += m*std::abs(v[3*i + d]);
            }
        };
        const FluidState f = s.fluid();
        for (std::size_t i = 0; i < f.id.size(); ++i)
            add(f.velocity, i, c.density*std::pow(c.spacing, D()));
        const DemState q = s.solids()->particles();
        // parts of a rigid body show its velocity of the middle of the step
        const std::vector<double> body = s.solids()->clumps().velocity;
        for (std::size_t i = 0; i < q.id.size(); ++i)
            add(body.empty() ? q.velocity : body, body.empty() ? i : q.clump[i], q.mass[i]);
        const CouplingState now = s.coupling();
        for (int d = 0; d < D(); ++d) p.sum[d] += now.pending[d];
        return p;
    }
};

} // namespace riprap

/*  Flows in which neighbours change fast: sheared, rotating, breaking, spray, pushed by a piston,
    with solids in them. And all pairs by brute force.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "couplingTest.hpp"

namespace riprap
{

//- Positions of everything in a scene, by id, and of wall points in the order of the input
struct Places { std::vector<double> fluid, solids, walls; };

class FlowTest : public CouplingTest
{
protected:

    struct Flow
    {
        const char* name;
        SphConfig c;
        FluidInput fluid;
        WallInput walls;
        WallMotion motion;
        std::vector<SolidInput> solids;     // none or one
    };

    std::unique_ptr<SphScene> make(const Flow& f) const
    {
        return f.solids.empty() ? createSphScene(f.c, f.fluid, f.walls, f.motion)
                                : createSphDemScene(f.c, f.fluid, f.walls, f.solids[0], f.motion);
    }

    double deep(double size) const { return D() == 3 ? size : 0.0; }

    //- Skins are thin, so that much happens to lists
    SphConfig flowConfig(Vector3 size, bool periodic) const
    {
        SphConfig c = config();
        c.spacing = c.wallSpacing = D() == 3 ? 0.1 : 0.05;
        c.domainMax = size;
        for (int d = 0; d < 3; ++d) c.periodic[d] = periodic;
        c.viscosityModel = "artificial";
        c.diffusion = "fourtakas";
        c.maxDensityDeviation = 0.5;
        c.skin = 0.1;
        return c;
    }

    template<class V>
    static void set(FluidInput& f, const V& velocity)
    {
        for (std::size_t i = 0; i < f.size(); ++i)
        {
            const Vector3 v = velocity(
                Vector3{{f.position[3*i], f.position[3*i + 1], f.position[3*i + 2]}});
            for (int d = 0; d < 3; ++d) f.velocity[3*i + d] += v[d];
        }
    }

    //- A current that runs fast, and across in waves
    Flow sheared() const
    {
        Flow s{"sheared", flowConfig({{3, 1, 0.9}}, true), {}, {}, {}, {}};
        s.fluid = lattice(s.c, {{0, 0, 0}}, {{3, 1, deep(0.9)}});
        disturb(s.c, s.fluid, 0.1, 0.02, 0.001);
        for (double& x : s.fluid.position) x = std::max(x, 0.0);
        set(s.fluid,
            [](const Vector3& x) {
                return Vector3{{1.5, 0.8*std::sin(2*M_PI*x[0]/3), 0}};
            });
        return s;
    }

    Flow rotating() const
    {
        Flow s{"rotating", flowConfig({{3, 3, 0.9}}, false), {}, {}, {}, {}};
        s.fluid = lattice(s.c, {{1, 1, deep(0.2)}}, {{2, 2, deep(0.6)}});
        set(s.fluid,
            [](const Vector3& x) {
                return Vector3{{-2*(x[1] - 1.5), 2*(x[0] - 1.5), 0}};
            });
        return s;
    }

    WallInput tankOf(const SphConfig& c) const
    {
        WallInput w = floorOf(c, 1, c.domainMin[1] + 3*c.spacing, 3);
        const WallInput left = floorOf(c, 0, c.domainMin[0] + 3*c.spacing, 3);
        append(w, left);
        WallInput right(left);
        for (std::size_t i = 0; i < right.size(); ++i)
        {
            right.position[3*i] = c.domainMax[0] + c.domainMin[0] - right.position[3*i];
            right.normal[3*i] = -1;
        }
        append(w, right);
        return w;
    }

    //- A column that is thrown against the right wall of a tank and falls back
    Flow breaking(const std::string& model, const std::string& integrator) const
    {
        SphConfig c = flowConfig({{2, 2, 0.9}}, false);
        c.periodic[2] = true;
        c.wallModel = model;
        c.integrator = integrator;
        c.gravity = {{0, -9.81, 0}};
        const double edge = 3*c.spacing;
        Flow s{"breaking", c, lattice(c, {{1, edge, 0}}, {{2 - edge, edge + 0.7, deep(0.9)}}),
            tankOf(c), {}, {}};
        set(s.fluid, [](const Vector3& x) { return Vector3{{1.5*(x[1] - 0.2), 0, 0}}; });
        return s;
    }

    //- Drops anywhere, each its own way: nothing that they have in common
    Flow spray() const
    {
        Flow s{"spray", flowConfig({{3, 1, 0.9}}, true), {}, {}, {}, {}};
        s.fluid = lattice(s.c, {{0, 0, 0}}, {{3, 1, deep(0.9)}});
        FluidInput some;
        std::mt19937 engine(5);
        for (std::size_t i = 0; i < s.fluid.size(); ++i)
        {
            if (uniform(engine, 0, 1) > 0.3) continue;
            for (int d = 0; d < 3; ++d)
            {
                some.position.push_back(s.fluid.position[3*i + d]);
                some.velocity.push_back(d < D() ? uniform(engine, -1, 1) : 0);
            }
            some.density.push_back(s.c.density);
        }
        s.fluid = some;
        return s;
    }

    //- The left wall comes in and pushes the column
    Flow piston() const
    {
        Flow s = breaking("extrapolated", "leapfrog");
        s.name = "piston";
        for (std::size_t i = 0; i < s.fluid.size(); ++i) s.fluid.position[3*i] -= 1 - 3*s.c.spacing;
        s.walls.nBodies = 1;
        for (std::size_t i = 0; i < s.walls.size(); ++i)
            s.walls.body.push_back(s.walls.normal[3*i] > 0.5 ? 0 : -1);
        s.motion = [](int, double t)
        {
            WallPose p;
            p.translation = {{0.3*(1 - std::cos(5*t)), 0, 0}};
            return p;
        };
        return s;
    }

    static void move(SolidInput& s, const Vector3& v)
    {
        s.input.particles.velocity.clear();
        for (std::size_t i = 0; i < s.input.particles.size(); ++i)
            s.input.particles.velocity.insert(s.input.particles.velocity.end(), v.begin(), v.end());
    }

    //- A bonded block that falls into water, beside another scene's: the same that floats along
    //  with it
    Flow plunging() const
    {
        Flow s = breaking("extrapolated", "leapfrog");
        s.name = "plunging";
        const double size = 0.8*s.c.spacing;
        s.solids.push_back(block(s.c, 3, size, {{1.3, 3*s.c.spacing + 0.75, deep(0.3)}}));
        s.solids[0].coupling.kind = "extrapolated";
        move(s.solids[0], {{0, -1.5, 0}});
        return s;
    }

    Flow carried() const { return about(false, "carried"); }

    //- The same block held whole: the current goes past it
    Flow passing() const { return about(true, "passing"); }

    Flow about(bool held, const char* name) const
    {
        Flow s = sheared();
        s.name = name;
        const double size = 0.8*s.c.spacing, low = 0.3;
        s.solids.push_back(block(s.c, 3, size, {{low, low, deep(low)}}));
        if (held)
        {
            DemGroup all;
            for (bool& axis : all.held) axis = true;
            all.heldSpin = true;
            s.solids[0].input.groups.push_back(all);
        }
        else move(s.solids[0], {{1.5, 0.4, 0}});
        FluidInput around;
        for (std::size_t i = 0; i < s.fluid.size(); ++i)
        {
            bool inside = true;
            for (int d = 0; d < D(); ++d)
            {
                const double x = s.fluid.position[3*i + d];
                inside = inside && x > low - 0.5*s.c.spacing && x < low + 3*size + 0.5*s.c.spacing;
            }
            if (inside) continue;
            around.position.insert(
                around.position.end(), &s.fluid.position[3*i], &s.fluid.position[3*i] + 3);
            around.velocity.insert(
                around.velocity.end(), &s.fluid.velocity[3*i], &s.fluid.velocity[3*i] + 3);
            around.density.push_back(s.fluid.density[i]);
        }
        s.fluid = around;
        return s;
    }

    //- A current along a floor, all of it as fast: nothing in it comes nearer, but other parts of
    //  the floor do
    Flow sliding() const
    {
        SphConfig c = flowConfig({{3, 1, 0.9}}, false);
        c.periodic[0] = c.periodic[2] = true;
        c.viscosityModel = "none";
        const double level = 3*c.spacing;
        Flow s{"sliding", c, lattice(c, {{0, level, 0}}, {{3, level + 0.2, deep(0.9)}}),
            floorOf(c, 1, level, 3), {}, {}};
        set(s.fluid, [](const Vector3&) { return Vector3{{1.9, 0, 0}}; });
        return s;
    }

    //- Two lumps that have nothing between them, and meet
    Flow meeting() const
    {
        Flow s{"meeting", flowConfig({{3, 1, 0.9}}, false), {}, {}, {}, {}};
        const double side = 3*s.c.spacing;
        s.fluid = lattice(
            s.c, {{1.5 - 0.3 - side, 0.4, deep(0.4)}}, {{1.5 - 0.3, 0.4 + side, deep(0.4 + side)}});
        const FluidInput other = lattice(
            s.c, {{1.5 + 0.3, 0.4, deep(0.4)}}, {{1.5 + 0.3 + side, 0.4 + side, deep(0.4 + side)}});
        s.fluid.position.insert(
            s.fluid.position.end(), other.position.begin(), other.position.end());
        s.fluid.density.insert(s.fluid.density.end(), other.density.begin(), other.density.end());
        s.fluid.velocity.assign(s.fluid.position.size(), 0.0);
        set(s.fluid, [](const Vector3& x) { return Vector3{{x[0] < 1.5 ? 1.2 : -1.2, 0, 0}}; });
        return s;
    }

    std::vector<Flow> allFlows() const
    {
        return {sliding(), meeting(), sheared(), rotating(),
            breaking("extrapolated", "leapfrog"),
            breaking("stationary", "symplectic"), spray(), piston(),
            plunging(), carried(), passing()};
    }

    template<class State>
    static std::vector<double> byIds(const State& s)
    {
        std::vector<std::size_t> order(s.id.size());
        std::iota(order.begin(), order.end(), std::size_t(0));
        std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return s.id[a] < s.id[b]; });
        std::vector<double> x;
        for (const std::size_t i : order) x.insert(x.end(), &s.position[3*i], &s.position[3*i] + 3);
        return x;
    }

    static Places placesOf(SphScene& s)
    {
        Places p;
        p.fluid = byIds(s.fluid());
        if (s.solids()) p.solids = byIds(s.solids()->particles());
        p.walls = s.walls().position;
        return p;
    }

    static double apart2(const SphConfig& c, const double* a, const double* b)
    {
        double r2 = 0;
        for (int d = 0; d < c.dimensions; ++d)
        {
            double s = a[d] - b[d];
            const double length = c.domainMax[d] - c.domainMin[d];
            if (c.periodic[d]) s -= length*std::rint(s/length);
            r2 += s*s;
        }
        return r2;
    }

    struct Bounds { std::int64_t least = 0, most = 0; };

    //- Ordered pairs of the two sets that are nearer than the support; at its edge they may be seen
    //  either way. One and the same set: each with all others
    static Bounds pairsWithin(
        const SphConfig& c, const std::vector<double>& a, const std::vector<double>& b)
    {
        const double support = 2*c.smoothingRatio*c.spacing, nearly = support*(1 - 1e-5),
                     beyond = support*(1 + 1e-5);
        Bounds n;
        for (std::size_t i = 0; i < a.size(); i += 3)
            for (std::size_t j = 0; j < b.size(); j += 3)
            {
                const double r2 = apart2(c, &a[i], &b[j]);
                if (r2 >= beyond*beyond || (&a == &b && i == j)) continue;
                ++n.most;
                n.least += r2 < nearly*nearly;
            }
        return n;
    }
};

} // namespace riprap

/*  Walls in a step: where their points and faces are, what the fluid gives their points, and its
    force on them.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/sph/parts/sphParts.hpp"
#include "solvers/sph/parts/sphRebuild.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class WallPasses
{
public:

    using real = typename P::real;

    explicit WallPasses(SphParts<Backend, D, P>& parts) : p_(parts) {}

    //- Points of moving walls to the end of the step, or to its middle
    void move(bool half);

    //- Points in the order of cells, where neighbours are sought
    void place();

    //- What the fluid sees of them at the very start, of all models
    void setStationary();

    //- What the fluid sees of them once they are placed or moved, of models that do not ask it
    void setPoints();

    //- Pressure, density and velocity of the points, of models that take them from the fluid
    void extrapolate(bool inStep);

    //- Force on the walls, or that of the pressure alone; without somewhere to put it, the work
    //  that moving walls do in this step
    void force(real* force, bool viscous = true);

    //- Faces to where they are at the end of the step
    void moveFaces();

    //- Bodies get what their faces took from the fluid in this step's drift
    void pushBodies();

private:

    template<class Model> void followFluid(bool inStep);

    SphParts<Backend, D, P>& p_;
};

template<class Backend, int D, class P>
void WallPasses<Backend, D, P>::move(bool half)
{
    if (!p_.walls.bodies) return;
    MoveWalls<Backend, D, P> m;
    m.box = p_.set.box;
    m.fields = p_.walls.fields();
    m.wall = p_.walls.records.view();
    m.rest = p_.walls.rest.data();
    for (int d = 0; d < D; ++d)
    {
        m.axes[d] = p_.set.config.axes[d];
        m.reference[d] = p_.walls.reference.data() + std::size_t(d)*p_.walls.count;
    }
    m.table = p_.poses.table();
    m.allowedWay = p_.walls.allowedWay;
    m.half = half;
    m.clock = p_.clock.data();
    forEach(p_.set.context, p_.walls.count, m);
    setPoints();
}

template<class Backend, int D, class P>
void WallPasses<Backend, D, P>::place()
{
    WallKeys<D, P> keys;
    keys.box = p_.set.box;
    keys.grid = p_.set.grid;
    for (int d = 0; d < D; ++d)
        keys.x[d] = p_.walls.values.template data<std::int64_t>(p_.walls.at.x + d);
    keys.keys = p_.walls.sort.keys();
    keys.indices = p_.walls.sort.indices();
    forEach(p_.set.context, p_.walls.count, keys);
    p_.walls.sort.sort(p_.set.context, p_.walls.count);
    p_.walls.values.permute(p_.set.context, p_.walls.sort.order(), p_.walls.count);
    if (!p_.walls.bodies)
    {
        p_.walls.values.releaseSpare();
        p_.walls.sort.releaseScratch();
    }
    PlaceWalls<Backend, D, P> place{};
    place.box = p_.set.box;
    place.records = p_.walls.records.view();
    if constexpr (Backend::gpu)
    {
        p_.memory.frames.clearStill(p_.set.context);
        place.frames = p_.memory.frames.view();
    }
    for (int d = 0; d < D; ++d)
    {
        place.x[d] = p_.walls.values.template data<std::int64_t>(p_.walls.at.x + d);
        place.reference[d] = p_.walls.bodies
            ? p_.walls.reference.data() + std::size_t(d)*p_.walls.count
            : nullptr;
    }
    forEach(p_.set.context, p_.walls.count, place);
    setPoints();
}

template<class Backend, int D, class P>
void WallPasses<Backend, D, P>::setStationary()
{
    forEach(p_.set.context, p_.walls.count,
        StationaryWall<Backend, D, P>{p_.walls.records.view(), p_.walls.fields(), p_.set.model});
}

template<class Backend, int D, class P>
void WallPasses<Backend, D, P>::setPoints()
{
    withWallModel(p_.set.config, [&](auto model)
    {
        using Model = decltype(model);
        if constexpr (!Model::followsFluid)
            forEach(p_.set.context, p_.walls.count,
                typename Model::template Points<Backend, D, P>{
                    p_.walls.records.view(), p_.walls.fields(), p_.set.model});
    });
}

template<class Backend, int D, class P>
void WallPasses<Backend, D, P>::extrapolate(bool inStep)
{
    if (!p_.walls.count) return;
    withWallModel(p_.set.config, [&](auto model)
    {
        if constexpr (decltype(model)::followsFluid) followFluid<decltype(model)>(inStep);
    });
}

template<class Backend, int D, class P>
template<class Model>
void WallPasses<Backend, D, P>::followFluid(bool inStep)
{
    withKernel(p_.set.config, [&](auto kernel, auto variable)
    {
        using Kernel = decltype(kernel);
        typename Model::template Pass<Backend, D, P, Kernel, decltype(variable)::value> pass;
        pass.box = p_.set.box;
        pass.grid = p_.set.grid;
        pass.source[0] = p_.fluidSource(true);
        pass.wall = p_.walls.records.view();
        pass.fields = p_.walls.fields();
        pass.kernel = p_.set.template kernelConstants<Kernel>();
        pass.model = p_.set.model;
        pass.count = p_.walls.count;
        pass.clock = inStep ? p_.clock.data() : nullptr;
        pass.ghosts = p_.wallGhosts();
        p_.run(pass, p_.walls.count);
    });
    if (p_.wallRanks) p_.wallRanks->share();
}

template<class Backend, int D, class P>
void WallPasses<Backend, D, P>::force(real* force, bool viscous)
{
    if (!force && !p_.walls.bodies) return;
    withKernel(p_.set.config, [&](auto kernel, auto variable)
    {
        using Kernel = decltype(kernel);
        p_.set.terms.withWallTerms(viscous, [&](const auto& terms)
        {
            using WallTerms = std::decay_t<decltype(terms)>;
            WallForcePass<Backend, D, P, Kernel, decltype(variable)::value, WallTerms> pass{
                p_.set.box, p_.set.grid, {p_.fluidSource(true)}, p_.walls.records.view(), terms,
                p_.set.template kernelConstants<Kernel>(), p_.set.model, p_.walls.count, force,
                nullptr, {}, nullptr, nullptr, p_.wallGhosts()};
            for (int d = 0; d < D; ++d) pass.wallVelocity[d] = p_.walls.velocity(d);
            if (force) return directPairLoop(p_.set.context, pass, p_.walls.count);
            pass.clock = p_.clock.data();
            pass.work = p_.walls.values.template data<double>(p_.walls.at.work);
            pass.pressureWork = p_.walls.values.template data<double>(p_.walls.at.pressureWork);
            p_.run(pass, p_.walls.count);
        });
    });
}

template<class Backend, int D, class P>
void WallPasses<Backend, D, P>::moveFaces()
{
    if (!p_.faces.any()) return;
    if (p_.walls.bodies)
    {
        PoseFaces<D, PoseTable> pose{p_.poses.table(), {}, p_.faces.pose(), p_.clock.data()};
        for (int d = 0; d < 3; ++d) pose.axes[d] = p_.set.config.axes[d];
        forEach(p_.set.context, p_.walls.bodies, pose);
    }
    if (p_.faces.bodies())
        forEach(p_.set.context, p_.faces.bodies(),
            PoseBodies<D, P>{p_.solids.side->bodies(), p_.faces.pose() + 1 + p_.walls.bodies});
}

template<class Backend, int D, class P>
void WallPasses<Backend, D, P>::pushBodies()
{
    if (!p_.faces.bodies() || !p_.solids.meetFluid) return;
    if (p_.solidRanks) p_.solidRanks->sumBlows(p_.faces.blow(), p_.faces.bodies());
    forEach(p_.set.context, p_.faces.bodies(),
        BlowBodies<D, P>{p_.solids.side->bodies(), p_.faces.blow(), double(p_.set.model.mass)});
}

} // namespace riprap

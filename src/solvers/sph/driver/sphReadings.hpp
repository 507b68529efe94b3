/*  Everything that is read back but forces.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/snapshot.hpp"
#include "core/loops/reduceMax.hpp"
#include "solvers/sph/driver/sphNeighbours.hpp"
#include "solvers/sph/parts/sphReadBack.hpp"
#include "solvers/fluidEnd.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class SphReadings
{
public:

    using real = typename P::real;
    using position = typename P::position;

    SphReadings(SphParts<Backend, D, P>& parts, FluidPasses<Backend, D, P>& fluid,
        WallPasses<Backend, D, P>& walls, SphNeighbours<Backend, D, P>& neighbours)
        : p_(parts), fluid_(fluid), walls_(walls), neighbours_(neighbours)
    {}

    // As SphScene has them
    FluidState fluid() { return fluid(false).take(); }
    Later<FluidState> fluidLater() { return fluid(true); }
    WallState walls();
    SphEnergy energy();
    FluidExtremes extremes();
    FluidEnd farEnd(const Vector3& direction, double reach);
    FaceContacts faceContacts();
    SampleResult sample(const std::vector<double>& points, const SightPlanes&);
    NeighbourCounts countNeighbours();
    double neighboursPerParticle();
    double estimateTimeStep(std::string& limit);
    std::vector<ArrayInfo> arrays() const;
    std::vector<KernelInfo> kernels() const;

private:

    Later<FluidState> fluid(bool later);

    SphParts<Backend, D, P>& p_;
    FluidPasses<Backend, D, P>& fluid_;
    WallPasses<Backend, D, P>& walls_;
    SphNeighbours<Backend, D, P>& neighbours_;
};

template<class Backend, int D, class P>
Later<FluidState> SphReadings<Backend, D, P>::fluid(bool later)
{
    const int n = p_.fluid.active();
    Snapshot<Backend> now(p_.set.context, later && !p_.ranks);
    FieldSet<Backend>& values = p_.fluid.values;
    std::array<ReadValues<std::int64_t>, D> places;
    std::array<ReadValues<real>, D> velocities;
    for (int d = 0; d < D; ++d)
    {
        places[d] = now.values(values.template data<std::int64_t>(p_.fluid.at.x + d), n);
        velocities[d] = now.values(values.template data<real>(p_.fluid.at.v + d), n);
    }
    const auto deviations = now.values(values.template data<real>(p_.fluid.at.deviation), n);
    const auto ids = now.values(values.template data<std::int32_t>(p_.fluid.at.id), n);
    const auto all = [=, model = p_.set.model]
    {
        FluidState s;
        std::vector<std::int64_t> x[D];
        for (int d = 0; d < D; ++d) x[d] = places[d]();
        p_.set.toMetres(x, n, s.position);
        s.velocity.assign(3*std::size_t(n), 0.0);
        for (int d = 0; d < D; ++d)
        {
            const std::vector<real> v = velocities[d]();
            #pragma omp parallel for schedule(static) if (n > 10000)
            for (int i = 0; i < n; ++i) s.velocity[3*std::size_t(i) + p_.set.config.axes[d]] = v[i];
        }
        const std::vector<real> deviation = deviations();
        s.id = ids();
        for (auto* v : {&s.density, &s.pressure, &s.smoothingLength}) v->resize(n);
        #pragma omp parallel for schedule(static) if (n > 10000)
        for (int i = 0; i < n; ++i)
        {
            s.density[i] = p_.set.config.density*(1 + double(deviation[i]));
            s.pressure[i] = model.eos.pressure(deviation[i]);
            s.smoothingLength[i] = model.smoothingLength(deviation[i]);
        }
        if (!p_.ranks) return s;
        for (auto* v : {&s.position, &s.velocity}) p_.ranks->dropGhosts(*v, 3);
        for (auto* v : {&s.density, &s.pressure, &s.smoothingLength}) p_.ranks->dropGhosts(*v, 1);
        p_.ranks->dropGhosts(s.id, 1);
        return s;
    };
    return takenOf<FluidState>(now.keeps() || !later, n, all);
}

template<class Backend, int D, class P>
WallState SphReadings<Backend, D, P>::walls()
{
    WallState s;
    s.position = p_.walls.input;
    s.velocity.assign(p_.walls.input.size(), 0.0);
    s.pressure.assign(p_.walls.count, 0.0);
    if (!p_.walls.count) return s;
    fluid_.refreshRecords();
    walls_.extrapolate(false);
    Array<Backend, real> pressure;
    pressure.allocate(p_.set.context, p_.walls.count);
    const auto id = p_.walls.values.template download<std::int32_t>(p_.set.context, p_.walls.at.id);
    forEach(p_.set.context, p_.walls.count,
        ReadWalls<Backend, D, P>{p_.walls.records.view(), p_.walls.fields().id, pressure.data()});
    const auto p = pressure.download();
    for (int i = 0; i < p_.walls.count; ++i) s.pressure[i] = p[i];
    for (int i = 0; i < p_.walls.count; ++i) if (p_.wallGhost(i)) s.pressure[id[i]] = 0;
    if (!p_.walls.bodies) return s;
    for (int d = 0; d < D; ++d)
    {
        const auto x = p_.walls.values.template download<std::int64_t>(
            p_.set.context, p_.walls.at.x + d);
        const auto v = p_.walls.values.template download<real>(p_.set.context, p_.walls.at.v + d);
        for (int i = 0; i < p_.walls.count; ++i)
        {
            if (p_.walls.bodyOf[id[i]] < 0) continue;
            s.position[3*std::size_t(id[i]) + p_.set.config.axes[d]] = p_.set.box.toMetres(d, x[i]);
            s.velocity[3*std::size_t(id[i]) + p_.set.config.axes[d]] = v[i];
        }
    }
    return s;
}

template<class Backend, int D, class P>
SphEnergy SphReadings<Backend, D, P>::energy()
{
    const auto sums = sumOver<3>(p_.set.context, p_.fluid.active(),
        withoutGhosts(EnergySums<D, P>{p_.set.box, p_.set.model, p_.fluid.fields()}, p_.ghosts()));
    SphEnergy e;
    e.kinetic = sums[0];
    e.potential = sums[1];
    e.elastic = sums[2];
    p_.clock.read();
    e.faceWork = double(p_.set.model.mass)*faceUnit*double(p_.clock.now.faces.energy);
    e.stiffening = p_.stiffening;
    if (!p_.walls.bodies) return e;
    const auto sumOf = [&](int field)
    {
        const auto work = p_.walls.values.template download<double>(p_.set.context, field);
        double sum = 0;
        for (int i = 0; i < p_.walls.count; ++i) if (!p_.wallGhost(i)) sum += work[i];
        return sum;
    };
    e.wallWork = sumOf(p_.walls.at.work);
    e.wallPressureWork = sumOf(p_.walls.at.pressureWork);
    return e;
}

template<class Backend, int D, class P>
FluidExtremes SphReadings<Backend, D, P>::extremes()
{
    const int n = p_.fluid.active();
    FluidExtremes e;
    e.speed = std::sqrt(reduceMax(
        p_.set.context, n, withoutGhosts(FluidSpeed2<D, P>{p_.fluid.fields()}, p_.ghosts())));
    e.densityDeviation = reduceMax(
        p_.set.context, n, withoutGhosts(FluidDeviation<D, P>{p_.fluid.fields()}, p_.ghosts()));
    return e;
}

template<class Backend, int D, class P>
FluidEnd SphReadings<Backend, D, P>::farEnd(const Vector3& direction, double reach)
{
    Vec<D, double> lower, upper;
    for (int d = 0; d < D; ++d)
    {
        lower.c[d] = p_.set.box.lower[d];
        upper.c[d] = p_.set.box.lower[d] + p_.set.box.length[d];
    }
    const int n = p_.fluid.active();
    std::function<double(double)> ofAll;
    if (p_.ranks) ofAll = [this](double here) { return p_.ranks->largest(here); };
    FluidEnd end = farEndOf<Backend, D>(p_.set.context, n,
        FluidPlaces<Backend, D, P>{p_.set.box, p_.fluid.fields(), p_.ghosts()},
        p_.set.config.axes, direction, reach, lower, upper, p_.set.emptyCoordinate, ofAll);
    if (p_.ranks) end.particles = p_.ranks->owned();
    return end;
}

template<class Backend, int D, class P>
FaceContacts SphReadings<Backend, D, P>::faceContacts()
{
    p_.clock.read();
    FaceContacts r;
    r.count = p_.clock.now.faces.contacts;
    r.atBodies = p_.clock.now.faces.atBodies;
    for (int d = 0; d < D; ++d)
        r.impulse[p_.set.config.axes[d]] = double(p_.set.model.mass)*faceUnit
            *double(p_.clock.now.faces.impulse[d]);
    return r;
}

//- D components of the normal and the depth, one plane after the other
template<int D, class R>
std::vector<R> solvedPlanes(const SightPlanes& planes, const int* axes)
{
    std::vector<R> r;
    for (std::size_t k = 0; k < planes.depth.size(); ++k)
    {
        for (int d = 0; d < D; ++d) r.push_back(R(planes.normal[3*k + axes[d]]));
        r.push_back(R(planes.depth[k]));
    }
    return r;
}

//- Points [m], three coordinates each, as passes have them. Points outside the box see its edge,
//  where there is no fluid
template<int D, class P>
std::vector<typename P::position> placesOf(
    const Box<D, P>& box, const std::vector<double>& points, const int* axes)
{
    const std::size_t m = points.size()/3;
    std::vector<typename P::position> x(m*D);
    for (std::size_t i = 0; i < m; ++i)
        for (int d = 0; d < D; ++d)
        {
            double p = points[3*i + axes[d]];
            if (!box.periodic[d])
                p = std::min(std::max(p, box.lower[d]), box.lower[d] + box.length[d]*(1 - 1e-9));
            x[i*D + d] = box.pairPosition(d, box.toFixed(d, p));
        }
    return x;
}

template<class Backend, int D, class P>
SampleResult SphReadings<Backend, D, P>::sample(
    const std::vector<double>& points, const SightPlanes& planes)
{
    const std::size_t m = points.size()/3;
    SampleResult r;
    r.volumeFraction.assign(m, 0.0);
    r.pressure.assign(m, 0.0);
    r.velocity.assign(3*m, 0.0);
    r.centroid.assign(3*m, 0.0);
    if (!m || !p_.fluid.n) return r;
    // fluid may have left its cells by more than the search allows for
    if constexpr (Backend::gpu) if (p_.memory.frames.on()) neighbours_.sortNow();
    const std::vector<position> x = placesOf<D, P>(p_.set.box, points, p_.set.config.axes);
    fluid_.refreshRecords();
    constexpr int channels = 2 + 2*D;
    Array<Backend, position> device;
    Array<Backend, real> result, plane;
    Array<Backend, std::int32_t> first;
    device.upload(p_.set.context, x);
    result.allocate(p_.set.context, m*channels);
    if (!planes.depth.empty())
    {
        first.upload(p_.set.context, planes.first);
        plane.upload(p_.set.context, solvedPlanes<D, real>(planes, p_.set.config.axes));
    }
    withKernel(p_.set.config, [&](auto kernel, auto variable)
    {
        using Kernel = decltype(kernel);
        SamplePass<Backend, D, P, Kernel, decltype(variable)::value> pass{p_.set.box, p_.set.grid,
            {p_.fluidSource(false)}, p_.set.template kernelConstants<Kernel>(), p_.set.model,
            device.data(), first.data(), plane.data(), result.data(), int(m)};
        directPairLoop(p_.set.context, pass, int(m));
    });
    const auto sums = result.download();
    for (std::size_t i = 0; i < m; ++i)
    {
        Vec<D, position> place;
        for (int d = 0; d < D; ++d) place.c[d] = x[i*D + d];
        if (p_.ranks && !p_.ranks->has(place)) continue;
        const real* s = &sums[i*channels];
        r.volumeFraction[i] = s[0];
        if (!(s[0] > 1e-6)) continue;
        r.pressure[i] = s[1]/s[0];
        for (int d = 0; d < D; ++d)
        {
            r.velocity[3*i + p_.set.config.axes[d]] = s[2 + d]/s[0];
            r.centroid[3*i + p_.set.config.axes[d]] = s[2 + D + d]/s[0];
        }
    }
    return r;
}

template<class Backend, int D, class P>
NeighbourCounts SphReadings<Backend, D, P>::countNeighbours()
{
    NeighbourCounts r;
    r.particles = p_.ranks ? p_.ranks->particles().ownedHere() : p_.fluid.active();
    fluid_.refreshRecords();
    const double support = supportOf(p_.set.config);
    const auto count = [&](const Source<Backend, D, P>& source,
                           const RecordsView<Backend, D, P>& target, int n,
                           const auto& ghost, bool solids)
    {
        if (!n || !source.start) return std::int64_t(0);
        Array<Backend, real> result;
        result.allocate(p_.set.context, n);
        const CountPass<Backend, D, P> pass{
            p_.set.box, p_.set.grid, {source}, target, real(support*support), result.data(), n};
        if (solids) p_.runOverSolids(pass);
        else p_.run(pass, n);
        const std::vector<real> counts = result.download();
        std::int64_t sum = 0;
        for (int i = 0; i < n; ++i)
            if (!ghost(i)) sum += std::int64_t(counts[i]);
        return sum;
    };
    const int n = p_.fluid.active();
    const auto ghost = [&](int i) { return p_.ghost(i); };
    r.fluid = count(p_.fluidSource(false), p_.fluid.records.view(), n, ghost, false);
    r.walls = count(p_.wallSource(), p_.fluid.records.view(), n, ghost, false);
    if (p_.walls.count && (p_.walls.bodies || p_.set.wallsFollowFluid()))
        r.aboutWalls = count(
            p_.fluidSource(true), p_.walls.records.view(), p_.walls.count,
            [&](int i) { return p_.wallGhost(i); }, false);
    if (!p_.solids.meetFluid) return r;
    int solids = 0;
    p_.set.context.toHost(&solids, p_.solids.sort.active(), sizeof(int));
    r.solids = count(p_.solidSource(), p_.fluid.records.view(), n, ghost, false);
    r.aboutSolids = count(p_.fluidAboutSolids(), p_.solids.records.view(), solids,
        [&](int i) { return p_.solidGhost(i); }, true);
    return r;
}

template<class Backend, int D, class P>
double SphReadings<Backend, D, P>::neighboursPerParticle()
{
    const NeighbourCounts c = countNeighbours();
    return c.particles ? double(c.fluid + c.walls)/double(c.particles) : 0;
}

template<class Backend, int D, class P>
double SphReadings<Backend, D, P>::estimateTimeStep(std::string& limit)
{
    p_.clock.read();
    Limit l = Limit::none;
    const double dt = p_.tick().longest(p_.clock.now, l);
    limit = wordOf(l);
    return dt;
}

template<class Backend, int D, class P>
std::vector<ArrayInfo> SphReadings<Backend, D, P>::arrays() const
{
    std::vector<ArrayInfo> r;
    const auto add = [&](const char* set, const std::string& name, std::size_t bytes, std::size_t n)
    { if (bytes) r.push_back(ArrayInfo{set, name, n ? bytes/n : 0, bytes}); };
    for (const auto& f : p_.fluid.values.info()) add("fluid", f.name, f.bytes, p_.fluid.n);
    add("fluid", "records", p_.fluid.records.bytes(), p_.fluid.n);
    add("fluid", "reference", p_.fluid.reference.bytes(), p_.fluid.n);
    std::size_t cells = p_.fluid.sort.bytes();
    if constexpr (Backend::gpu) cells += p_.memory.frames.bytes();
    add("fluid", "cells", cells, p_.fluid.n);
    for (const auto& f : p_.walls.values.info()) add("wall", f.name, f.bytes, p_.walls.count);
    add("wall", "records", p_.walls.records.bytes(), p_.walls.count);
    add("wall", "cells", p_.walls.sort.bytes(), p_.walls.count);
    add("wall", "motion", p_.walls.reference.bytes() + p_.walls.rest.bytes() + p_.poses.bytes(),
        p_.walls.count);
    add("wall", "faces", p_.faces.bytes(), 0);
    if (p_.solids.side)
    {
        add("solid points", "records", p_.solids.records.bytes(), p_.solids.count);
        add("solid points", "cells", p_.solids.cellBytes(), p_.solids.count);
        add("solid points", "velocity, mass", p_.solids.motionBytes(), p_.solids.count);
        add("solid points", "force", p_.solids.force.bytes() + p_.solids.forceBefore.bytes(),
            p_.solids.count);
        add("fluid", "action of solids", p_.solids.actionBytes(), p_.fluid.n);
        for (const ArrayInfo& a : p_.solids.scene->arrays()) r.push_back(a);
    }
    add("lists", "fluidSolid", p_.memory.fluidSolid.bytes(), p_.fluid.n);
    add("lists", "solidFluid", p_.memory.solidFluid.bytes(), p_.solids.count);
    add("lists", "fluidFluid", p_.memory.fluidFluid.bytes(), p_.fluid.n);
    add("lists", "fluidWall", p_.memory.fluidWall.bytes(), p_.fluid.n);
    add("lists", "wallFluid", p_.memory.wallFluid.bytes(), p_.walls.count);
    return r;
}

template<class Backend, int D, class P>
std::vector<KernelInfo> SphReadings<Backend, D, P>::kernels() const
{
    std::vector<KernelInfo> r;
    for (const auto& e : p_.set.context.profile.entries())
        r.push_back(KernelInfo{e.name, e.launches, e.seconds});
    if (p_.solids.side) for (KernelInfo k : p_.solids.scene->kernels())
    {
        k.name = "solids: " + k.name;
        r.push_back(k);
    }
    return r;
}

} // namespace riprap

/*  SphSolver: everything that is read back.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/loops/reduceMax.hpp"
#include "solvers/fluidEnd.hpp"
#include "solvers/sph/sphReadBack.hpp"
#include "solvers/sph/sphSolver.hpp"

namespace riprap
{

template<class Backend, int D, class P>
int SphSolver<Backend, D, P>::activeFluid()
{
    int active = 0;
    context_.toHost(&active, fluidSort_.active(), sizeof(int));
    return active;
}

template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::toMetres(
    const std::vector<std::int64_t>* x, std::size_t n, std::vector<double>& out) const
{
    out.assign(3*n, emptyCoordinate_);
    for (int d = 0; d < D; ++d)
        #pragma omp parallel for schedule(static) if (n > 10000)
        for (std::size_t i = 0; i < n; ++i) out[3*i + config_.axes[d]] = box_.toMetres(d, x[d][i]);
}

template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::refreshRecords()
{
    forEach(context_, n_, mover<RefreshRecords<Backend, D, P>>());
    if (ranks_) ranks_->shareRecords();
}

template<class Backend, int D, class P>
FluidState SphSolver<Backend, D, P>::fluid()
{
    const int n = activeFluid();
    FluidState s;
    std::vector<std::int64_t> x[D];
    for (int d = 0; d < D; ++d)
        x[d] = fluid_.template download<std::int64_t>(context_, xField_ + d);
    toMetres(x, n, s.position);
    s.velocity.assign(3*std::size_t(n), 0.0);
    for (int d = 0; d < D; ++d)
    {
        const auto v = fluid_.template download<real>(context_, vField_ + d);
        #pragma omp parallel for schedule(static) if (n > 10000)
        for (int i = 0; i < n; ++i) s.velocity[3*std::size_t(i) + config_.axes[d]] = v[i];
    }
    const auto deviation = fluid_.template download<real>(context_, deviationField_);
    s.id = fluid_.template download<std::int32_t>(context_, idField_);
    s.id.resize(n);
    for (auto* v : {&s.density, &s.pressure, &s.smoothingLength}) v->resize(n);
    #pragma omp parallel for schedule(static) if (n > 10000)
    for (int i = 0; i < n; ++i)
    {
        s.density[i] = config_.density*(1 + double(deviation[i]));
        s.pressure[i] = model_.eos.pressure(deviation[i]);
        s.smoothingLength[i] = model_.smoothingLength(deviation[i]);
    }
    if (!ranks_) return s;
    for (auto* v : {&s.position, &s.velocity}) ranks_->dropGhosts(*v, 3);
    for (auto* v : {&s.density, &s.pressure, &s.smoothingLength}) ranks_->dropGhosts(*v, 1);
    ranks_->dropGhosts(s.id, 1);
    return s;
}

template<class Backend, int D, class P>
WallState SphSolver<Backend, D, P>::walls()
{
    WallState s;
    s.position = wallInput_;
    s.velocity.assign(wallInput_.size(), 0.0);
    s.pressure.assign(nWalls_, 0.0);
    if (!nWalls_) return s;
    refreshRecords();
    wallPass(false);
    Array<Backend, real> pressure;
    pressure.allocate(context_, nWalls_);
    const auto id = wall_.template download<std::int32_t>(context_, wallIdField_);
    forEach(context_, nWalls_,
        ReadWalls<Backend, D, P>{wallRecords_.view(), wallFields().id, pressure.data()});
    const auto p = pressure.download();
    for (int i = 0; i < nWalls_; ++i) s.pressure[i] = p[i];
    if (ranks_) for (int i = 0; i < nWalls_; ++i) if (ranks_->wallGhost(i)) s.pressure[id[i]] = 0;
    if (!nBodies_) return s;
    for (int d = 0; d < D; ++d)
    {
        const auto x = wall_.template download<std::int64_t>(context_, wallXField_ + d);
        const auto v = wall_.template download<real>(context_, wallVField_ + d);
        for (int i = 0; i < nWalls_; ++i)
        {
            if (wallBodies_[id[i]] < 0) continue;
            s.position[3*std::size_t(id[i]) + config_.axes[d]] = box_.toMetres(d, x[i]);
            s.velocity[3*std::size_t(id[i]) + config_.axes[d]] = v[i];
        }
    }
    return s;
}

template<class Backend, int D, class P>
SphEnergy SphSolver<Backend, D, P>::energy()
{
    const auto sums = sumOver<3>(context_, activeFluid(),
        withoutGhosts(EnergySums<D, P>{box_, model_, fluidFields()}, ghosts()));
    SphEnergy e;
    e.kinetic = sums[0];
    e.potential = sums[1];
    e.elastic = sums[2];
    readClock();
    e.faceWork = double(model_.mass)*faceUnit*double(host_.faceEnergy);
    e.stiffening = stiffening_;
    if (!nBodies_) return e;
    for (const double w : wall_.template download<double>(context_, wallWorkField_))
        e.wallWork += w;
    for (const double w : wall_.template download<double>(context_, wallPressureWorkField_))
        e.wallPressureWork += w;
    return e;
}

template<class Backend, int D, class P>
FluidExtremes SphSolver<Backend, D, P>::extremes()
{
    const int n = activeFluid();
    FluidExtremes e;
    e.speed = std::sqrt(
        reduceMax(context_, n, withoutGhosts(FluidSpeed2<D, P>{fluidFields()}, ghosts())));
    e.densityDeviation = reduceMax(
        context_, n, withoutGhosts(FluidDeviation<D, P>{fluidFields()}, ghosts()));
    return e;
}

template<class Backend, int D, class P>
FluidEnd SphSolver<Backend, D, P>::farEnd(const Vector3& direction, double reach)
{
    if (ranks_) return ranks_->farEnd(fluid().position, direction, reach);
    Vec<D, double> lower, upper;
    for (int d = 0; d < D; ++d)
    {
        lower.c[d] = box_.lower[d];
        upper.c[d] = box_.lower[d] + box_.length[d];
    }
    return farEndOf<Backend, D>(context_, activeFluid(), FluidPlaces<D, P>{box_, fluidFields()},
        config_.axes, direction, reach, lower, upper, emptyCoordinate_);
}

template<class Backend, int D, class P>
FaceContacts SphSolver<Backend, D, P>::faceContacts()
{
    readClock();
    FaceContacts r;
    r.count = host_.faceContacts;
    r.atBodies = host_.bodyContacts;
    for (int d = 0; d < D; ++d)
        r.impulse[config_.axes[d]] = double(model_.mass)*faceUnit*double(host_.faceImpulse[d]);
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
SampleResult SphSolver<Backend, D, P>::sample(
    const std::vector<double>& points, const SightPlanes& planes)
{
    const std::size_t m = points.size()/3;
    SampleResult r;
    r.volumeFraction.assign(m, 0.0);
    r.pressure.assign(m, 0.0);
    r.velocity.assign(3*m, 0.0);
    r.centroid.assign(3*m, 0.0);
    if (!m || !n_) return r;
    // fluid may have left its cells by more than the search allows for
    if constexpr (Backend::gpu) if (parts_.frames.on()) sortNow();
    const std::vector<position> x = placesOf<D, P>(box_, points, config_.axes);
    refreshRecords();
    constexpr int channels = 2 + 2*D;
    Array<Backend, position> device;
    Array<Backend, real> result, plane;
    Array<Backend, std::int32_t> first;
    device.upload(context_, x);
    result.allocate(context_, m*channels);
    if (!planes.depth.empty())
    {
        first.upload(context_, planes.first);
        plane.upload(context_, solvedPlanes<D, real>(planes, config_.axes));
    }
    withKernel(config_, [&](auto kernel, auto variable)
    {
        using Kernel = decltype(kernel);
        SamplePass<Backend, D, P, Kernel, decltype(variable)::value> pass{box_, grid_,
            {fluidSource(false)}, kernelConstants<Kernel>(), model_, device.data(), first.data(),
            plane.data(), result.data(), int(m)};
        directPairLoop(context_, pass, int(m));
    });
    const auto sums = result.download();
    for (std::size_t i = 0; i < m; ++i)
    {
        Vec<D, position> place;
        for (int d = 0; d < D; ++d) place.c[d] = x[i*D + d];
        if (ranks_ && !ranks_->has(place)) continue;
        const real* s = &sums[i*channels];
        r.volumeFraction[i] = s[0];
        if (!(s[0] > 1e-6)) continue;
        r.pressure[i] = s[1]/s[0];
        for (int d = 0; d < D; ++d)
        {
            r.velocity[3*i + config_.axes[d]] = s[2 + d]/s[0];
            r.centroid[3*i + config_.axes[d]] = s[2 + D + d]/s[0];
        }
    }
    return r;
}

template<class Backend, int D, class P>
NeighbourCounts SphSolver<Backend, D, P>::countNeighbours()
{
    NeighbourCounts r;
    r.particles = ranks_ ? ranks_->particles().ownedHere() : activeFluid();
    refreshRecords();
    const double support = supportOf(config_);
    const auto count = [&](const Source<Backend, D, P>& source,
                           const RecordsView<Backend, D, P>& target, int n,
                           const GhostMarks<Backend>& ghosts, bool solids)
    {
        if (!n || !source.start) return std::int64_t(0);
        Array<Backend, real> result;
        result.allocate(context_, n);
        const CountPass<Backend, D, P> pass{
            box_, grid_, {source}, target, real(support*support), result.data(), n};
        if (solids) runOverSolids(pass);
        else run(pass, n);
        const std::vector<real> counts = result.download();
        std::int64_t sum = 0;
        for (int i = 0; i < n; ++i)
            if (!ghosts(i)) sum += std::int64_t(counts[i]);
        return sum;
    };
    const int n = activeFluid();
    r.fluid = count(fluidSource(false), fluidRecords_.view(), n, ghosts(), false);
    r.walls = count(wallSource(), fluidRecords_.view(), n, ghosts(), false);
    const GhostMarks<Backend> wallGhosts = ranks_ ? ranks_->wallMarks() : GhostMarks<Backend>();
    if (nWalls_ && (nBodies_ || config_.wallModel == WallKind::extrapolated))
        r.aboutWalls = count(fluidSource(true), wallRecords_.view(), nWalls_, wallGhosts, false);
    if (!solidsMeet_) return r;
    int solids = 0;
    context_.toHost(&solids, solidSort_.active(), sizeof(int));
    r.solids = count(solidSource(), fluidRecords_.view(), n, ghosts(), false);
    r.aboutSolids = count(fluidAboutSolids(), solidRecords_.view(), solids, {}, true);
    return r;
}

template<class Backend, int D, class P>
double SphSolver<Backend, D, P>::neighboursPerParticle()
{
    const NeighbourCounts c = countNeighbours();
    return c.particles ? double(c.fluid + c.walls)/double(c.particles) : 0;
}

template<class Backend, int D, class P>
double SphSolver<Backend, D, P>::estimateTimeStep(std::string& limit)
{
    readClock();
    Limit l = Limit::none;
    const double dt = tick().longest(host_, l);
    static const char* names[] = {
        "none", "acoustic", "force", "viscous", "fixed", "target", "maximum", "growth"};
    limit = names[int(l)];
    return dt;
}

template<class Backend, int D, class P>
std::vector<ArrayInfo> SphSolver<Backend, D, P>::arrays() const
{
    std::vector<ArrayInfo> r;
    const auto add = [&](const char* set, const std::string& name, std::size_t bytes, std::size_t n)
    { if (bytes) r.push_back(ArrayInfo{set, name, n ? bytes/n : 0, bytes}); };
    for (const auto& f : fluid_.info()) add("fluid", f.name, f.bytes, n_);
    add("fluid", "records", fluidRecords_.bytes(), n_);
    add("fluid", "reference", fluidReference_.bytes(), n_);
    std::size_t cells = fluidSort_.bytes();
    if constexpr (Backend::gpu) cells += parts_.frames.bytes();
    add("fluid", "cells", cells, n_);
    for (const auto& f : wall_.info()) add("wall", f.name, f.bytes, nWalls_);
    add("wall", "records", wallRecords_.bytes(), nWalls_);
    add("wall", "cells", wallSort_.bytes(), nWalls_);
    add("wall", "motion", wallReference_.bytes() + wallRest_.bytes() + poses_.bytes(), nWalls_);
    add("wall", "faces", faces_.bytes(), 0);
    if (solids_)
    {
        const std::size_t own = solidOwn_[0].bytes()*D + solidMass_.bytes()
            + solidMassOfKey_.bytes() + solidAddedOfKey_.bytes();
        add("solid points", "records", solidRecords_.bytes(), nSolids_);
        add("solid points", "cells",
            solidSort_.bytes() + solidReference_.bytes() + solidLast_.bytes(), nSolids_);
        add("solid points", "velocity, mass",
            own + solidVelocity_.bytes() + solidAcceleration_.bytes(), nSolids_);
        add("solid points", "force", solidForce_.bytes() + solidForceBefore_.bytes(), nSolids_);
        add("fluid", "action of solids",
            actionA_[0].bytes()*D + actionRate_.bytes() + actionDrift_[0].bytes()*D, n_);
        for (const ArrayInfo& a : solidScene_->arrays()) r.push_back(a);
    }
    if constexpr (Backend::gpu)
    {
        add("lists", "fluidSolid", parts_.fluidSolid.bytes(), n_);
        add("lists", "solidFluid", parts_.solidFluid.bytes(), nSolids_);
        add("lists", "fluidFluid", parts_.fluidFluid.bytes(), n_);
        add("lists", "fluidWall", parts_.fluidWall.bytes(), n_);
        add("lists", "wallFluid", parts_.wallFluid.bytes(), nWalls_);
    }
    return r;
}

template<class Backend, int D, class P>
std::vector<KernelInfo> SphSolver<Backend, D, P>::kernels() const
{
    std::vector<KernelInfo> r;
    for (const auto& e : context_.profile.entries())
        r.push_back(KernelInfo{e.name, e.launches, e.seconds});
    if (solids_) for (KernelInfo k : solidScene_->kernels())
    {
        k.name = "solids: " + k.name;
        r.push_back(k);
    }
    return r;
}

} // namespace riprap

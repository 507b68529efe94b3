/*  SphSolver: construction from a configuration and particles.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/sph/sphSolver.hpp"

namespace riprap
{

template<class Backend, int D, class P>
SphSolver<Backend, D, P>::SphSolver(const SphConfig& config, const FluidInput& fluid,
    const WallInput& walls, WallMotion motion, SolidPart solids)
    : config_(config), motion_(std::move(motion)), terms_(config)
{
    clock_.allocate(context_, 1);
    n_ = int(fluid.size());
    setModel();
    setBox();
    if (config.ranks && config.ranks->size() > 1)
        ranks_ = std::make_unique<FluidRanks<Backend, D, P>>(
            typename FluidRanks<Backend, D, P>::Scene{config_, box_, grid_, fluid_, fluidRecords_,
                fluidSort_, wallRecords_, n_, nWalls_, emptyCoordinate_},
            double(allowedWay_));
    setFluid(fluid);
    setWalls(walls);
    setFaces(walls.faces, solids);
    setSolids(std::move(solids));
    setFrames();
    allocateLists();
    if (nBodies_) setPoses(config_.startTime, config_.startTime);
    prime();
    if (ranks_) fitCapacity();
}

//- What is added to the support may be travelled by a particle before neighbours are sought anew:
//  half of it on the GPU, all of it on the CPU
template<class Backend, int D>
double skinRatio(const SphConfig& config, int n)
{
    if (config.skin >= 0) return config.skin;
    if (!Backend::gpu) return 0.1;
    // small scenes are bound by launches, of which a rebuild has many
    const bool symplectic = config.integrator == IntegratorKind::symplectic;
    if (n <= 24000) return D == 2 || symplectic ? 0.5 : 0.35;
    return n > 200000 ? 0.07 : (D == 2 ? 0.2 : 0.12);
}

//- Several ranks: memory for so many particles from now on; residents stay in their slots, and a
//  rebuild does the rest
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::setCapacity(int n)
{
    const int active = std::min(activeFluid(), n),
              kept = std::min({ranks_->particles().residents(), n_, n});
    FieldSet<Backend> old(std::move(fluid_));
    fluid_ = FieldSet<Backend>();
    const auto info = old.info();
    for (int f = 0; f < old.fields(); ++f)
    {
        if (old.elementBytes(f) == 8) fluid_.template add<std::int64_t>(info[f].name);
        else fluid_.template add<std::int32_t>(info[f].name);
    }
    fluid_.allocate(context_, n);
    for (int f = 0; f < fluid_.fields(); ++f)
        std::memcpy(fluid_.bytes(f), old.bytes(f), std::size_t(kept)*old.elementBytes(f));
    fluidRecords_ = Records<Backend, D, P>();
    fluidRecords_.allocate(context_, n, model_.variableH);
    fluidReference_ = Array<Backend, position>();
    fluidReference_.allocate(context_, std::size_t(n)*D);
    fluidSort_ = CellSort<Backend>();
    fluidSort_.allocate(context_, n, grid_.cells);
    context_.toDevice(const_cast<int*>(fluidSort_.active()), &active, sizeof(int));
    n_ = n;
}

//- Several ranks: memory for what is here, and some more
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::fitCapacity()
{
    setCapacity(ranks_->room());
    rebuild();
}

template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::setModel()
{
    const SphConfig& c = config_;
    model_.eos = EquationOfState<real>::make(
        c.eos == EosKind::linear, c.gamma, c.soundSpeed, c.density);
    for (int d = 0; d < D; ++d) model_.gravity.c[d] = real(c.gravity[c.axes[d]]);
    const double h0 = c.smoothingRatio*c.spacing;
    model_.rho0 = real(c.density);
    model_.h0 = real(h0);
    model_.hMin = real(h0/c.maxSmoothingGrowth);
    model_.hMax = real(h0*c.maxSmoothingGrowth);
    model_.mass = real(c.density*std::pow(c.spacing, D));
    model_.wallMass = real(c.density*std::pow(c.wallSpacing, D));
    model_.spacing = real(c.spacing);
    model_.variableH = c.variableSmoothing;
    model_.drifts = terms_.drifts();

    const double nu = terms_.viscosity(c);
    limits_.adjust = c.adjustTimeStep;
    limits_.fixedDt = c.fixedTimeStep;
    limits_.maxDt = c.maxTimeStep;
    limits_.acoustic = c.acousticCourant;
    limits_.force = c.forceCourant;
    limits_.h0 = h0;
    limits_.leastH = c.variableSmoothing ? h0/c.maxSmoothingGrowth : h0;
    limits_.dimensions = D;
    limits_.viscousDt = nu > 0 ? c.viscousCourant*h0*h0/nu : 1e30;
    limits_.maxDeviation = c.removeWild ? 1e30 : c.maxDensityDeviation;
    limits_.maxSpeed = c.removeWild ? 1e30 : c.maxSpeedRatio*c.maxVelocity;
    model_.removesWild = c.removeWild;
    model_.maxDeviation = real(c.maxDensityDeviation);
    model_.maxSpeed2 = real(std::pow(c.maxSpeedRatio*c.maxVelocity, 2));
    // its step would be a twentieth of what sound allows, a hundred times what a density twice as
    // high brings about
    model_.maxAcceleration2 = real(std::min(1e36, std::pow(100*c.soundSpeed*c.soundSpeed/h0, 2)));
    limits_.growth = 1.1;
}

template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::setBox()
{
    const SphConfig& c = config_;
    const double support = supportOf(c)*(c.variableSmoothing ? c.maxSmoothingGrowth : 1);
    // each row of cells must be its own neighbour at most once: a short period leaves room for a
    // thinner skin only
    double skin = skinRatio<Backend, D>(config_, n_)*support;
    for (int d = 0; d < D; ++d)
    {
        const double period = c.domainMax[c.axes[d]] - c.domainMin[c.axes[d]], least = 1.05*support;
        if (!c.periodic[c.axes[d]] || period >= 3*(support + skin)) continue;
        if (period < 3*least)
            throw std::invalid_argument("the periodic domain is " + std::to_string(period)
                + " m long; it must be at least three search radii, " + std::to_string(3*least)
                + " m");
        skin = period*(1 - 1e-9)/3 - support;       // so that rounding does not cost a row
    }
    const double radius = support + skin;
    // on the CPU who seeks is where it is now: only those that it seeks may have moved. A hair
    // less, for rounding
    allowedWay_ = real(Backend::gpu ? 0.5*skin : 0.999*skin);
    for (int d = 0; d < D; ++d)
    {
        const int axis = c.axes[d];
        const double lo = c.domainMin[axis], hi = c.domainMax[axis];
        if (c.periodic[axis])
        {
            box_.set(d, lo, hi - lo, true);
            model_.domainMin[d] = -1e300;
            model_.domainMax[d] = 1e300;
        }
        else
        {
            // a margin of two radii: fixed-point differences across it are never mistaken for near
            // ones
            box_.set(d, lo - radius, hi - lo + 2*radius, false);
            model_.domainMin[d] = radius*(1 - 1e-9) + c.escapeInset;
            model_.domainMax[d] = radius + (hi - lo)*(1 + 1e-9) - c.escapeInset;
        }
    }
    const int reach = Backend::gpu ? 2 : 1;
    const double volume = [&]
    {
        double v = 1;
        for (int d = 0; d < D; ++d) v *= box_.length[d];
        return v;
    }();
    const double cells = std::max(1e3, std::min(4e8, 2*volume/std::pow(c.spacing, D)));
    grid_.set(box_, radius, reach, Backend::gpu ? 4 : 6, cells);
}

//- On the GPU fluid's way is measured against what is around it, and walls are listed from farther
//  away
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::setFrames()
{
    wallWay_ = allowedWay_;
    if constexpr (Backend::gpu)
    {
        const double skin = 2*double(allowedWay_), radius = grid_.radius, support = radius - skin;
        parts_.wallRadius = grid_.radius;
        double reach = support + std::max(skin, wallSkin*support);
        for (int d = 0; d < D; ++d)
            if (box_.periodic[d] && box_.length[d] < 4*reach) reach = radius;
        parts_.wallRadius = real(reach);
        if (nBodies_) wallWay_ = real(0.5*(reach - support));
        parts_.frames.set(context_, box_, 2*radius, 2e6);
    }
}

template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::setFluid(const FluidInput& in)
{
    n_ = reported_ = int(in.size());
    const char* axisName[3] = {"x", "y", "z"};
    const auto addVector = [&](const char* name)
    {
        const int first = fluid_.fields();
        for (int d = 0; d < D; ++d)
            fluid_.template add<real>(std::string(name) + "." + axisName[d]);
        return first;
    };
    xField_ = fluid_.fields();
    for (int d = 0; d < D; ++d)
        fluid_.template add<std::int64_t>(std::string("position.") + axisName[d]);
    vField_ = addVector("velocity");
    deviationField_ = fluid_.template add<real>("densityDeviation");
    aField_ = addVector("acceleration");
    rateField_ = fluid_.template add<real>("densityRate");
    if (model_.drifts) driftField_ = addVector("drift");
    idField_ = fluid_.template add<std::int32_t>("id");
    fluid_.allocate(context_, n_);
    fluidRecords_.allocate(context_, n_, model_.variableH);
    fluidReference_.allocate(context_, std::size_t(n_)*D);
    fluidSort_.allocate(context_, n_, grid_.cells);
    if (D == 2)
        emptyCoordinate_ = 0.5
            *(config_.domainMin[config_.axes[2]] + config_.domainMax[config_.axes[2]]);
    std::vector<std::int64_t> x(n_);
    std::vector<real> value(n_);
    for (int d = 0; d < D; ++d)
    {
        const int axis = config_.axes[d];
        for (int i = 0; i < n_; ++i) x[i] = box_.toFixed(d, in.position[3*std::size_t(i) + axis]);
        fluid_.upload(context_, xField_ + d, x);
        for (int i = 0; i < n_; ++i) value[i] = real(in.velocity[3*std::size_t(i) + axis]);
        fluid_.upload(context_, vField_ + d, value);
    }
    for (int i = 0; i < n_; ++i) value[i] = real(in.density[i]/config_.density - 1);
    fluid_.upload(context_, deviationField_, value);
    std::vector<std::int32_t> id = in.id;
    if (id.empty()) for (int i = 0; i < n_; ++i) id.push_back(i);
    fluid_.upload(context_, idField_, id);
}

template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::setWalls(const WallInput& in)
{
    nWalls_ = int(in.size());
    nBodies_ = in.nBodies;
    wallInput_ = in.position;
    wallBodies_ = in.body.empty() ? std::vector<std::int32_t>(nWalls_, -1) : in.body;
    wallParts_ = in.part.empty() ? std::vector<std::int32_t>(nWalls_, 0) : in.part;
    if (!nWalls_) return;
    wallXField_ = wall_.fields();
    for (int d = 0; d < D; ++d) wall_.template add<std::int64_t>("position." + std::to_string(d));
    wallIdField_ = wall_.template add<std::int32_t>("id");
    if (nBodies_)
    {
        wallBodyField_ = wall_.template add<std::int32_t>("body");
        wallVField_ = wall_.fields();
        for (int d = 0; d < D; ++d) wall_.template add<real>("velocity." + std::to_string(d));
        wallAField_ = wall_.fields();
        for (int d = 0; d < D; ++d) wall_.template add<real>("acceleration." + std::to_string(d));
        wallWorkField_ = wall_.template add<double>("work");
        wallPressureWorkField_ = wall_.template add<double>("pressureWork");
        wallRest_.upload(context_, in.position);
        wallReference_.allocate(context_, std::size_t(nWalls_)*D);
        poses_.allocate(context_, std::size_t(nBodies_)*(poseIntervals + 1));
    }
    wall_.allocate(context_, nWalls_);
    wallRecords_.allocate(context_, nWalls_, model_.variableH);
    wallSort_.allocate(context_, nWalls_, grid_.cells);
    std::vector<std::int64_t> x(nWalls_);
    std::vector<std::int32_t> id(nWalls_);
    for (int d = 0; d < D; ++d)
    {
        for (int i = 0; i < nWalls_; ++i)
            x[i] = box_.toFixedInside(d, in.position[3*std::size_t(i) + config_.axes[d]]);
        wall_.upload(context_, wallXField_ + d, x);
    }
    for (int i = 0; i < nWalls_; ++i) id[i] = i;
    wall_.upload(context_, wallIdField_, id);
    if (nBodies_) wall_.upload(context_, wallBodyField_, wallBodies_);
}

//- First forces, from the state as given
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::prime()
{
    host_ = ClockData();
    host_.active = 1;
    host_.time = config_.startTime;
    writeClock();
    if constexpr (Backend::gpu) parts_.frames.clearStill(context_);
    if (nWalls_)
    {
        rebuildWalls();
        forEach(context_, nWalls_,
            StationaryWall<Backend, D, P>{wallRecords_.view(), wallFields(), model_});
        moveWalls(false);       // to where they are at the start: neighbours are sought there
    }
    for (;;)
    {
        rebuild();
        readClock();
        if (!host_.overflows()) break;
        growLists();
    }
    moveWalls(false);
    moveFaces();
    wallPass(true);
    solidPressurePass(true);
    solidPass<Part::all>();
    fluidPass<Part::all>(Finish::store);
    solidForcePass();
    showForces();
    if (ranks_) ranks_->agree(*clock_.data(), interrupted_);
    context_.synchronise();
    readClock();
}

} // namespace riprap

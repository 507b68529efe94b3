/*  PicSolver: construction.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <numeric>
#include "pic/terms/absorb.hpp"
#include "pic/cutCells/fillSolids.hpp"
#include "pic/surface/seeding.hpp"
#include "solvers/pic/picSolver.hpp"

namespace riprap
{

template<class Backend, int D, class P>
PicSolver<Backend, D, P>::PicSolver(const PicConfig& config, const FluidInput& fluid,
    const PicWalls& walls, LinearSolver* solver, PicInside&& inside)
    : config_(config), fromFaces_(config), inside_(std::move(inside)),
      linearSolver_(solver ? *solver : ownSolver_)
{
    ownSolver_.controls.tolerance = config.pressureTolerance;
    ownSolver_.controls.reflectionTolerance = config.reflectionTolerance;
    setGrid();
    setAbsorbers();
    clock_.time = config.startTime;
    sides_ = walls;
    if (!config.openings.empty()) setOpenings(sides_);
    if (cuts())
    {
        allocateCut();
        setSolids(fluid.size() > 0);
        cutGrid(clock_.time, 1);
    }
    else setWalls(sides_);
    setFluid(fluid);
    if (opens()) startOpenings();
    context_.synchronise();
}

template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::setGrid()
{
    grid_.h = config_.cellSize;
    for (int d = 0; d < D; ++d)
    {
        const int axis = config_.axes[d];
        grid_.origin[d] = config_.domainMin[axis];
        grid_.n[d] = config_.cells[axis];
        grid_.periodic[d] = config_.periodic[axis];
        gravity_[d] = config_.gravity[axis];
    }
    const int empty = config_.axes[2];
    emptyCoordinate_ = 0.5*(config_.domainMin[empty] + config_.domainMax[empty]);
    const int cells = grid_.cells();
    for (auto* a : {&phi_, &carried_, &spare_}) a->allocate(context_, cells);
    for (auto* a : {&wet_, &near_}) a->allocate(context_, cells);
    pressure_.allocate(context_, cells);
    if (config_.reflection > 0)
        for (auto* a : {&reflected_, &ahead_, &whole_}) a->allocate(context_, cells);
    pressureStep_.allocate(context_, grid_);
    for (int d = 0; d < D; ++d)
    {
        const int faces = grid_.faces(d);
        for (auto* a : {&u_[d], &before_[d], &change_[d], &mass_[d], &aperture_[d]})
            a->allocate(context_, faces);
        layer_[d].allocate(context_, faces);
        if (config_.reflection > 0)
            for (auto* a : {&after_[d], &carrier_[d]}) a->allocate(context_, faces);
    }
}

//- Where zones overlap their rates add up
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::setAbsorbers()
{
    std::vector<AbsorbingZone<D>> zones;
    for (const PicAbsorber& a : config_.absorbers)
    {
        AbsorbingZone<D> z;
        for (int d = 0; d < D; ++d)
        {
            z.from.c[d] = a.from[config_.axes[d]];
            z.to.c[d] = a.to[config_.axes[d]];
        }
        z.rate = a.rate;
        zones.push_back(z);
    }
    for (int d = 0; d < D && !zones.empty(); ++d)
    {
        std::vector<real> rate(grid_.faces(d), real(0));
        for (int i = 0; i < grid_.faces(d); ++i)
            for (const AbsorbingZone<D>& z : zones) rate[i] += real(z.at(faceMiddle(grid_, d, i)));
        absorb_[d].upload(context_, rate);
    }
}

template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::setWalls(const PicWalls& walls)
{
    for (int d = 0; d < D; ++d)
    {
        std::vector<real> a(walls.aperture[d].begin(), walls.aperture[d].end());
        if (a.empty())
        {
            a.assign(grid_.faces(d), real(1));
            for (int i = 0; i < grid_.faces(d) && !grid_.periodic[d]; ++i)
            {
                const int layer = grid_.faceIndex(d, i).c[d];
                if (layer == 0 || layer == grid_.n[d]) a[i] = 0;
            }
        }
        aperture_[d].upload(context_, a);
        if (!walls.wallVelocity[d].empty() || bodies_) wallsMove_ = true;
        if (opens()) keepOpenParts(d, a);
    }
    setSides();
    if (!wallsMove_) return;
    for (int d = 0; d < D; ++d)
    {
        std::vector<real> w(grid_.faces(d), real(0));
        std::copy(walls.wallVelocity[d].begin(), walls.wallVelocity[d].end(), w.begin());
        wallVelocity_[d].upload(context_, w);
    }
    if (opens()) writeOpenFaces();
}

//- Water sticks to a side of the block that is closed all over
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::setSides()
{
    if (!config_.noSlip) return;
    for (int d = 0; d < D; ++d)
    {
        if (grid_.periodic[d]) continue;
        const std::vector<real> a = aperture_[d].download();
        for (int side = 0; side < 2; ++side)
        {
            bool closed = true;
            for (int i = 0; i < grid_.faces(d); ++i)
                closed = closed
                    && (grid_.faceIndex(d, i).c[d] != side*grid_.n[d] || !(a[i] > real(0)));
            grid_.sticks[d][side] = closed;
            for (int e = 0; e < D; ++e)
                grid_.slide[d][side][e] = closed
                    ? config_.slide[config_.axes[d]][side][config_.axes[e]]
                    : 0;
        }
    }
}

template<class T> std::vector<double> asDouble(const std::vector<T>& v)
{
    return std::vector<double>(v.begin(), v.end());
}

//- The direction in which gravity is largest; -1: there is none
template<class Backend, int D, class P>
int PicSolver<Backend, D, P>::steepest() const
{
    int up = 0;
    for (int d = 1; d < D; ++d) if (std::abs(gravity_[d]) > std::abs(gravity_[up])) up = d;
    return gravity_[up] != 0 ? up : -1;
}

//- Points that lie in solids are left out
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::dropInside(std::vector<double>& x)
{
    const std::vector<double> distance = nodeDistance_.download();
    SolidField<D, real> solids{};
    solids.grid = grid_;
    solids.distance = distance.data();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < x.size()/D; ++i)
    {
        Vec<D, double> at, normal;
        for (int d = 0; d < D; ++d) at.c[d] = x[i*D + d];
        if (solids.at(at, normal) < wallMargin*grid_.h) continue;
        for (int d = 0; d < D; ++d) x[kept*D + d] = x[i*D + d];
        ++kept;
    }
    x.resize(kept*D);
}

//- The solved components of points, above the block's corner, or of vectors
template<class Backend, int D, class P>
std::vector<double> PicSolver<Backend, D, P>::solved(
    const std::vector<double>& xyz, bool position) const
{
    std::vector<double> x(xyz.size()/3*D);
    for (std::size_t i = 0; i < xyz.size()/3; ++i)
        for (int d = 0; d < D; ++d)
            x[i*D + d] = xyz[3*i + config_.axes[d]] - (position ? grid_.origin[d] : 0.0);
    return x;
}

template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::setFluid(const FluidInput& fluid)
{
    const real band = real(bandCells*grid_.h);
    if (fluid.size() == 0) { leaveDry(); return; }
    const std::vector<double> x = solved(fluid.position, true), v = solved(fluid.velocity, false);
    std::vector<double> fill = fillOfBoxes<D>(grid_, x, config_.spacing);
    if (cuts())
        fillSolids(grid_, clearCells(std::min(config_.spacing, nearSolid*grid_.h)),
            asDouble(open_.download()), steepest(), fill);
    const std::vector<real> phi = surfaceOf<D, real>(grid_, fill, band);
    phi_.upload(context_, phi);
    double sums[3];
    const double total = (cuts() ? waterVolume(sums)
                                 : std::accumulate(fill.begin(), fill.end(), 0.0))
        *grid_.volume();
    if (config_.seedsPerDirection > 0)
    {
        std::vector<double> at = seeds<D, real>(
            grid_, phi.data(), config_.seedsPerDirection, config_.jitter);
        if (cuts()) dropInside(at);
        std::vector<double> gradient;
        const std::vector<double> velocity = velocitiesAt(at, x, v, gradient);
        setParticles(at, velocity, gradient, std::vector<std::int32_t>());
    }
    else
    {
        std::vector<double> gradient;
        if (fromFaces_.gradient()) velocitiesAt(x, x, v, gradient);
        setParticles(x, v, gradient, fluid.id);
    }
    if (n_ == 0) throw std::invalid_argument("the fluid fills no cell");
    clock_.particleVolume = total/n_;
    clock_.initial = n_;
    sortParticles();
    markWater();
    volume_ = waterVolume(sums);
    flying_ = sumOverWater<1>(CountFlying<D, real>{grid_, particles(), near_.data()})[0];
}

//- Solids alone: arrays of one particle that does not count, and no surface
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::leaveDry()
{
    phi_.upload(context_, std::vector<real>(grid_.cells(), real(bandCells*grid_.h)));
    setParticles(std::vector<double>(D, 0.5*grid_.h), std::vector<double>(D, 0.0),
        std::vector<double>(D*D, 0.0), std::vector<std::int32_t>());
    clock_.particleVolume = grid_.volume();
    sortParticles();
    n_ = 0;
    markWater();
}

template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::setParticles(const std::vector<double>& x,
    const std::vector<double>& v, const std::vector<double>& gradient,
    const std::vector<std::int32_t>& id)
{
    n_ = int(x.size()/D);
    set_ = FieldSet<Backend>();
    xField_ = set_.template add<double>("x");
    for (int d = 1; d < D; ++d) set_.template add<double>("x");
    vField_ = set_.template add<real>("v");
    for (int d = 1; d < D; ++d) set_.template add<real>("v");
    if (fromFaces_.gradient())
    {
        affineField_ = set_.template add<real>("affine");
        for (int k = 1; k < D*D; ++k) set_.template add<real>("affine");
    }
    idField_ = set_.template add<std::int32_t>("id");
    memoryField_ = set_.fields();
    for (int k = 0; k < fromFaces_.memory(); ++k) set_.template add<real>("transfer");
    set_.allocate(context_, n_, true);
    sort_.allocate(context_, n_, grid_.cells());
    place_.allocate(context_, n_);
    if (config_.positionCorrection > 0)
        for (int d = 0; d < D; ++d) shift_[d].allocate(context_, n_);
    std::vector<double> component(n_);
    std::vector<real> velocity(n_);
    std::vector<std::int32_t> ids(id);
    if (ids.empty()) { ids.resize(n_); std::iota(ids.begin(), ids.end(), 0); }
    clock_.nextId = n_ ? std::int64_t(*std::max_element(ids.begin(), ids.end())) + 1 : 0;
    for (int d = 0; d < D; ++d)
    {
        const double length = grid_.n[d]*grid_.h,
                     margin = grid_.periodic[d] ? 0 : wallMargin*grid_.h;
        for (int i = 0; i < n_; ++i)
        {
            component[i] = std::max(margin, std::min(x[i*D + d], length - margin));
            velocity[i] = real(v[i*D + d]);
        }
        set_.upload(context_, xField_ + d, component);
        set_.upload(context_, vField_ + d, velocity);
    }
    set_.upload(context_, idField_, ids);
    for (int k = 0; affineField_ >= 0 && k < D*D; ++k)
    {
        for (int i = 0; i < n_; ++i) velocity[i] = real(gradient[i*D*D + k]);
        set_.upload(context_, affineField_ + k, velocity);
    }
    for (int k = 0; k < fromFaces_.memory(); ++k)
        set_.upload(context_, memoryField_ + k, std::vector<real>(n_, real(0)));
}

//- Velocities of given particles at seeds, and their gradients: the weighted least-squares plane
//  through those within a cell or two spacings
template<class Backend, int D, class P>
std::vector<double> PicSolver<Backend, D, P>::velocitiesAt(const std::vector<double>& seeds,
    const std::vector<double>& x, const std::vector<double>& v, std::vector<double>& gradient) const
{
    std::vector<double> result(seeds.size(), 0.0);
    gradient.assign(seeds.size()*D, 0.0);
    if (std::all_of(v.begin(), v.end(), [](double u) { return u == 0; })) return result;
    constexpr int terms = D + 1;
    const double reach = std::max(grid_.h, 2*config_.spacing);
    const int count = int(x.size()/D);
    int cells[3] = {1, 1, 1};
    for (int d = 0; d < D; ++d) cells[d] = std::max(1, int(grid_.n[d]*grid_.h/reach));
    const auto cellOf = [&](const double* at, int d)
    { return std::max(0, std::min(int(at[d]*cells[d]/(grid_.n[d]*grid_.h)), cells[d] - 1)); };
    const auto index = [&](int i, int j, int k) { return i + cells[0]*(j + cells[1]*k); };
    std::vector<std::vector<int>> bins(std::size_t(cells[0])*cells[1]*cells[2]);
    for (int p = 0; p < count; ++p)
        bins[index(
                 cellOf(&x[p*D], 0), cellOf(&x[p*D], 1), D == 3 ? cellOf(&x[p*D], D - 1) : 0)]
            .push_back(p);
    #pragma omp parallel for
    for (std::size_t s = 0; s < seeds.size()/D; ++s)
    {
        const double* at = &seeds[s*D];
        double a[terms][terms + D] = {};
        int low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
        for (int d = 0; d < D; ++d)
        {
            const int c = cellOf(at, d);
            low[d] = std::max(c - 1, 0);
            high[d] = std::min(c + 1, cells[d] - 1);
        }
        for (int k = low[2]; k <= high[2]; ++k)
            for (int j = low[1]; j <= high[1]; ++j)
                for (int i = low[0]; i <= high[0]; ++i)
                    for (const int p : bins[index(i, j, k)])
                    {
                        double basis[terms] = {1}, r2 = 0;
                        for (int d = 0; d < D; ++d)
                        {
                            basis[d + 1] = (x[p*D + d] - at[d])/reach;
                            r2 += basis[d + 1]*basis[d + 1];
                        }
                        if (r2 >= 1) continue;
                        const double w = (1 - r2)*(1 - r2);
                        for (int r = 0; r < terms; ++r)
                        {
                            for (int c = 0; c < terms; ++c) a[r][c] += w*basis[r]*basis[c];
                            for (int d = 0; d < D; ++d) a[r][terms + d] += w*basis[r]*v[p*D + d];
                        }
                    }
        if (!(a[0][0] > 0)) continue;
        // where particles do not span a plane, a little of the mean's weight does
        for (int r = 1; r < terms; ++r) a[r][r] += 1e-9*a[0][0];
        for (int c = 0; c < terms; ++c)
            for (int r = 0; r < terms; ++r)
            {
                if (r == c) continue;
                const double f = a[r][c]/a[c][c];
                for (int e = c; e < terms + D; ++e) a[r][e] -= f*a[c][e];
            }
        for (int d = 0; d < D; ++d)
        {
            result[s*D + d] = a[0][terms + d]/a[0][0];
            for (int e = 0; e < D; ++e)
                gradient[(s*D + d)*D + e] = a[e + 1][terms + d]/a[e + 1][e + 1]/reach;
        }
    }
    return result;
}

} // namespace riprap

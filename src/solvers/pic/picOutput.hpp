/*  PicSolver: everything that is read back.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/loops/reduceMax.hpp"
#include "pic/cutCells/samplePoints.hpp"
#include "pic/grid/speed.hpp"
#include "solvers/fluidEnd.hpp"
#include "solvers/pic/picSolver.hpp"

namespace riprap
{

template<int D, class R>
struct ParticleEnergy
{
    static constexpr const char* name = "particleEnergy";
    PicParticles<D, R> particles;
    Vec<D, double> gravity;

    HD void add(int i, double* sums) const
    {
        const Vec<D, double> x = particles.position(i);
        for (int d = 0; d < D; ++d)
        {
            sums[0] += 0.5*double(particles.v[d][i])*particles.v[d][i];
            sums[1] -= gravity.c[d]*x.c[d];
        }
    }
};

template<int D, class R>
struct ParticlePlaces
{
    UniformGrid<D> grid;
    PicParticles<D, R> particles;

    HD double x(int d, int i) const { return grid.origin[d] + particles.x[d][i]; }
};

//- Component d of the particles' velocities at the time of their positions
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::velocitiesNow(int d, Array<Backend, real>& now)
{
    now.allocate(context_, n_);
    withSpline(config_.splineOrder,
        [&](auto order)
        {
            forEach(context_, n_,
                VelocityNow<decltype(order)::value, D, real>{grid_, particles(), d,
                    change_[d].data(), near_.data(),
                    real(clock_.lastKick > 0 ? 0.5*clock_.lastStep/clock_.lastKick : 0),
                    real(0.5*clock_.lastStep*gravity_[d]), now.data()});
        });
}

//- Particles with these velocities, kept in v
template<class Backend, int D, class P>
PicParticles<D, typename P::real> PicSolver<Backend, D, P>::particlesNow(
    Array<Backend, real> (&v)[D])
{
    PicParticles<D, real> now = particles();
    for (int d = 0; d < D; ++d)
    {
        velocitiesNow(d, v[d]);
        now.v[d] = v[d].data();
    }
    return now;
}

template<class Backend, int D, class P>
std::vector<typename P::real> PicSolver<Backend, D, P>::velocities(int d)
{
    Array<Backend, real> now;
    velocitiesNow(d, now);
    return now.download();
}

template<class Backend, int D, class P>
FluidState PicSolver<Backend, D, P>::fluid()
{
    FluidState state;
    state.position.assign(3*std::size_t(n_), 0.0);
    state.velocity.assign(3*std::size_t(n_), 0.0);
    const int empty = config_.axes[2];
    if (D == 2) for (int i = 0; i < n_; ++i) state.position[3*i + empty] = emptyCoordinate_;
    std::vector<double> x[D];
    for (int d = 0; d < D; ++d)
    {
        x[d] = set_.template download<double>(context_, xField_ + d);
        const std::vector<real> v = velocities(d);
        const int axis = config_.axes[d];
        for (int i = 0; i < n_; ++i)
        {
            state.position[3*i + axis] = grid_.origin[d] + x[d][i];
            state.velocity[3*i + axis] = v[i];
        }
    }
    state.id = set_.template download<std::int32_t>(context_, idField_);
    state.id.resize(n_);
    state.density.assign(n_, config_.density);
    state.smoothingLength.assign(n_, grid_.h);
    state.pressure = sample(state.position).pressure;
    return state;
}

template<class Backend, int D, class P>
PicGridState PicSolver<Backend, D, P>::grid()
{
    const int cells = grid_.cells();
    PicGridState state;
    state.pressure = wholePressure().download();
    const std::vector<real> phi = phi_.download();
    const std::vector<unsigned char> near = near_.download();
    const std::vector<real> open = cuts() ? open_.download() : std::vector<real>();
    state.distance.assign(phi.begin(), phi.end());
    state.water.resize(cells);
    state.velocity.assign(3*std::size_t(cells), 0.0);
    std::vector<real> u[D];
    for (int d = 0; d < D; ++d) u[d] = u_[d].download();
    for (int i = 0; i < cells; ++i)
    {
        state.water[i] = waterFraction(grid_, phi.data(), i, 0)*(cuts() ? double(open[i]) : 1.0);
        if (!near[i]) continue;
        const typename UniformGrid<D>::Index c = grid_.cellIndex(i);
        for (int d = 0; d < D; ++d)
            state.velocity[3*i + config_.axes[d]] = 0.5
                *(double(u[d][grid_.faceOf(d, c, 0)]) + u[d][grid_.faceOf(d, c, 1)]);
    }
    return state;
}

template<class Backend, int D, class P>
SampleResult PicSolver<Backend, D, P>::sample(const std::vector<double>& points, const SightPlanes&)
{
    const std::size_t m = points.size()/3, most = 1 << 20;      // at once: memory on the device
    const std::vector<double> x = solved(points, true);
    Array<Backend, double> extended, places, found;
    SamplePoints<D, real> sample{
        grid_, {}, phi_.data(), wholePressure().data(), {}, nullptr, nullptr};
    for (int d = 0; d < D; ++d) sample.u[d] = u_[d].data();
    if (cuts())
    {
        std::vector<double> p = wholePressure().download();
        extendPressure(grid_, phi_.download().data(), wet_.download(), p);
        extended.upload(context_, p);
        sample.p = extended.data();
        sample.solids.grid = grid_;
        sample.solids.distance = nodeDistance_.data();
    }
    SampleResult result;
    result.volumeFraction.assign(m, 0.0);
    result.pressure.assign(m, 0.0);
    result.velocity.assign(3*m, 0.0);
    result.centroid.assign(3*m, 0.0);
    for (std::size_t first = 0; first < m; first += most)
    {
        const std::size_t end = std::min(m, first + most);
        places.upload(context_, std::vector<double>(x.begin() + D*first, x.begin() + D*end));
        found.allocate(context_, sample.values*(end - first));
        sample.x = places.data();
        sample.result = found.data();
        forEach(context_, int(end - first), sample);
        const std::vector<double> values = found.download();
        for (std::size_t i = first; i < end; ++i)
        {
            const double* v = &values[sample.values*(i - first)];
            result.volumeFraction[i] = v[0];
            result.pressure[i] = v[1];
            for (int d = 0; d < D; ++d) result.velocity[3*i + config_.axes[d]] = v[2 + d];
        }
    }
    return result;
}

template<class Backend, int D, class P>
FluidEnergy PicSolver<Backend, D, P>::energy()
{
    Array<Backend, real> v[D];
    ParticleEnergy<D, real> sum{particlesNow(v), {}};
    for (int d = 0; d < D; ++d) sum.gravity.c[d] = gravity_[d];
    const auto sums = sumOver<2>(context_, n_, sum);
    const double mass = config_.density*clock_.particleVolume;
    FluidEnergy e;
    e.kinetic = mass*sums[0];
    e.potential = mass*sums[1];
    return e;
}

//- The density is that of the fluid
template<class Backend, int D, class P>
FluidExtremes PicSolver<Backend, D, P>::extremes()
{
    Array<Backend, real> v[D];
    FluidExtremes e;
    e.speed = reduceMax(context_, n_, ParticleSpeed<D, real>{particlesNow(v)});
    return e;
}

template<class Backend, int D, class P>
FluidEnd PicSolver<Backend, D, P>::farEnd(const Vector3& direction, double reach)
{
    Vec<D, double> lower, upper;
    for (int d = 0; d < D; ++d)
    {
        lower.c[d] = grid_.origin[d];
        upper.c[d] = grid_.origin[d] + grid_.h*grid_.n[d];
    }
    return farEndOf<Backend, D>(context_, n_, ParticlePlaces<D, real>{grid_, particles()},
        config_.axes, direction, reach, lower, upper, emptyCoordinate_);
}

template<class Backend, int D, class P>
std::vector<ArrayInfo> PicSolver<Backend, D, P>::arrays() const
{
    std::vector<ArrayInfo> list;
    const std::size_t n = std::max(n_, 1);
    for (const auto& f : set_.info())
        list.push_back(ArrayInfo{"fluid", f.name, f.bytes/n, f.bytes});
    const auto add = [&](const char* name, std::size_t bytes)
    {
        if (bytes) list.push_back(ArrayInfo{"grid", name, 0, bytes});
    };
    add("phi", phi_.bytes() + carried_.bytes() + spare_.bytes());
    add("p", pressure_.bytes() + reflected_.bytes() + ahead_.bytes() + whole_.bytes());
    add("sums of tiles", toFaces_.bytes());
    std::size_t u = 0, walls = 0, absorb = 0, viscous = viscous_.pressure.bytes();
    for (int d = 0; d < D; ++d)
    {
        u += u_[d].bytes() + before_[d].bytes() + change_[d].bytes() + mass_[d].bytes()
            + after_[d].bytes() + carrier_[d].bytes() + layer_[d].bytes();
        walls += aperture_[d].bytes() + wallVelocity_[d].bytes() + sealed_[d].bytes()
            + faceDistance_[d].bytes() + solidVelocity_[d].bytes();
        absorb += absorb_[d].bytes();
        viscous += viscous_.force[d].bytes() + viscous_.source[d].bytes() + viscous_.r[d].bytes()
            + viscous_.p[d].bytes() + viscous_.q[d].bytes();
    }
    walls += nodeDistance_.bytes() + open_.bytes() + openWeight_.bytes() + cellLayer_.bytes();
    add("u", u);
    std::size_t shifts = 0;
    for (int d = 0; d < D; ++d) shifts += shift_[d].bytes();
    add("places in cells", place_.bytes());
    add("position correction", shifts);
    add("walls", walls);
    add("absorb", absorb);
    add("viscosity", viscous);
    std::size_t openings = openings_.flags.bytes() + openings_.buffer.bytes()
        + openings_.second.bytes();
    for (int d = 0; d < D; ++d)
        openings += openings_.face[d].bytes() + openings_.cell[d].bytes()
            + openings_.gate[d].bytes();
    add("openings", openings);
    return list;
}

template<class Backend, int D, class P>
std::vector<KernelInfo> PicSolver<Backend, D, P>::kernels() const
{
    std::vector<KernelInfo> list;
    for (const auto& e : context_.profile.entries())
        list.push_back(KernelInfo{e.name, e.launches, e.seconds});
    return list;
}

} // namespace riprap

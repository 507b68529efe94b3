/*  Everything that is read back from a scene of water in cells.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/loops/reduceMax.hpp"
#include "pic/cutCells/samplePoints.hpp"
#include "pic/grid/speed.hpp"
#include "pic/surface/fillFraction.hpp"
#include "pic/transfer/gridToParticle.hpp"
#include "solvers/fluidEnd.hpp"
#include "solvers/pic/driver/viscousStep.hpp"

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

template<class Backend, int D, class P>
class PicReadings
{
public:

    using real = typename P::real;

    PicReadings(PicParts<Backend, D, P>& parts, ViscousStep<Backend, D, P>& viscosity)
    :
        p_(parts), viscosity_(viscosity)
    {}

    FluidState fluid();
    PicGridState grid();
    SampleResult sample(const std::vector<double>& points);
    FluidEnergy energy();
    FluidExtremes extremes();
    FluidEnd farEnd(const Vector3& direction, double reach);
    std::vector<ArrayInfo> arrays() const;
    std::vector<KernelInfo> kernels() const;

private:

    void velocitiesNow(int d, Array<Backend, real>&);
    PicParticles<D, real> particlesNow(Array<Backend, real> (&v)[D]);
    std::vector<real> velocities(int d);

    PicParts<Backend, D, P>& p_;
    ViscousStep<Backend, D, P>& viscosity_;
};

//- Component d of the particles' velocities at the time of their positions
template<class Backend, int D, class P>
void PicReadings<Backend, D, P>::velocitiesNow(int d, Array<Backend, real>& now)
{
    PicClock& clock = p_.set.clock;
    PicParticleFields<Backend, D, P>& particles = p_.particles;
    now.allocate(p_.set.context, particles.n);
    withSpline(p_.set.config.splineOrder,
        [&](auto order)
        {
            forEach(p_.set.context, particles.n,
                VelocityNow<decltype(order)::value, D, real>{p_.set.grid, particles.view(), d,
                    p_.faces.change[d].data(), p_.surface.near.data(),
                    real(clock.lastKick > 0 ? 0.5*clock.lastStep/clock.lastKick : 0),
                    real(0.5*clock.lastStep*p_.set.gravity[d]), now.data()});
        });
}

//- Particles with these velocities, kept in v
template<class Backend, int D, class P>
PicParticles<D, typename P::real> PicReadings<Backend, D, P>::particlesNow(
    Array<Backend, real> (&v)[D])
{
    PicParticles<D, real> now = p_.particles.view();
    for (int d = 0; d < D; ++d)
    {
        velocitiesNow(d, v[d]);
        now.v[d] = v[d].data();
    }
    return now;
}

template<class Backend, int D, class P>
std::vector<typename P::real> PicReadings<Backend, D, P>::velocities(int d)
{
    Array<Backend, real> now;
    velocitiesNow(d, now);
    return now.download();
}

template<class Backend, int D, class P>
FluidState PicReadings<Backend, D, P>::fluid()
{
    const PicConfig& config = p_.set.config;
    PicParticleFields<Backend, D, P>& particles = p_.particles;
    FluidState state;
    state.position.assign(3*std::size_t(particles.n), 0.0);
    state.velocity.assign(3*std::size_t(particles.n), 0.0);
    const int empty = config.axes[2];
    if (D == 2)
        for (int i = 0; i < particles.n; ++i)
            state.position[3*i + empty] = p_.set.emptyCoordinate;
    for (int d = 0; d < D; ++d)
    {
        const std::vector<double> x = particles.values.template download<double>(
            p_.set.context, particles.at.x + d);
        const std::vector<real> v = velocities(d);
        const int axis = config.axes[d];
        #pragma omp parallel for schedule(static) if (particles.n > 10000)
        for (int i = 0; i < particles.n; ++i)
        {
            state.position[3*std::size_t(i) + axis] = p_.set.grid.origin[d] + x[i];
            state.velocity[3*std::size_t(i) + axis] = v[i];
        }
    }
    state.id = particles.values.template download<std::int32_t>(p_.set.context, particles.at.id);
    state.id.resize(particles.n);
    state.density.assign(particles.n, config.density);
    state.smoothingLength.assign(particles.n, p_.set.grid.h);
    state.pressure = sample(state.position).pressure;
    return state;
}

template<class Backend, int D, class P>
PicGridState PicReadings<Backend, D, P>::grid()
{
    const UniformGrid<D>& grid = p_.set.grid;
    const int cells = grid.cells();
    PicGridState state;
    state.pressure = p_.pressure.whole().download();
    const std::vector<real> phi = p_.surface.phi.download();
    const std::vector<unsigned char> near = p_.surface.near.download();
    const std::vector<real> open = p_.cuts() ? p_.cut.open.download() : std::vector<real>();
    state.distance.assign(phi.begin(), phi.end());
    state.water.resize(cells);
    state.velocity.assign(3*std::size_t(cells), 0.0);
    std::vector<real> u[D];
    for (int d = 0; d < D; ++d) u[d] = p_.faces.u[d].download();
    #pragma omp parallel for schedule(static) if (cells > 10000)
    for (int i = 0; i < cells; ++i)
    {
        state.water[i] = waterFraction(grid, phi.data(), i, 0)*(p_.cuts() ? double(open[i]) : 1.0);
        if (!near[i]) continue;
        const typename UniformGrid<D>::Index c = grid.cellIndex(i);
        for (int d = 0; d < D; ++d)
            state.velocity[3*std::size_t(i) + p_.set.config.axes[d]] = 0.5
                *(double(u[d][grid.faceOf(d, c, 0)]) + u[d][grid.faceOf(d, c, 1)]);
    }
    return state;
}

template<class Backend, int D, class P>
SampleResult PicReadings<Backend, D, P>::sample(const std::vector<double>& points)
{
    const UniformGrid<D>& grid = p_.set.grid;
    Context<Backend>& context = p_.set.context;
    SurfaceFields<Backend, D, P>& surface = p_.surface;
    const std::size_t m = points.size()/3, most = 1 << 20;      // at once: memory on the device
    const std::vector<double> x = p_.set.solved(points, true);
    Array<Backend, double> extended, places, found;
    SamplePoints<D, real> sample{
        grid, {}, surface.phi.data(), p_.pressure.whole().data(), {}, nullptr, nullptr};
    for (int d = 0; d < D; ++d) sample.u[d] = p_.faces.u[d].data();
    if (p_.cuts())
    {
        std::vector<double> p = p_.pressure.whole().download();
        extendPressure(grid, surface.phi.download().data(), surface.wet.download(), p);
        extended.upload(context, p);
        sample.p = extended.data();
        sample.solids.grid = grid;
        sample.solids.distance = p_.cut.nodeDistance.data();
    }
    SampleResult result;
    result.volumeFraction.assign(m, 0.0);
    result.pressure.assign(m, 0.0);
    result.velocity.assign(3*m, 0.0);
    result.centroid.assign(3*m, 0.0);
    for (std::size_t first = 0; first < m; first += most)
    {
        const std::size_t end = std::min(m, first + most);
        places.upload(context, std::vector<double>(x.begin() + D*first, x.begin() + D*end));
        found.allocate(context, sample.values*(end - first));
        sample.x = places.data();
        sample.result = found.data();
        forEach(context, int(end - first), sample);
        const std::vector<double> values = found.download();
        #pragma omp parallel for schedule(static) if (end - first > 10000)
        for (std::size_t i = first; i < end; ++i)
        {
            const double* v = &values[sample.values*(i - first)];
            result.volumeFraction[i] = v[0];
            result.pressure[i] = v[1];
            for (int d = 0; d < D; ++d) result.velocity[3*i + p_.set.config.axes[d]] = v[2 + d];
        }
    }
    return result;
}

template<class Backend, int D, class P>
FluidEnergy PicReadings<Backend, D, P>::energy()
{
    Array<Backend, real> v[D];
    ParticleEnergy<D, real> sum{particlesNow(v), {}};
    for (int d = 0; d < D; ++d) sum.gravity.c[d] = p_.set.gravity[d];
    const auto sums = sumOver<2>(p_.set.context, p_.particles.n, sum);
    const double mass = p_.set.config.density*p_.set.clock.particleVolume;
    FluidEnergy e;
    e.kinetic = mass*sums[0];
    e.potential = mass*sums[1];
    e.wallWork = p_.wallWork;
    return e;
}

//- The density is that of the fluid
template<class Backend, int D, class P>
FluidExtremes PicReadings<Backend, D, P>::extremes()
{
    Array<Backend, real> v[D];
    FluidExtremes e;
    e.speed = reduceMax(p_.set.context, p_.particles.n, ParticleSpeed<D, real>{particlesNow(v)});
    return e;
}

template<class Backend, int D, class P>
FluidEnd PicReadings<Backend, D, P>::farEnd(const Vector3& direction, double reach)
{
    const UniformGrid<D>& grid = p_.set.grid;
    Vec<D, double> lower, upper;
    for (int d = 0; d < D; ++d)
    {
        lower.c[d] = grid.origin[d];
        upper.c[d] = grid.origin[d] + grid.h*grid.n[d];
    }
    return farEndOf<Backend, D>(p_.set.context, p_.particles.n,
        ParticlePlaces<D, real>{grid, p_.particles.view()}, p_.set.config.axes, direction, reach,
        lower, upper, p_.set.emptyCoordinate);
}

template<class Backend, int D, class P>
std::vector<ArrayInfo> PicReadings<Backend, D, P>::arrays() const
{
    const OpenSides<Backend, D, P>& sides = p_.openings;
    const FaceVelocities<Backend, D, P>& faces = p_.faces;
    const PicParticleFields<Backend, D, P>& particles = p_.particles;
    const PressureOfWater<Backend, D, P>& pressure = p_.pressure;
    const CutCells<Backend, D, P>& cut = p_.cut;
    const SurfaceFields<Backend, D, P>& surface = p_.surface;
    std::vector<ArrayInfo> list;
    const std::size_t n = std::max(particles.n, 1);
    for (const auto& f : particles.values.info())
        list.push_back(ArrayInfo{"fluid", f.name, f.bytes/n, f.bytes});
    const auto add = [&](const char* name, std::size_t bytes)
    {
        if (bytes) list.push_back(ArrayInfo{"grid", name, 0, bytes});
    };
    add("phi", surface.phi.bytes() + surface.carried.bytes() + surface.spare.bytes());
    add("p",
        pressure.p.bytes() + pressure.reflected.bytes() + pressure.ahead.bytes()
            + pressure.total.bytes());
    add("sums of tiles", p_.toFaces.bytes());
    std::size_t u = 0, walls = 0, absorb = 0;
    for (int d = 0; d < D; ++d)
    {
        u += faces.u[d].bytes() + faces.before[d].bytes() + faces.change[d].bytes()
            + faces.mass[d].bytes() + faces.after[d].bytes() + faces.carrier[d].bytes()
            + faces.layer[d].bytes();
        walls += p_.walls.aperture[d].bytes() + p_.walls.velocity[d].bytes() + cut.sealed[d].bytes()
            + cut.faceDistance[d].bytes() + cut.solidVelocity[d].bytes();
        absorb += faces.absorb[d].bytes();
    }
    walls += cut.nodeDistance.bytes() + cut.open.bytes() + cut.openWeight.bytes()
        + cut.cellLayer.bytes();
    add("u", u);
    std::size_t shifts = 0;
    for (int d = 0; d < D; ++d) shifts += particles.shift[d].bytes();
    add("places in cells", particles.place.bytes());
    add("position correction", shifts);
    add("walls", walls);
    add("absorb", absorb);
    add("viscosity", viscosity_.bytes());
    std::size_t openings = sides.flags.bytes() + sides.buffer.bytes() + sides.second.bytes();
    for (int d = 0; d < D; ++d)
        openings += sides.face[d].bytes() + sides.cell[d].bytes() + sides.gate[d].bytes();
    add("openings", openings);
    return list;
}

template<class Backend, int D, class P>
std::vector<KernelInfo> PicReadings<Backend, D, P>::kernels() const
{
    std::vector<KernelInfo> list;
    for (const auto& e : p_.set.context.profile.entries())
        list.push_back(KernelInfo{e.name, e.launches, e.seconds});
    return list;
}

} // namespace riprap

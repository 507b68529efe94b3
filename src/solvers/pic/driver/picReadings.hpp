/*  Everything that is read back from a scene of water in cells.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/snapshot.hpp"
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
HD bool isInBrick(const UniformGrid<D>& grid, const CellBox& brick, const Vec<D, double>& x)
{
    typename UniformGrid<D>::Index c = InCell<D, R>(grid, x).index();
    for (int d = 0; d < D; ++d) c.c[d] += grid.first[d];
    return brick.has(c.c);
}

template<int D, class R>
struct ParticleEnergy
{
    static constexpr const char* name = "particleEnergy";
    PicParticles<D, R> particles;
    Vec<D, double> gravity;
    UniformGrid<D> grid;
    CellBox brick;              // of several ranks; empty: there is one
    bool divided;

    HD void add(int i, double* sums) const
    {
        const Vec<D, double> x = particles.position(i);
        if (divided && !isInBrick<D, R>(grid, brick, x)) return;
        for (int d = 0; d < D; ++d)
        {
            sums[0] += 0.5*double(particles.v[d][i])*particles.v[d][i];
            sums[1] -= gravity.c[d]*x.c[d];
        }
    }
};

//- 0 of ghosts: what the grid has at the end of a part is not right
template<int D, class R>
struct SpeedInBrick
{
    static constexpr const char* name = "particleSpeed";
    ParticleSpeed<D, R> of;
    UniformGrid<D> grid;
    CellBox brick;

    HD double value(int i) const
    {
        return isInBrick<D, R>(grid, brick, of.particles.position(i)) ? of.value(i) : 0.0;
    }
};

template<int D, class R>
struct ParticlePlaces
{
    UniformGrid<D> grid;
    PicParticles<D, R> particles;

    HD double x(int d, int i) const { return grid.origin[d] + particles.x[d][i]; }
    HD bool skips(int) const { return false; }
};

//- Where particles are, as samples are asked for: above the block's corner
template<int D, class R>
struct SampledPlaces
{
    static constexpr const char* name = "sampledPlaces";
    UniformGrid<D> grid;
    PicParticles<D, R> particles;
    int first;
    double* x;

    HD void operator()(int i) const
    {
        for (int d = 0; d < D; ++d)
            x[std::size_t(D)*i + d] = grid.origin[d] + particles.x[d][first + i] - grid.origin[d];
    }
};

//- Of some cells, as PicGridState has them
template<int D, class R>
struct FieldsOfCells
{
    static constexpr const char* name = "fieldsOfCells";
    UniformGrid<D> grid;
    const std::int32_t* cell;
    const R* phi;
    const unsigned char* near;
    const R* open;                      // nullptr: nothing is cut
    const R* u[D];
    const double* p;
    int axes[3];
    double *pressure, *velocity, *water;

    HD void operator()(int i) const
    {
        const int c = cell[i];
        pressure[i] = p[c];
        water[i] = waterFraction(grid, phi, c, 0)*(open ? double(open[c]) : 1.0);
        for (int d = 0; d < 3; ++d) velocity[3*std::size_t(i) + d] = 0;
        if (!near[c]) return;
        const typename UniformGrid<D>::Index at = grid.cellIndex(c);
        for (int d = 0; d < D; ++d)
            velocity[3*std::size_t(i) + axes[d]] = 0.5
                *(double(u[d][grid.faceOf(d, at, 0)]) + u[d][grid.faceOf(d, at, 1)]);
    }
};

struct SampledPressures
{
    static constexpr const char* name = "sampledPressures";
    const double* samples;
    int values;
    double* pressure;

    HD void operator()(int i) const { pressure[i] = samples[std::size_t(values)*i + 1]; }
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

    FluidState fluid() { return fluid(false).take(); }
    Later<FluidState> fluidLater() { return fluid(true); }
    PicGridState grid();
    void cellFields(const std::int32_t* cells, std::size_t n, const PicCellFields& to);
    SampleResult sample(const std::vector<double>& points);
    FluidEnergy energy();
    FluidExtremes extremes();
    FluidEnd farEnd(const Vector3& direction, double reach);
    std::vector<ArrayInfo> arrays() const;
    std::vector<KernelInfo> kernels() const;

private:

    Later<FluidState> fluid(bool later);
    ReadValues<double> pressures(Snapshot<Backend>& now);
    void velocitiesNow(int d, Array<Backend, real>&);
    PicParticles<D, real> particlesNow(Array<Backend, real> (&v)[D]);
    //- What samples are taken from, where the scene's own arrays are not that
    struct Sampled
    {
        Array<Backend, double> p, nodes;
        Array<Backend, real> phi, u[D];
    };
    SamplePoints<D, real> sampled(Sampled&);
    FluidEnd farEndOfRanks(const Vector3& direction, double reach);

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
                    real(0.5*clock.lastStep*p_.set.gravity[d]), now.data(),
                    p_.slow.any() ? p_.slow.change[d].data() : nullptr, p_.slow.in(slowTile)});
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

//- Pressures where particles are
template<class Backend, int D, class P>
ReadValues<double> PicReadings<Backend, D, P>::pressures(Snapshot<Backend>& now)
{
    Context<Backend>& context = p_.set.context;
    const int n = p_.particles.n, most = 1 << 20;           // at once: memory on the device
    Sampled fields;
    SamplePoints<D, real> sample = sampled(fields);
    Array<Backend, double> places, found;
    const auto pressure = std::make_shared<Array<Backend, double>>();
    pressure->allocate(context, n);
    for (int first = 0; first < n; first += most)
    {
        const int count = std::min(n - first, most);
        places.allocate(context, D*std::size_t(count));
        found.allocate(context, sample.values*std::size_t(count));
        forEach(context, count,
            SampledPlaces<D, real>{p_.set.grid, p_.particles.view(), first, places.data()});
        sample.x = places.data();
        sample.result = found.data();
        forEach(context, count, sample);
        forEach(context, count,
            SampledPressures{found.data(), sample.values, pressure->data() + first});
    }
    const auto values = now.values(*pressure);
    return [values, hold = now.keeps() ? nullptr : pressure] { return values(); };
}

//- Of this rank, where there are several
template<class Backend, int D, class P>
Later<FluidState> PicReadings<Backend, D, P>::fluid(bool later)
{
    PicParticleFields<Backend, D, P>& particles = p_.particles;
    Snapshot<Backend> now(p_.set.context, later && !p_.halo);
    const std::size_t n = particles.n;
    std::array<ReadValues<double>, D> places;
    std::array<ReadValues<real>, D> velocities;
    const auto kept = std::make_shared<std::array<Array<Backend, real>, D>>();
    for (int d = 0; d < D; ++d)
    {
        places[d] = now.values(particles.values.template data<double>(particles.at.x + d), n);
        velocitiesNow(d, (*kept)[d]);
        velocities[d] = now.values((*kept)[d]);
    }
    const auto ids = now.values(particles.values.template data<std::int32_t>(particles.at.id), n);
    const auto pressure = pressures(now);
    const auto hold = now.keeps() ? nullptr : kept;
    const auto owned = std::make_shared<const std::vector<int>>(particles.own());
    const auto all = [=, grid = p_.set.grid]
    {
        (void)hold;
        const std::vector<int>& own = *owned;
        const PicConfig& config = p_.set.config;
        const std::size_t count = own.size();
        FluidState state;
        state.position.assign(3*count, 0.0);
        state.velocity.assign(3*count, 0.0);
        if (D == 2)
            for (std::size_t i = 0; i < count; ++i)
                state.position[3*i + config.axes[2]] = p_.set.emptyCoordinate;
        for (int d = 0; d < D; ++d)
        {
            const std::vector<double> x = places[d]();
            const std::vector<real> v = velocities[d]();
            const int axis = config.axes[d];
            #pragma omp parallel for schedule(static) if (count > 10000)
            for (std::size_t i = 0; i < count; ++i)
            {
                state.position[3*i + axis] = grid.origin[d] + x[own[i]];
                state.velocity[3*i + axis] = v[own[i]];
            }
        }
        const std::vector<std::int32_t> id = ids();
        const std::vector<double> p = pressure();
        state.id.resize(count);
        state.pressure.resize(count);
        for (std::size_t i = 0; i < count; ++i) state.id[i] = id[own[i]];
        for (std::size_t i = 0; i < count; ++i) state.pressure[i] = p[own[i]];
        state.density.assign(count, config.density);
        state.smoothingLength.assign(count, grid.h);
        return state;
    };
    return takenOf<FluidState>(now.keeps() || !later, n, all);
}

//- Where one process has the grid, each value is made where it is: little is copied
template<class Backend, int D, class P>
void PicReadings<Backend, D, P>::cellFields(
    const std::int32_t* cells, std::size_t n, const PicCellFields& to)
{
    if (p_.halo) return takeCells(grid(), cells, n, to);
    Context<Backend>& context = p_.set.context;
    Array<Backend, std::int32_t> cell;
    Array<Backend, double> pressure, velocity, water;
    cell.allocate(context, n);
    for (auto* a : {&pressure, &water}) a->allocate(context, n);
    velocity.allocate(context, 3*n);
    if (n) context.toDevice(cell.data(), cells, n*sizeof(*cells));
    FieldsOfCells<D, real> fields{p_.set.grid, cell.data(), p_.surface.phi.data(),
        p_.surface.near.data(), p_.cuts() ? p_.cut.open.data() : nullptr, {},
        p_.pressure.whole().data(), {}, pressure.data(), velocity.data(), water.data()};
    for (int d = 0; d < D; ++d) fields.u[d] = p_.faces.u[d].data();
    for (int d = 0; d < 3; ++d) fields.axes[d] = p_.set.config.axes[d];
    forEach(context, int(n), fields);
    if (!n) return;
    context.toHost(to.pressure, pressure.data(), n*sizeof(double));
    context.toHost(to.velocity, velocity.data(), 3*n*sizeof(double));
    context.toHost(to.water, water.data(), n*sizeof(double));
}

template<class Backend, int D, class P>
PicGridState PicReadings<Backend, D, P>::grid()
{
    const UniformGrid<D>& grid = p_.set.whole();
    const int cells = grid.cells();
    PicGridState state;
    state.pressure = p_.whole(p_.pressure.whole(), -1);
    const std::vector<real> phi = p_.whole(p_.surface.phi, -1);
    const std::vector<unsigned char> near = p_.whole(p_.surface.near, -1);
    const std::vector<real> open = p_.cuts() ? p_.whole(p_.cut.open, -1) : std::vector<real>();
    state.distance.assign(phi.begin(), phi.end());
    state.water.resize(cells);
    state.velocity.assign(3*std::size_t(cells), 0.0);
    std::vector<real> u[D];
    for (int d = 0; d < D; ++d) u[d] = p_.whole(p_.faces.u[d], d);
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

//- Points may be anywhere: of several ranks each takes the whole block's fields. Pressures are
//  continued into solids
template<class Backend, int D, class P>
SamplePoints<D, typename P::real> PicReadings<Backend, D, P>::sampled(Sampled& fields)
{
    const UniformGrid<D>& grid = p_.set.whole();
    Context<Backend>& context = p_.set.context;
    SurfaceFields<Backend, D, P>& surface = p_.surface;
    SamplePoints<D, real> from{
        grid, {}, surface.phi.data(), p_.pressure.whole().data(), {}, nullptr, nullptr};
    for (int d = 0; d < D; ++d) from.u[d] = p_.faces.u[d].data();
    if (p_.halo)
    {
        fields.phi.upload(context, p_.whole(surface.phi, -1));
        from.phi = fields.phi.data();
        for (int d = 0; d < D; ++d)
        {
            fields.u[d].upload(context, p_.whole(p_.faces.u[d], d));
            from.u[d] = fields.u[d].data();
        }
    }
    if (p_.halo || p_.cuts())
    {
        std::vector<double> p = p_.whole(p_.pressure.whole(), -1);
        if (p_.cuts())
            extendPressure(grid, p_.whole(surface.phi, -1).data(), p_.whole(surface.wet, -1), p);
        fields.p.upload(context, p);
        from.p = fields.p.data();
    }
    if (!p_.cuts()) return from;
    from.solids.grid = grid;
    from.solids.distance = p_.cut.nodeDistance.data();
    if (!p_.halo) return from;
    fields.nodes.upload(context, p_.nodeDistances());
    from.solids.distance = fields.nodes.data();
    return from;
}

template<class Backend, int D, class P>
SampleResult PicReadings<Backend, D, P>::sample(const std::vector<double>& points)
{
    Context<Backend>& context = p_.set.context;
    const std::size_t m = points.size()/3, most = 1 << 20;      // at once: memory on the device
    const std::vector<double> x = p_.set.solved(points, true);
    Sampled fields;
    SamplePoints<D, real> sample = sampled(fields);
    Array<Backend, double> places, found;
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
    ParticleEnergy<D, real> sum{particlesNow(v), {}, p_.set.grid, {}, bool(p_.halo)};
    if (p_.halo) sum.brick = p_.set.bricks->brick();
    for (int d = 0; d < D; ++d) sum.gravity.c[d] = p_.set.gravity[d];
    const auto here = sumOver<2>(p_.set.context, p_.particles.n, sum);
    std::vector<double> sums(here.begin(), here.end());
    if (p_.halo) addByRank(p_.halo->ranks(), sums);
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
    const ParticleSpeed<D, real> speed{particlesNow(v)};
    FluidExtremes e;
    if (p_.halo)
        e.speed = p_.set.largest(reduceMax(p_.set.context, p_.particles.n,
            SpeedInBrick<D, real>{speed, p_.set.grid, p_.set.bricks->brick()}));
    else e.speed = reduceMax(p_.set.context, p_.particles.n, speed);
    return e;
}

template<class Backend, int D, class P>
FluidEnd PicReadings<Backend, D, P>::farEnd(const Vector3& direction, double reach)
{
    if (p_.halo) return farEndOfRanks(direction, reach);
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

//- Those of this rank within reach of where the water of all ranks ends
template<class Backend, int D, class P>
FluidEnd PicReadings<Backend, D, P>::farEndOfRanks(const Vector3& direction, double reach)
{
    const UniformGrid<D>& whole = p_.set.whole();
    const std::vector<int> own = p_.particles.own();
    std::vector<double> x[D], along(own.size(), 0.0);
    double most = -1e300, size = 0;
    for (int d = 0; d < D; ++d)
    {
        x[d] = p_.particles.values.template download<double>(
            p_.set.context, p_.particles.at.x + d);
        size += std::abs(whole.origin[d]) + 2*whole.n[d]*whole.h;
        for (std::size_t k = 0; k < own.size(); ++k)
        {
            x[d][own[k]] += whole.origin[d];
            along[k] += direction[p_.set.config.axes[d]]*x[d][own[k]];
        }
    }
    for (const double a : along) most = std::max(most, a);
    const double least = p_.set.largest(most) - reach - 1e-12*size;
    FluidEnd end;
    end.particles = own.size();
    for (std::size_t k = 0; k < own.size(); ++k)
    {
        if (along[k] < least) continue;
        Vector3 at{{p_.set.emptyCoordinate, p_.set.emptyCoordinate, p_.set.emptyCoordinate}};
        for (int d = 0; d < D; ++d) at[p_.set.config.axes[d]] = x[d][own[k]];
        end.position.insert(end.position.end(), at.begin(), at.end());
    }
    return end;
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
    add("multirate", p_.slow.bytes());
    add("viscosity", viscosity_.bytes());
    std::size_t openings = sides.flags.bytes() + sides.buffer.bytes() + sides.second.bytes();
    for (int d = 0; d < D; ++d)
        openings += sides.face[d].bytes() + sides.cell[d].bytes() + sides.gate[d].bytes();
    add("openings", openings);
    if (p_.halo) add("messages", p_.halo->bytes());
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

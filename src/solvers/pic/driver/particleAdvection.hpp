/*  Particles go with the water, and are sorted by the cells that they come to.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/loops/reduceMax.hpp"
#include "pic/grid/speed.hpp"
#include "pic/transfer/cellLanes.hpp"
#include "pic/transfer/moveParticles.hpp"
#include "pic/transfer/positionCorrection.hpp"
#include "solvers/pic/parts/picParts.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class ParticleAdvection
{
public:

    using real = typename P::real;

    explicit ParticleAdvection(PicParts<Backend, D, P>& parts) : p_(parts) {}

    void move(double dt);
    void sort(PicReport* report = nullptr, bool keysKnown = false);
    double fastest();
    double fastestCarried(double of);

private:

    //- Particles of some tiles in a time; lag: what it has more than the step
    struct Moving
    {
        Array<Backend, real>* u;
        TileList<D> list;
        TileChoice<D> only;
        double time, lag;
    };

    void correct(const Moving&);
    void carry(const Moving&);
    void reportLeft(PicReport&, int left);

    PicParts<Backend, D, P>& p_;
};

template<class Backend, int D, class P>
void ParticleAdvection<Backend, D, P>::move(double dt)
{
    PicParticleFields<Backend, D, P>& particles = p_.particles;
    SlowTiles<Backend, D, real>& slow = p_.slow;
    std::vector<Moving> all;
    if (!slow.any())
        all.push_back(Moving{p_.faces.carrying(), p_.toFaces.occupied(), {}, dt, 0});
    else
    {
        all.push_back(
            Moving{p_.faces.carrying(), slow.list(currentTile), slow.in(currentTile), dt, 0});
        if (slow.due())
            all.push_back(Moving{
                slow.mean, slow.list(dueTile), slow.in(dueTile), slow.time, slow.time - dt});
    }
    if (p_.set.config.positionCorrection > 0)
    {
        for (int d = 0; slow.any() && d < D; ++d)
            p_.set.context.zero(particles.shift[d].data(), particles.n*sizeof(real));
        for (const Moving& m : all) correct(m);
    }
    for (const Moving& m : all) carry(m);
}

template<class Backend, int D, class P>
void ParticleAdvection<Backend, D, P>::correct(const Moving& m)
{
    const UniformGrid<D>& grid = p_.set.grid;
    CorrectPositions<D, real, !Backend::gpu> f{};
    f.grid = grid;
    f.inverse = 1/grid.h;
    f.particles = p_.particles.view();
    f.phi = p_.surface.phi.data();
    f.nearWater = p_.surface.near.data();
    for (int d = 0; d < D; ++d) f.shift[d] = p_.particles.shift[d].data();
    f.strength = real(p_.set.config.positionCorrection*m.time);
    f.spacing = real(p_.set.particleSpacing());
    f.only = m.only;
    forEach(p_.set.context, p_.particles.n, f);
}

template<class Backend, int D, class P>
void ParticleAdvection<Backend, D, P>::carry(const Moving& m)
{
    const UniformGrid<D>& grid = p_.set.grid;
    const PicConfig& config = p_.set.config;
    Context<Backend>& context = p_.set.context;
    PicParticleFields<Backend, D, P>& particles = p_.particles;
    const bool corrected = config.positionCorrection > 0;
    p_.set.withWindows([&](auto order, auto around)
    {
        MoveParticles<decltype(order)::value, D, real, decltype(around)::value> f{};
        f.grid = grid;
        f.inverse = 1/grid.h;
        f.particles = particles.view();
        for (int d = 0; d < D; ++d)
        {
            f.u[d] = m.u[d].data();
            f.aperture[d] = p_.walls.aperture[d].data();
            f.shift[d] = corrected ? particles.shift[d].data() : nullptr;
            f.gate[d] = p_.opens() ? p_.openings.gate[d].data() : nullptr;
        }
        f.nearWater = p_.surface.near.data();
        f.timeStep = m.time;
        f.lag = m.lag;
        f.order = config.advectionOrder;
        f.inside = p_.cuts();
        f.margin = p_.set.wallMargin*grid.h;
        f.keys = p_.cuts() || p_.opens() || p_.slow.any() ? nullptr : particles.sort.keys();
        f.indices = particles.sort.indices();
        f.only = m.only;
        f.from = p_.slow.any() ? particles.sort.sortedKeys() : nullptr;
        if constexpr (!Backend::gpu && D == 2 && decltype(order)::value == 2)
            forEachRow(context, m.list.count,
                MoveCells<real, decltype(around)::value>{f, m.list.tiles, m.list.list});
        else forEach(context, particles.n, f);
    });
}

//- By cells; those that have left the block come last and are dropped
template<class Backend, int D, class P>
void ParticleAdvection<Backend, D, P>::sort(PicReport* report, bool keysKnown)
{
    Context<Backend>& context = p_.set.context;
    PicParticleFields<Backend, D, P>& particles = p_.particles;
    const int before = particles.n;
    if (!keysKnown)
        forEach(context, particles.n,
            PicCellKeys<D, real>{
                p_.set.grid, particles.view(), particles.sort.keys(), particles.sort.indices()});
    particles.sort.sort(context, particles.n);
    forEach(context, particles.n,
        PutInOrder<D, real>{1/p_.set.grid.h, particles.sort.order(), particles.view(),
            particles.view(true), particles.place.data()});
    particles.values.takeSpares();
    context.toHost(&particles.n, particles.sort.active(), sizeof(int));
    if (report && particles.n < before) reportLeft(*report, before - particles.n);
}

//- Those that have gone through an opening count as that; others have escaped
template<class Backend, int D, class P>
void ParticleAdvection<Backend, D, P>::reportLeft(PicReport& report, int left)
{
    PicParticleFields<Backend, D, P>& particles = p_.particles;
    std::vector<std::int32_t> id(left);
    std::vector<double> x[D];
    p_.set.context.toHost(id.data(),
        particles.values.template data<std::int32_t>(particles.at.id) + particles.n,
        left*sizeof(std::int32_t));
    for (int d = 0; d < D; ++d)
    {
        x[d].resize(left);
        p_.set.context.toHost(x[d].data(),
            particles.values.template data<double>(particles.at.x + d) + particles.n,
            left*sizeof(double));
    }
    for (int i = 0; i < left; ++i)
    {
        Vector3 at{{p_.set.emptyCoordinate, p_.set.emptyCoordinate, p_.set.emptyCoordinate}};
        Vec<D, double> place;
        for (int d = 0; d < D; ++d)
        {
            place.c[d] = x[d][i];
            at[p_.set.config.axes[d]] = p_.set.grid.origin[d] + x[d][i];
        }
        if (p_.openings.takeLeft(place)) continue;
        report.escaped.push_back(at);
        report.escapedId.push_back(id[i]);
    }
}

template<class Backend, int D, class P> double ParticleAdvection<Backend, D, P>::fastest()
{
    return p_.set.largest(
        reduceMax(p_.set.context, p_.particles.n, ParticleSpeed<D, real>{p_.particles.view()}));
}

//- Of particles that water carries, and of others as far as they limit the step. of: all
template<class Backend, int D, class P>
double ParticleAdvection<Backend, D, P>::fastestCarried(double of)
{
    const PicConfig& config = p_.set.config;
    if (!(p_.surface.flying > 0) || !(config.maxFlyingCourant > config.maxCourant)) return of;
    return p_.set.largest(reduceMax(p_.set.context, p_.particles.n,
        CarriedSpeed<D, real>{p_.set.grid, {p_.particles.view()}, p_.surface.near.data(),
            config.maxCourant/config.maxFlyingCourant}));
}

} // namespace riprap

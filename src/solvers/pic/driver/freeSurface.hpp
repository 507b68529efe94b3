/*  The water's surface: a distance that moves with the water, kept by the particles, and the volume
    under it.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <array>
#include "pic/cutCells/extendSurface.hpp"
#include "pic/grid/wetCells.hpp"
#include "pic/surface/advectLevelSet.hpp"
#include "pic/surface/fillFraction.hpp"
#include "pic/surface/redistance.hpp"
#include "pic/surface/waterVolume.hpp"
#include "solvers/pic/driver/particleAdvection.hpp"
#include "solvers/pic/driver/particleMigration.hpp"
#include "solvers/pic/driver/rankSums.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class FreeSurface
{
public:

    using real = typename P::real;

    FreeSurface(PicParts<Backend, D, P>& parts, ParticleAdvection<Backend, D, P>& advection)
    :
        p_(parts), advection_(advection)
    {}

    void markWater();
    void move(double dt, PicReport&);
    void holdVolume();
    double waterVolume(double* sums);

    //- Volume and flying particles as they are
    void measure();

private:

    static constexpr double volumeProbe = 0.05;     // cells

    template<int N, class F> std::array<double, N> sumOver(const F&);
    std::array<double, 3> volumeInOrder();
    void shiftTo(double target);
    void redistance();
    void extend(Array<Backend, real>& phi);

    PicParts<Backend, D, P>& p_;
    ParticleAdvection<Backend, D, P>& advection_;
};

//- f.add(cell, sums) over the cells about the water; over all before these are known
template<class Backend, int D, class P>
template<int N, class F>
std::array<double, N> FreeSurface<Backend, D, P>::sumOver(const F& f)
{
    if (p_.halo) return sumByRank<N>(p_, f);
    return p_.rows.found() ? p_.rows.template sum<N>(p_.set.context, f)
                           : riprap::sumOver<N>(p_.set.context, p_.set.grid.cells(), f);
}

template<class Backend, int D, class P>
void FreeSurface<Backend, D, P>::markWater()
{
    const UniformGrid<D>& grid = p_.set.grid;
    Context<Backend>& context = p_.set.context;
    SurfaceFields<Backend, D, P>& surface = p_.surface;
    const MarkWetCells<D, real> wet{p_.pressureFields(0), surface.wet.data()};
    const MarkNearWater<D> near{grid, surface.wet.data(), surface.near.data()};
    if (p_.rows.found())
    {
        p_.rows.eachCell(context, wet);
        p_.rows.eachCell(context, near);
        return;
    }
    forEach(context, grid.cells(), wet);
    forEach(context, grid.cells(), near);
}

//- The surface goes with the water; then the particles, sorted, have their say
template<class Backend, int D, class P>
void FreeSurface<Backend, D, P>::move(double dt, PicReport& report)
{
    const UniformGrid<D>& grid = p_.set.grid;
    SurfaceFields<Backend, D, P>& surface = p_.surface;
    const real band = real(p_.set.bandCells*grid.h);
    p_.set.withWindows([&](auto order, auto around)
    {
        AdvectLevelSet<decltype(order)::value, D, real, decltype(around)::value> f{};
        f.grid = grid;
        for (int d = 0; d < D; ++d) f.u[d] = p_.faces.carrying()[d].data();
        f.from = surface.phi.data();
        f.to = surface.carried.data();
        f.timeStep = dt;
        f.band = band;
        p_.rows.eachCellOfBoth(p_.set.context, f);
    });
    if (p_.halo) ParticleMigration<Backend, D, P>(p_).migrate(report);
    // else solids have moved particles since, others have come in, or some have waited
    advection_.sort(&report, !p_.cuts() && !p_.opens() && !p_.halo && !p_.slow.any());
    p_.rows.eachCell(p_.set.context,
        HoldSurface<D, real>{grid, p_.particles.view(),
            real(p_.set.clock.particleVolume/grid.volume()),
            p_.cuts() ? p_.cut.open.data() : nullptr,
            p_.cuts() ? p_.cut.openWeight.data() : nullptr, surface.carried.data(), band});
    if (p_.cuts()) extend(surface.carried);
    if (p_.halo) p_.halo->exchange({{surface.carried, -1}});
    redistance();
    markWater();
}

//- phi on into the solids, about the water
template<class Backend, int D, class P>
void FreeSurface<Backend, D, P>::extend(Array<Backend, real>& phi)
{
    CutCells<Backend, D, P>& cut = p_.cut;
    p_.rows.eachCellOfBoth(
        p_.set.context, MarkKnownCells<real>{cut.open.data(), cut.cellLayer.data()});
    // a pass sees three cells far: two leave the brick right
    static_assert(GridBricks<D>::depth > 6, "two passes between exchanges");
    for (int pass = 1; pass <= int(p_.set.bandCells) + 1; ++pass)
    {
        if (p_.halo && pass % 2 == 1) p_.halo->exchange({{phi, -1}, {cut.cellLayer, -1}});
        p_.rows.eachCellOfBoth(p_.set.context,
            ExtendSurface<D, real>{p_.set.grid, static_cast<unsigned char>(pass),
                cut.cellLayer.data(), phi.data(), real(p_.set.bandCells*p_.set.grid.h)});
    }
}

//- phi of the carried one, which changes in the rows about the water alone
template<class Backend, int D, class P>
void FreeSurface<Backend, D, P>::redistance()
{
    const UniformGrid<D>& grid = p_.set.grid;
    SurfaceFields<Backend, D, P>& surface = p_.surface;
    const real band = real(p_.set.bandCells*grid.h);
    p_.rows.eachCellOfBoth(p_.set.context,
        StartDistance<D, real>{
            grid, surface.carried.data(), surface.phi.data(), band, surface.spare.data()});
    for (int pass = 0; pass <= int(p_.set.bandCells); ++pass)
    {
        p_.rows.each(p_.set.context,
            SpreadDistance<D, real>{
                grid, surface.carried.data(), surface.phi.data(), surface.spare.data(), band});
        surface.phi.swap(surface.spare);
    }
}

//- The same bits as of one process
template<class Backend, int D, class P>
std::array<double, 3> FreeSurface<Backend, D, P>::volumeInOrder()
{
    Array<Backend, real> phi, open;
    phi.upload(p_.set.context, p_.whole(p_.surface.phi, -1));
    if (p_.cuts()) open.upload(p_.set.context, p_.whole(p_.cut.open, -1));
    return sumInOrder<3>(p_,
        WaterVolume<D, real>{p_.set.whole(), phi.data(), p_.cuts() ? open.data() : nullptr,
            volumeProbe*p_.set.grid.h});
}

//- Volume under phi [cells]; sums: also with phi a little higher and lower. Before rows are known,
//  at the start, in the order of one process
template<class Backend, int D, class P>
double FreeSurface<Backend, D, P>::waterVolume(double* sums)
{
    const bool inOrder = p_.halo && (p_.gathered || !p_.rows.found());
    const auto s = inOrder
        ? volumeInOrder()
        : sumOver<3>(WaterVolume<D, real>{p_.set.grid, p_.surface.phi.data(),
            p_.cuts() ? p_.cut.open.data() : nullptr, volumeProbe*p_.set.grid.h});
    for (int k = 0; k < 3; ++k) sums[k] = s[k];
    return s[0];
}

//- The surface moved by what the water under it lacks
template<class Backend, int D, class P>
void FreeSurface<Backend, D, P>::holdVolume()
{
    const UniformGrid<D>& grid = p_.set.grid;
    SurfaceFields<Backend, D, P>& surface = p_.surface;
    surface.flying = sumOver<1>(
        CountFlying<D, real>{grid, p_.particles.view(), surface.near.data()})[0];
    const double particle = p_.set.clock.particleVolume/grid.volume();
    shiftTo((double(p_.particles.all()) - surface.flying)*particle
        + (p_.opens() ? p_.openings.balance()/grid.volume() : 0));
    if (p_.halo)
        p_.halo->exchange({{surface.phi, -1}, {surface.wet, -1}, {surface.near, -1}});
}

//- target: volume [cells]
template<class Backend, int D, class P>
void FreeSurface<Backend, D, P>::shiftTo(double target)
{
    const UniformGrid<D>& grid = p_.set.grid;
    SurfaceFields<Backend, D, P>& surface = p_.surface;
    constexpr double largestShift = 0.1;        // of a cell, a step
    double sums[3];
    // until the loop over steps ends and asks again
    surface.volume = waterVolume(sums);
    const double slope = (sums[2] - sums[1])/(0.1*grid.h);         // dV/d(-phi)
    if (!(slope > 0) || !(target > 0)) return;
    p_.set.clock.drift += (surface.volume - target)/target;
    double shift = (surface.volume - target)/slope;
    shift = std::max(-largestShift*grid.h, std::min(shift, largestShift*grid.h));
    if (std::abs(surface.volume - target) < 1e-9*target) return;           // round-off is no loss
    p_.rows.eachCell(p_.set.context,
        ShiftSurface<D, real>{surface.phi.data(), real(shift), real(p_.set.bandCells*grid.h)});
    markWater();
}

template<class Backend, int D, class P>
void FreeSurface<Backend, D, P>::measure()
{
    SurfaceFields<Backend, D, P>& surface = p_.surface;
    double sums[3];
    surface.volume = waterVolume(sums);
    surface.flying = sumOver<1>(
        CountFlying<D, real>{p_.set.grid, p_.particles.view(), surface.near.data()})[0];
}

} // namespace riprap

/*  What a step does to momentum, for those who ask (PicScene::watchMomentum); nothing of this is
    done otherwise.

    The mass that the pressure moves at a face is rho a S theta h: a is its open part, theta h the
    way from cell to cell, or to the surface (pressureFields.hpp). So the impulses on the water sum
    to what the pressure does to the closed parts of the cells' faces, which bodies and walls share:
    an identity of the equations, to round-off, if bodies feel what the water feels.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/projection/project.hpp"
#include "solvers/pic/parts/picParts.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class MomentumBudget
{
public:

    using real = typename P::real;

    explicit MomentumBudget(PicParts<Backend, D, P>& parts) : p_(parts) {}

    void watch(bool on) { watches_ = on; }
    const PicMomentum& last() const { return momentum_; }

    void keepForced();
    void weigh(double dt);
    void holdParticles();
    void compareParticles();

private:

    Vec<D, double> ofParticles();

    PicParts<Backend, D, P>& p_;
    bool watches_ = false;
    std::vector<real> forced_[D];               // while somebody watches
    Vec<D, double> held_{};
    PicMomentum momentum_;
};

//- u* before the pressure is solved, gravity in it
template<class Backend, int D, class P> void MomentumBudget<Backend, D, P>::keepForced()
{
    for (int d = 0; watches_ && d < D; ++d) forced_[d] = p_.faces.u[d].download();
}

//- After the velocities' changes are known, and before they are extended past the surface
template<class Backend, int D, class P>
void MomentumBudget<Backend, D, P>::weigh(double dt)
{
    const UniformGrid<D>& grid = p_.set.grid;
    SolidsInWater<Backend, D, P>& solids = p_.solids;
    if (!watches_) return;
    PicMomentum sum;
    const std::vector<real> phi = p_.surface.phi.download();
    const std::vector<double> p = p_.pressure.whole().download();
    std::vector<int> wet(grid.cells());
    p_.set.context.toHost(wet.data(), p_.pressure.step.wet(), wet.size()*sizeof(int));
    for (int d = 0; d < D; ++d)
    {
        const int axis = p_.set.config.axes[d];
        const std::vector<real> a = p_.walls.aperture[d].download(),
                                before = p_.faces.before[d].download(),
                                change = p_.faces.change[d].download();
        const std::vector<double> bodies = solids.bodies ? solids.cut.shareOfFaces(d)
                                                         : std::vector<double>();
        for (int f = 0; f < grid.faces(d); ++f)
        {
            const auto x = grid.faceIndex(d, f);
            if (grid.periodic[d] && x.c[d] == grid.n[d]) continue;        // a copy
            const int lower = grid.cellOf(d, x, 0), upper = grid.cellOf(d, x, 1);
            const bool wetLower = lower >= 0 && wet[lower], wetUpper = upper >= 0 && wet[upper];
            if (!wetLower && !wetUpper) continue;
            const double closed = 1 - double(a[f]) - (solids.bodies ? bodies[f] : 0.0);
            sum.walls[axis] += dt*grid.area()*closed
                *((wetLower ? p[lower] : 0.0) - (wetUpper ? p[upper] : 0.0));
            if (!(a[f] > real(0))) continue;
            double theta = 1;
            if (!wetLower) theta = lower < 0 ? endTheta : surfaceTheta(phi[upper], phi[lower]);
            if (!wetUpper) theta = upper < 0 ? endTheta : surfaceTheta(phi[lower], phi[upper]);
            const double mass = p_.set.config.density*grid.volume()*double(a[f])*theta;
            sum.water[axis] += mass*change[f];
            sum.gravity[axis] += mass*p_.set.gravity[d]*dt;
            sum.other[axis] += mass*(double(forced_[d][f]) - before[f] - p_.set.gravity[d]*dt);
        }
    }
    if (solids.bodies)
        for (int d = 0; d < 3; ++d) sum.solids[d] = dt*solids.bodies->forces.force()[d];
    momentum_ = sum;
}

//- With what those that wait have still to take
template<class Backend, int D, class P>
Vec<D, double> MomentumBudget<Backend, D, P>::ofParticles()
{
    Vec<D, double> sum = p_.particles.momentum();
    if (!p_.slow.any()) return sum;
    const double mass = p_.set.config.density*p_.set.clock.particleVolume;
    withSpline(p_.set.config.splineOrder, [&](auto order)
    {
        SumPending<decltype(order)::value, D, real> pending{
            p_.particles.view(), p_.set.grid, p_.slow.in(slowTile), {}};
        for (int d = 0; d < D; ++d) pending.change[d] = p_.slow.change[d].data();
        const auto sums = sumOver<D>(p_.set.context, p_.particles.n, pending);
        for (int d = 0; d < D; ++d) sum[d] += mass*sums[d];
    });
    return sum;
}

//- What particles have before they take from the grid, and what it has made of that
template<class Backend, int D, class P> void MomentumBudget<Backend, D, P>::holdParticles()
{
    if (watches_) held_ = ofParticles();
}

template<class Backend, int D, class P>
void MomentumBudget<Backend, D, P>::compareParticles()
{
    if (!watches_) return;
    const Vec<D, double> now = ofParticles();
    for (int d = 0; d < D; ++d) momentum_.particles[p_.set.config.axes[d]] = now[d] - held_[d];
}

} // namespace riprap

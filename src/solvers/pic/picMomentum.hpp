/*  PicSolver: what a step does to momentum, for those who ask (PicScene::watchMomentum); nothing of
    this is called otherwise.

    The mass that the pressure moves at a face is rho a S theta h: a is its open part, theta h the
    way from cell to cell, or to the surface (pressureFields.hpp). So the impulses on the water sum
    to what the pressure does to the closed parts of the cells' faces, which bodies and walls share:
    an identity of the equations, to round-off, if bodies feel what the water feels.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/projection/project.hpp"
#include "solvers/pic/picSolver.hpp"

namespace riprap
{

//- Sum of the particles' momentum along the solved directions
template<class Backend, int D, class P>
Vec<D, double> PicSolver<Backend, D, P>::particleMomentum()
{
    Vec<D, double> sum{};
    const double mass = config_.density*clock_.particleVolume;
    for (int d = 0; d < D; ++d)
    {
        const std::vector<real> v = set_.template download<real>(context_, vField_ + d);
        for (int i = 0; i < n_; ++i) sum[d] += mass*v[i];
    }
    return sum;
}

//- u* before the pressure is solved, gravity in it
template<class Backend, int D, class P> void PicSolver<Backend, D, P>::keepForced()
{
    for (int d = 0; d < D; ++d) forced_[d] = u_[d].download();
}

//- After the velocities' changes are known, and before they are extended past the surface
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::weighMomentum(double dt)
{
    PicMomentum sum;
    const std::vector<real> phi = phi_.download();
    const std::vector<double> p = wholePressure().download();
    std::vector<int> wet(grid_.cells());
    context_.toHost(wet.data(), pressureStep_.wet(), wet.size()*sizeof(int));
    for (int d = 0; d < D; ++d)
    {
        const int axis = config_.axes[d];
        const std::vector<real> a = aperture_[d].download(), before = before_[d].download(),
                                change = change_[d].download();
        const std::vector<double> bodies = bodies_ ? bodyCut_.shareOfFaces(d)
                                                   : std::vector<double>();
        for (int f = 0; f < grid_.faces(d); ++f)
        {
            const auto x = grid_.faceIndex(d, f);
            if (grid_.periodic[d] && x.c[d] == grid_.n[d]) continue;        // a copy
            const int lower = grid_.cellOf(d, x, 0), upper = grid_.cellOf(d, x, 1);
            const bool wetLower = lower >= 0 && wet[lower], wetUpper = upper >= 0 && wet[upper];
            if (!wetLower && !wetUpper) continue;
            const double closed = 1 - double(a[f]) - (bodies_ ? bodies[f] : 0.0);
            sum.walls[axis] += dt*grid_.area()*closed
                *((wetLower ? p[lower] : 0.0) - (wetUpper ? p[upper] : 0.0));
            if (!(a[f] > real(0))) continue;
            double theta = 1;
            if (!wetLower) theta = lower < 0 ? endTheta : surfaceTheta(phi[upper], phi[lower]);
            if (!wetUpper) theta = upper < 0 ? endTheta : surfaceTheta(phi[lower], phi[upper]);
            const double mass = config_.density*grid_.volume()*double(a[f])*theta;
            sum.water[axis] += mass*change[f];
            sum.gravity[axis] += mass*gravity_[d]*dt;
            sum.other[axis] += mass*(double(forced_[d][f]) - before[f] - gravity_[d]*dt);
        }
    }
    if (bodies_) for (int d = 0; d < 3; ++d) sum.solids[d] = dt*bodies_->force()[d];
    momentum_ = sum;
}

} // namespace riprap

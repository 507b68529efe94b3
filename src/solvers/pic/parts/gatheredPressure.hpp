/*  The pressure of a scene on several ranks, where these do not divide the equation: each has that
    of the whole block, and solves it as one process does, to the same bits. For small blocks.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/projection/pressureStep.hpp"
#include "solvers/pic/parts/picSetting.hpp"
#include "pic/ranks/haloExchange.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class GatheredPressure
{
public:

    using real = typename P::real;

    GatheredPressure(PicSetting<Backend, D, P>& set, const HaloExchange<Backend, D>& halo)
    :
        set_(set), halo_(halo)
    {
        step_.allocate(set.context, set.whole());
    }

    //- p of a rank's part: as PressureStep::solve
    PressureReport solve(const PressureFields<D, real>& part, LinearSolver& solver, bool sameWater,
        double tolerance);

private:

    void gatherWalls(const PressureFields<D, real>& part);
    template<class T>
    void gather(Array<Backend, T>& whole, const T* part, int direction)
    {
        whole.upload(set_.context, halo_.gather(part, direction));
    }

    PicSetting<Backend, D, P>& set_;
    const HaloExchange<Backend, D>& halo_;
    PressureStep<Backend, D, real> step_;
    Array<Backend, real> phi_, u_[D], aperture_[D], wallVelocity_[D];
    Array<Backend, double> p_;
};

//- Once, where nothing of them changes
template<class Backend, int D, class P>
void GatheredPressure<Backend, D, P>::gatherWalls(const PressureFields<D, real>& part)
{
    const bool change = part.wallVelocity[0] != nullptr;
    if (aperture_[0].size() && !change) return;
    for (int d = 0; d < D; ++d)
    {
        gather(aperture_[d], part.aperture[d], d);
        if (change) gather(wallVelocity_[d], part.wallVelocity[d], d);
    }
}

template<class Backend, int D, class P>
PressureReport GatheredPressure<Backend, D, P>::solve(
    const PressureFields<D, real>& part, LinearSolver& solver, bool sameWater, double tolerance)
{
    PressureFields<D, real> f = part;
    f.grid = set_.whole();
    if (!sameWater)
    {
        gather(phi_, part.phi, -1);
        gatherWalls(part);
    }
    gather(p_, part.p, -1);
    f.phi = phi_.data();
    f.p = p_.data();
    for (int d = 0; d < D; ++d)
    {
        gather(u_[d], part.u[d], d);
        f.u[d] = u_[d].data();
        f.aperture[d] = aperture_[d].data();
        f.wallVelocity[d] = wallVelocity_[d].size() ? wallVelocity_[d].data() : nullptr;
    }
    const PressureReport report = step_.solve(
        set_.context, f, solver, nullptr, sameWater, nullptr, tolerance);
    const std::vector<double> own = halo_.partOf(p_.download(), -1);
    set_.context.toDevice(part.p, own.data(), own.size()*sizeof(double));
    return report;
}

} // namespace riprap

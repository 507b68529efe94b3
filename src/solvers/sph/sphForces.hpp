/*  SphSolver: forces of the fluid on walls and solids, where they are asked for. Nothing of this is
    part of a step.

    The pressure's part is what the same pass finds without the terms of viscosity; the rest is
    viscous. What faces of walls do to particles that they put back is in neither
    (SphScene::faceContacts).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/sph/sphSolver.hpp"

namespace riprap
{

//- D components a point, in the device's order; the fluid is sorted
template<class Backend, int D, class P>
std::vector<typename P::real> SphSolver<Backend, D, P>::wallPointForces(bool viscous)
{
    Array<Backend, real> force;
    force.allocate(context_, std::size_t(nWalls_)*D);
    wallForcePass(force.data(), viscous);
    return force.download();
}

template<class Backend, int D, class P>
std::vector<Vector3> SphSolver<Backend, D, P>::wallForces()
{
    std::vector<Vector3> total(nBodies_ + 1, Vector3{{0, 0, 0}});
    if (!nWalls_) return total;
    sortNow();
    wallPass(false);
    const auto f = wallPointForces(true);
    const auto id = wall_.template download<std::int32_t>(context_, wallIdField_);
    for (int i = 0; i < nWalls_; ++i)
        for (int d = 0; d < D && !(ranks_ && ranks_->wallGhost(i)); ++d)
            total[wallBodies_[id[i]] + 1][config_.axes[d]] += f[std::size_t(i)*D + d];
    return total;
}

template<class Backend, int D, class P>
std::vector<FluidForce> SphSolver<Backend, D, P>::forcesOnWalls()
{
    std::vector<FluidForce> all;
    if (!nWalls_) return all;
    sortNow();
    wallPass(false);
    const auto whole = wallPointForces(true), pressure = wallPointForces(false);
    const auto id = wall_.template download<std::int32_t>(context_, wallIdField_);
    std::vector<std::int64_t> x[D];
    for (int d = 0; d < D; ++d)
        x[d] = wall_.template download<std::int64_t>(context_, wallXField_ + d);
    for (int i = 0; i < nWalls_; ++i)
    {
        if (ranks_ && ranks_->wallGhost(i)) continue;
        FluidForce f;
        bool any = false;
        f.part = wallParts_[id[i]];
        f.place[config_.axes[2]] = emptyCoordinate_;
        for (int d = 0; d < D; ++d)
        {
            const int axis = config_.axes[d];
            const double w = whole[std::size_t(i)*D + d], p = pressure[std::size_t(i)*D + d];
            any = any || w != 0 || p != 0;
            f.place[axis] = nBodies_ ? box_.toMetres(d, x[d][i])
                                     : wallInput_[3*std::size_t(id[i]) + axis];
            f.pressure[axis] = p;
            f.viscous[axis] = w - p;
        }
        if (any) all.push_back(f);
    }
    return all;
}

//- In the order of DemScene::particles(), at their centres
template<class Backend, int D, class P>
std::vector<FluidForce> SphSolver<Backend, D, P>::forcesOnSolids()
{
    std::vector<FluidForce> all;
    if (!solids_ || !solidsMeet_) return all;
    Array<Backend, real> force;
    force.upload(context_, std::vector<real>(std::size_t(nSolids_)*D, real(0)));
    solidForcePass(force.data());
    const std::vector<real> pressure = force.download(), whole = solidForce_.download();
    const std::vector<std::int32_t> keys = solids_->order();
    const DemState now = solidScene_->motion();
    for (std::size_t i = 0; i < keys.size(); ++i)
    {
        FluidForce f;
        f.part = now.group[i];
        for (int d = 0; d < 3; ++d) f.place[d] = now.position[3*i + d];
        for (int d = 0; d < D; ++d)
        {
            const std::size_t at = std::size_t(keys[i])*D + d;
            f.pressure[config_.axes[d]] = pressure[at];
            f.viscous[config_.axes[d]] = double(whole[at]) - double(pressure[at]);
        }
        all.push_back(f);
    }
    return all;
}

} // namespace riprap

/*  Forces of the fluid on walls and solids, where they are asked for. Nothing of this is part of a
    step.

    The pressure's part is what the same pass finds without the terms of viscosity; the rest is
    viscous. What faces of walls do to particles that they put back is in neither
    (SphScene::faceContacts).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/sph/driver/sphNeighbours.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class SphForces
{
public:

    using real = typename P::real;

    SphForces(SphParts<Backend, D, P>& parts, WallPasses<Backend, D, P>& walls,
        SolidCoupling<Backend, D, P>& solids, SphNeighbours<Backend, D, P>& neighbours)
        : p_(parts), walls_(walls), solids_(solids), neighbours_(neighbours)
    {}

    // As SphScene has them
    std::vector<Vector3> wallForces();
    std::vector<FluidForce> forcesOnWalls();
    std::vector<FluidForce> forcesOnSolids();

private:

    std::vector<real> wallPointForces(bool viscous);

    SphParts<Backend, D, P>& p_;
    WallPasses<Backend, D, P>& walls_;
    SolidCoupling<Backend, D, P>& solids_;
    SphNeighbours<Backend, D, P>& neighbours_;
};

//- D components a point, in the device's order; the fluid is sorted
template<class Backend, int D, class P>
std::vector<typename P::real> SphForces<Backend, D, P>::wallPointForces(bool viscous)
{
    Array<Backend, real> force;
    force.allocate(p_.set.context, std::size_t(p_.walls.count)*D);
    walls_.force(force.data(), viscous);
    return force.download();
}

template<class Backend, int D, class P>
std::vector<Vector3> SphForces<Backend, D, P>::wallForces()
{
    std::vector<Vector3> total(p_.walls.bodies + 1, Vector3{{0, 0, 0}});
    if (!p_.walls.count) return total;
    neighbours_.sortNow();
    walls_.extrapolate(false);
    const auto f = wallPointForces(true);
    const auto id = p_.walls.values.template download<std::int32_t>(p_.set.context, p_.walls.at.id);
    for (int i = 0; i < p_.walls.count; ++i)
        for (int d = 0; d < D && !p_.wallGhost(i); ++d)
            total[p_.walls.bodyOf[id[i]] + 1][p_.set.config.axes[d]] += f[std::size_t(i)*D + d];
    return total;
}

template<class Backend, int D, class P>
std::vector<FluidForce> SphForces<Backend, D, P>::forcesOnWalls()
{
    std::vector<FluidForce> all;
    if (!p_.walls.count) return all;
    neighbours_.sortNow();
    walls_.extrapolate(false);
    const auto whole = wallPointForces(true), pressure = wallPointForces(false);
    const auto id = p_.walls.values.template download<std::int32_t>(p_.set.context, p_.walls.at.id);
    std::vector<std::int64_t> x[D];
    for (int d = 0; d < D; ++d)
        x[d] = p_.walls.values.template download<std::int64_t>(p_.set.context, p_.walls.at.x + d);
    for (int i = 0; i < p_.walls.count; ++i)
    {
        if (p_.wallGhost(i)) continue;
        FluidForce f;
        bool any = false;
        f.part = p_.walls.partOf[id[i]];
        f.place[p_.set.config.axes[2]] = p_.set.emptyCoordinate;
        for (int d = 0; d < D; ++d)
        {
            const int axis = p_.set.config.axes[d];
            const double w = whole[std::size_t(i)*D + d], p = pressure[std::size_t(i)*D + d];
            any = any || w != 0 || p != 0;
            f.place[axis] = p_.walls.bodies ? p_.set.box.toMetres(d, x[d][i])
                                            : p_.walls.input[3*std::size_t(id[i]) + axis];
            f.pressure[axis] = p;
            f.viscous[axis] = w - p;
        }
        if (any) all.push_back(f);
    }
    return all;
}

//- In the order of DemScene::particles(), at their centres
template<class Backend, int D, class P>
std::vector<FluidForce> SphForces<Backend, D, P>::forcesOnSolids()
{
    std::vector<FluidForce> all;
    if (!p_.solids.side || !p_.solids.meetFluid) return all;
    Array<Backend, real> force;
    force.upload(p_.set.context, std::vector<real>(std::size_t(p_.solids.count)*D, real(0)));
    solids_.forcePass(force.data());
    const std::vector<real> pressure = force.download(), whole = p_.solids.force.download();
    const std::vector<std::int32_t> keys = p_.solids.side->order();
    const DemState now = p_.solids.scene->motion();
    for (std::size_t i = 0; i < keys.size(); ++i)
    {
        FluidForce f;
        f.part = now.group[i];
        for (int d = 0; d < 3; ++d) f.place[d] = now.position[3*i + d];
        for (int d = 0; d < D; ++d)
        {
            const std::size_t at = std::size_t(keys[i])*D + d;
            f.pressure[p_.set.config.axes[d]] = pressure[at];
            f.viscous[p_.set.config.axes[d]] = double(whole[at]) - double(pressure[at]);
        }
        all.push_back(f);
    }
    return all;
}

} // namespace riprap

/*  Stationary wall (paper section 5, method 1): wall points keep p = 0, rho0 and the wall's
    velocity. Fluid particles feel them through Eqs. 32, 34 and 36; they are pushed off as their own
    density rises on approach.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "sph/boundary/wallFields.hpp"
#include "sph/state/fluidFields.hpp"

namespace riprap
{

template<class Backend, int D, class P>
struct StationaryWall
{
    using real = typename P::real;
    static constexpr const char* name = "stationaryWall";

    RecordsView<Backend, D, P> wall;
    WallFields<D, P> fields;
    FluidModel<D, P> model;

    HD void operator()(int i) const
    {
        PairParticle<D, real> p;
        for (int d = 0; d < D; ++d) p.velocity.c[d] = fields.v[0] ? fields.v[d][i] : real(0);
        p.pressureTerm = 0;
        p.density = model.rho0;
        p.h = model.h0;
        wall.store(i, p);
    }
};

struct StationaryWalls
{
    static constexpr const char* word = "stationary";
    static constexpr const char* text = "points keep rest density and no pressure (section 5)";
    static constexpr bool followsFluid = false;

    //- Where points have been placed or moved
    template<class Backend, int D, class P> using Points = StationaryWall<Backend, D, P>;
};

} // namespace riprap

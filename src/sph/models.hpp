/*  The models there are, a line each family, and which combinations of terms are compiled exactly.
    Equations of state: sph/eos/equationOfState.hpp.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "api/models.hpp"
#include "sph/boundary/extrapolatedWall.hpp"
#include "sph/boundary/stationaryWall.hpp"
#include "sph/kernels/cubicSpline.hpp"
#include "sph/kernels/wendlandC2.hpp"
#include "sph/passes/shifting.hpp"
#include "sph/terms/antiClump.hpp"
#include "sph/terms/artificialViscosity.hpp"
#include "sph/terms/continuity.hpp"
#include "sph/terms/densityDiffusion.hpp"
#include "sph/terms/laminarViscosity.hpp"
#include "sph/terms/pressure.hpp"
#include "sph/terms/xsph.hpp"
#include "sph/time/leapfrog.hpp"
#include "sph/time/symplectic.hpp"

namespace riprap
{

using Kernels = Models<WendlandC2, CubicSpline>;
using WallModels = Models<StationaryWalls, ExtrapolatedWalls>;
using Integrators = Models<SphLeapfrog, SphSymplectic>;
using Shiftings = Models<NoShifting, FickianShifting>;
template<int D, class R>
using PairTerms = Models<LaminarViscosity<R>, ArtificialViscosity<R>, AntiClump<R>, Xsph<R>,
    DensityDiffusion<D, R>>;

//- What cases usually take: passes with these terms alone, in single precision and with kernels
//  that are frequent too
template<Part part, int D, class R> struct FrequentTerms;

template<int D, class R>
struct FrequentTerms<Part::all, D, R>
{
    using type = Models
    <
        Terms<Pressure, Continuity, LaminarViscosity<R>>,
        Terms<Pressure, Continuity, LaminarViscosity<R>, AntiClump<R>, Xsph<R>>,
        Terms<Pressure, Continuity, ArtificialViscosity<R>, DensityDiffusion<D, R>>
    >;
};

template<int D, class R>
struct FrequentTerms<Part::momentum, D, R>
{
    using type = Models
    <
        Terms<Pressure>,
        Terms<Pressure, LaminarViscosity<R>>,
        Terms<Pressure, LaminarViscosity<R>, AntiClump<R>>,
        Terms<Pressure, ArtificialViscosity<R>>
    >;
};

template<int D, class R>
struct FrequentTerms<Part::density, D, R>
{
    using type = Models<Terms<Continuity>, Terms<Continuity, DensityDiffusion<D, R>>>;
};

} // namespace riprap

/*  How fluid and solid particles act on each other by pressure (solidTerms.hpp has the equations).

        gradient        Eq. 40 in place of Eq. 34: the solids' own pressure is not asked for
        pressed         solids take a pressure from the fluid in each step
        extrapolates    that of Adami et al. 2012; else the sum of Eq. 41

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "api/models.hpp"

namespace riprap
{

struct CouplingTraits
{
    static constexpr bool gradient = false, pressed = false, extrapolates = false;
};

struct StationaryCoupling : CouplingTraits
{
    static constexpr const char* word = "stationary";
    static constexpr const char* text = "solids have no pressure and rest density";
};

struct PressureGradientCoupling : CouplingTraits
{
    static constexpr const char* word = "pressureGradient";
    static constexpr const char* text = "the fluid's own pressure on the solids' volume (Eq. 40)";
    static constexpr bool gradient = true;
};

struct PressureApproximationCoupling : CouplingTraits
{
    static constexpr const char* word = "pressureApproximation";
    static constexpr const char* text = "solids have the mean pressure about them (Eq. 41)";
    static constexpr bool pressed = true;
};

struct ExtrapolatedCoupling : CouplingTraits
{
    static constexpr const char* word = "extrapolated";
    static constexpr const char* text = "solids have the pressure of walls (Adami et al. 2012)";
    static constexpr bool pressed = true, extrapolates = true;
};

using Couplings = Models<StationaryCoupling, PressureGradientCoupling,
    PressureApproximationCoupling, ExtrapolatedCoupling>;

struct CouplingCard
{
    const char* word;
    const char* text;
    bool gradient, pressed, extrapolates;

    template<class M>
    explicit CouplingCard(Model<M>)
    : word(M::word), text(M::text), gradient(M::gradient), pressed(M::pressed),
      extrapolates(M::extrapolates)
    {
        static_assert(!(M::gradient && M::pressed), "a pressure that nothing looks at");
        static_assert(M::pressed || !M::extrapolates, "extrapolated from what?");
    }
};

//- By its word; std::invalid_argument with the valid ones if there is none
inline const CouplingCard& couplingOf(const std::string& word)
{ return cardOf<CouplingCard, Couplings>("coupling", word); }

} // namespace riprap

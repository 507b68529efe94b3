/*  The radius of a bond's cement by those of its particles, R_A + R_B = sum [m].

        mean        sum/2
        harmonic    R_A R_B/sum

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstdint>
#include "api/models.hpp"
#include "core/simd/math.hpp"

namespace riprap
{

struct MeanRadius
{
    static constexpr const char* word = "mean";
    static constexpr const char* text = "half the sum of the two";
    template<class R> static HD R of(R, R, R sum) { return R(0.5)*sum; }
};

struct HarmonicRadius
{
    static constexpr const char* word = "harmonic";
    static constexpr const char* text = "their product over their sum";
    template<class R> static HD R of(R radiusA, R radiusB, R sum) { return radiusA*radiusB/sum; }
};

using BondRadii = Models<MeanRadius, HarmonicRadius>;

//- Of the one at `choice`: as many questions as there are others
template<class R, class M, class... Rest>
HD R radiusOf(Model<Models<M, Rest...>>, int choice, R radiusA, R radiusB, R sum)
{
    if constexpr (sizeof...(Rest) == 0) return M::of(radiusA, radiusB, sum);
    else
        return choice == 0 ? M::of(radiusA, radiusB, sum)
                           : radiusOf(Model<Models<Rest...>>(), choice - 1, radiusA, radiusB, sum);
}

//- Place in the table; std::invalid_argument with the valid words if there is none
inline std::uint8_t bondRadiusChoice(const std::string& word)
{ return std::uint8_t(choiceOf<BondRadii>("radius", word)); }

} // namespace riprap

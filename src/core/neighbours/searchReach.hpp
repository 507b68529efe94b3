/*  How far a search reaches where the particles' own reach varies: as far as two of the largest
    there is, of which the device alone knows.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/simd/macros.hpp"

namespace riprap
{

template<class R>
struct SearchReach
{
    const float* found = nullptr;       // largest h when the search began [m]; null: h is constant
    float growth = 0, most = 0;         // so much of it more, but not beyond this [m]
    R skin = 0;                         // [m]
    R support = 2;                      // reach of a smoothing length, of it

    HD R radius(R fixed) const
    {
        if (!found) return fixed;
        const float h = (1 + growth)**found;
        return support*R(h < most ? h : most) + skin;
    }
};

} // namespace riprap

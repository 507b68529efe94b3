/*  Positions of some solids, for the host: fewer bytes than those of all.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstdint>
#include "core/backend/launch.hpp"

namespace riprap
{

template<int D>
struct GatherPlaces
{
    static constexpr const char* name = "gatherPlaces";
    const int* who;                     // their slots
    const std::int64_t* x[D];           // of all
    std::int64_t* out;                  // D of each of who

    HD void operator()(int k) const
    {
        for (int d = 0; d < D; ++d) out[std::size_t(D)*k + d] = x[d][who[k]];
    }
};

} // namespace riprap

/*  Wall points on the device: they lie outside the fluid, in layers behind the wall, each with its
    own volume.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstdint>
#include "core/containers/records.hpp"

namespace riprap
{

template<int D, class P>
struct WallFields
{
    using real = typename P::real;

    std::int64_t* x[D];         // fixed-point position
    std::int32_t* id;           // index in the input
    std::int32_t* body;         // moving group, -1: fixed; null: all fixed
    real* v[D];                 // velocity [m/s]; null: all fixed
    real* a[D];                 // acceleration [m/s2]; null: all fixed
};

} // namespace riprap

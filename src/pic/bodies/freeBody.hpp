/*  A rigid body in the water, as the grid is told of it.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <vector>
#include "core/simd/vec.hpp"

namespace riprap
{

//- Where a body may be, and its distance; Shape as in pic/shapes
template<int D, class Shape>
struct FreeBody
{
    Shape shape;
    Vec<D, double> centre;      // of mass
    double reach;               // nothing of it is farther from the centre
    std::vector<double> velocity;
};

} // namespace riprap

/*  What a cut writes to, from a test's own arrays.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/bodies/bodyCut.hpp"
#include "pic/cutCells/obstacleDistance.hpp"

namespace riprap
{

template<int D, class Faces, class Nodes>
auto cutFieldsOf(const UniformGrid<D>& grid, Faces (&aperture)[D], Faces (&wallVelocity)[D],
    Faces (&base)[D], Nodes& distance, Nodes& baseDistance)
{
    using R = typename std::remove_pointer<decltype(aperture[0].data())>::type;
    CutFields<D, R> f{};
    for (int d = 0; d < D; ++d)
    {
        f.aperture[d] = aperture[d].data();
        f.wallVelocity[d] = wallVelocity[d].data();
        f.baseAperture[d] = base[d].data();
    }
    f.distance = distance.data();
    f.baseDistance = baseDistance.data();
    f.band = bandNodes*grid.h;
    return f;
}

} // namespace riprap

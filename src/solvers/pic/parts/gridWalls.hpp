/*  What walls leave open of the grid's faces, how they move, and which sides water sticks to.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/backend.hpp"
#include "solvers/pic/parts/picSetting.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class GridWalls
{
public:

    using real = typename P::real;

    Array<Backend, real> aperture[D], velocity[D];
    bool move = false;
    PicWalls sides;                             // of the domain, with openings' faces open

    explicit GridWalls(PicSetting<Backend, D, P>& set) : set_(set)
    {
        for (int d = 0; d < D; ++d) aperture[d].allocate(set.context, set.grid.faces(d));
    }

    void setSides();

private:

    PicSetting<Backend, D, P>& set_;
};

//- Water sticks to a side of the block that is closed all over
template<class Backend, int D, class P>
void GridWalls<Backend, D, P>::setSides()
{
    if (!set_.config.noSlip) return;
    for (int d = 0; d < D; ++d)
    {
        if (set_.grid.periodic[d]) continue;
        const std::vector<real> a = aperture[d].download();
        for (int side = 0; side < 2; ++side)
        {
            bool closed = true;
            for (int i = 0; i < set_.grid.faces(d); ++i)
                closed = closed
                    && (set_.grid.faceIndex(d, i).c[d] != side*set_.grid.n[d]
                        || !(a[i] > real(0)));
            set_.grid.sticks[d][side] = closed;
            for (int e = 0; e < D; ++e)
                set_.grid.slide[d][side][e] = closed
                    ? set_.config.slide[set_.config.axes[d]][side][set_.config.axes[e]]
                    : 0;
        }
    }
}

} // namespace riprap

/*  What walls leave open of the grid's faces, how they move, and which sides water sticks to.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/backend.hpp"
#include "solvers/pic/parts/picSetting.hpp"

namespace riprap
{

//- Of the faces of direction d as given; where nothing is given sides are closed, and all else is
//  open
template<class R, int D>
std::vector<R> openParts(const UniformGrid<D>& grid, int d, const std::vector<double>& given)
{
    std::vector<R> a(given.begin(), given.end());
    if (!a.empty()) return a;
    a.assign(grid.faces(d), R(1));
    for (int i = 0; i < grid.faces(d) && !grid.periodic[d]; ++i)
    {
        const int layer = grid.faceIndex(d, i).c[d];
        if (layer == 0 || layer == grid.n[d]) a[i] = 0;
    }
    return a;
}

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

    void setSides(const std::vector<real> (&open)[D]);

private:

    PicSetting<Backend, D, P>& set_;
};

//- Water sticks to a side of the block that is closed all over. open: parts of the block's faces
template<class Backend, int D, class P>
void GridWalls<Backend, D, P>::setSides(const std::vector<real> (&open)[D])
{
    if (!set_.config.noSlip) return;
    const UniformGrid<D>& whole = set_.whole();
    for (int d = 0; d < D; ++d)
    {
        if (whole.periodic[d]) continue;
        for (int side = 0; side < 2; ++side)
        {
            bool closed = true;
            for (int i = 0; i < whole.faces(d); ++i)
                closed = closed
                    && (whole.faceIndex(d, i).c[d] != side*whole.n[d] || !(open[d][i] > real(0)));
            double slide[3] = {0, 0, 0};
            for (int e = 0; e < D && closed; ++e)
                slide[e] = set_.config.slide[set_.config.axes[d]][side][set_.config.axes[e]];
            if (set_.bricks && closed) set_.bricks->stick(d, side, slide);
            // a rank's part may end before the side
            UniformGrid<D>& grid = set_.grid;
            closed = closed && (side ? grid.first[d] + grid.n[d] == whole.n[d] : !grid.first[d]);
            grid.sticks[d][side] = closed;
            for (int e = 0; e < D; ++e) grid.slide[d][side][e] = closed ? slide[e] : 0;
        }
    }
}

} // namespace riprap

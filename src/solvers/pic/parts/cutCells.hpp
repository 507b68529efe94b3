/*  What solids inside the domain leave of the cells; nothing is allocated in a scene that has none.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/backend.hpp"
#include "pic/cutCells/apertures.hpp"
#include "solvers/pic/parts/picSetting.hpp"
#include "solvers/pic/picObstacles.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class CutCells
{
public:

    using real = typename P::real;

    PicCut base;                                // by what does not belong to the solids
    Array<Backend, real> baseAperture[D], baseVelocity[D];      // of the grid without bodies
    Array<Backend, double> baseDistance;
    // is the grid cut where solids now are, with velocities of a step?
    bool moves = false, forStep = false;
    Array<Backend, double> nodeDistance;        // to solids
    Array<Backend, real> open, openWeight;      // parts of cells
    Array<Backend, real> faceDistance[D], solidVelocity[D];     // where water sticks to solids
    Array<Backend, unsigned char> cellLayer, sealed[D];
    Array<Backend, real> pushed[D];             // of obstacles that move, what closes faces times w

    explicit CutCells(PicSetting<Backend, D, P>& set) : set_(set) {}

    //- sticks: does water stick to the solids?
    void allocate(bool sticks);

private:

    PicSetting<Backend, D, P>& set_;
};

template<class Backend, int D, class P>
void CutCells<Backend, D, P>::allocate(bool sticks)
{
    const int cells = set_.grid.cells();
    const NodeGrid<D> nodes{set_.grid};
    nodeDistance.allocate(set_.context, nodes.count());
    for (auto* a : {&open, &openWeight}) a->allocate(set_.context, cells);
    cellLayer.allocate(set_.context, cells);
    for (int d = 0; d < D; ++d)
    {
        sealed[d].allocate(set_.context, set_.grid.faces(d));
        if (sticks) faceDistance[d].allocate(set_.context, set_.grid.faces(d));
    }
}

} // namespace riprap

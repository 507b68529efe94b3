/*  Openings of a side, on the host: how much of each face is under water, what is given there, and
    the particles that come in.

    A face of which the part f is under water lets q f |S| dt in, q being the velocity into the
    block. That volume is kept, and each time it has become that of a particle, one enters: at as
    many places in turn as the seeds of a cell have (the wet part of the face, in equal shares), and
    as far inside as the water has come since: rest/(f |S|). So water that comes in evenly is as
    even as a lattice, and no volume is lost or made.

    Particles leave one by one, too, often a row of them at a time, but water leaves evenly: what
    the flow has carried out and what has left as particles is balanced for each opening, so that
    the water's volume does not jump.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>
#include "pic/grid/uniformGrid.hpp"

namespace riprap
{

template<int D>
struct OpenFace
{
    int direction = 0, face = 0, cell = 0;
    bool upper = false;             // side of the block
    int opening = 0;                // number
    Vec<D, double> corner;          // the lowest, above the block's [m]
    double height = 0, extent = 0;  // of its middle, and of its edges, against gravity [m]
    double open = 1;                // part that no obstacle closes
    // parts: through which water may come in, and that is under water
    double wet = 0, filled = 0;

    double kept = 0;                // volume that has come in, less its particles' [m^D]
    int turn = 0;                   // place of the next one

    double inward(double along) const { return upper ? -along : along; }

    //- Under water that stands at a level, or at the distance phi from the middle of the cell
    double under(double level) const
    {
        if (!(extent > 0)) return level > height ? 1 : 0;
        return std::max(0.0, std::min(0.5 + (level - height)/extent, 1.0));
    }
    double underSurface(double phi) const { return under(height - phi); }
};

//- Faces of the sides that belong to openings: opening[d]: number of each face of direction d, -1:
//  none. up: against gravity, of length 1
template<int D>
std::vector<OpenFace<D>> openFaces(
    const UniformGrid<D>& grid, const std::vector<int>* opening, const Vec<D, double>& up)
{
    std::vector<OpenFace<D>> faces;
    for (int d = 0; d < D; ++d)
        for (int i = 0; i < int(opening[d].size()); ++i)
        {
            const typename UniformGrid<D>::Index at = grid.faceIndex(d, i);
            if (opening[d][i] < 0 || grid.periodic[d] || (at.c[d] != 0 && at.c[d] != grid.n[d]))
                continue;
            OpenFace<D> f;
            f.direction = d;
            f.face = i;
            f.upper = at.c[d] != 0;
            f.cell = grid.cellOf(d, at, f.upper ? 0 : 1);
            f.opening = opening[d][i];
            for (int e = 0; e < D; ++e)
            {
                f.corner.c[e] = at.c[e]*grid.h;
                f.height += up.c[e]*(grid.origin[e] + (at.c[e] + (e == d ? 0.0 : 0.5))*grid.h);
                if (e != d) f.extent += std::abs(up.c[e])*grid.h;
            }
            if (f.extent < 1e-6*grid.h) f.extent = 0;
            faces.push_back(f);
        }
    return faces;
}

//- What the flow has carried out, less what has left as particles, is less than a row of particles
template<int D> void balance(double& owed, double more, double row)
{
    owed = std::max(-row, std::min(owed + more, row));
}

//- Places above the block's corner of the particles of `volume` that enter in dt, inward at the
//  velocity q > 0. vertical: the direction of gravity, -1: there is none; upward: does it point to
//  higher coordinates? perDirection: particles of a cell
template<int D>
void enter(OpenFace<D>& f, const UniformGrid<D>& grid, double q, double dt, double volume,
    int perDirection, int vertical, bool upward, double margin, std::vector<Vec<D, double>>& places)
{
    const double area = f.wet*f.open*grid.area();
    if (!(area > 0) || !(q > 0)) return;
    f.kept += q*area*dt;
    while (f.kept >= volume)
    {
        f.kept -= volume;
        const double inside = std::max(margin, std::min(f.kept/area, std::min(q*dt, grid.h)));
        Vec<D, double> x = f.corner;
        x.c[f.direction] += f.upper ? -inside : inside;
        int turn = f.turn;
        for (int e = 0; e < D; ++e)
        {
            if (e == f.direction) continue;
            double part = (turn % perDirection + 0.5)/perDirection;
            turn /= perDirection;
            if (e == vertical) part = upward ? part*f.wet : 1 - part*f.wet;
            x.c[e] += part*grid.h;
        }
        f.turn = (f.turn + 1) % (D == 2 ? perDirection : perDirection*perDirection);
        places.push_back(x);
    }
}

} // namespace riprap

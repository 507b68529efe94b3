/*  The uniform Cartesian block that the grid of PIC lives on: cells and the staggered faces of each
    direction.

    Cell (i, j, k) is number i + n0*(j + n1*k). Faces normal to direction d form an array of their
    own, with n_d + 1 layers along d: face (i, j, k) of direction d lies at the lower side along d
    of the cell of the same indices. Along a periodic direction the last layer is a copy of the
    first. A side of the block may be a wall that water sticks to, and that slides in its own plane.

    A block may be a part of a larger one, that of a process: places are above the corner of the
    whole one everywhere, so that they are the same bits in each part.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstddef>
#include "core/simd/vec.hpp"

namespace riprap
{

template<int D>
struct UniformGrid
{
    double origin[D];           // lower corner [m]
    double h;                   // edge of a cell [m]
    int n[3] = {1, 1, 1};       // cells a direction
    bool periodic[3] = {false, false, false};
    bool sticks[3][2] = {};     // along each direction: the lower and the upper side
    double slide[3][2][3] = {}; // their velocities [m/s]
    int first[3] = {0, 0, 0};   // number of its first cell in the whole block
    // is it no whole block? Asked before numbers are shifted: what is then done for whole ones is
    // compiled as if there were no parts, and rounds the same
    bool part = false;

    using Index = Vec<3, int>;

    HD int cells() const { return n[0]*n[1]*n[2]; }
    HD int layers(int d, int along) const { return n[along] + (d == along ? 1 : 0); }
    HD int faces(int d) const { return layers(d, 0)*layers(d, 1)*layers(d, 2); }

    HD int cell(const Index& c) const { return c.c[0] + n[0]*(c.c[1] + n[1]*c.c[2]); }
    HD int face(int d, const Index& f) const
    {
        return f.c[0] + layers(d, 0)*(f.c[1] + layers(d, 1)*f.c[2]);
    }

    HD Index cellIndex(int i) const { return Index{{i % n[0], i/n[0] % n[1], i/(n[0]*n[1])}}; }
    HD Index faceIndex(int d, int i) const
    {
        const int a = layers(d, 0), b = layers(d, 1);
        return Index{{i % a, i/a % b, i/(a*b)}};
    }

    //- The face of direction d below (side 0) or above (side 1) a cell
    HD int faceOf(int d, Index c, int side) const
    {
        c.c[d] += side;
        return face(d, c);
    }

    //- The cell below (side 0) or above (side 1) a face, -1 beyond the block
    HD int cellOf(int d, Index f, int side) const
    {
        f.c[d] += side - 1;
        if (f.c[d] < 0 || f.c[d] >= n[d])
        {
            if (!periodic[d]) return -1;
            f.c[d] += f.c[d] < 0 ? n[d] : -n[d];
        }
        return cell(f);
    }

    //- The neighbour of a cell along d, offset -1 or 1; -1 beyond the block
    HD int neighbour(Index c, int d, int offset) const
    {
        return cellOf(d, offset > 0 ? shifted(c, d) : c, offset > 0);
    }

    //- Where it begins and ends along d, above the corner of the whole block
    HD double low(int d) const { return first[d]*h; }
    HD double high(int d) const { return (first[d] + n[d])*h; }

    HD double volume() const { return D == 2 ? h*h : h*h*h; }
    HD double area() const { return D == 2 ? h : h*h; }

private:

    HD static Index shifted(Index c, int d) { c.c[d] += 1; return c; }
};

} // namespace riprap

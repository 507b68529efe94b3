/*  The cell-linked grid: shape, cell of a position, and the rows of cells that a sphere touches.

    Cells are stored x fastest; of the other axes y before z, or where asked for the one with fewer
    cells: in a long scene what is near is then near in memory too. A row is a line of cells along
    x: particles of a row's cells lie side by side in memory, so a search is a few contiguous
    ranges. Cells are fine along x (ranges are trimmed to the sphere) and 1/reach of the search
    radius along the other axes.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include "core/simd/precision.hpp"

namespace riprap
{

template<int D, class P>
struct CellGrid
{
    using real = typename P::real;

    int n[3] = {1, 1, 1};
    real inverse[3];            // 1/cell size [1/m]
    real size[3];               // cell size [m]
    int stride[3] = {1, 1, 1};  // cells from one to the next along each axis
    bool periodic[3] = {false, false, false};
    int reach = 1;              // rows to each side that a search visits
    int cells = 0;
    real radius = 0;            // search radius: support plus skin [m]

    //- Cover the box with cells for a search radius; about cellsPerRadius cells along x in one
    //  radius
    void set(const Box<D, P>& box, double searchRadius, int rowReach, double cellsPerRadius,
        double maxCells, bool shortFirst = false)
    {
        radius = real(searchRadius);
        reach = rowReach;
        double count[3] = {1, 1, 1};
        for (int d = 0; d < D; ++d)
        {
            const double target = d == 0 ? searchRadius/cellsPerRadius : searchRadius/rowReach;
            count[d] = std::max(1.0, std::floor(box.length[d]/target));
            periodic[d] = box.periodic[d];
        }
        const double total = count[0]*count[1]*count[2];
        // fewer than four periodic cells could be found from both sides, and twice
        if (total > maxCells)
            count[0] = std::max(periodic[0] ? std::min(count[0], 4.0) : 1.0,
                std::floor(count[0]*maxCells/total));
        for (int d = 0; d < D; ++d)
        {
            n[d] = int(count[d]);
            size[d] = real(box.length[d]/n[d]);
            inverse[d] = real(n[d]/box.length[d]);
        }
        cells = n[0]*n[1]*n[2];
        const int first = shortFirst && n[2] < n[1] ? 2 : 1;
        stride[first] = n[0];
        stride[3 - first] = n[0]*n[first];
    }

    //- Cell index of a position (metres above the box's corner), clamped into the grid
    HD int cellOf(const Vec<D, real>& x) const
    {
        int index = 0;
        for (int d = D - 1; d >= 0; --d)
        {
            const int c = floorInt(x.c[d]*inverse[d]);
            index += (c < 0 ? 0 : (c >= n[d] ? n[d] - 1 : c))*stride[d];
        }
        return index;
    }

    //- Call f(begin, end) for every range of particles that may lie within `radius` of x.
    //  start: first particle of each cell, cells + 1 entries
    template<class F>
    HD void forEachRange(const Vec<D, real>& x, const int* start, const F& f) const
    {
        forEachRange(x, radius, reach, reach, start, f);
    }

    //- The same within a distance of no more than that
    template<class F>
    HD void forEachRangeNear(
        const Vec<D, real>& x, real distance, const int* start, const F& f) const
    {
        forEachRange(x, distance, reach, reach, start, f);
    }

    //- The same within another distance: for particles that look for others of another size
    template<class F>
    HD void forEachRangeWithin(
        const Vec<D, real>& x, real distance, const int* start, const F& f) const
    {
        const int y = int(distance*inverse[1]) + 1,
                  z = D == 3 ? int(distance*inverse[D - 1]) + 1 : 0;
        forEachRange(x, distance, y, z, start, f);
    }

private:
    template<class F>
    HD void forEachRange(const Vec<D, real>& x, real distance, int reachY, int reachZ,
        const int* start, const F& f) const
    {
        const real r2 = distance*distance;
        const int cy = floorInt(x.c[1]*inverse[1]);
        if constexpr (D == 2)
        {
            for (int dy = -reachY; dy <= reachY; ++dy)
                row(x, wrap(cy + dy, 1)*stride[1], r2 - square(gap(x, cy, dy, 1)), start, f);
        }
        else
        {
            const int cz = floorInt(x.c[2]*inverse[2]);
            for (int dz = -reachZ; dz <= reachZ; ++dz)
            {
                const int z = wrap(cz + dz, 2);
                const real rz2 = r2 - square(gap(x, cz, dz, 2));
                if (z < 0 || rz2 <= 0) continue;
                for (int dy = -reachY; dy <= reachY; ++dy)
                {
                    const int y = wrap(cy + dy, 1);
                    row(x, y < 0 ? -1 : z*stride[2] + y*stride[1],
                        rz2 - square(gap(x, cy, dy, 1)), start, f);
                }
            }
        }
    }

    HD static real square(real a) { return a*a; }

    //- Distance along axis d from x to the slab of cells `offset` away from its own (0 inside)
    HD real gap(const Vec<D, real>& x, int cell, int offset, int d) const
    {
        if (offset > 0) return maximum(real(cell + offset)*size[d] - x.c[d], real(0));
        if (offset < 0) return maximum(x.c[d] - real(cell + offset + 1)*size[d], real(0));
        return 0;
    }

    //- Cell index along axis d, wrapped where periodic; -1 outside
    HD int wrap(int c, int d) const
    {
        if (periodic[d]) return c < 0 ? c + n[d] : (c >= n[d] ? c - n[d] : c);
        return c < 0 || c >= n[d] ? -1 : c;
    }

    template<class F>
    HD void row(
        const Vec<D, real>& x, int first, real halfWidth2, const int* start, const F& f) const
    {
        if (first < 0 || halfWidth2 <= 0) return;
        // a hair wider than exact, so that rounding of x never loses a neighbour
        const real half = squareRoot(halfWidth2)*real(1.001);
        int low = floorInt((x.c[0] - half)*inverse[0]), high = floorInt((x.c[0] + half)*inverse[0]);
        if (periodic[0])
        {
            if (low < 0) { range(start, first + low + n[0], first + n[0] - 1, f); low = 0; }
            if (high >= n[0]) { range(start, first, first + high - n[0], f); high = n[0] - 1; }
        }
        else
        {
            low = low < 0 ? 0 : low;
            high = high >= n[0] ? n[0] - 1 : high;
        }
        if (low <= high) range(start, first + low, first + high, f);
    }

    template<class F>
    HD void range(const int* start, int low, int high, const F& f) const
    {
        const int begin = start[low], end = start[high + 1];
        if (begin < end) f(begin, end);
    }
};

} // namespace riprap

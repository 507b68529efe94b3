/*  Apertures of faces and open volumes of cells, from signed distances at the nodes of the grid
    (negative in solids).

    Node (i, j, k) is the lower corner of the cell of the same indices, and number i + (n0 + 1)*(j +
    (n1 + 1)*k). Faces that are open by less than smallestAperture are closed: nothing worth its row
    of equations flows through.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/simd/math.hpp"
#include "pic/shapes/faceCut.hpp"
#include "pic/grid/uniformGrid.hpp"

namespace riprap
{

static constexpr double smallestAperture = 1e-3;

//- Where the distance at a corner of a cell is more, in cells, no solid reaches into it: it is
//  longer than the cell's diagonal
static constexpr double clearOfCell = 1.75;

//- The nodes of a grid
template<int D>
struct NodeGrid
{
    UniformGrid<D> grid;

    HD int count() const
    {
        int n = 1;
        for (int d = 0; d < D; ++d) n *= grid.n[d] + 1;
        return n;
    }

    HD int stride(int d) const
    {
        return d == 0 ? 1 : d == 1 ? grid.n[0] + 1 : (grid.n[0] + 1)*(grid.n[1] + 1);
    }

    HD int node(const typename UniformGrid<D>::Index& x) const
    {
        int i = 0;
        for (int d = 0; d < D; ++d) i += x.c[d]*stride(d);
        return i;
    }

    HD Vec<D, double> position(int i) const
    {
        typename UniformGrid<D>::Index at;
        for (int d = 0; d < D; ++d)
        {
            at.c[d] = i % (grid.n[d] + 1);
            i /= grid.n[d] + 1;
        }
        return position(at);
    }

    HD Vec<D, double> position(const typename UniformGrid<D>::Index& at) const
    {
        Vec<D, double> x;
        for (int d = 0; d < D; ++d) x[d] = grid.origin[d] + grid.h*(grid.first[d] + at.c[d]);
        return x;
    }
};

//- Distance to the nearest of several solids: the smallest
template<int D, class Shape>
struct NodeDistances
{
    static constexpr const char* name = "nodeDistances";
    NodeGrid<D> nodes;
    Shape shape;
    double* distance;

    HD void operator()(int i) const
    {
        const double d = shape.distance(nodes.position(i));
        if (d < distance[i]) distance[i] = d;
    }
};

//- Solid part of a face of direction d, whose lower corner is a node
template<int D>
HD SolidPart<D> solidOfFace(const NodeGrid<D>& nodes, int d,
    const typename UniformGrid<D>::Index& face, const double* distance)
{
    const int n = nodes.node(face);
    if constexpr (D == 2) return solidOfEdge(distance[n], distance[n + nodes.stride(1 - d)]);
    else
    {
        const int a = nodes.stride(d == 0 ? 1 : 0), b = nodes.stride(d == 2 ? 1 : 2);
        return solidOfSquare(distance[n], distance[n + a], distance[n + b], distance[n + a + b]);
    }
}

//- Faces of direction d: what is open already (aperture, in) and what solids leave of it
template<int D, class R>
struct CloseFaces
{
    static constexpr const char* name = "closeFaces";
    NodeGrid<D> nodes;
    int d;
    const double* distance;
    R* aperture;

    HD void operator()(int i) const
    {
        const double open = double(aperture[i])
            *(1 - solidOfFace(nodes, d, nodes.grid.faceIndex(d, i), distance).share);
        aperture[i] = open < smallestAperture ? R(0) : R(open);
    }
};

//- Open share of each cell
template<int D, class R>
struct OpenVolumes
{
    static constexpr const char* name = "openVolumes";
    NodeGrid<D> nodes;
    const double* distance;
    R* open;

    HD void operator()(int i) const
    {
        const int n = nodes.node(nodes.grid.cellIndex(i));
        if (distance[n] > clearOfCell*nodes.grid.h) { open[i] = 1; return; }
        const auto at = [&](int corner)
        {
            int c = n;
            for (int d = 0; d < D; ++d) c += (corner >> d & 1)*nodes.stride(d);
            return distance[c];
        };
        if constexpr (D == 2) open[i] = R(1 - solidOfSquare(at(0), at(1), at(2), at(3)).share);
        else
        {
            // in cells: a part is wanted to the precision of what keeps it
            R corner[8];
            bool in = true, out = true;
            for (int k = 0; k < 8; ++k)
            {
                corner[k] = R(at(k)/nodes.grid.h);
                in = in && corner[k] < 0;
                out = out && corner[k] >= 0;
            }
            open[i] = in || out ? R(out) : maximum(R(0), 1 - solidOfCube(corner));
        }
    }
};

} // namespace riprap

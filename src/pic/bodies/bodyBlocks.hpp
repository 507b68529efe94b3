/*  Bodies as kernels see them, and the work about them: each has a block of nodes, faces and cells,
    whose rows along the first axis are numbered through all bodies. So the cost is that of the
    blocks, whatever the grid around them.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/loops/atomicMinimum.hpp"
#include "pic/bodies/bodyShape.hpp"
#include "pic/cutCells/apertures.hpp"

namespace riprap
{

//- A block reaches so many cells beyond its body: distances are known for two (bandNodes)
static constexpr int blockMargin = 2;

template<int D>
struct PlacedBody
{
    Vec<D, double> centre;      // of mass
    int firstBall, balls;
    int sampled;                // its number among those with a shape of their own; -1: balls
    int low[3], size[3];        // of the block: its first index, and indices along each axis

    HD int rows() const { return size[1]*size[2]; }

    //- Nothing of the body is farther than reach from its centre
    void setBlock(const UniformGrid<D>& grid, double reach)
    {
        for (int d = 0; d < 3; ++d) { low[d] = 0; size[d] = 1; }
        for (int d = 0; d < D; ++d)
        {
            const int first = floorInt((centre[d] - reach - grid.origin[d])/grid.h)
                - grid.first[d] - blockMargin,
                      last = floorInt((centre[d] + reach - grid.origin[d])/grid.h)
                - grid.first[d] + 1 + blockMargin;
            low[d] = first > 0 ? first : 0;
            size[d] = (last < grid.n[d] ? last : grid.n[d]) - low[d] + 1;
            if (size[d] < 0) size[d] = 0;
        }
        if (!size[0]) size[1] = 0;
    }
};

//- A row of a block
struct BlockRow { int body, j, k; };

//- Threads to a row, each with every so-manieth place of it: what is worth work lies at the ends of
//  rows, and in a few of them
template<class Backend> inline constexpr int rowLanes = Backend::gpu ? 8 : 1;

template<int D>
struct BodyBlocks
{
    UniformGrid<D> grid;
    int count;
    const PlacedBody<D>* body;
    const int* firstRow;        // of each body, and the number of rows
    const int* bodyOfRow;
    const Ball<D>* ball;
    const SampledShape<D>* sampled;

    HD ShapeView<D> shape(int b) const
    {
        return {{ball + body[b].firstBall, body[b].balls},
            body[b].sampled < 0 ? nullptr : sampled + body[b].sampled};
    }

    HD BlockRow row(int r) const
    {
        const int b = bodyOfRow[r], i = r - firstRow[b];
        return {b, i % body[b].size[1], i/body[b].size[1]};
    }

    //- The first index of a row
    HD typename UniformGrid<D>::Index first(const BlockRow& r) const
    { return {{body[r.body].low[0], body[r.body].low[1] + r.j, body[r.body].low[2] + r.k}}; }
};

//- The body of each row: the last that begins at or before it
struct BodiesOfRows
{
    static constexpr const char* name = "bodiesOfRows";
    int count;
    const int* firstRow;
    int* body;

    HD void operator()(int r) const
    {
        int low = 0, high = count;
        while (high - low > 1)
        {
            const int middle = (low + high)/2;
            if (firstRow[middle] <= r) low = middle;
            else high = middle;
        }
        body[r] = low;
    }
};

//- f(index) over the cells of rows, as far as the grid has them
template<int D, int Lanes, class F>
struct OverBlockCells
{
    static constexpr const char* name = F::name;
    BodyBlocks<D> blocks;
    F f;

    HD void operator()(int thread) const
    {
        const int lane = thread % Lanes;
        const BlockRow row = blocks.row(thread/Lanes);
        const UniformGrid<D>& g = blocks.grid;
        typename UniformGrid<D>::Index c = blocks.first(row);
        for (int d = 1; d < D; ++d) if (c.c[d] >= g.n[d]) return;
        c.c[0] += lane;
        for (int i = lane; i < blocks.body[row.body].size[0] && c.c[0] < g.n[0];
             i += Lanes, c.c[0] += Lanes)
            f(g.cell(c));
    }
};

//- Bodies' distances to the nodes about them, where they are the nearest
template<int D, int Lanes>
struct LowerDistances
{
    static constexpr const char* name = "bodyDistances";
    BodyBlocks<D> blocks;
    double band;                // [m]: beyond it nothing is told
    double* distance;

    HD void operator()(int thread) const
    {
        const BlockRow row = blocks.row(thread/Lanes);
        const NodeGrid<D> nodes{blocks.grid};
        const ShapeView<D> shape = blocks.shape(row.body);
        const Ball<D>* ball = shape.single();
        typename UniformGrid<D>::Index at = blocks.first(row);
        const int first = nodes.node(at);
        at.c[0] += thread % Lanes;
        for (int n = first + thread % Lanes; n < first + blocks.body[row.body].size[0];
             n += Lanes, at.c[0] += Lanes)
        {
            const Vec<D, double> x = nodes.position(at);
            if (ball
                && squaredNorm(x - ball->centre) > (ball->radius + band)*(ball->radius + band))
                continue;
            const double d = shape.distance(x);
            if (d < band) atomicMinimum(distance + n, d);
        }
    }
};

//- As it was without bodies
template<int D, int Lanes>
struct RestoreDistances
{
    static constexpr const char* name = "restoreDistances";
    BodyBlocks<D> blocks;
    const double* base;
    double* distance;

    HD void operator()(int thread) const
    {
        const BlockRow row = blocks.row(thread/Lanes);
        const int first = NodeGrid<D>{blocks.grid}.node(blocks.first(row));
        for (int n = first + thread % Lanes; n < first + blocks.body[row.body].size[0]; n += Lanes)
            distance[n] = base[n];
    }
};

} // namespace riprap

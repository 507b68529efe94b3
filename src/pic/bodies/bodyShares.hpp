/*  Bodies' shares of faces, and what they leave open.

    Shares stand row by row of the bodies' blocks: each row of faces of a direction has those from
    the first to the last that may have any. Sorted by faces (stable: in the order of the bodies)
    each face sums its own. Where bodies and walls leave less than smallestAperture of a face it is
    closed, and shares that sum to more than the face are scaled down to it. A face that is a wall
    inside the grid keeps the bodies' shares, so that a body that the wall clips still has a closed
    surface; one of a side's wall has none, for the same reason: with a share there the body would
    leave or enter through the wall, for which water that fills a closed tank could not make up: its
    pressure, known but for a constant, would stop the body at once and throw it back. Of a face
    that several bodies close contactLeak stays open: where they touch at their true surfaces,
    without a gap, water would else be trapped between three disks, and its incompressibility and
    the stiffness of the contacts would fight for the same motion. Water passes touching rocks. A
    slit that one body leaves of a face of a cell which solids fill together is closed: no water is
    in such a cell, and what moves its walls would be pressed through the slit, at a speed and a
    pressure without bounds as it narrows. Faces at periodic ends, which exist twice, have none: no
    body reaches across.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/bodies/bodyBlocks.hpp"
#include "pic/ranks/gridBricks.hpp"
#include "pic/bodies/bodyTerm.hpp"
#include "pic/bodies/inBody.hpp"

namespace riprap
{

//- Part of a face that several bodies leave open together
static constexpr double contactLeak = 0.05;

//- Faces of all directions in one count: a share's key; what has no share comes after them
template<int D>
struct FaceKeys
{
    std::uint32_t first[D + 1];

    explicit FaceKeys(const UniformGrid<D>& grid)
    {
        first[0] = 0;
        for (int d = 0; d < D; ++d) first[d + 1] = first[d] + std::uint32_t(grid.faces(d));
    }

    HD std::uint32_t none() const { return first[D]; }
    HD int direction(std::uint32_t key) const
    {
        int d = 0;
        while (key >= first[d + 1]) ++d;
        return d;
    }
};

//- Rows of faces: of a body those of direction 0 first
template<int D>
struct FaceRow
{
    BlockRow row;
    int d;

    HD FaceRow(const BodyBlocks<D>& blocks, int r)
    {
        row = blocks.row(r/D);
        const PlacedBody<D>& b = blocks.body[row.body];
        const int i = r - D*blocks.firstRow[row.body], in = i % b.rows();
        d = i/b.rows();
        row.j = in % b.size[1];
        row.k = in/b.size[1];
    }

    //- The number of a row of a body
    HD static int number(const BodyBlocks<D>& blocks, int body, int d, int j, int k)
    {
        const PlacedBody<D>& b = blocks.body[body];
        return D*blocks.firstRow[body] + (d*b.size[2] + k)*b.size[1] + j;
    }
};

//- Where shares are in memory
template<int D>
struct ShareRows
{
    const int* first;           // of each row of faces
    const int* x;               // index along the first axis of a row's first share
    const double* share;
    const Vec<D, double>* arm;  // from the body's centre to the middle of its share

    //- The number of a face's share in a row; -1: it has none
    HD int at(int row, int faceX) const
    {
        const int i = faceX - x[row];
        return i >= 0 && i < first[row + 1] - first[row] ? first[row] + i : -1;
    }
};

//- How many faces of a row may have a share, and from which on
template<int D>
struct FindShares
{
    static constexpr const char* name = "findShares";
    BodyBlocks<D> blocks;
    int* count;
    int* x;

    HD void operator()(int r) const
    {
        count[r] = x[r] = 0;
        if (r >= D*blocks.firstRow[blocks.count]) return;      // one more, for the sum
        const FaceRow<D> at(blocks, r);
        const UniformGrid<D>& g = blocks.grid;
        const ShapeView<D> shape = blocks.shape(at.row.body);
        const NodeGrid<D> nodes{g};
        typename UniformGrid<D>::Index f = blocks.first(at.row);
        for (int e = 1; e < D; ++e) if (f.c[e] >= g.layers(at.d, e)) return;
        RowInBody<D, ShapeView<D>> row(shape, nodes.position(f), at.d, g.h);
        if (row.none()) return;
        int first = -1, last = -1;
        for (int i = 0; i < blocks.body[at.row.body].size[0] && f.c[0] < g.layers(at.d, 0);
             ++i, ++f.c[0])
        {
            if (g.periodic[at.d] && (f.c[at.d] == 0 || f.c[at.d] == g.n[at.d])) continue;
            if (!row.may(g.origin[0] + g.h*(g.first[0] + f.c[0]))) continue;
            if (first < 0) first = f.c[0];
            last = f.c[0];
        }
        if (first < 0) return;
        x[r] = first;
        count[r] = last - first + 1;
    }
};

//- A body's share of a face, of a part of its volume where the body has a shape of its own; arm:
//  from the body's centre to the middle of the share
template<int D>
HD double measureShare(const BodyBlocks<D>& blocks, int body, int d,
    const typename UniformGrid<D>::Index& f, const AlongFace& volume, Vec<D, double>& arm)
{
    const UniformGrid<D>& g = blocks.grid;
    const SolidPart<D> part = inBody(
        blocks.shape(body), NodeGrid<D>{g}.position(f), d, g.h, volume);
    const bool any = part.share > 0;
    int m = 0;
    for (int e = 0; e < D; ++e)
    {
        const double in = e == d ? 0 : any ? part.moment[m]/part.share : 0;
        m += e != d;
        arm[e] = g.origin[e] + g.h*(g.first[e] + f.c[e] + in) - blocks.body[body].centre[e];
    }
    return any ? part.share : 0;
}

template<int D, int Lanes>
struct MeasureShares
{
    static constexpr const char* name = "measureShares";
    BodyBlocks<D> blocks;
    FaceKeys<D> faces;
    const int* first;
    const int* x;
    double* share;
    Vec<D, double>* arm;
    int* body;
    std::uint32_t* key;
    std::uint32_t* number;

    HD void operator()(int thread) const
    {
        const int r = thread/Lanes, lane = thread % Lanes;
        if (first[r] + lane >= first[r + 1]) return;
        const FaceRow<D> at(blocks, r);
        const int d = at.d;
        const UniformGrid<D>& g = blocks.grid;
        typename UniformGrid<D>::Index f = blocks.first(at.row);
        f.c[0] = x[r] + lane;
        for (int s = first[r] + lane; s < first[r + 1]; s += Lanes, f.c[0] += Lanes)
        {
            const bool twice = g.periodic[d] && (f.c[d] == 0 || f.c[d] == g.n[d]);
            share[s] = measureShare(blocks, at.row.body, d, f, AlongFace(), arm[s]);
            if (twice) share[s] = 0;
            const bool any = share[s] > 0;
            body[s] = at.row.body;
            key[s] = any ? faces.first[d] + std::uint32_t(g.face(d, f)) : faces.none();
            number[s] = std::uint32_t(s);
        }
    }
};

//- Shares in the order of their faces
template<int D>
struct SortedShares
{
    FaceKeys<D> faces;
    int count;
    const std::uint32_t* key;
    const std::uint32_t* number;

    //- f(direction, face, end) if a face's shares begin at q; they end before end
    template<class F>
    HD void onceAFace(int q, const F& f) const
    {
        const std::uint32_t k = key[q];
        if (k >= faces.none() || (q > 0 && key[q - 1] == k)) return;
        int end = q + 1;
        while (end < count && key[end] == k) ++end;
        const int d = faces.direction(k);
        f(d, int(k - faces.first[d]), end);
    }
};

//- aperture: of walls alone in base, with the bodies afterwards
template<int D, class R>
struct CloseByBodies
{
    static constexpr const char* name = "closeByBodies";
    SortedShares<D> sorted;
    const R* base[D];
    R* aperture[D];
    double* share;
    Vec<D, double>* arm;
    BodyBlocks<D> blocks;
    const int* body;                // of shares
    const double* distance;         // nodes, with the bodies

    HD void operator()(int q) const
    {
        sorted.onceAFace(q, [&](int d, int face, int end) { (*this)(d, face, q, end); });
    }

    //- A face with the shares q .. end - 1
    HD void operator()(int d, int face, int q, int end) const
    {
        double sum = 0;
        for (int s = q; s < end; ++s) sum += share[sorted.number[s]];
        const double before = base[d][face], most = end - q > 1 ? before*(1 - contactLeak) : before;
        const double left = before - sum;
        const bool leaks = most < before && sum > most;
        const bool slit = end - q == 1 && left < contactLeak;
        const bool opens = leaks
            || (left >= smallestAperture && !(slit && besideFullCell(d, face, shapeOf(q))));
        const double scale = leaks ? most/sum
            : before > 0 && !opens ? before/sum
                                   : (sum > 1 ? 1/sum : 1);
        if (leaks) sum = most;
        if (scale != 1) for (int s = q; s < end; ++s) share[sorted.number[s]] *= scale;
        if (scale != 1 && !opens && end - q == 1 && before == 1)
            takeWhole(d, face, int(sorted.number[q]));
        aperture[d][face] = R(opens ? before - sum : 0);
    }

    HD ShapeView<D> shapeOf(int q) const { return blocks.shape(body[sorted.number[q]]); }

    //- Have solids all corners of a cell beside it, and this one not all of them?
    HD bool besideFullCell(int d, int face, const ShapeView<D>& shape) const
    {
        const UniformGrid<D>& g = blocks.grid;
        const NodeGrid<D> nodes{g};
        const typename UniformGrid<D>::Index f = g.faceIndex(d, face);
        for (int side = 0; side < 2; ++side)
        {
            const int cell = g.cellOf(d, f, side);
            if (cell < 0) continue;
            const int first = nodes.node(g.cellIndex(cell));
            bool full = true, alone = true;
            for (int corner = 0; corner < (1 << D); ++corner)
            {
                int node = first;
                for (int e = 0; e < D; ++e) node += (corner >> e & 1)*nodes.stride(e);
                full = full && distance[node] < 0;
                alone = alone && full && shape.distance(nodes.position(node)) < 0;
            }
            if (full && !alone) return true;
        }
        return false;
    }

    //- The share of a body that has the face to itself is the face, its middle the face's: else the
    //  body's spin would push something into cells that it fills, which have no equation, and over
    //  those that have one it would not sum to zero
    HD void takeWhole(int d, int face, int s) const
    {
        const UniformGrid<D>& g = blocks.grid;
        const NodeGrid<D> nodes{g};
        arm[s] = middleOfFace(nodes.position(nodes.node(g.faceIndex(d, face))), d, g.h)
            - blocks.body[body[s]].centre;
    }
};

//- Bodies have nothing of the faces of the sides' walls: what a body displaces and what the water
//  does to it sum to zero over all cells
template<int D, class R>
struct LeaveSidesAlone
{
    static constexpr const char* name = "leaveSidesAlone";
    BodyBlocks<D> blocks;
    const int* first;
    const int* x;
    const R* base[D];
    double* share;

    HD void operator()(int r) const
    {
        if (first[r] == first[r + 1]) return;
        const FaceRow<D> at(blocks, r);
        const UniformGrid<D>& g = blocks.grid;
        typename UniformGrid<D>::Index f = blocks.first(at.row);
        const auto visit = [&](int s)
        {
            f.c[0] = x[r] + s - first[r];
            const bool side = f.c[at.d] == 0 || f.c[at.d] == g.n[at.d];
            if (side && !(base[at.d][g.face(at.d, f)] > R(0))) share[s] = 0;
        };
        if (at.d == 0)
        {
            visit(first[r]);
            visit(first[r + 1] - 1);
        }
        else if (f.c[at.d] == 0 || f.c[at.d] == g.n[at.d])
            for (int s = first[r]; s < first[r + 1]; ++s) visit(s);
    }
};

//- Velocities of the closed parts of faces: walls and bodies by their shares
template<int D, class R>
struct BodyFaceVelocities
{
    static constexpr const char* name = "bodyFaceVelocities";
    SortedShares<D> sorted;
    const R* base[D];
    const R* baseVelocity[D];       // nullptr: walls rest
    const R* aperture[D];
    const double* share;
    const Vec<D, double>* arm;
    const int* body;
    const double* velocity;         // bodyModes a body
    R* wallVelocity[D];

    HD void operator()(int q) const
    {
        sorted.onceAFace(q, [&](int d, int face, int end)
        {
            const double closed = 1 - double(aperture[d][face]);
            if (!(closed > 0)) return;
            double flux = baseVelocity[d]
                ? (1 - double(base[d][face]))*double(baseVelocity[d][face])
                : 0;
            for (int q2 = q; q2 < end; ++q2)
            {
                const int s = int(sorted.number[q2]);
                const double* v = velocity + bodyModes<D>*body[s];
                double speed = 0;
                for (int m = 0; m < bodyModes<D>; ++m) speed += modeVelocity(m, d, arm[s])*v[m];
                flux += share[s]*speed;
            }
            wallVelocity[d][face] = R(flux/closed);
        });
    }
};

//- Faces as they were without bodies
template<int D, class R>
struct RestoreFaces
{
    static constexpr const char* name = "restoreFaces";
    SortedShares<D> sorted;
    const R* base[D];
    const R* baseVelocity[D];
    R* aperture[D];
    R* wallVelocity[D];

    HD void operator()(int q) const
    {
        sorted.onceAFace(q, [&](int d, int face, int)
        {
            aperture[d][face] = base[d][face];
            wallVelocity[d][face] = baseVelocity[d] ? baseVelocity[d][face] : R(0);
        });
    }
};

//- The volume that buoyancy acts on: a body's shares of the faces across `up`, row by row
template<int D>
struct VolumesOfRows
{
    static constexpr const char* name = "bodyVolumes";
    BodyBlocks<D> blocks;
    ShareRows<D> shares;
    int up;
    CellBox own;                    // faces that count
    double* volume;                 // a row of cells each [m2, m3]

    HD void operator()(int r) const
    {
        const BlockRow row = blocks.row(r);
        const int of = FaceRow<D>::number(blocks, row.body, up, row.j, row.k);
        const UniformGrid<D>& g = blocks.grid;
        typename UniformGrid<D>::Index f = blocks.first(row);
        for (int d = 0; d < D; ++d) f.c[d] += g.first[d];
        double sum = 0;
        for (int s = shares.first[of]; s < shares.first[of + 1]; ++s)
        {
            f.c[0] = g.first[0] + shares.x[of] + s - shares.first[of];
            if (own.has(f.c)) sum += shares.share[s]*g.area()*g.h;
        }
        volume[r] = sum;
    }
};

} // namespace riprap

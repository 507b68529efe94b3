/*  The pressure equation as the host solves it: the finest level of the multigrid as rows of its
    wet cells, in the order of the grid.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstddef>
#include <utility>
#include <vector>
#include "api/linearSolver.hpp"
#include "core/backend/backend.hpp"
#include "pic/bodies/bodyTerm.hpp"
#include "pic/grid/uniformGrid.hpp"
#include "pic/pressure/conjugateGradient.hpp"

namespace riprap
{

//- Values of the finest level on the host, numbered as there
template<int D>
class HostLevel
{
    int margin_;
    std::vector<double> a_[D], s_, rhs_, x_;

public:

    template<class Backend>
    HostLevel(Context<Backend>& context, const FineData<D>& fine) : margin_(fine.shape.margin)
    {
        const auto fetch = [&](const double* from)
        {
            std::vector<double> v(fine.shape.cells + 2*margin_);
            context.toHost(v.data(), from - margin_, v.size()*sizeof(double));
            return v;
        };
        s_ = fetch(fine.s);
        rhs_ = fetch(fine.rhs);
        x_ = fetch(fine.x);
        for (int d = 0; d < D; ++d) a_[d] = fetch(fine.a[d]);
    }

    //- Of the face below a cell along d
    double a(int d, int c) const { return a_[d][c + margin_]; }
    double s(int c) const { return s_[c + margin_]; }
    double rhs(int c) const { return rhs_[c + margin_]; }
    double x(int c) const { return x_[c + margin_]; }
    double& x(int c) { return x_[c + margin_]; }

    template<class Backend> void storeX(Context<Backend>& context, const FineData<D>& fine) const
    {
        context.toDevice(fine.x - margin_, x_.data(), x_.size()*sizeof(double));
    }
};

//- Which cells of the level are rows
struct HostRows
{
    std::vector<int> row;           // of each cell, -1: it is none
    std::vector<int> stored;        // each row's cell
    int lone = 0;                   // wet cells that are solved without a row
};

//- Where a cell of the grid is kept
template<int D>
Place<D> storedAt(const UniformGrid<D>& grid, const GridShape<D>& shape, int cell)
{
    const auto index = grid.cellIndex(cell);
    Place<D> p;
    p.c = 0;
    for (int d = 0; d < D; ++d) { p.x[d] = index.c[d]; p.c += p.x[d]*shape.stride[d]; }
    return p;
}

//- Cells whose water and free bodies push each other. A sliver on top of a light body weighs as
//  much as the body: solved for apart, with the body's velocity as given, it would throw it back
//  and forth
template<int D>
std::vector<char> besideBodies(
    const UniformGrid<D>& grid, const GridShape<D>& shape, const std::vector<BodyTerm>& bodies)
{
    std::vector<char> beside(shape.cells, 0);
    for (const BodyTerm& b : bodies)
        if (b.modes) for (const int cell : b.cell) beside[storedAt(grid, shape, cell).c] = 1;
    return beside;
}

//- Rows of the wet cells without what joins them
template<int D>
HostRows numberRows(const UniformGrid<D>& grid, const GridShape<D>& shape,
    const std::vector<BodyTerm>& bodies, HostLevel<D>& level, ReducedSystem& r)
{
    HostRows rows;
    rows.row.assign(shape.cells, -1);
    const std::vector<char> moved = besideBodies(grid, shape, bodies);
    r.closed = true;
    for (int i = 0; i < grid.cells(); ++i)
    {
        const Place<D> p = storedAt(grid, shape, i);
        double joined = 0;
        for (int d = 0; d < D; ++d) joined += level.a(d, p.c) + level.a(d, shape.above(p, d));
        const double tied = level.s(p.c);
        // a drop of one cell that no body pushes: solved here, since GAMG could not join it to any
        // other
        if (!(joined > 0) && !(tied > 0 && moved[p.c]))
        {
            if (tied > 0) { level.x(p.c) = level.rhs(p.c)/tied; ++rows.lone; }
            continue;
        }
        rows.row[p.c] = r.rows();
        r.closed = r.closed && tied <= 1e-9*(joined + tied);
        r.cell.push_back(i);
        rows.stored.push_back(p.c);
        r.diagonal.push_back(joined + tied);
        r.rhs.push_back(level.rhs(p.c));
        r.x.push_back(level.x(p.c));
    }
    return rows;
}

//- The faces that join rows: owners ascend, and so do the neighbours of each
template<int D>
void joinRows(
    const GridShape<D>& shape, const HostLevel<D>& level, const HostRows& rows, ReducedSystem& r)
{
    for (int own = 0; own < r.rows(); ++own)
    {
        const Place<D> p = shape.place(rows.stored[own]);
        std::pair<int, double> face[2*D];
        int faces = 0;
        const auto add = [&](int other, double coefficient)
        {
            const int neighbour = rows.row[other];
            if (!(coefficient > 0) || neighbour <= own) return;
            for (int k = 0; k < faces; ++k)
                if (face[k].first == neighbour)
                {
                    face[k].second += coefficient;
                    return;
                }
            face[faces++] = {neighbour, coefficient};
        };
        for (int d = 0; d < D; ++d)
        {
            const int above = shape.above(p, d);
            if (level.a(d, above) > 0) add(above, level.a(d, above));
            if (level.a(d, p.c) > 0) add(shape.below(p, d), level.a(d, p.c));
        }
        for (int k = 1; k < faces; ++k)
            for (int m = k; m > 0 && face[m].first < face[m - 1].first; --m)
                std::swap(face[m], face[m - 1]);
        for (int k = 0; k < faces; ++k)
        {
            r.owner.push_back(own);
            r.neighbour.push_back(face[k].first);
            r.offDiagonal.push_back(-face[k].second);
        }
    }
}

//- U = J L of a body at its rows, with M^-1 = L L^T and L scaled. light: below this density
template<int D>
BodyRows rowsOfBody(const UniformGrid<D>& grid, const GridShape<D>& shape, const HostRows& at,
    const BodyTerm& b, double scale, double light)
{
    const std::vector<double> root = b.rootOfInverseMass();
    BodyRows rows;
    rows.modes = b.modes;
    rows.light = b.modes && b.lighterThan(light);
    for (std::size_t i = 0; i < b.cell.size(); ++i)
    {
        const int row = at.row[storedAt(grid, shape, b.cell[i]).c];
        if (row < 0) continue;
        rows.row.push_back(row);
        for (int m = 0; m < b.modes; ++m)
        {
            double u = 0;
            for (int k = m; k < b.modes; ++k) u += b.j[i*b.modes + k]*root[k*b.modes + m];
            rows.u.push_back(scale*u);
        }
    }
    return rows;
}

} // namespace riprap

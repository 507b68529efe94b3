/*  Free bodies in a grid on the host, share by share: what kernels of pic/bodies do must come to
    the same.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include "pic/bodies/bodyTerm.hpp"
#include "pic/bodies/freeBody.hpp"
#include "pic/bodies/inBody.hpp"
#include "pic/cutCells/apertures.hpp"

namespace riprap
{

//- A body's share of a face
template<int D>
struct FaceShare
{
    int d, face, body;
    double share;
    Vec<D, double> middle;      // of the share
};

template<int D>
struct BodyGrid
{
    // in: of walls alone; out: with the bodies, at their V*
    std::vector<double> aperture[D], wallVelocity[D];
    std::vector<FaceShare<D>> shares;
    std::vector<BodyTerm> terms;                        // without masses
};

template<int D, class Shape>
void sharesOf(const UniformGrid<D>& grid, const FreeBody<D, Shape>& b, int body,
    std::vector<FaceShare<D>>& shares)
{
    const NodeGrid<D> nodes{grid};
    int low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
    for (int d = 0; d < D; ++d)
    {
        low[d] = std::max(0, int(std::floor((b.centre[d] - b.reach - grid.origin[d])/grid.h)) - 1);
        high[d] = std::min(
            grid.n[d], int(std::ceil((b.centre[d] + b.reach - grid.origin[d])/grid.h)) + 1);
    }
    typename UniformGrid<D>::Index x;
    for (int d = 0; d < D; ++d)
        for (x.c[2] = low[2]; x.c[2] <= high[2]; ++x.c[2])
            for (x.c[1] = low[1]; x.c[1] <= high[1]; ++x.c[1])
                for (x.c[0] = low[0]; x.c[0] <= high[0]; ++x.c[0])
                {
                    bool in = true;
                    for (int e = 0; e < D; ++e) in = in && x.c[e] < grid.layers(d, e);
                    if (!in) continue;
                    const int n = nodes.node(x);
                    const SolidPart<D> part = inBody(b.shape, nodes.position(n), d, grid.h);
                    if (!(part.share > 0)) continue;
                    FaceShare<D> s{d, grid.face(d, x), body, part.share, {}};
                    int m = 0;
                    for (int e = 0; e < D; ++e)
                        s.middle[e] = grid.origin[e]
                            + grid.h*(x.c[e] + (e == d ? 0 : part.moment[m++]/part.share));
                    shares.push_back(s);
                }
}

//- up: the direction against gravity, across which volumes are measured
template<int D, class Shape>
void cutBodies(const UniformGrid<D>& grid, const std::vector<FreeBody<D, Shape>>& bodies, int up,
    BodyGrid<D>& out)
{
    constexpr int modes = bodyModes<D>;
    out.shares.clear();
    out.terms.assign(bodies.size(), BodyTerm{});
    for (int b = 0; b < int(bodies.size()); ++b) sharesOf(grid, bodies[b], b, out.shares);

    std::vector<double> sum[D], flux[D];
    std::vector<int> bodiesOn[D];
    for (int d = 0; d < D; ++d)
    {
        sum[d].assign(grid.faces(d), 0);
        flux[d].assign(grid.faces(d), 0);
        bodiesOn[d].assign(grid.faces(d), 0);
        out.wallVelocity[d].resize(grid.faces(d), 0);
    }
    for (const FaceShare<D>& s : out.shares)
    {
        sum[s.d][s.face] += s.share;
        ++bodiesOn[s.d][s.face];
    }
    const auto opens = [&](int d, int f)
    { return out.aperture[d][f] - sum[d][f] >= smallestAperture; };
    for (FaceShare<D>& s : out.shares)
    {
        const double before = out.aperture[s.d][s.face], total = sum[s.d][s.face];
        if (before > 0 && !opens(s.d, s.face)) s.share *= before/total;
        else if (total > 1) s.share /= total;
        // the body's alone: the whole face
        if (before == 1 && !opens(s.d, s.face) && bodiesOn[s.d][s.face] == 1)
        {
            const NodeGrid<D> nodes{grid};
            s.middle = middleOfFace(
                nodes.position(nodes.node(grid.faceIndex(s.d, s.face))), s.d, grid.h);
        }
    }
    // nothing goes through the walls of the sides
    for (FaceShare<D>& s : out.shares)
    {
        const int layer = grid.faceIndex(s.d, s.face).c[s.d];
        if ((layer == 0 || layer == grid.n[s.d]) && out.aperture[s.d][s.face] == 0) s.share = 0;
    }
    std::vector<std::vector<std::pair<int, Vec<6, double>>>> rows(bodies.size());
    for (const FaceShare<D>& s : out.shares)
    {
        const auto x = grid.faceIndex(s.d, s.face);
        const Vec<D, double> r = s.middle - bodies[s.body].centre;
        Vec<6, double> j = filled<6>(0.0);
        double speed = 0;
        for (int m = 0; m < modes; ++m)
        {
            j[m] = s.share*grid.area()*modeVelocity(m, s.d, r);
            speed += modeVelocity(m, s.d, r)*bodies[s.body].velocity[m];
        }
        flux[s.d][s.face] += s.share*speed;
        for (int side = 0; side < 2; ++side)
        {
            const int cell = grid.cellOf(s.d, x, side);
            if (cell >= 0) rows[s.body].emplace_back(cell, side ? j : -1.0*j);
        }
        if (s.d == up) out.terms[s.body].volume += s.share*grid.area()*grid.h;
    }
    for (std::size_t b = 0; b < bodies.size(); ++b)
    {
        BodyTerm& t = out.terms[b];
        t.modes = modes;
        t.velocity = bodies[b].velocity;
        std::stable_sort(rows[b].begin(), rows[b].end(),
            [](const auto& p, const auto& q) { return p.first < q.first; });
        for (const auto& [cell, j] : rows[b])
        {
            if (t.cell.empty() || t.cell.back() != cell)
            {
                t.cell.push_back(cell);
                t.j.resize(t.j.size() + modes, 0.0);
            }
            for (int m = 0; m < modes; ++m) t.j[t.j.size() - modes + m] += j[m];
        }
    }
    for (int d = 0; d < D; ++d)
        for (int f = 0; f < grid.faces(d); ++f)
        {
            if (!(sum[d][f] > 0)) continue;
            const double before = out.aperture[d][f], open = opens(d, f) ? before - sum[d][f] : 0;
            if (open < 1)
                out.wallVelocity[d][f] = ((1 - before)*out.wallVelocity[d][f] + flux[d][f])
                    /(1 - open);
            out.aperture[d][f] = open;
        }
}

} // namespace riprap

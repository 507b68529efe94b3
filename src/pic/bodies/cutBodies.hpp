/*  Free bodies in the grid: their shares of faces, what they leave open, and their terms of the pressure equation.

    Where bodies and walls leave less than smallestAperture of a face it is closed, and shares that sum to more than the face are scaled down to it, before J
    is made of them. In 3D the parts of faces are by distances at points a quarter of a cell apart. In 2D they are exact. Their sum is the body's area by chords at the planes of the faces, which misses up to (h/a)^1.5 of it where a plane
    nearly touches the body, and its added mass with it; there the mean over the planes of half a cell on either side is taken (inPole), and both converge
    with second order.  A face that is a wall keeps the bodies' shares, so that a body that a wall clips still has a closed surface.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include "pic/bodies/bodyTerm.hpp"
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

//- Where a body may be, and its distance; Shape as in pic/shapes
template<int D, class Shape>
struct FreeBody
{
    Shape shape;
    Vec<D, double> centre;      // of mass
    double reach;               // nothing of it is farther from the centre
    std::vector<double> velocity;
};

template<int D>
struct BodyGrid
{
    std::vector<double> aperture[D], wallVelocity[D];   // in: of walls alone; out: with the bodies, at their V*
    std::vector<FaceShare<D>> shares;
    std::vector<BodyTerm> terms;                        // without masses
};

//- Faces of direction d from x along the other axis: the part in the body
template<class Shape>
SolidPart<2> inBody(const Shape& shape, Vec<2, double> x, int d, double h)
{
    constexpr int planes = 8;
    const int along = 1 - d;
    Vec<2, double> middle = x;
    middle[along] += 0.5*h;
    const double distance = shape.distance(middle);
    if (distance > h) return {0, {0}};
    if (distance < -h) return {1, {0.5}};
    SolidPart<2> part = shape.solidOfLine(x, along, h);
    const double inPole = 1 - shape.behindPole(middle, d)/h;
    if (!(inPole > 0)) return part;
    part.share *= 1 - inPole;
    part.moment[0] *= 1 - inPole;
    for (int k = 0; k < planes; ++k)
    {
        Vec<2, double> at = x;
        at[d] += h*((k + 0.5)/planes - 0.5);
        const SolidPart<2> there = shape.solidOfLine(at, along, h);
        part.share += inPole/planes*there.share;
        part.moment[0] += inPole/planes*there.moment[0];
    }
    return part;
}

//- A face of direction d in 3D with its lower corner at x. Distances at its corners alone would cut chords off the body: 2.3 % of the volume of a ball of 3.75 cells
//  a radius, and with it of its weight in water; those of sixteen parts leave a sixteenth of that
template<class Shape>
SolidPart<3> inBody(const Shape& shape, const Vec<3, double>& x, int d, double h)
{
    constexpr int parts = 4;
    const int a = d == 0 ? 1 : 0, c = d == 2 ? 1 : 2;
    const auto distance = [&](int i, int j)
    {
        Vec<3, double> at = x;
        at[a] += h*i/parts;
        at[c] += h*j/parts;
        return shape.distance(at);
    };
    const double middle = distance(parts/2, parts/2);
    if (middle > h) return {0, {0, 0}};
    if (middle < -h) return {1, {0.5, 0.5}};
    double corner[parts + 1][parts + 1];
    for (int i = 0; i <= parts; ++i) for (int j = 0; j <= parts; ++j) corner[i][j] = distance(i, j);
    SolidPart<3> part{0, {0, 0}};
    for (int i = 0; i < parts; ++i)
        for (int j = 0; j < parts; ++j)
        {
            const SolidPart<3> p = solidOfSquare(corner[i][j], corner[i + 1][j], corner[i][j + 1], corner[i + 1][j + 1]);
            part.share += p.share/(parts*parts);
            part.moment[0] += (p.share*i + p.moment[0])/(parts*parts*parts);
            part.moment[1] += (p.share*j + p.moment[1])/(parts*parts*parts);
        }
    return part;
}

template<int D, class Shape>
void sharesOf(const UniformGrid<D>& grid, const FreeBody<D, Shape>& b, int body, std::vector<FaceShare<D>>& shares)
{
    const NodeGrid<D> nodes{grid};
    int low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
    for (int d = 0; d < D; ++d)
    {
        low[d] = std::max(0, int(std::floor((b.centre[d] - b.reach - grid.origin[d])/grid.h)) - 1);
        high[d] = std::min(grid.n[d], int(std::ceil((b.centre[d] + b.reach - grid.origin[d])/grid.h)) + 1);
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
                    for (int e = 0; e < D; ++e) s.middle[e] = grid.origin[e] + grid.h*(x.c[e] + (e == d ? 0 : part.moment[m++]/part.share));
                    shares.push_back(s);
                }
}

//- Velocities of the closed parts of faces, from bodies' velocities: walls (what is open without bodies, and how fast the rest is) and bodies by
//  their shares; open: what is left
template<int D, class Shape>
void bodyVelocities
(
    const UniformGrid<D>& grid, const std::vector<FreeBody<D, Shape>>& bodies, const std::vector<FaceShare<D>>& shares,
    const std::vector<double>* walls, const std::vector<double>* wallVelocity, const std::vector<double>* open, std::vector<double>* velocity
)
{
    for (int d = 0; d < D; ++d)
    {
        velocity[d] = wallVelocity[d];
        velocity[d].resize(grid.faces(d), 0);
    }
    // each face is scaled once, by its first share
    std::vector<char> begun[D];
    for (int d = 0; d < D; ++d) begun[d].assign(grid.faces(d), 0);
    for (const FaceShare<D>& s : shares)
    {
        const double closed = 1 - open[s.d][s.face];
        if (!(closed > 0)) continue;
        double& v = velocity[s.d][s.face];
        if (!begun[s.d][s.face]) v *= (1 - walls[s.d][s.face])/closed;
        begun[s.d][s.face] = 1;
        const Vec<D, double> r = s.middle - bodies[s.body].centre;
        double speed = 0;
        for (int m = 0; m < bodyModes<D>; ++m) speed += modeVelocity(m, s.d, r)*bodies[s.body].velocity[m];
        v += s.share*speed/closed;
    }
}

//- up: the direction against gravity, across which volumes are measured
template<int D, class Shape>
void cutBodies(const UniformGrid<D>& grid, const std::vector<FreeBody<D, Shape>>& bodies, int up, BodyGrid<D>& out)
{
    constexpr int modes = bodyModes<D>;
    out.shares.clear();
    out.terms.assign(bodies.size(), BodyTerm{});
    for (int b = 0; b < int(bodies.size()); ++b) sharesOf(grid, bodies[b], b, out.shares);

    std::vector<double> sum[D], flux[D];
    for (int d = 0; d < D; ++d)
    {
        sum[d].assign(grid.faces(d), 0);
        flux[d].assign(grid.faces(d), 0);
        out.wallVelocity[d].resize(grid.faces(d), 0);
    }
    for (const FaceShare<D>& s : out.shares) sum[s.d][s.face] += s.share;
    const auto opens = [&](int d, int f) { return out.aperture[d][f] - sum[d][f] >= smallestAperture; };
    for (FaceShare<D>& s : out.shares)
    {
        const double before = out.aperture[s.d][s.face], total = sum[s.d][s.face];
        if (before > 0 && !opens(s.d, s.face)) s.share *= before/total;
        else if (total > 1) s.share /= total;
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
            if (cell >= 0) rows[s.body].push_back({cell, side ? j : -1.0*j});
        }
        if (s.d == up) out.terms[s.body].volume += s.share*grid.area()*grid.h;
    }
    for (std::size_t b = 0; b < bodies.size(); ++b)
    {
        BodyTerm& t = out.terms[b];
        t.modes = modes;
        t.velocity = bodies[b].velocity;
        std::stable_sort(rows[b].begin(), rows[b].end(), [](const auto& p, const auto& q) { return p.first < q.first; });
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
            if (open < 1) out.wallVelocity[d][f] = ((1 - before)*out.wallVelocity[d][f] + flux[d][f])/(1 - open);
            out.aperture[d][f] = open;
        }
}

} // namespace riprap

/*  Signed distances of an obstacle at the nodes of a grid, and at the centres of its cells which of
    them are solid.

    Distances are to the nearest element within a band of bandNodes cells, beyond it the band's
    width. The side comes from counting how often the surface is crossed on the way along x: no
    normals, which are ambiguous at edges.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <cmath>
#include "core/simd/closestPoint.hpp"
#include "pic/cutCells/apertures.hpp"
#include "pic/cutCells/obstacle.hpp"

namespace riprap
{

static constexpr double bandNodes = 2;

//- Points of a lattice: nodes of the grid, or centres of its cells
template<int D>
struct Lattice
{
    Vec<D, double> origin;
    double h;
    int n[3] = {1, 1, 1};

    static Lattice nodes(const UniformGrid<D>& g) { return of(g, 0, 1); }
    static Lattice centres(const UniformGrid<D>& g) { return of(g, 0.5, 0); }

    int count() const { return n[0]*n[1]*n[2]; }
    int index(int i, int j, int k) const { return i + n[0]*(j + n[1]*k); }
    Vec<D, double> position(const int* x) const
    {
        Vec<D, double> p;
        for (int d = 0; d < D; ++d) p[d] = origin[d] + h*x[d];
        return p;
    }

private:

    static Lattice of(const UniformGrid<D>& g, double shift, int more)
    {
        Lattice l;
        l.h = g.h;
        for (int d = 0; d < D; ++d)
        {
            l.origin[d] = g.origin[d] + shift*g.h;
            l.n[d] = g.n[d] + more;
        }
        return l;
    }
};

//- f(x) for the points of a lattice in the bounds of an element, widened
template<int D, class F>
void eachNear(const Lattice<D>& l, const Obstacle<D>& o, int element, double widened, const F& f)
{
    int low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
    for (int d = 0; d < D; ++d)
    {
        double a = 1e300, b = -1e300;
        for (int v = 0; v < D; ++v)
        {
            const double x = o.vertices[o.elements[element][v]][d];
            a = std::min(a, x);
            b = std::max(b, x);
        }
        const auto bounded = [&](double x, int top)
        { return int(std::max(-1.0, std::min(x, double(top)))); };
        low[d] = bounded(std::ceil((a - widened - l.origin[d])/l.h), l.n[d]);
        high[d] = bounded(std::floor((b + widened - l.origin[d])/l.h), l.n[d] - 1);
        low[d] = std::max(low[d], 0);
    }
    int x[3];
    for (x[2] = low[2]; x[2] <= high[2]; ++x[2])
        for (x[1] = low[1]; x[1] <= high[1]; ++x[1])
            for (x[0] = low[0]; x[0] <= high[0]; ++x[0]) f(x);
}

//- Which points of a lattice are solid
template<int D>
std::vector<char> solidPoints(const Lattice<D>& l, const Obstacle<D>& o)
{
    std::vector<char> solid(l.count(), 0);
    if (!o.closed) return solid;
    const int rows = l.n[1]*l.n[2];
    std::vector<std::vector<double>> crossings(rows);
    for (int e = 0; e < int(o.elements.size()); ++e)
    {
        Lattice<D> row = l;     // the lines along x, which pass an element wherever it is along x
        row.n[0] = 1;
        row.origin[0] = o.vertices[o.elements[e][0]][0];
        eachNear(row, o, e, 1e-9*l.h,
            [&](const int* x)
            {
                eachCrossing(o, e, 0, l.position(x),
                    [&](double at) { crossings[x[1] + l.n[1]*x[2]].push_back(at); });
            });
    }
    for (int r = 0; r < rows; ++r)
    {
        std::sort(crossings[r].begin(), crossings[r].end());
        std::size_t passed = 0;
        for (int i = 0; i < l.n[0]; ++i)
        {
            const double x = l.origin[0] + i*l.h;
            while (passed < crossings[r].size() && crossings[r][passed] < x) ++passed;
            solid[i + l.n[0]*r] = (passed % 2 == 1) != o.solidOutside;
        }
    }
    return solid;
}

//- Signed distances at the nodes
template<int D>
std::vector<double> obstacleDistance(const UniformGrid<D>& grid, const Obstacle<D>& o)
{
    const Lattice<D> l = Lattice<D>::nodes(grid);
    const double band = bandNodes*grid.h;
    std::vector<double> distance(l.count(), band*band);
    for (int e = 0; e < int(o.elements.size()); ++e)
    {
        Vec<D, double> v[D];
        for (int k = 0; k < D; ++k) v[k] = o.vertices[o.elements[e][k]];
        eachNear(l, o, e, band, [&](const int* x)
        {
            const Vec<D, double> p = l.position(x);
            int feature;
            double& to = distance[l.index(x[0], x[1], x[2])];
            to = std::min(to, squaredNorm(closestPoint(v, p, feature) - p));
        });
    }
    const std::vector<char> solid = solidPoints(l, o);
    for (std::size_t i = 0; i < distance.size(); ++i)
        distance[i] = (solid[i] ? -1 : 1)*std::sqrt(distance[i]);
    return distance;
}

} // namespace riprap

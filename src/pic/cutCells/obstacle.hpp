/*  A solid obstacle as the grid sees it: its surface as segments (2D) or triangles (3D), in the
    frame of the solved axes, where it is now and where it will be at the end of the step.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <vector>
#include "core/simd/vec.hpp"

namespace riprap
{

template<int D>
struct Obstacle
{
    std::vector<Vec<D, double>> vertices, next;     // next: at the end of the step; empty: it rests
    std::vector<Vec<D, int>> elements;
    bool closed = true;                             // else a sheet, which has no inside
    bool solidOutside = false;                      // a basin: solid is what is not inside

    bool moves() const { return !next.empty(); }
};

//- Crossings of a line along axis d with an obstacle's elements: f(coordinate along d). at: the
//  line's other coordinates, those of the axes after d in turn (d + 1, d + 2). A vertex belongs to
//  the element above it, so that a closed surface is crossed evenly
template<int D, class F>
void eachCrossing(const Obstacle<D>& o, int element, int d, const Vec<D, double>& at, const F& f)
{
    const auto& e = o.elements[element];
    const int b = (d + 1) % D;
    if constexpr (D == 2)
    {
        const Vec<D, double>&p = o.vertices[e[0]], &q = o.vertices[e[1]];
        if ((p[b] <= at[b]) == (q[b] <= at[b])) return;
        f(p[d] + (at[b] - p[b])/(q[b] - p[b])*(q[d] - p[d]));
    }
    else
    {
        const int c = (d + 2) % D;
        // edges that the half line from `at` along c crosses: an odd number for a point inside the
        // projected triangle. Each edge is taken from its lower end, so that both triangles that
        // share it find the same
        int passed = 0;
        for (int k = 0; k < 3; ++k)
        {
            int i = e[k], j = e[(k + 1) % 3];
            if (i > j) { const int s = i; i = j; j = s; }
            const Vec<D, double>&p = o.vertices[i], &q = o.vertices[j];
            if ((p[b] <= at[b]) == (q[b] <= at[b])) continue;
            if (p[c] + (at[b] - p[b])/(q[b] - p[b])*(q[c] - p[c]) > at[c]) ++passed;
        }
        if (passed % 2 == 0) return;
        const Vec<D, double>&p = o.vertices[e[0]], u = o.vertices[e[1]] - p,
                     v = o.vertices[e[2]] - p;
        const double area = u[b]*v[c] - u[c]*v[b];
        if (area == 0) return;
        const double s = ((at[b] - p[b])*v[c] - (at[c] - p[c])*v[b])/area,
                     t = (u[b]*(at[c] - p[c]) - u[c]*(at[b] - p[b]))/area;
        f(p[d] + s*u[d] + t*v[d]);
    }
}

} // namespace riprap

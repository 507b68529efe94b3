/*  A solid of any shape by its signed distances at the points of a lattice in its own frame, linear
    between them along each axis.

    Points of the lattice lie about a quarter of a cell of the grid apart, so that what is linear
    between them errs by less than what is linear across a cell. Edges are rounded by as much.
    Beyond the lattice the distance is that to its nearest point more: never less than the truth to
    the box of the solid.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cmath>
#include <cstddef>
#include "core/simd/vec.hpp"
#include "pic/shapes/faceCut.hpp"

namespace riprap
{

template<int D>
struct ShapeLattice
{
    Vec<D, double> lower;               // of its first point, in the solid's frame [m]
    double step;                        // [m]
    int n[D];                           // points
    const double* distance;             // the first axis fastest [m], negative in the solid

    HD std::size_t points() const
    {
        std::size_t all = 1;
        for (int d = 0; d < D; ++d) all *= std::size_t(n[d]);
        return all;
    }

    HD double at(const Vec<D, double>& y) const
    {
        double f[D], beyond = 0;
        int first = 0, stride[D], size = 1;
        for (int d = 0; d < D; ++d)
        {
            double s = (y[d] - lower[d])/step;
            const double inside = s < 0 ? 0 : (s > n[d] - 1 ? n[d] - 1 : s);
            beyond += (s - inside)*(s - inside);
            int i = int(inside);
            if (i > n[d] - 2) i = n[d] - 2;
            f[d] = inside - i;
            stride[d] = size;
            first += i*size;
            size *= n[d];
        }
        double sum = 0;
        for (int corner = 0; corner < (1 << D); ++corner)
        {
            int point = first;
            double w = 1;
            for (int d = 0; d < D; ++d)
            {
                const int up = corner >> d & 1;
                point += up*stride[d];
                w *= up ? f[d] : 1 - f[d];
            }
            sum += w*distance[point];
        }
        return beyond > 0 ? sum + step*std::sqrt(beyond) : sum;
    }
};

//- Such a solid where it is: x = centre + axis y
template<int D>
struct SampledShape
{
    ShapeLattice<D> lattice;
    Vec<D, double> centre;              // the frame's origin: the centre of mass
    double axis[D][D];                  // the frame's axes, as columns

    HD double distance(const Vec<D, double>& x) const
    {
        const Vec<D, double> r = x - centre;
        Vec<D, double> y;
        for (int k = 0; k < D; ++k)
        {
            y[k] = 0;
            for (int d = 0; d < D; ++d) y[k] += axis[d][k]*r[d];
        }
        return lattice.at(y);
    }

    //- Of the line from x along an axis: the part in the solid, by distances at the ends of eight
    //  parts
    HD SolidPart<2> solidOfLine(Vec<D, double> x, int along, double length) const
    {
        constexpr int parts = 8;
        SolidPart<2> sum{0, {0}};
        double before = distance(x);
        for (int i = 0; i < parts; ++i)
        {
            x[along] += length/parts;
            const double after = distance(x);
            const SolidPart<2> part = solidOfEdge(before, after);
            sum.share += part.share/parts;
            sum.moment[0] += (part.share*i + part.moment[0])/(parts*parts);
            before = after;
        }
        return sum;
    }

    //- Of length 1, out of the solid; 0 where distances tell none
    HD Vec<D, double> normal(const Vec<D, double>& x) const
    {
        const double half = 0.5*lattice.step;
        Vec<D, double> n;
        for (int d = 0; d < D; ++d)
        {
            Vec<D, double> up = x, down = x;
            up[d] += half;
            down[d] -= half;
            n[d] = distance(up) - distance(down);
        }
        const double length = std::sqrt(squaredNorm(n));
        return length > 0 ? (1/length)*n : n;
    }

    //- As of a ball (shapes.hpp) whose radius is the way from the centre: zero where the surface
    //  lies across the axis
    HD double behindPole(const Vec<D, double>& x, int across) const
    {
        return behindPole(x, normal(x), across);
    }
    HD double behindPole(const Vec<D, double>& x, const Vec<D, double>& n, int across) const
    { return std::sqrt(squaredNorm(x - centre))*(1 - std::fabs(n[across])); }

    //- Nothing of it is farther from its centre: the largest of the ways to points of the lattice
    //  in it, and a step
    double reach() const
    {
        double most2 = 0;
        int index[3] = {0, 0, 0};
        for (const double* p = lattice.distance; ; ++p)
        {
            double r2 = 0;
            for (int d = 0; d < D; ++d)
            {
                const double y = lattice.lower[d] + index[d]*lattice.step;
                r2 += y*y;
            }
            if (*p < lattice.step && r2 > most2) most2 = r2;
            int d = 0;
            while (d < D && ++index[d] == lattice.n[d]) index[d++] = 0;
            if (d == D) return std::sqrt(most2) + lattice.step;
        }
    }
};

} // namespace riprap

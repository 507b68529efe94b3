/*  The solid part of a face or cell, from signed distances at its corners (negative in the solid), to second order.

    An edge is cut where the distance, linear along it, is zero; a square is four triangles about its middle, where the distance is
    the mean of the corners', and a cube 24 tetrahedra; in each the distance is linear. A distance of zero is open.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/macros.hpp"

namespace riprap
{

//- Solid part of a face of side 1: its share, and share times the position of its centroid in the face (0 .. 1 each)
template<int D>
struct SolidPart
{
    double share;
    double moment[D - 1];
};

//- From the end with distance a < 0, the part of an edge up to where the distance is zero; b >= 0
HD double cutLength(double a, double b) { return a/(a - b); }

//- The edge of a cell in 2D
HD SolidPart<2> solidOfEdge(double a, double b)
{
    if (a >= 0 && b >= 0) return {0, {0}};
    if (a < 0 && b < 0) return {1, {0.5}};
    const double t = a < 0 ? cutLength(a, b) : cutLength(b, a);
    return {t, {t*(a < 0 ? 0.5*t : 1 - 0.5*t)}};
}

struct CutCorner { double x, y, distance; };

//- Adds the corner p of a triangle pqr of the given area, as far as the distance has p's sign there, times sign
HD void addCorner(SolidPart<3>& part, const CutCorner& p, const CutCorner& q, const CutCorner& r, double area, double sign)
{
    const double s = cutLength(p.distance, q.distance), t = cutLength(p.distance, r.distance);
    const double share = sign*area*s*t;
    part.share += share;
    part.moment[0] += share*(p.x + (s*(q.x - p.x) + t*(r.x - p.x))/3);
    part.moment[1] += share*(p.y + (s*(q.y - p.y) + t*(r.y - p.y))/3);
}

HD void addWhole(SolidPart<3>& part, const CutCorner& p, const CutCorner& q, const CutCorner& r, double area)
{
    part.share += area;
    part.moment[0] += area*(p.x + q.x + r.x)/3;
    part.moment[1] += area*(p.y + q.y + r.y)/3;
}

HD void addTriangle(SolidPart<3>& part, const CutCorner& p, const CutCorner& q, const CutCorner& r, double area)
{
    const bool inP = p.distance < 0, inQ = q.distance < 0, inR = r.distance < 0;
    const int inside = inP + inQ + inR;
    if (inside == 0) return;
    const bool whole = inside > 1;      // then the lone corner is open, and is taken away
    if (whole) addWhole(part, p, q, r, area);
    if (inside == 3) return;
    const double sign = whole ? -1 : 1;
    if (inP != whole) addCorner(part, p, q, r, area, sign);
    else if (inQ != whole) addCorner(part, q, r, p, area, sign);
    else addCorner(part, r, p, q, area, sign);
}

//- A square: distances at (0 0), (1 0), (0 1), (1 1)
HD SolidPart<3> solidOfSquare(double d00, double d10, double d01, double d11)
{
    if (d00 >= 0 && d10 >= 0 && d01 >= 0 && d11 >= 0) return {0, {0, 0}};
    if (d00 < 0 && d10 < 0 && d01 < 0 && d11 < 0) return {1, {0.5, 0.5}};
    SolidPart<3> part{0, {0, 0}};
    const CutCorner a{0, 0, d00}, b{1, 0, d10}, c{1, 1, d11}, e{0, 1, d01}, m{0.5, 0.5, 0.25*(d00 + d10 + d01 + d11)};
    addTriangle(part, a, b, m, 0.25);
    addTriangle(part, b, c, m, 0.25);
    addTriangle(part, c, e, m, 0.25);
    addTriangle(part, e, a, m, 0.25);
    return part;
}

//- Solid share of a tetrahedron
HD double solidOfTetrahedron(const double* distance)
{
    double in[4] = {}, out[4] = {};
    int inside = 0, outside = 0;
    for (int k = 0; k < 4; ++k)
    {
        if (distance[k] < 0) in[inside++] = distance[k];
        else out[outside++] = distance[k];
    }
    if (inside == 0) return 0;
    if (inside == 4) return 1;
    if (inside == 1) return cutLength(in[0], out[0])*cutLength(in[0], out[1])*cutLength(in[0], out[2]);
    if (inside == 3) return 1 - cutLength(out[0], in[0])*cutLength(out[0], in[1])*cutLength(out[0], in[2]);
    // a prism between two cut corners, as three tetrahedra
    const double a0 = cutLength(in[0], out[0]), a1 = cutLength(in[0], out[1]), b0 = cutLength(in[1], out[0]), b1 = cutLength(in[1], out[1]);
    return a0*a1 + a0*b1*(1 - a1) + b0*b1*(1 - a0);
}

//- A cube: distances of corner x + 2 y + 4 z
HD double solidOfCube(const double* d)
{
    constexpr int face[6][4] = {{0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}};   // around each
    double middle = 0, share = 0;
    for (int k = 0; k < 8; ++k) middle += d[k]/8;
    for (int f = 0; f < 6; ++f)
    {
        double centre = 0;
        for (int k = 0; k < 4; ++k) centre += d[face[f][k]]/4;
        for (int k = 0; k < 4; ++k)
        {
            const double corner[4] = {middle, centre, d[face[f][k]], d[face[f][(k + 1) & 3]]};
            share += solidOfTetrahedron(corner)/24;
        }
    }
    return share;
}

} // namespace riprap

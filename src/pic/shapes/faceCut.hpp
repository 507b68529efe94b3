/*  The solid part of a face or cell, from signed distances at its corners (negative in the solid),
    to second order.

    An edge is cut where the distance, linear along it, is zero; a square is four triangles about
    its middle, where the distance is the mean of the corners', and a cube 24 tetrahedra; in each
    the distance is linear. A distance of zero is open.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/simd/macros.hpp"

namespace riprap
{

//- Solid part of a face of side 1: its share, and share times the position of its centroid in the
//  face (0 .. 1 each)
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

//- Adds the corner p of a triangle pqr of the given area, as far as the distance has p's sign
//  there, times sign
HD void addCorner(SolidPart<3>& part, const CutCorner& p, const CutCorner& q, const CutCorner& r,
    double area, double sign)
{
    const double s = cutLength(p.distance, q.distance), t = cutLength(p.distance, r.distance);
    const double share = sign*area*s*t;
    part.share += share;
    part.moment[0] += share*(p.x + (s*(q.x - p.x) + t*(r.x - p.x))/3);
    part.moment[1] += share*(p.y + (s*(q.y - p.y) + t*(r.y - p.y))/3);
}

HD void addWhole(
    SolidPart<3>& part, const CutCorner& p, const CutCorner& q, const CutCorner& r, double area)
{
    part.share += area;
    part.moment[0] += area*(p.x + q.x + r.x)/3;
    part.moment[1] += area*(p.y + q.y + r.y)/3;
}

HD void addTriangle(
    SolidPart<3>& part, const CutCorner& p, const CutCorner& q, const CutCorner& r, double area)
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
    const CutCorner a{0, 0, d00}, b{1, 0, d10}, c{1, 1, d11}, e{0, 1, d01},
        m{0.5, 0.5, 0.25*(d00 + d10 + d01 + d11)};
    addTriangle(part, a, b, m, 0.25);
    addTriangle(part, b, c, m, 0.25);
    addTriangle(part, c, e, m, 0.25);
    addTriangle(part, e, a, m, 0.25);
    return part;
}

//- Solid share of a tetrahedron: distances at its corners, in any order. They are put in order, so
//  that none is looked up by a number that is not known before
template<class T>
HD T solidOfTetrahedron(T a, T b, T c, T d)
{
    const auto order = [](T& p, T& q)
    {
        const T low = p < q ? p : q;
        q = p < q ? q : p;
        p = low;
    };
    order(a, b);
    order(c, d);
    order(a, c);
    order(b, d);
    order(b, c);
    if (!(a < 0)) return 0;
    if (d < 0) return 1;
    const auto length = [](T p, T q) { return p/(p - q); };
    if (!(b < 0)) return length(a, b)*length(a, c)*length(a, d);
    if (c < 0) return 1 - length(d, a)*length(d, b)*length(d, c);
    // a prism between two cut corners, as three tetrahedra
    const T a0 = length(a, c), a1 = length(a, d), b0 = length(b, c), b1 = length(b, d);
    return a0*a1 + a0*b1*(1 - a1) + b0*b1*(1 - a0);
}

//- A cube: distances of corner x + 2 y + 4 z
template<class T>
HD T solidOfCube(const T* d)
{
    T middle = 0, share = 0;
    for (int k = 0; k < 8; ++k) middle += d[k]/8;
    const auto face = [&](T p, T q, T r, T s)       // corners, around it
    {
        const T centre = T(0.25)*(p + q + r + s);
        share += solidOfTetrahedron(middle, centre, p, q) + solidOfTetrahedron(middle, centre, q, r)
            + solidOfTetrahedron(middle, centre, r, s) + solidOfTetrahedron(middle, centre, s, p);
    };
    face(d[0], d[2], d[6], d[4]);
    face(d[1], d[3], d[7], d[5]);
    face(d[0], d[1], d[5], d[4]);
    face(d[2], d[3], d[7], d[6]);
    face(d[0], d[1], d[3], d[2]);
    face(d[4], d[5], d[7], d[6]);
    return share/24;
}

} // namespace riprap

// SPDX-License-Identifier: GPL-3.0-or-later
/*  Wall points of a mesh made in memory, and what they must do: complete the kernel's support. */
#pragma once

#include "boxMesh.hpp"
#include "wallPoints.H"
#include "wallSurface.H"

#include <cmath>

inline Foam::wallPointsControls wallControls(double spacing, int layers, double firstOffset = -1)
{
    Foam::wallPointsControls controls;
    controls.spacing = spacing;
    controls.layers = layers;
    controls.firstOffset = firstOffset;
    return controls;
}

//- Behind all wall patches, and bodies if there are some
inline Foam::wallPoints laid(const Foam::polyMesh& mesh, const Foam::wallPointsControls& controls,
    const Foam::geometryWalls* bodies = nullptr)
{
    return Foam::generateWallPoints(mesh, Foam::wallPatches(mesh), bodies, controls);
}

//- Wendland's C2 kernel of support 2 h
inline double wendland(double r, double h, int D)
{
    const double q = r/h, pi = std::acos(-1.0);
    const double alpha = D == 2 ? 7/(4*pi*h*h) : 21/(16*pi*h*h*h);
    return q < 2 ? alpha*std::pow(1 - 0.5*q, 4)*(2*q + 1) : 0;
}

//- Sum of V W of particles that stand for spacing^D each
inline double kernelSum(const Foam::UList<Foam::point>& particles, const Foam::point& at,
    double spacing, double h, int D)
{
    double sum = 0;
    for (const Foam::point& p : particles) sum += wendland(Foam::mag(p - at), h, D);
    return sum*std::pow(spacing, D);
}

//- Distance between the two nearest
inline double nearestTwo(const Foam::UList<Foam::point>& points)
{
    double least = 1e300;
    for (int i = 0; i < points.size(); ++i)
        for (int j = 0; j < i; ++j) least = std::min(least, Foam::mag(points[i] - points[j]));
    return least;
}

//- Middles of n[d] even parts from low to high: particles of the fluid in a box
inline Foam::pointField middles(
    const Foam::point& low, const Foam::point& high, const std::array<int, 3>& n)
{
    Foam::pointField all(n[0]*n[1]*n[2]);
    for (int c = 0; c < all.size(); ++c)
    {
        const int at[3] = {c % n[0], c/n[0] % n[1], c/(n[0]*n[1])};
        for (int d = 0; d < 3; ++d) all[c][d] = low[d] + (high[d] - low[d])*(at[d] + 0.5)/n[d];
    }
    return all;
}

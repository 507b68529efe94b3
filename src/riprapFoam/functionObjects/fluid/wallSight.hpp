// SPDX-License-Identifier: GPL-3.0-or-later
/*  What a point near walls can see of the fluid: only what is in front of every wall face that the
    point itself is in front of. A particle in a wall, or beyond a thin one, is behind a face and is
    not seen.

    Faces come from the wall points: half a spacing before the outermost ones, along their normals.
    The nearest one gives the first plane; each next wall point whose face is still in front of all
    planes gives another: the floor in front of a gauge on a side wall does, the top of a box above
    a gauge on its side (a convex edge) does not.
*/
#ifndef wallSight_hpp
#define wallSight_hpp

#include "wallNeighbours.hpp"

namespace riprap
{

//- The half-space normal.d >= -depth of places d from the point
struct SightPlane
{
    Vector3 normal{{0, 0, 0}};              // unit
    double depth = 0;                       // [m], not negative
};

inline bool seenFrom(const std::vector<SightPlane>& planes, const Vector3& d, double slack = 0)
{
    for (const SightPlane& plane : planes)
    {
        if (dotOf(plane.normal, d) < -plane.depth + slack) return false;
    }
    return true;
}

//- @param walls  near the point
//  @param spacing  of wall points [m]
//  @param planes  the sensor's own, to which those of the walls are added
inline void addWallPlanes(
    std::vector<WallNeighbour> walls, double spacing, std::vector<SightPlane>& planes)
{
    // Faces of one wall, with the round-off of curved ones, and a gauge that is meant to be on one
    const double same = 0.25*spacing, roundOff = 1e-3*spacing;

    std::sort(walls.begin(), walls.end(),
        [](const WallNeighbour& a, const WallNeighbour& b)
        { return dotOf(a.offset, a.offset) < dotOf(b.offset, b.offset); });

    for (const WallNeighbour& w : walls)
    {
        Vector3 face = w.offset;
        for (int d = 0; d < 3; ++d) face[d] += 0.5*spacing*w.normal[d];

        const double height = -dotOf(w.normal, face);
        if (height < -same || !seenFrom(planes, face, planes.empty() ? 0 : same)) continue;

        planes.push_back({w.normal, std::max(height, 0.0) + roundOff});
    }
}

} // namespace riprap

#endif

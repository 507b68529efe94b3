// SPDX-License-Identifier: GPL-3.0-or-later
/*  3D walls of any shape. Each smooth region of the surface (bounded by sharp edges) is moved into
    the solid, layer by layer, and points are spread over the moved sheet: a lattice on rectangles,
    else an even relaxed set. Sharp convex edges and corners: wallEdges.C.
*/

#include "wallSurface.H"
#include "sheetSampling.H"
#include "wallEdges.H"

namespace Foam
{

// Displacement of the points of a region for unit depth: mean normal, lengthened so that faces move
// by one; along cyclic patches at their edge
static vectorField shifts(const triSurface& region, const vectorField& seam)
{
    vectorField shift(region.nPoints(), Zero);
    forAll(shift, p)
    {
        vector n(Zero);
        for (const label f : region.pointFaces()[p])
        {
            // Weighted by the angle at the point, so that the cut into triangles does not matter
            const labelledTri& t = region.localFaces()[f];
            const label v = t[0] == p ? 0 : t[1] == p ? 1 : 2;
            const pointField& x = region.localPoints();
            const vector a(normalised(x[t[(v + 1) % 3]] - x[p])),
                b(normalised(x[t[(v + 2) % 3]] - x[p]));
            n += Foam::acos(min(max(a & b, scalar(-1)), scalar(1)))*region.faceNormals()[f];
        }
        n = normalised(n);
        const vector m(n - (n & seam[p])*seam[p]);
        if ((m & n) > 0.3) n = normalised(m);

        scalar cosine = 0;
        for (const label f : region.pointFaces()[p]) cosine += n & region.faceNormals()[f];
        cosine /= region.pointFaces()[p].size();
        shift[p] = n/max(cosine, scalar(0.5));
    }
    return shift;
}


// The region moved by depth, without the faces that a tight curve turned over
static triSurface movedSheet(
    const triSurface& region, const vectorField& shift, scalar depth, labelList& faceMap)
{
    const pointField moved(region.localPoints() - depth*shift);
    List<labelledTri> faces(region.size());
    faceMap.setSize(region.size());
    label n = 0;
    forAll(faces, f)
    {
        const labelledTri& t = region.localFaces()[f];
        const vector area(t.areaNormal(moved));
        if ((area & region.faceNormals()[f]) > 0.01*mag(region.faceAreas()[f]))
        {
            faces[n] = t;
            faceMap[n++] = f;
        }
    }
    faces.setSize(n);
    faceMap.setSize(n);
    return triSurface(faces, moved);
}


static sheetPoints samplePoints(const triSurface& sheet, scalar spacing)
{
    point corner;
    vector side1, side2;
    return
        isRectangle(sheet, corner, side1, side2)
      ? latticeOnRectangle(corner, side1, side2, spacing)
      : relaxedOnSheet(sheet, spacing);
}


// All of it moves alike: points of the first layer serve for all
static bool movesAlike(const vectorField& shift)
{
    for (const vector& v : shift) if (mag(v - shift[0]) > 1e-3) return false;
    return true;
}


static void layRegion
(
    const wallSpace& space,
    const triSurface& region,
    const vectorField& seam,
    label layers,
    wallCandidates& out
)
{
    const vectorField shift(shifts(region, seam));
    const bool plane = movesAlike(shift);
    sheetPoints points;
    labelList faceMap;
    for (label layer = 0; layer < layers; ++layer)
    {
        const scalar d = space.firstOffset + layer*space.spacing;
        if (layer == 0 || !plane)
        {
            const triSurface sheet(movedSheet(region, shift, d, faceMap));
            if (sheet.empty()) break;
            points = samplePoints(sheet, space.spacing);
        }
        else
        {
            points.position -= space.spacing*shift[0];
        }
        forAll(points.position, i)
        {
            const label f = faceMap[max(points.face[i], label(0))];
            out.add(points.position[i], region.faceNormals()[f], region[f].region(), d);
        }
    }
}

} // namespace Foam


void Foam::laySheets(const wallSpace& space, const wallSurface& wall, wallCandidates& out)
{
    const auto kinds(wall.edgeKinds(space.cosFeature));
    boolList border(kinds.size());
    forAll(kinds, e) border[e] = kinds[e] != wallSurface::edgeKind::smooth;

    labelList zone;
    const label nRegions = wall.surface.markZones(border, zone);
    for (label r = 0; r < nRegions; ++r)
    {
        boolList include(zone.size());
        forAll(zone, f) include[f] = zone[f] == r;
        labelList pointMap, faceMap;
        const triSurface region(wall.surface.subsetMesh(include, pointMap, faceMap));

        // Points of the region are numbered as its local points
        vectorField seam(region.nPoints());
        forAll(seam, p)
            seam[p] = wall.seam[wall.surface.meshPoints()[pointMap[region.meshPoints()[p]]]];
        layRegion(space, region, seam, wall.layers, out);
    }

    fillEdges(space, wall, kinds, out);
    fillCorners(space, wall, kinds, out);
}

// SPDX-License-Identifier: GPL-3.0-or-later
/*  Surfaces of constant/geometry as oriented elements, normals into the fluid; in 2D cut with the
    mid-plane */

#include "wallSurface.H"
#include "bodyShapes.H"
#include "edgeHashes.H"
#include "geometryWalls.H"
#include "searchableBox.H"
#include "searchableCylinder.H"
#include "searchableDisk.H"
#include "searchablePlate.H"
#include "searchableRotatedBox.H"
#include "searchableSphere.H"

namespace Foam
{

// The segments in which triangles meet the mid-plane. A vertex on the plane counts as above it.
static wallElements cut(const wallSpace& space, const wallElements& solid)
{
    wallElements all;
    EdgeMap<label> pointOfEdge;

    auto above = [&](label p) { return solid.points[p][space.empty] >= space.middle; };
    auto crossing = [&](label a, label b)
    {
        const edge e(min(a, b), max(a, b));
        if (!pointOfEdge.found(e))
        {
            const point &p = solid.points[e[0]], &q = solid.points[e[1]];
            const scalar w = (space.middle - p[space.empty])/(q[space.empty] - p[space.empty]);
            point x(p + w*(q - p));
            x[space.empty] = space.middle;
            pointOfEdge.insert(e, all.addPoint(x));
        }
        return pointOfEdge[e];
    };

    forAll(solid.elements, i)
    {
        const auto& t = solid.elements[i];
        label end[2], n = 0;
        for (label v = 0; v < 3; ++v)
        {
            const label a = t[v], b = t[(v + 1) % 3];
            if (above(a) != above(b)) end[n++] = crossing(a, b);
        }
        if (n != 2) continue;

        const vector normal
        (
            (solid.points[t[1]] - solid.points[t[0]]) ^ (solid.points[t[2]] - solid.points[t[0]])
        );
        if ((space.left(all.points[end[1]] - all.points[end[0]]) & normal) < 0)
            std::swap(end[0], end[1]);
        all.add(end[0], end[1], -1, solid.source[i]);
    }
    return all;
}

} // namespace Foam


Foam::wallElements Foam::bodyElements
(
    const wallSpace& space,
    const geometryWalls& bodies,
    label bodyi,
    label source
)
{
    const searchableSurface& s = bodies[bodyi];
    const dictionary& d = bodies.dict(bodyi);
    const word& name = bodies.names()[bodyi];

    wallElements all;
    if (isA<searchableBox>(s) || isA<searchableRotatedBox>(s))
    {
        addBox(all, s.points()(), source);
    }
    else if (isA<searchableSphere>(s))
    {
        addSphere(all, s.bounds().midpoint(), d.get<scalar>("radius"), space.spacing, source);
    }
    else if (isA<searchableCylinder>(s))
    {
        addCylinder(all, d, space.spacing, source);
    }
    else if (isA<searchablePlate>(s))
    {
        addPlate(all, d, source);
    }
    else if (isA<searchableDisk>(s))
    {
        addDisk(all, d, space.spacing, source);
    }
    else
    {
        addTriangles(all, refCast<const triSurfaceMesh>(s), name, source);
    }

    if (bodies.side(bodyi) == geometryWalls::solidSide::outside) all.flip();
    if (space.planar)
    {
        all = cut(space, all);
        if (all.elements.empty())
        {
            FatalErrorInFunction
                << "surface " << name
                << " of constant/geometry does not meet the mid-plane of the mesh, "
                << vector::componentNames[space.empty] << " = " << space.middle << exit(FatalError);
        }
    }
    return all;
}

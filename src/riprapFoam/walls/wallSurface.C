// SPDX-License-Identifier: GPL-3.0-or-later
/*  Assembly, connectivity and searches of wall surfaces */

#include "wallSurface.H"
#include "wallPoints.H"
#include "unitConversion.H"

Foam::wallSpace::wallSpace(const polyMesh& m, const wallPointsControls& controls)
:
    mesh(m),
    planar(m.nGeometricD() == 2),
    empty(2),
    middle(0),
    spacing(controls.spacing),
    firstOffset(controls.firstOffset < 0 ? 0.5*controls.spacing : controls.firstOffset),
    cosFeature(Foam::cos(degToRad(controls.featureAngle)))
{
    if (m.nGeometricD() < 2)
    {
        FatalErrorInFunction << "the mesh has " << m.nGeometricD()
                            << " dimensions that are not empty: walls need 2 or 3"
                            << exit(FatalError);
    }
    if (planar)
    {
        for (direction d = 0; d < vector::nComponents; ++d)
        {
            if (m.geometricD()[d] < 0) empty = d;
        }
        middle = m.bounds().midpoint()[empty];
    }
}


Foam::vector Foam::wallSpace::left(const vector& t) const
{
    vector e(Zero);
    e[empty] = 1;
    return e ^ t;
}


Foam::label Foam::wallElements::addPoint(const point& p, const vector& cyclicNormal)
{
    points.append(p);
    seam.append(cyclicNormal);
    return points.size() - 1;
}


void Foam::wallElements::add(label a, label b, label c, label from)
{
    FixedList<label, 3> element;
    element[0] = a;
    element[1] = b;
    element[2] = c;
    elements.append(element);
    source.append(from);
}


void Foam::wallElements::flip()
{
    for (auto& element : elements) std::swap(element[0], element[1]);
}


Foam::List<Foam::wallElements> Foam::connectedParts(const wallElements& all)
{
    // Union-find over points; the root is the lowest label, so parts come in the order of their
    // points
    labelList root(identity(all.points.size()));
    auto find = [&](label p)
    {
        while (root[p] != p) p = root[p] = root[root[p]];
        return p;
    };
    for (const auto& element : all.elements)
    {
        for (label v = 1; v < 3 && element[v] >= 0; ++v)
        {
            const label a = find(element[0]), b = find(element[v]);
            root[max(a, b)] = min(a, b);
        }
    }

    labelList partOfRoot(all.points.size(), -1);
    labelList local(all.points.size(), -1);
    DynamicList<wallElements> parts;
    forAll(all.elements, i)
    {
        const auto& element = all.elements[i];
        label& parti = partOfRoot[find(element[0])];
        if (parti < 0)
        {
            parti = parts.size();
            parts.append(wallElements());
        }
        wallElements& part = parts[parti];
        FixedList<label, 3> mine(-1);
        for (label v = 0; v < 3 && element[v] >= 0; ++v)
        {
            label& p = local[element[v]];
            if (p < 0) p = part.addPoint(all.points[element[v]], all.seam[element[v]]);
            mine[v] = p;
        }
        part.elements.append(mine);
        part.source.append(all.source[i]);
    }
    return List<wallElements>(std::move(parts));
}


Foam::wallSurface::wallSurface(const wallSpace& space, const wallElements& part, label nLayers)
:
    points(part.points),
    seam(part.seam),
    layers(nLayers)
{
    DynamicList<labelledTri> tris(2*part.elements.size());
    pointField corners(points);

    if (space.planar)
    {
        // Strips: the far side's points follow the near side's
        vector half(Zero);
        half[space.empty] = 0.5*space.spacing;
        const label n = points.size();
        corners.setSize(2*n);
        for (label p = 0; p < n; ++p)
        {
            corners[p] = points[p] - half;
            corners[p + n] = points[p] + half;
        }
        segments.setSize(part.elements.size());
        forAll(part.elements, i)
        {
            const label a = part.elements[i][0], b = part.elements[i][1];
            segments[i] = edge(a, b);
            tris.append(labelledTri(a, b + n, b, part.source[i]));
            tris.append(labelledTri(a, a + n, b + n, part.source[i]));
        }
    }
    else
    {
        forAll(part.elements, i)
        {
            const auto& t = part.elements[i];
            tris.append(labelledTri(t[0], t[1], t[2], part.source[i]));
        }
    }
    surface = triSurface(tris, geometricSurfacePatchList(), corners);
}


Foam::List<Foam::pointIndexHit> Foam::wallSurface::nearest(const pointField& at) const
{
    if (!search_.valid()) search_.reset(new triSurfaceSearch(surface));

    List<pointIndexHit> hits;
    search_->findNearest(at, scalarField(at.size(), sqr(GREAT)), hits);
    return hits;
}


Foam::scalarField Foam::wallSurface::distance(const pointField& at) const
{
    const List<pointIndexHit> hits(nearest(at));
    scalarField d(at.size());
    forAll(d, i) d[i] = mag(hits[i].rawPoint() - at[i]);
    return d;
}


Foam::List<Foam::wallSurface::edgeKind> Foam::wallSurface::edgeKinds(scalar cosFeature) const
{
    const auto& edgeFaces = surface.edgeFaces();
    const auto& normals = surface.faceNormals();
    const auto& centres = surface.faceCentres();

    List<edgeKind> kinds(surface.nEdges(), edgeKind::smooth);
    forAll(kinds, e)
    {
        if (edgeFaces[e].size() != 2)
        {
            kinds[e] = edgeKind::open;
            continue;
        }
        const label f = edgeFaces[e][0], g = edgeFaces[e][1];
        if ((normals[f] & normals[g]) < cosFeature)
        {
            const scalar rise = (centres[g] - centres[f]) & normals[f];
            kinds[e] = rise > 0 ? edgeKind::convex : edgeKind::concave;
        }
    }
    return kinds;
}


void Foam::wallCandidates::add(const point& p, const vector& n, label from, scalar behind)
{
    position.append(p);
    normal.append(n);
    source.append(from);
    depth.append(behind);
}


void Foam::wallCandidates::keep(const boolList& those)
{
    label n = 0;
    forAll(those, i)
    {
        if (!those[i]) continue;
        position[n] = position[i];
        normal[n] = normal[i];
        source[n] = source[i];
        depth[n] = depth[i];
        ++n;
    }
    position.setSize(n);
    normal.setSize(n);
    source.setSize(n);
    depth.setSize(n);
}

// SPDX-License-Identifier: GPL-3.0-or-later

#include "wallEdges.H"
#include "labelVector.H"
#include "polylines.H"

namespace Foam
{

// Cross-section at a point of an edge line: normals of both faces, and the ways on past the edge
struct crossSection
{
    vector n1 = Zero, n2 = Zero, t1 = Zero, t2 = Zero;

    void add(const wallSurface& wall, label e, const vector& along)
    {
        const triSurface& s = wall.surface;
        for (const label f : s.edgeFaces()[e])
        {
            const vector& n = s.faceNormals()[f];
            vector out(normalised(along ^ n));
            const bool outward = (out & (s.faceCentres()[f] - s.localPoints()[s.edges()[e][0]]))
                < 0;
            // The face whose way out is along x n is the first
            (outward ? n1 : n2) += n;
            (outward ? t1 : t2) += outward ? out : -out;
        }
    }

    void finish()
    {
        n1 = normalised(n1);
        n2 = normalised(n2);
        t1 = normalised(t1);
        t2 = normalised(t2);
    }

    scalar halfTangent() const
    {
        return Foam::tan(0.5*Foam::acos(min(max(n1 & n2, scalar(-0.99)), scalar(1))));
    }

    //- Fraction w of the way round the edge at depth d
    point at(const point& p, scalar d, scalar w) const
    {
        const scalar side = d*halfTangent();
        return w < 0.5 ? p - d*n1 + 2*w*side*t1 : p - d*n2 + 2*(1 - w)*side*t2;
    }
};


static void fillLine
(
    const wallSpace& space,
    const wallSurface& wall,
    const polyline& line,
    const List<crossSection>& sections,
    label source,
    wallCandidates& out
)
{
    const pointField& points = wall.surface.localPoints();
    const scalar reach = 1.5*(space.firstOffset + wall.layers*space.spacing);
    scalar mean = 0;
    for (const crossSection& c : sections) mean += c.halfTangent()/sections.size();

    for (label layer = 0; layer < wall.layers; ++layer)
    {
        const scalar d = space.firstOffset + layer*space.spacing;
        const label n = label(2*d*mean/space.spacing + 0.5);
        for (label i = 0; i < n; ++i)
        {
            const scalar w = (i + 0.5)/n;
            pointField curve(line.points.size());
            forAll(curve, j) curve[j] = sections[j].at(points[line.points[j]], d, w);

            scalarField lengths(line.edges.size());
            forAll(lengths, j)
            {
                const vector along
                (
                    normalised(points[line.points[j + 1]] - points[line.points[j]])
                );
                lengths[j] = max(scalar(0), (curve[j + 1] - curve[j]) & along);
            }
            for (const auto& part : divideEvenly(lengths, space.spacing))
            {
                const label j = part.first();
                const scalar x = part.second();
                const point at((1 - x)*curve[j] + x*curve[j + 1]);
                const point foot((1 - x)*points[line.points[j]] + x*points[line.points[j + 1]]);
                if (mag(at - foot) < reach) out.add(at, normalised(foot - at), source, d);
            }
        }
    }
}


// Where three sharp edges or more meet, and all are convex or flat
static bool isConvexCorner(const triSurface& s, const List<wallSurface::edgeKind>& kinds, label p)
{
    label nSharp = 0;
    bool convex = true;
    for (const label e : s.pointEdges()[p])
    {
        nSharp += kinds[e] == wallSurface::edgeKind::convex;
        convex = convex && kinds[e] != wallSurface::edgeKind::open
            && kinds[e] != wallSurface::edgeKind::concave;
    }
    return nSharp >= 3 && convex;
}


// Points about a corner that are no deeper than the wall's layers, and their depths. The lattice
// lies along the first face's normal and the edge of it that is nearest to a right angle
static void cornerLattice
(
    const wallSpace& space,
    const wallSurface& wall,
    label p,
    pointField& lattice,
    scalarField& depth
)
{
    const triSurface& s = wall.surface;
    const labelList& faces = s.pointFaces()[p];
    const vector e1(s.faceNormals()[faces[0]]);
    vector second(Zero);
    for (const label f : faces)
    {
        const vector n(s.faceNormals()[f] - (s.faceNormals()[f] & e1)*e1);
        if (mag(n) > mag(second)) second = n;
    }
    const vector e2(normalised(second)), e3(e1 ^ e2);

    const point& corner = s.localPoints()[p];
    const label n = 2*wall.layers;
    for (label l = 0; l < 8*n*n*n; ++l)
    {
        const labelVector i(l % (2*n), l/(2*n) % (2*n), l/(4*n*n));
        const point x
        (
            corner + space.spacing*
            (
                (i.x() - n + 0.5)*e1 + (i.y() - n + 0.5)*e2 + (i.z() - n + 0.5)*e3
            )
        );
        scalar deepest = 0;
        for (const label f : faces) deepest = max(deepest, (corner - x) & s.faceNormals()[f]);
        if (deepest < space.firstOffset + (wall.layers - 0.9)*space.spacing)
        {
            lattice.append(x);
            depth.append(deepest);
        }
    }
}

} // namespace Foam


void Foam::fillEdges
(
    const wallSpace& space,
    const wallSurface& wall,
    const List<wallSurface::edgeKind>& kinds,
    wallCandidates& out
)
{
    const triSurface& s = wall.surface;
    DynamicList<edge> sharp;
    DynamicList<label> sharpLabel;
    forAll(kinds, e)
    {
        if (kinds[e] != wallSurface::edgeKind::convex) continue;
        sharp.append(s.edges()[e]);
        sharpLabel.append(e);
    }
    auto unitAlong = [&](label e) { return sharp[e].unitVec(s.localPoints()); };
    auto isEnd = [&](label p, label e, label f)
    {
        const scalar turn = (unitAlong(e) & unitAlong(f))*(sharp[e].start() == p ? -1 : 1)
            *(sharp[f].start() == p ? 1 : -1);
        return turn < space.cosFeature;
    };

    for (const polyline& line : linkEdges(sharp, isEnd))
    {
        List<crossSection> sections(line.points.size());
        label source = labelMax;
        forAll(line.edges, i)
        {
            const label e = sharpLabel[line.edges[i]];
            const vector along
            (
                s.localPoints()[line.points[i + 1]] - s.localPoints()[line.points[i]]
            );
            sections[i].add(wall, e, normalised(along));
            sections[i + 1].add(wall, e, normalised(along));
            for (const label f : s.edgeFaces()[e]) source = min(source, s.localFaces()[f].region());
            if (line.closed && i == 0) sections.last().add(wall, e, normalised(along));
            if (line.closed && i == line.edges.size() - 1)
                sections.first().add(wall, e, normalised(along));
        }
        for (crossSection& c : sections) c.finish();
        fillLine(space, wall, line, sections, source, out);
    }
}


void Foam::fillCorners
(
    const wallSpace& space,
    const wallSurface& wall,
    const List<wallSurface::edgeKind>& kinds,
    wallCandidates& out
)
{
    const triSurface& s = wall.surface;
    forAll(s.pointEdges(), p)
    {
        if (!isConvexCorner(s, kinds, p)) continue;

        const point& corner = s.localPoints()[p];
        label source = labelMax;
        for (const label f : s.pointFaces()[p]) source = min(source, s.localFaces()[f].region());

        pointField lattice;
        scalarField depth;
        cornerLattice(space, wall, p, lattice, depth);
        const scalarField distance(wall.distance(lattice));
        forAll(lattice, i)
        {
            if (depth[i] > 0 && mag(lattice[i] - corner) < distance[i] + 1e-6*space.spacing)
            {
                out.add(lattice[i], normalised(corner - lattice[i]), source, depth[i]);
            }
        }
    }
}

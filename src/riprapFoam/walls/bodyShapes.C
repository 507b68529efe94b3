// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyShapes.H"
#include "mathematicalConstants.H"

namespace Foam
{

// Facets round a circle of radius r. At most those of a radius of 8,500 spacings
static label facets(scalar r, scalar spacing)
{
    constexpr scalar most = 2048;
    const scalar sagitta = min(0.01*spacing/r, 0.5);
    if (sagitta < 1e-6) return label(most);
    return max(label(16), label(min(most, constant::mathematical::pi/acos(1 - sagitta))) + 1);
}


static void quad(wallElements& all, label a, label b, label c, label d, label source)
{
    all.add(a, b, c, source);
    all.add(a, c, d, source);
}


// Corners in the order of treeBoundBox: x, then y, then z fastest to slowest
void addBox(wallElements& all, const pointField& corner, label source)
{
    for (const point& p : corner) all.addPoint(p);
    quad(all, 0, 4, 6, 2, source);
    quad(all, 1, 3, 7, 5, source);
    quad(all, 0, 1, 5, 4, source);
    quad(all, 2, 6, 7, 3, source);
    quad(all, 0, 2, 3, 1, source);
    quad(all, 4, 5, 7, 6, source);
}


// Two unit vectors that make a right-handed frame with axis
static void frame(const vector& axis, vector& u, vector& v)
{
    const vector least = mag(axis.x()) < 0.6 ? vector(1, 0, 0) : vector(0, 1, 0);
    u = normalised(least - (least & axis)*axis);
    v = axis ^ u;
}


static labelList ring
(
    wallElements& all,
    const point& centre,
    const vector& axis,
    scalar radius,
    label n
)
{
    vector u, v;
    frame(axis, u, v);
    labelList points(n);
    forAll(points, i)
    {
        const scalar angle = constant::mathematical::twoPi*i/n;
        points[i] = all.addPoint(centre + radius*(cos(angle)*u + sin(angle)*v));
    }
    return points;
}


static void cap(wallElements& all, const labelList& rim, const point& centre, bool up, label source)
{
    const label c = all.addPoint(centre);
    forAll(rim, i)
    {
        const label a = rim[i], b = rim[rim.fcIndex(i)];
        all.add(c, up ? a : b, up ? b : a, source);
    }
}


static void band(wallElements& all, const labelList& low, const labelList& high, label source)
{
    forAll(low, i)
    {
        const label j = low.fcIndex(i);
        quad(all, low[i], low[j], high[j], high[i], source);
    }
}


void addCylinder(wallElements& all, const dictionary& d, scalar spacing, label source)
{
    const point a(d.get<point>("point1")), b(d.get<point>("point2"));
    const scalar r = d.get<scalar>("radius");
    const vector axis(normalised(b - a));
    const label n = facets(r, spacing);
    const labelList low(ring(all, a, axis, r, n)), high(ring(all, b, axis, r, n));
    band(all, low, high, source);
    cap(all, low, a, false, source);
    cap(all, high, b, true, source);
}


void addSphere(wallElements& all, const point& centre, scalar r, scalar spacing, label source)
{
    const vector axis(0, 0, 1);
    const label n = facets(r, spacing), rows = n/2;

    labelList below;
    for (label row = 1; row < rows; ++row)
    {
        const scalar angle = constant::mathematical::pi*row/rows;
        const point c(centre - r*cos(angle)*axis);
        const labelList here(ring(all, c, axis, r*sin(angle), n));
        if (row == 1)
        {
            cap(all, here, centre - r*axis, false, source);
        }
        else
        {
            band(all, below, here, source);
        }
        below = here;
    }
    cap(all, below, centre + r*axis, true, source);
}


void addDisk(wallElements& all, const dictionary& d, scalar spacing, label source)
{
    const scalar r = d.get<scalar>("radius");
    const point centre(d.get<point>("origin"));
    const vector axis(normalised(d.get<vector>("normal")));
    cap(all, ring(all, centre, axis, r, facets(r, spacing)), centre, true, source);
}


void addPlate(wallElements& all, const dictionary& d, label source)
{
    const point origin(d.get<point>("origin"));
    const vector span(d.get<vector>("span"));
    vector u(Zero), v(Zero);
    bool first = true;
    for (direction c = 0; c < vector::nComponents; ++c)
    {
        if (span[c] == 0) continue;
        (first ? u : v)[c] = span[c];
        first = false;
    }
    for (const point& p : {origin, origin + u, origin + u + v, origin + v}) all.addPoint(p);
    quad(all, 0, 1, 2, 3, source);
}


void addTriangles(wallElements& all, const triSurfaceMesh& s, const word& name, label source)
{
    for (const point& p : s.localPoints()) all.addPoint(p);
    scalar volume = 0;
    const point c(average(s.localPoints()));
    for (const labelledTri& t : s.localFaces())
    {
        const pointField& p = s.localPoints();
        volume += ((p[t[0]] - c) & ((p[t[1]] - c) ^ (p[t[2]] - c)));
        all.add(t[0], t[1], t[2], source);
    }

    // Two triangles must pass their edge in opposite senses
    for (label e = 0; e < s.nInternalEdges(); ++e)
    {
        if (s.edgeFaces()[e].size() != 2) continue;
        const label f = s.edgeFaces()[e][0], g = s.edgeFaces()[e][1];
        if (s.localFaces()[f].edgeDirection(s.edges()[e])
            == s.localFaces()[g].edgeDirection(s.edges()[e]))
        {
            FatalErrorInFunction << "the triangles of surface " << name
                                << " are not oriented alike at "
                                << s.edges()[e].centre(s.localPoints()) << ": run surfaceOrient"
                                << exit(FatalError);
        }
    }
    if (s.hasVolumeType() && volume < 0)
    {
        FatalErrorInFunction
            << "the normals of the closed surface " << name << " point into it: run surfaceOrient"
            << exit(FatalError);
    }
}

} // namespace Foam

// SPDX-License-Identifier: GPL-3.0-or-later
/*  A closed surface as the shape of a region. In 2D its section by the mesh's mid-plane: segments
    from a to b with the inside on their left, whose order does not matter (Green's theorem):

        A = sum c/2,    A X = sum (a + b) c/6,    J = sum c (a.a + a.b + b.b)/12,    c = a x b
*/

#include "principalAxes.H"
#include "momentOfInertia.H"
#include "regionShapes.H"
#include "triSurfaceSearch.H"

namespace Foam
{

struct segment
{
    vector2D a, b;
};


// Points at a plane's height are taken to be above it, so that each line is cut once
static List<segment> sectionOf(const triSurface& surface, const particlePacking& frame)
{
    const direction x = frame.axis(0), y = frame.axis(1), up = frame.axis(2);
    const scalar height = frame.inPlane(Zero)[up];
    const pointField& p = surface.points();

    DynamicList<segment> segments;
    for (const labelledTri& t : surface)
    {
        vector2D cut[2];
        label cuts = 0;
        for (label e = 0; e < 3; ++e)
        {
            const point& a = p[t[e]];
            const point& b = p[t[(e + 1) % 3]];
            if ((a[up] >= height) == (b[up] >= height)) continue;
            const scalar s = (height - a[up])/(b[up] - a[up]);
            cut[cuts++] = vector2D(a[x] + s*(b[x] - a[x]), a[y] + s*(b[y] - a[y]));
        }
        if (cuts < 2 || magSqr(cut[1] - cut[0]) == 0) continue;

        // Outside on the right
        const vector normal((p[t[1]] - p[t[0]]) ^ (p[t[2]] - p[t[0]]));
        const vector2D way(cut[1] - cut[0]);
        const bool right = way.y()*normal[x] - way.x()*normal[y] > 0;
        segments.append(right ? segment{cut[0], cut[1]} : segment{cut[1], cut[0]});
    }
    return List<segment>(std::move(segments));
}


// Negative inside: crossings of a ray are counted
static scalar signedDistance(const List<segment>& line, const vector2D& p)
{
    bool in = false;
    scalar nearest2 = GREAT;
    for (const segment& s : line)
    {
        if ((s.a.y() > p.y()) != (s.b.y() > p.y())
            && p.x() < s.a.x() + (p.y() - s.a.y())/(s.b.y() - s.a.y())*(s.b.x() - s.a.x()))
            in = !in;
        const vector2D along(s.b - s.a), to(p - s.a);
        const scalar t = min(max((to & along)/magSqr(along), scalar(0)), scalar(1));
        nearest2 = min(nearest2, magSqr(to - t*along));
    }
    return (in ? -1 : 1)*Foam::sqrt(nearest2);
}


static clumpShape section(const triSurface& surface, const particlePacking& frame)
{
    const direction x = frame.axis(0), y = frame.axis(1);
    const List<segment> line(sectionOf(surface, frame));
    scalar A = 0, J = 0;
    vector2D X(Zero);
    for (const segment& s : line)
    {
        const scalar c = s.a.x()*s.b.y() - s.a.y()*s.b.x();
        A += c/2;
        X += c/6*(s.a + s.b);
        J += c*(magSqr(s.a) + (s.a & s.b) + magSqr(s.b))/12;
    }

    clumpShape shape;
    shape.box = boundBox(surface.points(), false);
    if (mag(A) > VSMALL) X /= A;
    shape.volume = mag(A);
    shape.middle[x] = X.x();
    shape.middle[y] = X.y();
    shape.middle = frame.inPlane(shape.middle);
    shape.moments[2] = mag(J - A*magSqr(X));
    shape.distance = [line, x, y](const pointField& points)
    {
        scalarField all(points.size());
        forAll(points, i) all[i] = signedDistance(line, vector2D(points[i][x], points[i][y]));
        return all;
    };
    return shape;
}

} // namespace Foam


Foam::clumpShape Foam::closedShape(
    const std::shared_ptr<const triSurface>& surface, const particlePacking& frame)
{
    if (frame.planar()) return section(*surface, frame);

    clumpShape shape;
    shape.box = boundBox(surface->points(), false);
    tensor J(Zero);
    momentOfInertia::massPropertiesSolid(*surface, 1, shape.volume, shape.middle, J);
    shape.moments = principalMoments(J, shape.axes);
    const auto search = std::make_shared<triSurfaceSearch>(*surface);
    const boundBox box(shape.box);
    shape.distance = [surface, search, box](const pointField& points)
    {
        const boolList in(search->calcInside(points));
        scalarField all(points.size());
        forAll(points, i)
        {
            const vector span(2*(box.span() + 2*cmptMag(points[i] - box.midpoint())));
            const pointIndexHit hit(search->nearest(points[i], span));
            all[i] = (in[i] ? -1 : 1)*mag(hit.hitPoint() - points[i]);
        }
        return all;
    };
    return shape;
}

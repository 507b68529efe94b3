// SPDX-License-Identifier: GPL-3.0-or-later
/*  Shapes of rigid bodies in 2D: a closed line of points. Area, centre and second moments are the
    line's own, in closed form (Green's theorem):

        A = sum c/2,    A X = sum (a + b) c/6,    J = sum c (a.a + a.b + b.b)/12,    c = a x b

    over its segments from a to b; J about the centre by Steiner.
*/

#include "clumpShape.H"
#include "pointField.H"

namespace Foam
{

struct flatPoint
{
    scalar x, y;
};

static scalar crossed(const flatPoint& a, const flatPoint& b)
{
    return a.x*b.y - a.y*b.x;
}

static scalar dotted(const flatPoint& a, const flatPoint& b)
{
    return a.x*b.x + a.y*b.y;
}

static flatPoint minus(const flatPoint& a, const flatPoint& b)
{
    return {a.x - b.x, a.y - b.y};
}

// Do the segments ab and cd cross or touch?
static bool meet(const flatPoint& a, const flatPoint& b, const flatPoint& c, const flatPoint& d)
{
    const auto side = [](const flatPoint& p, const flatPoint& q, const flatPoint& r)
    { return crossed(minus(q, p), minus(r, p)); };
    return side(a, b, c)*side(a, b, d) <= 0 && side(c, d, a)*side(c, d, b) <= 0;
}

// Distance to the line; negative inside (crossings of a ray along x are counted)
static scalar signedDistance(const List<flatPoint>& line, const flatPoint& p)
{
    bool in = false;
    scalar nearest2 = GREAT;
    forAll(line, i)
    {
        const flatPoint& a = line[i];
        const flatPoint& b = line[(i + 1) % line.size()];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y)/(b.y - a.y)*(b.x - a.x)) in = !in;
        const flatPoint along(minus(b, a)), to(minus(p, a));
        const scalar t = min(max(dotted(along, to)/dotted(along, along), scalar(0)), scalar(1));
        const flatPoint apart{to.x - t*along.x, to.y - t*along.y};
        nearest2 = min(nearest2, dotted(apart, apart));
    }
    return (in ? -1 : 1)*Foam::sqrt(nearest2);
}

static void requireSimple(const List<flatPoint>& line, const dictionary& dict)
{
    const label n = line.size();
    const auto bad = [&](const char* why)
    {
        FatalIOErrorInFunction(dict) << "Entry outline " << why << exit(FatalIOError);
    };
    if (n < 3) bad("needs at least three points");
    forAll(line, i)
    {
        const flatPoint side(minus(line[(i + 1) % n], line[i]));
        if (!(dotted(side, side) > 0)) bad("has the same point twice in a row");
    }
    forAll(line, i)
    {
        const flatPoint& a = line[i];
        const flatPoint& b = line[(i + 1) % n];
        for (label j = i + 2; j < n; ++j)
        {
            if (i == 0 && j == n - 1) continue;         // neighbours, too
            if (meet(a, b, line[j], line[(j + 1) % n])) bad("crosses itself");
        }
    }
}

} // namespace Foam


Foam::pointField Foam::shapeLattice(const boundBox& box, label resolution)
{
    const scalar step = cmptMax(box.span())/resolution;
    const Vector<label> n(label(box.span().x()/step) + 1, label(box.span().y()/step) + 1,
        label(box.span().z()/step) + 1);
    const vector margin(0.5*(box.span() - step*vector(n.x() - 1, n.y() - 1, n.z() - 1)));
    DynamicList<point> points;
    for (label k = 0; k < n.z(); ++k)
    {
        for (label j = 0; j < n.y(); ++j)
        {
            for (label i = 0; i < n.x(); ++i)
                points.append(box.min() + margin + step*vector(i, j, k));
        }
    }
    return pointField(std::move(points));
}


Foam::clumpShape Foam::outlineShape(checkedDictionary& dict, const int axes[3])
{
    const direction x = axes[0], y = axes[1], empty = axes[2];
    dict.found("outline");
    pointField given(dict.dict().get<pointField>("outline"));
    List<flatPoint> line(given.size());
    forAll(given, i)
    {
        given[i][empty] = 0;
        line[i] = {given[i][x], given[i][y]};
    }
    requireSimple(line, dict.dict());

    scalar A = 0, J = 0;
    flatPoint X{0, 0};
    forAll(line, i)
    {
        const flatPoint& a = line[i];
        const flatPoint& b = line[(i + 1) % line.size()];
        const scalar c = crossed(a, b);
        A += c/2;
        X.x += c*(a.x + b.x)/6;
        X.y += c*(a.y + b.y)/6;
        J += c*(dotted(a, a) + dotted(a, b) + dotted(b, b))/12;
    }
    X = {X.x/A, X.y/A};

    clumpShape shape;
    shape.volume = mag(A);
    shape.middle[x] = X.x;
    shape.middle[y] = X.y;
    shape.moments[2] = mag(J - A*dotted(X, X));
    shape.box = boundBox(given, false);
    shape.distance = [line, x, y](const pointField& points)
    {
        scalarField all(points.size());
        forAll(points, i) all[i] = signedDistance(line, {points[i][x], points[i][y]});
        return all;
    };
    return shape;
}

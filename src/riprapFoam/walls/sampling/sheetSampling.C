// SPDX-License-Identifier: GPL-3.0-or-later

#include "sheetSampling.H"
#include "pointGrid.H"
#include "triSurfaceSearch.H"
#include "mathematicalConstants.H"

#include <queue>

namespace Foam
{

// n points, low-discrepancy within triangles and even over their total area
static sheetPoints denseSet(const triSurface& sheet, label n)
{
    const scalarField area(mag(sheet.faceAreas()));
    const scalar total = sum(area);

    sheetPoints dense{pointField(n), labelList(n)};
    label f = 0;
    scalar before = 0;
    for (label i = 0; i < n; ++i)
    {
        const scalar at = (i + 0.5)*total/n;
        while (f + 1 < area.size() && before + area[f] < at) before += area[f++];

        // R2 sequence of M. Roberts: powers of the plastic number
        scalar u = 0.7548776662466927*(i + 1), v = 0.5698402909980532*(i + 1);
        u -= std::floor(u);
        v -= std::floor(v);
        if (u + v > 1)
        {
            u = 1 - u;
            v = 1 - v;
        }
        const pointField& p = sheet.localPoints();
        const labelledTri& t = sheet.localFaces()[f];
        dense.position[i] = p[t[0]] + u*(p[t[1]] - p[t[0]]) + v*(p[t[2]] - p[t[0]]);
        dense.face[i] = f;
    }
    return dense;
}


// Drop the most crowded point again and again until n are left
static sheetPoints eliminate(const sheetPoints& dense, label n, scalar area)
{
    const label m = dense.position.size();
    const scalar reach = 2*Foam::sqrt(area/(2*Foam::sqrt(scalar(3))*n));
    auto weightAt = [&](scalar d) { return Foam::pow(1 - d/reach, 8); };

    const pointGrid grid(reach, dense.position);
    scalarField weight(m, Zero);
    std::priority_queue<std::pair<scalar, label>> crowded;
    forAll(weight, i)
    {
        grid.near
        (
            dense.position[i],
            [&](label j, const vector&, scalar d) { if (j != i) weight[i] += weightAt(d); }
        );
        crowded.push({weight[i], i});
    }

    std::vector<bool> gone(std::size_t(max(m, 0)), false);
    for (label left = m; left > n && !crowded.empty();)
    {
        const auto top = crowded.top();
        const label i = top.second;
        crowded.pop();
        if (gone[i] || top.first != weight[i]) continue;    // out of date
        gone[i] = true;
        --left;
        grid.near
        (
            dense.position[i],
            [&](label j, const vector&, scalar d)
            {
                if (gone[j]) return;
                weight[j] -= weightAt(d);
                crowded.push({weight[j], j});
            }
        );
    }

    sheetPoints kept;
    for (label i = 0; i < m; ++i)
    {
        if (gone[i]) continue;
        kept.position.append(dense.position[i]);
        kept.face.append(dense.face[i]);
    }
    return kept;
}


// Points close together along the sheet's boundary and the way in from each
static void boundaryPoints(
    const triSurface& sheet, scalar every, pointField& at, vectorField& inward)
{
    DynamicList<point> p;
    DynamicList<vector> in;
    forAll(sheet.edges(), e)
    {
        if (sheet.edgeFaces()[e].size() != 1) continue;
        const label f = sheet.edgeFaces()[e][0];
        const edge& ends = sheet.edges()[e];
        const vector along(ends.vec(sheet.localPoints()));
        vector way(normalised(sheet.faceNormals()[f] ^ along));
        if ((way & (sheet.faceCentres()[f] - ends.centre(sheet.localPoints()))) < 0) way = -way;

        const label n = label(mag(along)/every) + 1;
        for (label i = 0; i < n; ++i)
        {
            p.append(sheet.localPoints()[ends[0]] + ((i + 0.5)/n)*along);
            in.append(way);
        }
    }
    at = pointField(p);
    inward = vectorField(in);
}


static void relax(const triSurface& sheet, scalar spacing, sheetPoints& points)
{
    constexpr label nIterations = 40;
    const scalar reach = 1.7*spacing;

    const triSurfaceSearch search(sheet);
    pointField edgeAt;
    vectorField inward;
    boundaryPoints(sheet, 0.2*spacing, edgeAt, inward);
    const pointGrid edges(reach, edgeAt);

    for (label iteration = 0; iteration < nIterations; ++iteration)
    {
        pointGrid grid(reach, points.position);
        for (const point& x : points.position)
        {
            label nearest = -1;
            scalar least = GREAT;
            edges.near
            (
                x,
                [&](label e, const vector&, scalar d)
                {
                    if (d < least) { least = d; nearest = e; }
                }
            );
            if (nearest < 0) continue;
            const scalar in = max((x - edgeAt[nearest]) & inward[nearest], 0.05*spacing);
            grid.insert(x - 2*in*inward[nearest], -1);
        }

        // Soft repulsion, damped towards the end
        const scalar step = 0.3*spacing*(1 - 0.8*scalar(iteration)/nIterations);
        pointField moved(points.position);
        forAll(moved, i)
        {
            vector push(Zero);
            grid.near
            (
                points.position[i],
                [&](label j, const vector& away, scalar d)
                {
                    if (j != i && d > SMALL) push += sqr(1 - d/reach)*away/d;
                }
            );
            const scalar m = mag(push);
            moved[i] += step*push*min(scalar(1), 0.6/max(m, SMALL));
        }

        List<pointIndexHit> hits;
        search.findNearest(moved, scalarField(moved.size(), sqr(GREAT)), hits);
        forAll(hits, i)
        {
            points.position[i] = hits[i].rawPoint();
            points.face[i] = hits[i].index();
        }
    }
}

} // namespace Foam


bool Foam::isRectangle(const triSurface& sheet, point& corner, vector& side1, vector& side2)
{
    const vectorField& normals = sheet.faceNormals();
    const vector n(normalised(sum(sheet.faceAreas())));
    for (const vector& m : normals) if ((m & n) < 0.9998) return false;

    // The longest boundary edge gives the first side
    vector along(Zero);
    scalar area = 0;
    forAll(sheet.edges(), e)
    {
        if (sheet.edgeFaces()[e].size() != 1) continue;
        const vector here(sheet.edges()[e].vec(sheet.localPoints()));
        if (mag(here) > (1 + 1e-6)*mag(along)) along = here;
    }
    if (mag(along) < SMALL) return false;
    const vector u(normalised(along - (along & n)*n)), v(n ^ u);

    const scalarField x(sheet.localPoints() & u), y(sheet.localPoints() & v);
    const scalar z = sum(sheet.localPoints() & n)/sheet.nPoints();
    area = sum(mag(sheet.faceAreas()));
    side1 = (max(x) - min(x))*u;
    side2 = (max(y) - min(y))*v;
    corner = min(x)*u + min(y)*v + z*n;
    return mag(area - mag(side1)*mag(side2)) < 0.005*area;
}


Foam::sheetPoints Foam::latticeOnRectangle
(
    const point& corner,
    const vector& side1,
    const vector& side2,
    scalar spacing
)
{
    const label n = label(mag(side1)/spacing + 0.5), m = label(mag(side2)/spacing + 0.5);
    sheetPoints points{pointField(n*m), labelList(n*m, -1)};
    for (label i = 0; i < n*m; ++i)
    {
        const label row = i/n;
        points.position[i] = corner + ((i % n) + 0.5)/n*side1 + (row + 0.5)/m*side2;
    }
    return points;
}


Foam::sheetPoints Foam::relaxedOnSheet(const triSurface& sheet, scalar spacing)
{
    const scalar area = sum(mag(sheet.faceAreas()));
    const label n = label(area/sqr(spacing) + 0.5);
    if (n == 0) return sheetPoints();

    sheetPoints points(eliminate(denseSet(sheet, 8*n), n, area));
    relax(sheet, spacing, points);
    return points;
}

// SPDX-License-Identifier: GPL-3.0-or-later
/*  Are the particles of a region where fluid can be, and clear of each other? */

#include "particleRegions.H"
#include "clipOrStop.H"
#include "dividedRegion.H"
#include "particleCloudIO.H"
#include "pointGrid.H"

#include <algorithm>


void Foam::checkPlace
(
    particleRegion& region,
    const particlePacking& packing,
    const regionSpace& space
)
{
    // With several processes placePart has done this
    if (!Pstream::parRun())
    {
        const labelList cell(locateParticles(space.mesh, region.position, labelList(), false));
        boolList good(cell.size());
        forAll(good, i) good[i] = cell[i] >= 0;
        clipOrStop(region, good, "outside the mesh");
    }

    for (label b = 0; space.bodies && b < space.bodies->size(); ++b)
    {
        boolList good(space.bodies->inSolid(b, region.position));
        for (bool& g : good) g = !g;
        clipOrStopAll(
            region, good, "in the solid " + space.bodies->names()[b] + " of constant/geometry");
    }

    // A particle half a spacing before a wall is (dp + dw)/2 from the first layer; half of that is
    // too near
    if (space.walls.size() == 0) return;
    const scalar near = 0.25*(packing.spacing() + space.walls.spacing);
    const pointGrid walls(near, space.walls.position);
    labelList found(region.size(), -1);
    #pragma omp parallel for schedule(static) if (region.size() > 10000)
    for (label i = 0; i < region.size(); ++i)
    {
        walls.near(region.position[i],
            [&](label w, const vector&, scalar)
            {
                if (found[i] < 0) found[i] = w;
            });
    }
    boolList good(region.size(), true);
    label first = -1;
    forAll(good, i)
    {
        if (found[i] < 0) continue;
        if (first < 0) first = i;
        good[i] = false;
    }
    label wall = first < 0 ? 0 : space.walls.source[found[first]];
    if (Pstream::parRun()) ofLeast(first < 0 ? noNumber : region.number[first], first >= 0, wall);
    clipOrStopAll(region, good, "too near to wall " + space.walls.names[wall] + " (or others)");
}


namespace Foam
{

// One of the points that another region's can reach
struct sharedPoint
{
    std::int64_t order;             // of the regions, then of their points
    label region;
    point position;
};


// Those of other processes that are near to the cells of this one are among them
static void addNearOnes(const polyMesh& mesh, scalar reach, std::vector<sharedPoint>& points)
{
    pointField position(label(points.size()));
    forAll(position, i) position[i] = points[i].position;
    const std::vector<labelList> near(pointsNearParts(mesh, position, reach));

    std::vector<riprap::RankBytes> out(near.size()), in;
    for (std::size_t rank = 0; rank < near.size(); ++rank)
        for (const label i : near[rank]) riprap::putValues(out[rank], &points[i]);
    pstreamTransport().exchange(out, in);
    for (const riprap::RankBytes& bytes : in)
    {
        const std::size_t n = bytes.size()/sizeof(sharedPoint), before = points.size();
        const unsigned char* from = bytes.data();
        points.resize(before + n);
        if (n) takeBytes(from, &points[before], n);
    }
    std::sort(points.begin(), points.end(),
        [](const sharedPoint& a, const sharedPoint& b) { return a.order < b.order; });
}


// In the order of one process
static std::vector<sharedPoint> sharedPoints(const polyMesh& mesh,
    const List<particleRegion>& regions, const List<boundBox>& bounds, scalar reach)
{
    std::vector<sharedPoint> points;
    forAll(regions, r)
    {
        const particleRegion& region = regions[r];
        forAll(region.position, i)
        {
            bool shared = !region.regular;
            forAll(bounds, other)
            {
                shared = shared || (other != r && bounds[other].contains(region.position[i]));
            }
            if (!shared) continue;
            const std::int64_t number = region.number.size() ? region.number[i] : i;
            points.push_back({(std::int64_t(r) << 48) + number, r, region.position[i]});
        }
    }
    if (Pstream::parRun()) addNearOnes(mesh, reach, points);
    return points;
}

} // namespace Foam


void Foam::checkOverlap(
    const polyMesh& mesh, const List<particleRegion>& regions, const particlePacking& packing)
{
    // 0.49: regions side by side may round to half a spacing
    const scalar least = 0.49*packing.spacing();
    List<boundBox> bounds(regions.size());
    forAll(regions, r)
    {
        bounds[r] = boundBox(regions[r].position, true);
        bounds[r].min() -= vector::one*least;
        bounds[r].max() += vector::one*least;
    }

    const std::vector<sharedPoint> points(sharedPoints(mesh, regions, bounds, least));
    pointGrid grid(least);
    label bad = -1;
    struct { label a, b; point x; } found{0, 0, Zero};
    for (std::size_t i = 0; i < points.size() && bad < 0; ++i)
    {
        const sharedPoint& p = points[i];
        label other = -1;
        grid.near(p.position, [&](label j, const vector&, scalar) { other = j; });
        if (other >= 0)
        {
            bad = label(i);
            found = {points[other].region, p.region, p.position};
        }
        grid.insert(p.position, label(i));
    }
    const bool any = Pstream::parRun()
        ? ofLeast(bad < 0 ? noNumber : points[bad].order, bad >= 0, found) : bad >= 0;
    if (!any) return;
    FatalIOErrorInFunction(regions[found.b].dict)
        << "Regions " << regions[found.a].name << " and " << regions[found.b].name
        << " overlap at " << found.x << ": particles there are nearer than half a spacing"
        << exit(FatalIOError);
}

// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluidClip.H"
#include "allRanks.H"
#include "dividedRegion.H"
#include "fittedPacking.H"
#include "latticeRows.H"
#include "ListOps.H"
#include "pointGrid.H"

namespace Foam
{

// Layers that are moved, in spacings from the surface
static const scalar movedLayers = 4;
// Nearer than this to a solid's surface, in spacings, the start of a run refuses water
static const scalar tooNear = 0.4;


// All bodies as one
static clumpShape together(const List<fluidObstacle>& solids)
{
    DynamicList<std::shared_ptr<const clumpShape>> shapes;
    clumpShape all;
    for (const fluidObstacle& solid : solids)
    {
        if (!solid.shape) continue;
        shapes.append(solid.shape);
        all.volume += solid.shape->volume;
        all.box.add(solid.shape->box);
    }
    all.distance = [shapes](const pointField& points)
    {
        scalarField least(points.size(), GREAT);
        for (const auto& shape : shapes) least = min(least, shape->distance(points));
        return least;
    };
    return all;
}


// Part of a particle's cell that is in the bodies, by a fine lattice in it
static scalar partInside(const clumpShape& bodies, const particlePacking& packing, const point& x)
{
    const label D = packing.planar() ? 2 : 3, n = packing.planar() ? 16 : 8;
    pointField probes(D == 2 ? n*n : n*n*n, x);
    forAll(probes, i)
    {
        const label index[3] = {i % n, (i/n) % n, i/(n*n)};
        for (label d = 0; d < D; ++d)
            probes[i][packing.axis(d)] += ((index[d] + 0.5)/n - 0.5)*packing.spacing();
    }
    label in = 0;
    for (const scalar distance : bodies.distance(probes)) in += distance < 0;
    return scalar(in)/probes.size();
}


// Volume of the bodies in the region's cells, in particles
static scalar wetVolume(const clumpShape& bodies, const particlePacking& packing,
    const pointField& x, const scalarField& distance)
{
    const scalar corner = 0.5*packing.spacing()*Foam::sqrt(scalar(packing.planar() ? 2 : 3));
    scalar sum = 0;
    forAll(x, i)
    {
        if (distance[i] < -corner) sum += 1;
        else if (distance[i] < corner) sum += partInside(bodies, packing, x[i]);
    }
    return sum;
}


// What the region's lattice would be beyond its ends, outside of the bodies by less than reach and
// room. Each process looks for a share of it
static pointField beyond(const particleRegion& region, const particlePacking& packing,
    const clumpShape& bodies, scalar reach, scalar room)
{
    const label cells = label(std::ceil(reach/packing.spacing())) + 1;
    boundBox box(region.lattice), limits(bodies.box);
    for (label d = 0; d < (packing.planar() ? 2 : 3); ++d)
    {
        const direction axis = packing.axis(d);
        box.min()[axis] -= cells*packing.spacing();
        box.max()[axis] += cells*packing.spacing();
    }
    limits.min() -= reach*vector::one;
    limits.max() += reach*vector::one;
    if (packing.planar())
    {
        limits.min()[packing.axis(2)] = box.min()[packing.axis(2)] - 1;
        limits.max()[packing.axis(2)] = box.max()[packing.axis(2)] + 1;
    }
    const scalar same = 0.1*packing.spacing();
    const pointGrid own(same, region.position);
    DynamicList<point> others;
    const auto look = [&](const pointField& some)
    {
        const scalarField distance(bodies.distance(some));
        forAll(some, i)
        {
            if (distance[i] > 0 && distance[i] < reach + room
                && own.nearest(some[i], -1) >= same)
                others.append(some[i]);
        }
    };
    if (!Pstream::parRun())
    {
        look(packing.fill(box, limits));
        return pointField(std::move(others));
    }
    eachShare(latticeRows(packing, box, limits), look);
    return joinRanks(pointField(std::move(others)));
}


// Points in groups of those that are mirror images of each other across the planes through their
// centre, along the two axes that are not upright. Of four the opposite ones follow each other
static List<labelList> mirrorImages(
    const labelList& points, const pointField& x, const particlePacking& packing)
{
    const scalar same = 1e-6*packing.spacing();
    const label sides = packing.planar() ? 1 : 2;
    const direction up = packing.axis(sides);
    const point centre(average(pointField(x, points)));
    const auto away = [&](label i, label d)
    { return mag(x[i][packing.axis(d)] - centre[packing.axis(d)]); };
    const auto isPositive = [&](label i, label d)
    { return x[i][packing.axis(d)] > centre[packing.axis(d)]; };
    const auto apart = [&](label i, label j)
    {
        for (label d = 0; d < sides; ++d)
            if (mag(away(i, d) - away(j, d)) > same) return away(i, d) - away(j, d);
        return mag(x[i][up] - x[j][up]) > same ? x[i][up] - x[j][up] : scalar(0);
    };
    labelList order(points);
    std::sort(order.begin(), order.end(), [&](label i, label j)
    {
        const scalar difference = apart(i, j);
        if (difference != 0) return difference < 0;
        const bool alikeI = isPositive(i, 0) == isPositive(i, sides - 1);
        const bool alikeJ = isPositive(j, 0) == isPositive(j, sides - 1);
        if (alikeI != alikeJ) return alikeI;
        return isPositive(i, 0) != isPositive(j, 0) ? isPositive(j, 0) : i < j;
    });
    DynamicList<labelList> groups;
    forAll(order, k)
    {
        if (k == 0 || apart(order[k - 1], order[k]) != 0) groups.append(labelList());
        groups.last().append(order[k]);
    }
    return List<labelList>(std::move(groups));
}


// Those that stay when the `gone` nearest leave. Of equally near ones, of which some leave, mirror
// images leave together, evenly among the others: all from one side, as their order in memory has
// it, would let a float heel
static boolList withoutNearest(
    const scalarField& distance, const pointField& x, label gone, const particlePacking& packing)
{
    const scalar same = 1e-6*packing.spacing();
    labelList order;
    sortedOrder(distance, order);
    label first = gone, end = gone;
    if (gone > 0 && gone < order.size())
    {
        const scalar last = distance[order[gone - 1]];
        while (first > 0 && last - distance[order[first - 1]] < same) --first;
        while (end < order.size() && distance[order[end]] - last < same) ++end;
    }

    boolList stays(distance.size(), true);
    for (label i = 0; i < first; ++i) stays[order[i]] = false;
    label some = gone - first;
    if (some == 0) return stays;

    const List<labelList> images(
        mirrorImages(SubList<label>(order, end - first, first), x, packing));
    const label n = images.size(), groups = label(std::int64_t(some)*n/(end - first));
    for (label k = 0; k < groups; ++k)
    {
        const labelList& group = images[label(((2*std::int64_t(k) + 1)*n - 1)/(2*groups))];
        if (group.size() > some) continue;
        for (const label i : group) stays[i] = false;
        some -= group.size();
    }
    for (const labelList& group : images)
    {
        for (const label i : group)
        {
            if (some > 0 && stays[i])
            {
                stays[i] = false;
                --some;
            }
        }
    }
    return stays;
}


// How far from the surface something is felt: what moves, and a kernel
static scalar reachOf(const particlePacking& packing)
{
    return (movedLayers + 2.5)*packing.spacing();
}


// The `gone` nearest leave, and those left about the bodies get into layers. ghosts: from beyond.
// \return how many are moved
static label cutAndMove(particleRegion& region, const particlePacking& packing,
    const List<fluidObstacle>& solids, const clumpShape& bodies, label gone,
    const scalarField& distance, const pointField& ghosts)
{
    const scalar spacing = packing.spacing();
    region.keep(withoutNearest(distance, region.position, gone, packing));

    const scalarField left(bodies.distance(region.position));
    DynamicList<label> moved;
    DynamicList<point> held(ghosts);
    forAll(left, i)
    {
        if (left[i] < movedLayers*spacing) moved.append(i);
        else if (left[i] < reachOf(packing)) held.append(region.position[i]);
    }
    DynamicList<scalar> volume(scalarField(held.size(), scalar(1)));
    for (const fluidObstacle& solid : solids)
    {
        if (!solid.shape) continue;
        held.append(solid.centre);
        volume.append(scalarField(solid.shape->volume/packing.volume()*solid.share));
    }
    pointField points(region.position, moved);
    fittedPacking{bodies, packing, spacing, 0.5*spacing, false}.relax(
        points, pointField(std::move(held)), scalarField(std::move(volume)), false);
    forAll(moved, i) region.position[moved[i]] = points[i];
    return moved.size();
}


// Of all processes' points those not deep in the bodies and not far from them, on each process. The
// own ones among them leave the region; all deep ones leave it, too. \return how many these are
static label takeNearBodies(particleRegion& region, const scalarField& distance, scalar deep,
    scalar far, particleRegion& band)
{
    boolList near(region.size()), rest(region.size());
    int64_t gone = 0;
    forAll(near, i)
    {
        near[i] = distance[i] >= deep && distance[i] < far;
        rest[i] = distance[i] >= far;
        gone += distance[i] < deep;
    }
    band.name = region.name;
    band.lattice = region.lattice;
    band.position = region.position;
    band.velocity = region.velocity;
    band.number = region.number;
    band.keep(near);
    const label clipped = region.clipped;
    region.keep(rest);
    region.clipped = clipped;
    return label(sumOfRanks(gone));
}


// The same as on one process: all of them move the points about the bodies, and nothing else
static label cutDivided(particleRegion& region, const particlePacking& packing,
    const List<fluidObstacle>& solids, const clumpShape& bodies, label gone,
    const scalarField& distance, const polyMesh& mesh)
{
    const scalar spacing = packing.spacing(), room = 1.5*spacing;
    const scalar corner = 0.5*spacing*Foam::sqrt(scalar(packing.planar() ? 2 : 3));
    particleRegion band;
    const label deep = takeNearBodies(region, distance, -corner - 1e-3*spacing,
        reachOf(packing) + room + 0.5*spacing, band);
    const List<std::int64_t> former(band.number);
    gatherPoints(band);
    const pointField ghosts(beyond(band, packing, bodies, reachOf(packing), room));
    band.clipped = 0;
    const label moved = cutAndMove(band, packing, solids, bodies, gone - deep,
        bodies.distance(band.position), ghosts);
    takeBand(mesh, band, former, region);
    if (Pstream::master()) region.clipped += gone;
    return moved;
}


static void clipAtShapes(particleRegion& region, const particlePacking& packing,
    const List<fluidObstacle>& solids, const polyMesh& mesh)
{
    const clumpShape bodies(together(solids));
    const scalarField distance(bodies.distance(region.position));
    // Of whole probes: the same sum in any order
    const scalar wet =
        returnReduce(wetVolume(bodies, packing, region.position, distance), sumOp<scalar>());
    const label gone = label(std::lround(wet));
    if (wet == 0) return;

    const label moved = Pstream::parRun()
        ? cutDivided(region, packing, solids, bodies, gone, distance, mesh)
        : cutAndMove(region, packing, solids, bodies, gone, distance,
              beyond(region, packing, bodies, reachOf(packing), GREAT));
    const scalar cell = packing.volume();
    Info<< "    " << region.name << ": cut at solids, " << gone << " particles of " << gone*cell
        << " m3" << (packing.planar() ? " per metre" : "") << " for " << wet*cell
        << " of the bodies in it; " << moved << " moved into layers about them" << nl;
}


// Where no shape is known, or no lattice
static void clipAtParticles(
    particleRegion& region, const particlePacking& packing, const fluidObstacle& solid, bool shaped)
{
    const scalar least = tooNear*packing.spacing();
    boolList good(region.size(), true);
    if (shaped)
    {
        const scalarField distance(solid.shape->distance(region.position));
        forAll(good, i) good[i] = distance[i] >= least;
    }
    else
    {
        const pointGrid centres(max(solid.radius) + least, solid.centre);
        forAll(good, i)
        {
            centres.near(region.position[i],
                [&](label s, const vector&, scalar distance)
                {
                    if (distance < solid.radius[s] + least) good[i] = false;
                });
        }
    }
    const label before = region.size();
    region.keep(good);
    const int64_t gone = sumOfRanks(before - region.size());
    if (gone == 0) return;
    Info<< "    " << region.name << ": cut at solids " << solid.name << ", "
        << gone << " particles of " << gone*packing.volume() << " m3"
        << (packing.planar() ? " per metre" : "") << ", without layers about them" << nl;
}

} // namespace Foam


void Foam::clipAtSolids(
    particleRegion& region,
    const particlePacking& packing,
    const List<fluidObstacle>& solids,
    const polyMesh& mesh)
{
    const bool fits = region.regular && packing.square();
    bool any = false;
    for (const fluidObstacle& solid : solids)
    {
        if (fits && solid.shape) any = true;
        else clipAtParticles(region, packing, solid, bool(solid.shape));
    }
    if (any) clipAtShapes(region, packing, solids, mesh);
}

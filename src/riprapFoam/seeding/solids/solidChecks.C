// SPDX-License-Identifier: GPL-3.0-or-later
/*  Are bodies where they can be, and clear of walls and of each other? */

#include "solidRegions.H"
#include "clipOrStop.H"
#include "dividedCloud.H"
#include "HashSet.H"
#include "labelPair.H"
#include "listed.H"
#include "pointGrid.H"
#include "sceneCloud.H"
#include "wallPoints.H"
#include "wallSurface.H"
#include "wholeBoundary.H"

namespace Foam
{

// Deeper in a wall than the tolerance allows?
static boolList clearOf
(
    solidRegion& region,
    const wallSpace& space,
    const wallElements& elements,
    scalar tolerance
)
{
    boolList good(region.size(), true);
    if (elements.elements.empty() || good.empty()) return good;

    const wallSurface surface(space, elements, 1);
    const scalarField distance(surface.distance(region.position));
    forAll(good, i)
    {
        good[i] = distance[i] > (1 - tolerance)*region.radius[i];
        region.wallGap = min(region.wallGap, distance[i] - region.radius[i]);
    }
    return good;
}

} // namespace Foam


void Foam::checkSolidPlace(solidRegion& region, const solidSpace& space, scalar tolerance)
{
    const demWalls& walls = space.settings.walls;
    if (region.size() == 0) return;

    // Each process has all of them
    clipOrStop(region, inAnyCell(space.mesh, region.position), "outside the mesh");

    for (label b = 0; space.bodies && b < space.bodies->size() && region.size(); ++b)
    {
        boolList good(space.bodies->inSolid(b, region.position));
        for (bool& g : good) g = !g;
        clipOrStop(
            region, good, "in the solid " + space.bodies->names()[b] + " of constant/geometry");
    }

    const polyMesh& boundary = wholeBoundary(space.mesh);
    const labelList patches
    (
        walls.everyWallPatch
      ? wallPatches(boundary)
      : wallPatches(boundary, walls.patches, walls.dict)
    );
    wallPointsControls controls;
    controls.spacing = region.size() ? 2*min(region.radius) : 1;
    const wallSpace surfaces(boundary, controls);
    clipOrStop
    (
        region,
        clearOf(region, surfaces, patchElements(surfaces, patches), tolerance),
        "in the mesh's walls by more than overlapTolerance"
    );
    for (label b = 0; space.bodies && b < space.bodies->size(); ++b)
    {
        clipOrStop
        (
            region,
            clearOf(region, surfaces, bodyElements(surfaces, *space.bodies, b, 0), tolerance),
            "in the surface " + space.bodies->names()[b] + " by more than overlapTolerance"
        );
    }
    for (const auto& plane : walls.planes)
    {
        const point x(plane.second().get<point>("point"));
        const vector n(normalised(plane.second().get<vector>("normal")));
        boolList good(region.size());
        forAll(good, i)
        {
            const scalar distance = (region.position[i] - x) & n;
            good[i] = distance > (1 - tolerance)*region.radius[i];
            region.wallGap = min(region.wallGap, distance - region.radius[i]);
        }
        clipOrStop(region, good, "behind the plane " + plane.first() + " or in it");
    }
}


void Foam::checkSolidOverlap
(
    const List<solidRegion>& regions,
    const solidSet& all,
    const riprap::DemBondState& bonds,
    const riprap::DemConfig& config,
    scalar tolerance
)
{
    HashSet<labelPair, labelPair::Hash<>> bonded;
    for (std::size_t i = 0; i < bonds.a.size(); ++i)
    {
        bonded.insert(labelPair(min(bonds.a[i], bonds.b[i]), max(bonds.a[i], bonds.b[i])));
    }

    DynamicList<label> owner;
    forAll(regions, r) owner.append(labelList(regions[r].size(), r));

    const auto& p = all.particles;
    const vectorField x(toVectors(p.position));
    scalar largest = 0;
    for (const double R : p.radius) largest = max(largest, R);
    pointGrid grid(2*largest, x);
    grid.repeat(config);

    forAll(x, i)
    {
        label other = -1;
        scalar way = 0;
        grid.nearOrImage
        (
            x[i],
            [&](label j, const vector&, scalar distance)
            {
                const scalar allowed = tolerance*min(p.radius[i], p.radius[j]);
                const bool together = p.clump.size() && p.clump[i] >= 0 && p.clump[i] == p.clump[j];
                if (j < i && distance < p.radius[i] + p.radius[j] - allowed && !together
                    && !bonded.found(labelPair(j, i)))
                {
                    other = j;
                    way = distance;
                }
            }
        );
        if (other < 0) continue;
        FatalIOErrorInFunction(regions[owner[i]].dict)
            << "Particles overlap at the start: one of region " << regions[owner[other]].name
            << " at " << x[other] << " and one of region " << regions[owner[i]].name << " at "
            << x[i] << ", by " << p.radius[i] + p.radius[other] - way
            << " m; overlapTolerance allows " << tolerance << " of the smaller radius"
            << exit(FatalIOError);
    }
}



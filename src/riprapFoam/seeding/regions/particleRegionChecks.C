// SPDX-License-Identifier: GPL-3.0-or-later
/*  Are the particles of a region where fluid can be, and clear of each other? */

#include "particleRegions.H"
#include "clipOrStop.H"
#include "particleCloudIO.H"
#include "pointGrid.H"


void Foam::checkPlace
(
    particleRegion& region,
    const particlePacking& packing,
    const regionSpace& space
)
{
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
        clipOrStop(
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
    word wall;
    forAll(good, i)
    {
        if (found[i] < 0) continue;
        if (wall.empty()) wall = space.walls.names[space.walls.source[found[i]]];
        good[i] = false;
    }
    clipOrStop(region, good, "too near to wall " + wall + " (or others)");
}


void Foam::checkOverlap(const List<particleRegion>& regions, const particlePacking& packing)
{
    // 0.49: regions side by side may round to half a spacing
    const scalar least = 0.49*packing.spacing();
    pointGrid grid(least);
    DynamicList<label> owner;

    List<boundBox> bounds(regions.size());
    forAll(regions, r)
    {
        bounds[r] = boundBox(regions[r].position, false);
        bounds[r].min() -= vector::one*least;
        bounds[r].max() += vector::one*least;
    }
    // Only particles that another region's can reach
    auto shared = [&](label r, const point& x)
    {
        forAll(bounds, other)
        {
            if (other != r && bounds[other].contains(x)) return true;
        }
        return !regions[r].regular;
    };

    forAll(regions, r)
    {
        for (const point& x : regions[r].position)
        {
            if (!shared(r, x)) continue;
            label other = -1;
            grid.near(x, [&](label i, const vector&, scalar) { other = i; });
            if (other >= 0)
            {
                const word& name = regions[owner[other]].name;
                FatalIOErrorInFunction(regions[r].dict)
                    << "Regions " << name << " and " << regions[r].name << " overlap at " << x
                    << ": particles there are nearer than half a spacing" << exit(FatalIOError);
            }
            grid.insert(x, owner.size());
            owner.append(r);
        }
    }
}

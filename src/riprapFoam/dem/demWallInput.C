/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Walls that solids touch: triangles (3D) or segments (2D) of the mesh's
    patches and of constant/geometry, and planes.
\*---------------------------------------------------------------------------*/

#include "checkedDictionary.H"
#include "demInput.H"
#include "listed.H"
#include "wallSurface.H"
#include "wallPoints.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- That of the first entry that names the wall literally, else of the first
//  pattern, else the one for all
static label materialOf
(
    const word& name,
    const demSettings& settings,
    labelHashSet& used
)
{
    const auto& materials = settings.walls.materials;
    for (const bool pattern : {false, true})
    {
        forAll(materials, i)
        {
            const wordRe& key = materials[i].first();
            if (key.isPattern() == pattern && key.match(name))
            {
                used.insert(i);
                return settings.material
                (
                    materials[i].second(),
                    settings.walls.dict
                );
            }
        }
    }

    if (settings.walls.material.empty())
    {
        FatalIOErrorInFunction(settings.dict)
            << "Entry walls: wall " << name << " has no material: walls {"
            << " material <name>; } for all, or materials { " << name
            << " <name>; }; valid are "
            << listed(settings.materialNames()).c_str() << exit(FatalIOError);
    }
    return settings.material(settings.walls.material, settings.walls.dict);
}


//- Elements of one source, their points numbered from 0
static void addElements
(
    const wallElements& all,
    label source,
    bool planar,
    riprap::DemWall& wall
)
{
    labelList number(all.points.size(), -1);
    forAll(all.elements, e)
    {
        if (all.source[e] != source) continue;

        for (label v = 0; v < (planar ? 2 : 3); ++v)
        {
            const label p = all.elements[e][v];
            if (number[p] < 0)
            {
                number[p] = wall.vertices.size()/3;
                for (direction d = 0; d < vector::nComponents; ++d)
                {
                    wall.vertices.push_back(all.points[p][d]);
                }
            }
            wall.elements.push_back(number[p]);
        }
    }
}


static riprap::DemWall plane
(
    const word& name,
    const dictionary& entries,
    const riprap::DemConfig& config
)
{
    checkedDictionary dict(entries);
    dict.found("point");
    dict.found("normal");
    const point x(entries.get<point>("point"));
    vector n(entries.get<vector>("normal"));
    dict.end();

    if (config.dimensions == 2)
    {
        n[config.axes[2]] = 0;
    }
    if (!(mag(n) > SMALL))
    {
        FatalIOErrorInFunction(entries)
            << "Entry normal of plane " << name << " is "
            << entries.get<vector>("normal") << ": it needs a length"
            << (config.dimensions == 2 ? " in the plane of this 2D case" : "")
            << exit(FatalIOError);
    }

    riprap::DemWall wall;
    wall.name = name;
    wall.plane = true;
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        wall.point[d] = x[d];
        wall.normal[d] = n[d]/mag(n);
    }
    return wall;
}


static void requireUsed(const demWalls& walls, const labelHashSet& used, const wordList& names)
{
    forAll(walls.materials, i)
    {
        if (!used.found(i))
        {
            FatalIOErrorInFunction(walls.dict)
                << "Entry materials: " << walls.materials[i].first()
                << " selects no wall; valid are " << listed(names).c_str()
                << exit(FatalIOError);
        }
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::vector<riprap::DemWall> Foam::demWallInput
(
    const polyMesh& mesh,
    const demSettings& settings,
    const geometryWalls* geometry,
    const wallBodies& bodies,
    scalar size
)
{
    const demWalls& asked = settings.walls;
    const labelList patches
    (
        asked.everyWallPatch
      ? wallPatches(mesh)
      : wallPatches(mesh, asked.patches, asked.dict)
    );

    wallPointsControls controls;
    controls.spacing = size;
    const wallSpace space(mesh, controls);

    std::vector<riprap::DemWall> walls;
    const wallElements ofPatches(patchElements(space, patches));
    forAll(patches, i)
    {
        walls.emplace_back();
        walls.back().name = mesh.boundaryMesh()[patches[i]].name();
        addElements(ofPatches, i, space.planar, walls.back());
    }
    for (label i = 0; geometry && i < geometry->size(); ++i)
    {
        walls.emplace_back();
        walls.back().name = geometry->names()[i];
        addElements(bodyElements(space, *geometry, i, 0), 0, space.planar, walls.back());
    }
    for (const auto& p : asked.planes)
    {
        walls.push_back(plane(p.first(), p.second(), settings.config));
    }

    wordList names;
    for (const riprap::DemWall& wall : walls)
    {
        names.append(word(wall.name, false));
    }
    const labelList bodyOfWall(bodies.bodyOf(names));
    labelHashSet used;
    forAll(names, i)
    {
        walls[i].material = materialOf(names[i], settings, used);
        walls[i].motion = bodyOfWall[i];
    }
    requireUsed(asked, used, names);

    return walls;
}


void Foam::markWalledSides
(
    const polyMesh& mesh,
    const std::vector<riprap::DemWall>& walls,
    riprap::DemConfig& config
)
{
    wordHashSet fixed;
    for (const riprap::DemWall& wall : walls)
    {
        if (wall.motion < 0) fixed.insert(word(wall.name, false));
    }

    const boundBox& box = mesh.bounds();
    const scalar tolerance = 1e-6*box.mag();
    for (direction axis = 0; axis < vector::nComponents; ++axis)
    {
        for (const int side : {0, 1})
        {
            const scalar end = side ? box.max()[axis] : box.min()[axis];
            label walled = 0;
            label open = 0;
            for (const polyPatch& patch : mesh.boundaryMesh())
            {
                label there = 0;
                for (const face& f : patch)
                {
                    bool all = true;
                    for (const label v : f)
                        all = all && mag(mesh.points()[v][axis] - end) < tolerance;
                    there += all;
                }
                (fixed.found(patch.name()) ? walled : open) += there;
            }
            config.walled[axis][side] = walled && !open;
        }
    }
}


// ************************************************************************* //

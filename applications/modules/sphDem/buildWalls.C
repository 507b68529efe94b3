/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Wall points from the mesh's patches and constant/geometry; which of them
    move with which body.
\*---------------------------------------------------------------------------*/

#include "sphDem.H"
#include "sweptDomain.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

riprap::WallInput Foam::solverModules::sphDem::buildWalls
(
    otherSpeeds& others
)
{
    const sphWalls& walls = settings_.walls;

    const labelList patches
    (
        walls.everyWallPatch
      ? wallPatches(mesh_)
      : wallPatches(mesh_, walls.patches, walls.dict)
    );
    const autoPtr<geometryWalls> geometry(wallGeometry(runTime_));

    wallPointsControls controls;
    controls.spacing = settings_.config.wallSpacing;
    controls.layers = wallLayers(settings_);

    walls_ = generateWallPoints(mesh_, patches, geometry.get(), controls);

    const labelList bodyOfSource(bodies_.bodyOf(walls_.names));
    labelList bodyOfPoint(walls_.size());

    riprap::WallInput input;
    input.nBodies = bodies_.size();
    input.position.reserve(3*walls_.size());
    input.normal.reserve(3*walls_.size());
    input.body.reserve(walls_.size());

    forAll(walls_.position, i)
    {
        for (direction d = 0; d < vector::nComponents; ++d)
        {
            input.position.push_back(walls_.position[i][d]);
            input.normal.push_back(walls_.normal[i][d]);
        }
        bodyOfPoint[i] = bodyOfSource[walls_.source[i]];
        input.body.push_back(bodyOfPoint[i]);
    }

    coverMotion(bodyOfPoint, others);

    return input;
}


//- Widen the domain to what moving walls reach; how fast they are, and how deep
//  they take water
void Foam::solverModules::sphDem::coverMotion
(
    const labelList& bodyOfPoint,
    otherSpeeds& others
)
{
    List<boundBox> reference(bodies_.size());
    forAll(bodyOfPoint, i)
    {
        if (bodyOfPoint[i] >= 0)
        {
            reference[bodyOfPoint[i]].add(walls_.position[i]);
        }
    }
    Foam::coverMotion
    (
        mesh_,
        bodies_,
        reference,
        wallThickness(settings_),
        settings_.config
    );

    const riprap::Vector3& gravity = settings_.config.gravity;
    const vector g(gravity[0], gravity[1], gravity[2]);
    const auto depth = [&](const boundBox& box)
    {
        return max(box.points()() & g);
    };
    const scalar floor = lowestPlace(mesh_, g);
    const scalar begin = runTime_.value();
    const scalar end = endOfMotion(runTime_);
    forAll(reference, body)
    {
        boundBox swept(reference[body]);
        if (swept.empty())
        {
            continue;
        }
        others.walls = max
        (
            others.walls,
            bodies_.largestSpeed(body, reference[body], begin, end)
        );
        bodies_.sweep(body, reference[body], begin, end, swept);
        const scalar before = depth(reference[body]);
        others.deeper = max
        (
            others.deeper,
            min(before - floor, scalar(0)) + depth(swept) - before
        );
    }
}


void Foam::solverModules::sphDem::writeWalls()
{
    if (!wallsWritten_ && walls_.size())
    {
        // Where setParticles writes them, too
        writeWallPoints(walls_, runTime_.path()/"VTK"/"walls.vtp");
        wallsWritten_ = true;
    }
}


// ************************************************************************* //

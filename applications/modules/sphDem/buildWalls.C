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

riprap::WallInput Foam::solverModules::sphDem::buildWalls()
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

    coverMotion(bodyOfPoint);

    return input;
}


void Foam::solverModules::sphDem::coverMotion(const labelList& bodyOfPoint)
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

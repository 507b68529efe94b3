/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Wall points from the mesh's patches and constant/geometry; which of them
    move with which body.
\*---------------------------------------------------------------------------*/

#include "sphDem.H"

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


//- A wall that retreats beyond the mesh takes its fluid along: widen the
//  domain to all that the bodies reach until endTime
void Foam::solverModules::sphDem::coverMotion(const labelList& bodyOfPoint)
{
    riprap::SphConfig& config = settings_.config;
    const scalar margin = wallThickness(settings_);

    // stopAt other than endTime: endTime is not known
    const scalar begin = runTime_.value();
    const scalar end =
        max(begin, runTime_.controlDict().getOrDefault<scalar>("endTime", begin));

    for (label body = 0; body < bodies_.size(); ++body)
    {
        boundBox reference;
        forAll(bodyOfPoint, i)
        {
            if (bodyOfPoint[i] == body)
            {
                reference.add(walls_.position[i]);
            }
        }

        boundBox swept;
        bodies_.sweep(body, reference, begin, end, swept);

        const direction empty = config.axes[2];
        if
        (
            config.dimensions == 2
         && mag(swept.span()[empty] - reference.span()[empty])
          > 1e-6*mesh_.bounds().mag()
        )
        {
            FatalIOErrorInFunction(settings_.walls.dict)
                << "Motion " << bodies_.name(body) << " leaves the plane of"
                << " this 2D case: " << vector::componentNames[empty]
                << " is its empty direction" << exit(FatalIOError);
        }

        for (int i = 0; i < config.dimensions; ++i)
        {
            const int axis = config.axes[i];
            if (!config.periodic[axis])
            {
                config.domainMin[axis] =
                    min(config.domainMin[axis], swept.min()[axis] - margin);
                config.domainMax[axis] =
                    max(config.domainMax[axis], swept.max()[axis] + margin);
            }
        }
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

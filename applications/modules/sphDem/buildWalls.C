/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Wall points from the mesh's patches and constant/geometry; which of them
    move with which body.
\*---------------------------------------------------------------------------*/

#include "sphDem.H"
#include "UIndirectList.H"
#include "toStdVector.H"
#include "sweptDomain.H"
#include "wholeBoundary.H"
#include "solvers/sph/sphModels.hpp"

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
    controls.where = settings_.walls.dict;

    walls_ = generateWallPoints(mesh_, patches, geometry.get(), controls);

    const labelList bodyOfSource(bodies_.bodyOf(walls_.names));
    dropBeyondDomain(bodyOfSource);
    labelList bodyOfPoint(walls_.size());

    riprap::WallInput input;
    input.nBodies = bodies_.size();
    input.position.reserve(3*walls_.size());
    input.normal.reserve(3*walls_.size());
    input.body.reserve(walls_.size());
    input.part.reserve(walls_.size());

    forAll(walls_.position, i)
    {
        for (direction d = 0; d < vector::nComponents; ++d)
        {
            input.position.push_back(walls_.position[i][d]);
            input.normal.push_back(walls_.normal[i][d]);
        }
        bodyOfPoint[i] = bodyOfSource[walls_.source[i]];
        input.body.push_back(bodyOfPoint[i]);
        input.part.push_back(walls_.source[i]);
    }

    coverMotion(bodyOfPoint, others);
    if (settings_.walls.impermeable)
    {
        input.faces = wallFaceInput(bodyOfSource);
    }

    return input;
}


riprap::WallFaceInput Foam::solverModules::sphDem::wallFaceInput
(
    const labelList& bodyOfSource
) const
{
    const wallFaces& from = walls_.faces;

    riprap::WallFaceInput faces;
    faces.point = toStdVector("walls", "faces", pointField(from.points));
    forAll(from.elements, i)
    {
        for (direction d = 0; d < vector::nComponents; ++d)
        {
            faces.vertex.push_back(from.elements[i][d]);
            faces.normal.push_back(from.normal[i][d]);
        }
        faces.body.push_back(bodyOfSource[from.source[i]]);
        faces.part.push_back(from.part[i]);
        faces.halfThickness.push_back(from.halfThickness[i]);
    }
    return faces;
}


//- Surfaces of constant/geometry may stick out of the mesh: fixed points
//  that no fluid can come near are left out
void Foam::solverModules::sphDem::dropBeyondDomain
(
    const labelList& bodyOfSource
)
{
    const riprap::SphConfig& config = settings_.config;
    const scalar margin = riprap::supportOf(config);

    const auto beyond = [&](const point& x)
    {
        for (int k = 0; k < config.dimensions; ++k)
        {
            const int axis = config.axes[k];
            if
            (
                !config.periodic[axis]
             && (
                    x[axis] < config.domainMin[axis] - margin
                 || x[axis] > config.domainMax[axis] + margin
                )
            )
            {
                return true;
            }
        }
        return false;
    };

    DynamicList<label> kept(walls_.size());
    forAll(walls_.position, i)
    {
        const bool moves = bodyOfSource[walls_.source[i]] >= 0;
        if (moves || !beyond(walls_.position[i]))
        {
            kept.append(i);
        }
    }
    if (kept.size() == walls_.size())
    {
        return;
    }
    walls_.position = pointField(walls_.position, kept);
    walls_.normal = vectorField(walls_.normal, kept);
    walls_.source = labelList(UIndirectList<label>(walls_.source, kept));
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
        wholeBoundary(mesh_),
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
    const scalar floor = lowestPlace(wholeBoundary(mesh_), g);
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
        if (Pstream::master())
        {
            writeWallPoints(walls_, runTime_.globalPath()/"VTK"/"walls.vtp");
        }
        wallsWritten_ = true;
    }
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fluidWalls.H"
#include "UIndirectList.H"
#include "toStdVector.H"
#include "sweptDomain.H"
#include "wholeBoundary.H"
#include "solvers/sph/sphModels.hpp"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

riprap::WallFaceInput Foam::fluidWalls::faceInput
(
    const labelList& bodyOfSource
) const
{
    const wallFaces& from = points_.faces;

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
void Foam::fluidWalls::dropBeyondDomain
(
    const riprap::SphConfig& config,
    const labelList& bodyOfSource
)
{
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

    DynamicList<label> kept(points_.size());
    forAll(points_.position, i)
    {
        const bool moves = bodyOfSource[points_.source[i]] >= 0;
        if (moves || !beyond(points_.position[i]))
        {
            kept.append(i);
        }
    }
    if (kept.size() == points_.size())
    {
        return;
    }
    points_.position = pointField(points_.position, kept);
    points_.normal = vectorField(points_.normal, kept);
    points_.source = labelList(UIndirectList<label>(points_.source, kept));
}


//- Widen the domain to what moving walls reach; how fast they are, and how deep
//  they take water
void Foam::fluidWalls::coverMotion
(
    const labelList& bodyOfPoint,
    sphSettings& settings,
    otherSpeeds& others
) const
{
    List<boundBox> reference(bodies_.size());
    forAll(bodyOfPoint, i)
    {
        if (bodyOfPoint[i] >= 0)
        {
            reference[bodyOfPoint[i]].add(points_.position[i]);
        }
    }
    Foam::coverMotion
    (
        wholeBoundary(mesh_),
        bodies_,
        reference,
        wallThickness(settings),
        settings.config
    );

    const riprap::Vector3& gravity = settings.config.gravity;
    const vector g(gravity[0], gravity[1], gravity[2]);
    const auto depth = [&](const boundBox& box)
    {
        return max(box.points()() & g);
    };
    const scalar floor = lowestPlace(wholeBoundary(mesh_), g);
    const scalar begin = time_.value();
    const scalar end = endOfMotion(time_);
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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fluidWalls::fluidWalls
(
    const Time& time,
    const polyMesh& mesh,
    const List<wallMotion>& motion
)
:
    time_(time),
    mesh_(mesh),
    bodies_(time, motion)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

riprap::WallInput Foam::fluidWalls::build
(
    sphSettings& settings,
    otherSpeeds& others
)
{
    const sphWalls& walls = settings.walls;

    const labelList patches
    (
        walls.everyWallPatch
      ? wallPatches(mesh_)
      : wallPatches(mesh_, walls.patches, walls.dict)
    );
    const autoPtr<geometryWalls> geometry(wallGeometry(time_));

    wallPointsControls controls;
    controls.spacing = settings.config.wallSpacing;
    controls.layers = wallLayers(settings);
    controls.where = walls.dict;

    points_ = generateWallPoints(mesh_, patches, geometry.get(), controls);

    const labelList bodyOfSource(bodies_.bodyOf(points_.names));
    dropBeyondDomain(settings.config, bodyOfSource);
    labelList bodyOfPoint(points_.size());

    riprap::WallInput input;
    input.nBodies = bodies_.size();
    input.position.reserve(3*points_.size());
    input.normal.reserve(3*points_.size());
    input.body.reserve(points_.size());
    input.part.reserve(points_.size());

    forAll(points_.position, i)
    {
        for (direction d = 0; d < vector::nComponents; ++d)
        {
            input.position.push_back(points_.position[i][d]);
            input.normal.push_back(points_.normal[i][d]);
        }
        bodyOfPoint[i] = bodyOfSource[points_.source[i]];
        input.body.push_back(bodyOfPoint[i]);
        input.part.push_back(points_.source[i]);
    }

    coverMotion(bodyOfPoint, settings, others);
    if (walls.impermeable)
    {
        input.faces = faceInput(bodyOfSource);
    }

    return input;
}


void Foam::fluidWalls::write()
{
    if (!written_ && points_.size())
    {
        // Where setParticles writes them, too
        if (Pstream::master())
        {
            writeWallPoints(points_, time_.globalPath()/"VTK"/"walls.vtp");
        }
        written_ = true;
    }
}


// ************************************************************************* //

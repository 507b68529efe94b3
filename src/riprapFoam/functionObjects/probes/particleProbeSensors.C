/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    particleProbes: where sensors are, and which way their faces look
\*---------------------------------------------------------------------------*/

#include "particleProbes.H"

namespace
{
    // Nearer to a wall than this centroid's distance, in spacings, a probe counts as on it
    constexpr double onWall = 0.1;
}


Foam::pointField Foam::functionObjects::particleProbes::placed
(
    const riprap::WallPose& pose,
    const pointField& points
)
{
    pointField now(points.size());
    forAll(points, i)
    {
        now[i] = toVector(riprap::placed(pose, toVector3(points[i])));
    }
    return now;
}


Foam::vectorField Foam::functionObjects::particleProbes::turned
(
    const riprap::WallPose& pose,
    const vectorField& normals
)
{
    vectorField now(normals.size());
    forAll(normals, i)
    {
        now[i] = toVector(riprap::turned(pose, toVector3(normals[i])));
    }
    return now;
}


void Foam::functionObjects::particleProbes::readBody(const dictionary& dict)
{
    // Solids: from the pose now where the dictionary was edited, else from that of the run which is
    // continued
    const bool same = body_.ofSolids() && body_.name() == dict.lookupOrDefault("body", word::null);
    scalarList before;
    if (same)
    {
        before = gaugeBody::state(body_.pose());
    }

    body_.find(dict, name());
    if (!same && body_.ofSolids()) before = saved(poseProperty());
    body_.begin(dict, before);
}


void Foam::functionObjects::particleProbes::requireInside(const dictionary& dict)
{
    const pointField now(placed(body_.pose(), locations_));

    forAll(now, i)
    {
        if (!reach().contains(now[i]))
        {
            FatalIOErrorInFunction(dict)
                << "Entry probeLocations of function object " << name()
                << ": probe " << i << " at " << now[i]
                << " is outside of the mesh, which spans "
                << mesh_.bounds().min() << " to " << mesh_.bounds().max()
                << exit(FatalIOError);
        }
    }
}


Foam::vector Foam::functionObjects::particleProbes::sensorNormal
(
    const dictionary& dict,
    const vector& offset,
    const label i
) const
{
    const vector given(dict.lookupOrDefault("sensorNormal", vector(Zero)));
    vector normal(mag(given) > 0 ? given : offset);

    if (mag(given) == 0 && mag(normal) < onWall*fluid().fluidConfig().spacing)
    {
        FatalIOErrorInFunction(dict)
            << "Entry sensorNormal of function object " << name()
            << " is missing: probe " << i << " at " << locations_[i]
            << (
                   body_.ofSolids()
                 ? " rides on solids"
                 : " has a sensorRadius and is on no wall"
               )
            << exit(FatalIOError);
    }

    if (mesh_.nGeometricD() == 2)
    {
        normal[fluid().fluidConfig().axes[2]] = 0;
    }
    if (mag(normal) < 0.1*mag(given))
    {
        FatalIOErrorInFunction(dict)
            << "Entry sensorNormal of function object " << name() << ": "
            << given << " is across the plane of the 2D mesh"
            << exit(FatalIOError);
    }

    return normal/mag(normal);
}


void Foam::functionObjects::particleProbes::makeSensors(const dictionary& dict)
{
    const scalar radius = notNegative(dict, "sensorRadius", 0);
    const bool given = dict.found("sensorNormal");
    const riprap::WallPose pose(body_.pose());

    if (onGrid() && given && !(radius > 0))
    {
        FatalIOErrorInFunction(dict)
            << "Entry sensorNormal of function object " << name()
            << " needs a sensorRadius where water is on a grid"
            << exit(FatalIOError);
    }

    vector empty(Zero);
    if (mesh_.nGeometricD() == 2)
    {
        empty[fluid().fluidConfig().axes[2]] = 1;
    }

    sensors_.resize(locations_.size());
    walls_.reset(true);
    if (!onGrid())
    {
        walls_.update(sph(), placed(pose, locations_));
    }
    points_.clear();
    normals_.clear();

    forAll(locations_, i)
    {
        sensors_[i] = sensorDisc{pointField(1, locations_[i]), scalarField(1, 1.0)};

        if (radius > 0 || given || (body_.ofSolids() && !onGrid()))
        {
            const vector offset
            (
                onGrid() || body_.ofSolids()
              ? vector(Zero)
              : toVector(riprap::turnedBack(pose, toVector3(walls_.offset(i))))
            );
            const vector normal(sensorNormal(dict, offset, i));

            if (radius > 0)
            {
                sensors_[i] = makeSensorDisc(locations_[i], normal, empty, radius);
            }
            if (given)
            {
                normals_.append(vectorField(sensors_[i].points.size(), normal));
            }
        }
        points_.append(sensors_[i].points);
    }

    walls_.reset(true);
}

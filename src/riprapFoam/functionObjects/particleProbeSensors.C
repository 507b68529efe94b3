/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    particleProbes: the faces of round sensors
\*---------------------------------------------------------------------------*/

#include "particleProbes.H"

namespace
{
    // Nearer to a wall than this centroid's distance, in spacings, a probe counts as on it
    constexpr double onWall = 0.1;
}


Foam::vector Foam::functionObjects::particleProbes::sensorNormal
(
    const dictionary& dict,
    const label i
) const
{
    const vector given(dict.lookupOrDefault("sensorNormal", vector(Zero)));
    vector normal(mag(given) > 0 || onGrid() ? given : walls_.offset(i));

    if (mag(given) == 0 && mag(normal) < onWall*fluid().fluidConfig().spacing)
    {
        FatalIOErrorInFunction(dict)
            << "Entry sensorNormal of function object " << name()
            << " is missing: probe " << i << " at " << locations_[i]
            << " has a sensorRadius and is on no wall" << exit(FatalIOError);
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
    vector empty(Zero);

    if (mesh_.nGeometricD() == 2)
    {
        empty[fluid().fluidConfig().axes[2]] = 1;
    }

    sensors_.resize(locations_.size());
    walls_.reset(mesh_);
    if (!onGrid())
    {
        walls_.update(sph(), locations_);
    }
    points_.clear();

    forAll(locations_, i)
    {
        sensors_[i] =
            radius > 0
          ? makeSensorDisc(locations_[i], sensorNormal(dict, i), empty, radius)
          : sensorDisc{pointField(1, locations_[i]), scalarField(1, 1.0)};

        points_.append(sensors_[i].points);
    }

    walls_.reset(mesh_);
}

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The fluid's particles of the current time.
\*---------------------------------------------------------------------------*/

#include "sphDem.H"
#include "packedFields.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

Foam::particleCloud Foam::solverModules::sphDem::readFluid() const
{
    requireCloud(mesh_, "fluid");
    particleCloud cloud(readParticleCloud(mesh_, "fluid"));

    if (cloud.size() == 0)
    {
        FatalErrorInFunction
            << "The cloud " << runTime_.timePath()/"lagrangian/fluid"
            << " is empty" << exit(FatalError);
    }

    requiredVectors(mesh_, cloud, "U");

    if (!cloud.labels.found("id"))
    {
        cloud.labels.set("id", labelField(identity(cloud.size())));
    }

    return cloud;
}


riprap::FluidInput Foam::solverModules::sphDem::fluidInput
(
    const particleCloud& cloud
) const
{
    const riprap::SphConfig& config = settings_.config;

    riprap::FluidInput fluid;
    fluid.position = packed("fluid", "positions", cloud.position);
    fluid.velocity = packed("fluid", "U", requiredVectors(mesh_, cloud, "U"));
    fluid.id = uniqueIds("fluid", "id", cloud.labels["id"]);

    // Densities are those of the speed of sound at which they were written:
    // at another one particles keep their pressure
    const scalar c0 = readCloudProperties(runTime_, "fluid")
        .getOrDefault<scalar>("soundSpeed", config.soundSpeed);
    const bool stiffer = mag(c0 - config.soundSpeed) > 1e-9*config.soundSpeed;

    // Density, else from pressure, else at rest
    fluid.density.assign(cloud.size(), config.density);
    if (cloud.scalars.found("rho"))
    {
        const scalarField& rho = cloud.scalars["rho"];
        forAll(rho, i)
        {
            requirePositive("fluid", "rho", i, rho[i]);
            fluid.density[i] = stiffer
              ? densityOfPressure(config, pressureOfDensity(config, rho[i], c0))
              : rho[i];
        }
    }
    else if (cloud.scalars.found("p"))
    {
        const scalarField& p = cloud.scalars["p"];
        forAll(p, i)
        {
            requireFinite("fluid", "p", i, p[i]);
            fluid.density[i] = densityOfPressure(config, p[i]);
        }
    }

    return fluid;
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The fluid's particles of the current time.
\*---------------------------------------------------------------------------*/

#include "sphDem.H"
#include "dividedCloud.H"
#include "toStdVector.H"
#include "sceneState.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

Foam::particleCloud Foam::solverModules::sphDem::readFluid() const
{
    particleCloud cloud(readWholeCloud(mesh_, "fluid"));

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

    // Processors have each some: the order of one process is that of ids
    if (Pstream::parRun()) sortByLabel(cloud, "id");

    return cloud;
}


riprap::FluidInput Foam::solverModules::sphDem::fluidInput
(
    const particleCloud& cloud
) const
{
    const riprap::SphConfig& config = settings_.config;

    riprap::FluidInput fluid;
    fluid.position = toStdVector("fluid", "positions", cloud.position);
    fluid.velocity = toStdVector("fluid", "U", requiredVectors(mesh_, cloud, "U"));
    fluid.id = uniqueIds("fluid", "id", cloud.labels["id"]);

    // Densities are those of the speed of sound at which they were written:
    // at another one particles keep their pressure
    const dictionary written(readCloudProperties(runTime_, "fluid"));
    const scalar c0 =
        written.getOrDefault<scalar>("soundSpeed", config.soundSpeed);
    const bool stiffer = mag(c0 - config.soundSpeed) > 1e-9*config.soundSpeed;

    // And of the rho that constant/fluidProperties had: they stay in units
    // of it, so that hydrostatic pressures are those of the new one
    const scalar relative =
        config.density
       /written.getOrDefault<scalar>("density", config.density);

    // Density, else from pressure, else at rest
    fluid.density.assign(cloud.size(), config.density);
    if (cloud.scalars.found("rho"))
    {
        const scalarField& rho = cloud.scalars["rho"];
        forAll(rho, i)
        {
            requirePositive("fluid", "rho", i, rho[i]);
            const scalar now = relative*rho[i];
            fluid.density[i] = stiffer
              ? densityOfPressure(config, pressureOfDensity(config, now, c0))
              : now;
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


void Foam::solverModules::sphDem::warnOfOtherProperties() const
{
    const riprap::SphConfig& config = settings_.config;
    const dictionary written(readCloudProperties(runTime_, "fluid"));

    const scalar rho =
        written.getOrDefault<scalar>("density", config.density);
    if (mag(config.density - rho) > 1e-9*rho)
    {
        WarningInFunction
            << "Entry rho of constant/fluidProperties is " << config.density
            << ", and was " << rho << " when lagrangian/fluid of time "
            << runTime_.timeName() << " was written (its cloudProperties). The"
            << " new one is used: every particle keeps its relative density"
            << " rho/rho0, so that mass, density and pressure change by the"
            << " same factor" << endl;
    }

    const vector now
    (
        config.gravity[0], config.gravity[1], config.gravity[2]
    );
    const scalarList of(exactList(written, "gravity"));
    const vector g(of.size() == 3 ? vector(of[0], of[1], of[2]) : now);
    if (mag(now - g) > 1e-9*mag(g))
    {
        WarningInFunction
            << "Entry value of constant/g is " << now << ", and was " << g
            << " when setParticles made lagrangian/fluid of time "
            << runTime_.timeName() << " (its cloudProperties): hydrostatic"
            << " pressures there are those of the latter. Run setParticles"
            << " for a start at rest" << endl;
    }
}


// ************************************************************************* //

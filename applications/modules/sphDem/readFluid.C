/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The fluid's particles of the current time.
\*---------------------------------------------------------------------------*/

#include "sphDem.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static void requireFinite(const word& field, label i, scalar value)
{
    if (!std::isfinite(value))
    {
        FatalErrorInFunction
            << "lagrangian/fluid/" << field << " has the value " << value
            << " at entry " << i << exit(FatalError);
    }
}


static std::vector<double> packed(const word& name, const vectorField& field)
{
    std::vector<double> xyz(3*field.size());
    forAll(field, i)
    {
        for (direction d = 0; d < vector::nComponents; ++d)
        {
            requireFinite(name, i, field[i][d]);
            xyz[3*i + d] = field[i][d];
        }
    }
    return xyz;
}


static std::vector<std::int32_t> uniqueIds(const labelField& id)
{
    const labelHashSet seen(id);
    if (seen.size() != id.size() || (id.size() && min(id) < 0))
    {
        FatalErrorInFunction
            << "lagrangian/fluid/id: " << id.size() - seen.size()
            << " ids occur more than once, the smallest is " << min(id)
            << ": ids must be unique and not negative" << exit(FatalError);
    }
    return std::vector<std::int32_t>(id.begin(), id.end());
}

} // End namespace Foam


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

Foam::particleCloud Foam::solverModules::sphDem::readFluid() const
{
    if (!hasParticleCloud(mesh_, "fluid"))
    {
        FatalErrorInFunction
            << "There are no particles at time " << runTime_.timeName() << ": "
            << runTime_.timePath()/"lagrangian/fluid"
            << " has no positions. Has setParticles been run?"
            << exit(FatalError);
    }

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
    fluid.position = packed("positions", cloud.position);
    fluid.velocity = packed("U", requiredVectors(mesh_, cloud, "U"));
    fluid.id = uniqueIds(cloud.labels["id"]);

    // Density, else from pressure, else at rest
    fluid.density.assign(cloud.size(), config.density);
    if (cloud.scalars.found("rho"))
    {
        const scalarField& rho = cloud.scalars["rho"];
        forAll(rho, i)
        {
            requireFinite("rho", i, rho[i]);
            fluid.density[i] = rho[i];
        }
    }
    else if (cloud.scalars.found("p"))
    {
        const scalarField& p = cloud.scalars["p"];
        forAll(p, i)
        {
            requireFinite("p", i, p[i]);
            fluid.density[i] = densityOfPressure(config, p[i]);
        }
    }

    return fluid;
}


// ************************************************************************* //

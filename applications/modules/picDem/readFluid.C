/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The fluid's particles of the current time.
\*---------------------------------------------------------------------------*/

#include "picDem.H"
#include "checkedDictionary.H"
#include "dividedCloud.H"
#include "IOdictionary.H"
#include "toStdVector.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

Foam::particleCloud Foam::solverModules::picDem::readFluid() const
{
    if (solids_ && !hasCloudFolder(runTime_, "fluid"))
    {
        // Solids alone
        particleCloud none;
        none.vectors.set("U", vectorField());
        none.labels.set("id", labelField());
        return none;
    }

    particleCloud cloud(readWholeCloud(mesh_, "fluid"));

    if (cloud.size() == 0 && !solids_)
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


//- Of the cloud that is read [m]
Foam::scalar Foam::solverModules::picDem::givenSpacing() const
{
    if (!hasCloudFolder(runTime_, "fluid"))
    {
        return 0.5*grid_.cellSize();
    }

    dictionary dict(readCloudProperties(runTime_, "fluid"));
    if (!dict.found("spacing"))
    {
        // A cloud that setParticles did not write
        dict = IOdictionary
        (
            IOobject
            (
                "setParticlesDict",
                runTime_.system(),
                runTime_,
                IOobject::MUST_READ,
                IOobject::NO_WRITE,
                false
            )
        );
    }

    return checkedDictionary(dict).positive("spacing");
}


riprap::FluidInput Foam::solverModules::picDem::fluidInput
(
    const particleCloud& cloud
) const
{
    riprap::FluidInput fluid;
    fluid.position = toStdVector("fluid", "positions", cloud.position);
    fluid.velocity = toStdVector("fluid", "U", requiredVectors(mesh_, cloud, "U"));
    fluid.id = uniqueIds("fluid", "id", cloud.labels["id"]);
    return fluid;
}


// ************************************************************************* //

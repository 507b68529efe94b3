/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    constant/g, constant/fluidProperties and the time step of
    system/controlDict; constant/sphProperties: readSphProperties.C
\*---------------------------------------------------------------------------*/

#include "sphDictionaries.H"
#include "particleDomain.H"
#include "fluidProperties.H"
#include "IOdictionary.H"
#include "Time.H"

namespace Foam
{

void readSphProperties(checkedDictionary, sphSettings&);

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

sphSettings readSphSettings(const polyMesh& mesh)
{
    sphSettings settings;
    riprap::SphConfig& config = settings.config;
    const Time& time = mesh.time();

    setDomain(config, readParticleDomain(mesh));
    readFluidProperties(readConstant("fluidProperties", time), config);

    settings.dict = readConstant("sphProperties", time);
    readSphProperties(checkedDictionary(settings.dict), settings);

    readTimeStep(time.controlDict(), config);
    config.startTime = time.value();

    return settings;
}

} // End namespace Foam


// ************************************************************************* //

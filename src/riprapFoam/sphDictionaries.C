/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    constant/g, constant/fluidProperties and the time step of
    system/controlDict; constant/sphProperties: readSphProperties.C
\*---------------------------------------------------------------------------*/

#include "sphDictionaries.H"
#include "particleDomain.H"
#include "checkedDictionary.H"
#include "IOdictionary.H"
#include "Switch.H"
#include "Time.H"

namespace Foam
{

void readSphProperties(checkedDictionary, sphSettings&);

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static void readFluid(const dictionary& dict, riprap::SphConfig& config)
{
    checkedDictionary fluid(dict);

    config.density = fluid.positive("rho", dimDensity);

    const bool mu = fluid.found("mu");
    const bool nu = fluid.found("nu");
    if (mu == nu)
    {
        FatalIOErrorInFunction(dict)
            << "One of the entries mu [Pa s] and nu [m2/s] must be there"
            << (mu ? ", not both" : "") << exit(FatalIOError);
    }

    config.viscosity =
    (
        mu
      ? fluid.positive("mu", dimDynamicViscosity)
      : config.density*fluid.positive("nu", dimViscosity)
    );

    fluid.end();
}


static void readTimeStep(const dictionary& dict, riprap::SphConfig& config)
{
    checkedDictionary control(dict);

    config.adjustTimeStep = dict.getOrDefault<Switch>("adjustTimeStep", false);

    if (config.adjustTimeStep)
    {
        config.maxTimeStep = control.positive("maxDeltaT", config.maxTimeStep);
    }
    else
    {
        config.fixedTimeStep = control.positive("deltaT");
    }
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

sphSettings readSphSettings(const polyMesh& mesh)
{
    sphSettings settings;
    riprap::SphConfig& config = settings.config;
    const Time& time = mesh.time();

    setDomain(config, readParticleDomain(mesh));
    readFluid(readConstant("fluidProperties", time), config);

    settings.dict = readConstant("sphProperties", time);
    readSphProperties(checkedDictionary(settings.dict), settings);

    readTimeStep(time.controlDict(), config);
    config.startTime = time.value();

    return settings;
}

} // End namespace Foam


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fluidProperties.H"

namespace Foam
{

void readFluidProperties(const dictionary& dict, riprap::FluidConfig& config)
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

} // End namespace Foam


// ************************************************************************* //

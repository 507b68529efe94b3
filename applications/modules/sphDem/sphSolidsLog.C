/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    What the log says of solids in the fluid.
\*---------------------------------------------------------------------------*/

#include "sphSolids.H"
#include "moduleLog.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::sphSolids::logModels() const
{
    Info<< nl << "Solids in the fluid" << nl;
    logItem("coupling") << coupling_.kind.c_str()
        << ", fluidForce " << coupling_.force.c_str()
        << ", viscosity " << (coupling_.viscosity ? "yes" : "no")
        << ", XSPH " << (coupling_.xsph ? "yes" : "no")
        << ", antiClump " << (coupling_.antiClump ? "yes" : "no") << nl;
    if (!input_.clumps.empty())
    {
        logItem("impermeable") << bodiesWithFaces_ << " of "
            << label(input_.clumps.size()) << " rigid bodies" << nl;
    }
    std::string limit;
    const scalar fluidStep = scene_->estimateTimeStep(limit);
    logSolids(fluidStep, limit);
}


void Foam::sphSolids::logStep() const
{
    const riprap::CouplingState now(scene_->coupling());
    logSteps(now.subcycles, now.total);
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The log of an OpenFOAM time step. Courant numbers are those of the
    particle steps: mean, c0 dt/h of the mean step; max, (c0 + |U|max) dt/h of
    the largest one.
\*---------------------------------------------------------------------------*/

#include "sphDem.H"
#include "logPrecision.H"
#include "logRanks.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solverModules::sphDem::report()
{
    const logPrecision digits;

    const riprap::SphConfig& config = settings_.config;
    const scalar h = config.smoothingRatio*config.spacing;
    const scalar c0 = config.soundSpeed;
    const scalar meanStep =
        runTime_.deltaTValue()/max(report_.steps, std::int64_t(1));

    // What limits the step now: the last one taken ended at the target
    std::string limit;
    scene_->estimateTimeStep(limit);

    Info<< "Courant Number mean: " << c0*meanStep/h
        << " max: " << (c0 + report_.maxSpeed)*report_.maxTimeStep/h << nl
        << "Particle steps = " << report_.steps << " (" << run_.steps
        << "), deltaT = " << report_.minTimeStep << " to "
        << report_.maxTimeStep << " s, limit: " << limit.c_str()
        << ", steps a list = "
        << scalar(report_.steps)/max(report_.rebuilds, std::int64_t(1)) << nl
        << "max(mag(U)) = " << report_.maxSpeed
        << " m/s, max density deviation = " << report_.maxDensityDeviation
        << endl;

    if (solids_)
    {
        solids_->logStep();
    }
    const riprap::FaceContacts contacts(scene_->faceContacts());
    if (contacts.count > contacts.atBodies)
    {
        Info<< "Put back at faces of walls: "
            << contacts.count - contacts.atBodies << " times in all" << nl;
    }
    if (contacts.atBodies)
    {
        Info<< "Put back at faces of bodies: " << contacts.atBodies
            << " times in all" << nl;
    }
    if (ranks_.valid()) logRanks(*ranks_, report_.rank);
    logEscaped(report_.escaped.size(), run_);
    if (report_.skinExceeded)
    {
        Info<< "Missed pairs are possible in this time step, and were in "
            << nSkinExceeded_ << " in all" << endl;
    }

    logProgress();
}


// ************************************************************************* //

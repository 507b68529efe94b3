/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    maxVelocity auto: what solids add to the estimate of the start, and the
    raise in a run whose water becomes faster.
\*---------------------------------------------------------------------------*/

#include "sphDem.H"
#include "logPrecision.H"
#include "wholeBoundary.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::solverModules::sphDem::addSolids(otherSpeeds& others) const
{
    if (!solids_)
    {
        return;
    }
    const riprap::Vector3& gravity = settings_.config.gravity;
    const vector g(gravity[0], gravity[1], gravity[2]);

    others.solids =
        solids_->fallSpeed(g, lowestPlace(wholeBoundary(mesh_), g) + others.deeper);
    others.walls = max(others.walls, solids_->movedSpeed());
}


//- The front on a dry bed is 1.41 times as fast as maxVelocity auto (Ritter), and
//  is meant to be. Water faster than 1.5 times it has a Mach number above 0.15, and
//  noise grows. Spray is not a reason: a hundredth of the fluid is, and
//  ten particles at least. Raised by quarters, to what all but those stay below
void Foam::solverModules::sphDem::followSpeed()
{
    riprap::SphConfig& config = settings_.config;
    if
    (
        !settings_.autoMaxVelocity
     || !config.adjustTimeStep
     || !(report_.maxSpeed > 1.5*config.maxVelocity)
    )
    {
        return;
    }

    const scalar beyond = 1.5*config.maxVelocity;
    const scalar spray = max(scalar(1e-2)*report_.fluid, scalar(10));
    const scalar raise = 1.25;
    std::array<double, riprap::SphScene::speedClasses> speeds;
    scalar next = beyond;
    for (double& speed : speeds)
    {
        speed = next;
        next *= raise;
    }

    const auto faster = scene_->fasterThan(speeds);
    if (!(scalar(faster[0]) > spray))
    {
        return;
    }
    scalar maxVelocity = speeds[0];
    for (std::size_t k = 0; k < speeds.size() && scalar(faster[k]) > spray; ++k)
    {
        maxVelocity = raise*speeds[k];
    }

    const logPrecision digits;
    const scalar soundSpeed = settings_.soundSpeedRatio*maxVelocity;
    Info<< "maxVelocity auto: " << config.maxVelocity << " to " << maxVelocity
        << " m/s, c0 " << config.soundSpeed << " to " << soundSpeed
        << " m/s at time " << report_.time << " s: "
        << 100*scalar(faster[0])/report_.fluid
        << " % of the fluid is faster than 1.5 times the first" << endl;

    scene_->setMaxVelocity(maxVelocity, soundSpeed);
    config.maxVelocity = run_.maxVelocity = maxVelocity;
    config.soundSpeed = run_.soundSpeed = soundSpeed;
}


// ************************************************************************* //

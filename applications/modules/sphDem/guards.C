/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    What is taken out of a run, and what stops it: what, where, when. The state
    at the stop is written, so that the run can go on from it.
\*---------------------------------------------------------------------------*/

#include "sphDem.H"
#include "caseTime.H"
#include "pictures.H"
#include "remedies.H"
#include "solvers/sph/sphModels.hpp"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

Foam::string Foam::solverModules::sphDem::advice() const
{
    using riprap::StopReason;
    const riprap::SphConfig& config = settings_.config;
    remedies helps;
    helps.when
    (
        report_.stop == StopReason::density || report_.stop == StopReason::speed
     || !report_.wild.empty(),
        "a larger maxVelocity, where water is faster than "
      + name(config.maxVelocity) + " m/s by right"
    );
    if (config.adjustTimeStep)
    {
        helps.above
        (
            "acousticCourant",
            config.acousticCourant,
            riprap::integratorOf(config).acousticCourant
        );
        helps.above("forceCourant", config.forceCourant, 0.25);
        if (config.viscosity > 0)
        {
            helps.above("viscousCourant", config.viscousCourant, 0.125);
        }
    }
    else
    {
        helps.when(true, "adjustTimeStep yes, or a smaller deltaT");
    }
    helps.when(!settings_.walls.impermeable, "impermeable yes of the walls");
    if (solids_.valid()) solids_->remediesOf(helps);
    return helps.text
    (
        "A shorter time step (the Courant numbers), a larger maxVelocity, walls"
        " in closed layers, artificial viscosity or densityDiffusion help"
        " against most causes"
    );
}


//- The state as it is now, whatever the plan of writing says
void Foam::solverModules::sphDem::writeAtStop()
{
    if (dryRun_)
    {
        return;
    }
    runTime_.setTime(report_.time, runTime_.timeIndex() + 1);
    Info<< "Writing the state at the stop as time " << runTime_.timeName()
        << nl << endl;
    pictures::ofRun().requireState();
    runTime_.writeNow();
    dynamic_cast<caseTime&>(runTime_).finishAtStop();
}


//- Particles whose density, speed or acceleration no fluid has are taken out
//  and counted; too many of them stop the run
void Foam::solverModules::sphDem::countWild()
{
    if (report_.wild.empty())
    {
        return;
    }
    run_.wild += report_.wild.size();
    recentWild_.append
    (
        Tuple2<scalar, label>(report_.time, label(report_.wild.size()))
    );

    const label most = 5;       // of one interval that are named
    forAll(report_.wild, i)
    {
        if (i == most)
        {
            Info<< "    and " << report_.wild.size() - most << " more" << nl;
            break;
        }
        const riprap::WildParticle& p = report_.wild[i];
        const point x(p.position[0], p.position[1], p.position[2]);
        Info<< "Taken out: particle " << p.id << " at " << x
            << " (nearest patch: " << boundary_.patch(x)
            << "), density deviation " << p.deviation << ", speed " << p.speed
            << " m/s" << nl;
    }

    scalar lastSecond = 0;
    for (const Tuple2<scalar, label>& r : recentWild_)
    {
        if (r.first() > report_.time - 1) lastSecond += r.second();
    }
    // A small scene may lose a few
    const scalar allowed =
    (
        settings_.maxWild > 0
      ? max(settings_.maxWild*run_.initialParticles, scalar(3))
      : 0
    );
    Info<< "Taken out in all: " << run_.wild << ", in the last second "
        << lastSecond << " of " << allowed << " allowed" << nl << endl;

    if (lastSecond > allowed)
    {
        writeAtStop();
        FatalErrorInFunction
            << "Guard at time " << report_.time << " s, particle step "
            << run_.steps << ": " << lastSecond << " particles of "
            << run_.initialParticles << " ran wild within a second;"
            << " guards/maxWild allows a share of " << settings_.maxWild
            << " a second" << nl << advice().c_str() << exit(FatalError);
    }
}


void Foam::solverModules::sphDem::checkStop()
{
    using riprap::StopReason;

    if (report_.stop == StopReason::none)
    {
        return;
    }

    const riprap::SphConfig& config = settings_.config;

    OStringStream what;
    switch (report_.stop)
    {
        case StopReason::notANumber:
            what<< "has a value that is not a number";
            break;

        case StopReason::density:
            what<< "has a density that deviates by " << report_.stopValue
                << " (relative) from rho; guards/densityDeviation allows "
                << config.maxDensityDeviation;
            break;

        case StopReason::speed:
            what<< "has the speed " << report_.stopValue << " m/s;"
                << " guards/speedRatio allows " << config.maxSpeedRatio
                << " times maxVelocity " << config.maxVelocity << " m/s";
            break;

        default:
            what<< "has more neighbours than the list of its kind holds";
    }

    writeAtStop();
    stopAt(report_, run_, what.str());
}


//- Neighbours are sought anew before particles can have moved too far; a
//  step that grew, or an impact, may still carry one further than foreseen
void Foam::solverModules::sphDem::checkSkin()
{
    if (report_.skinExceeded && ++nSkinExceeded_ == 1)
    {
        WarningInFunction
            << "Up to time " << report_.time << " s, particle step "
            << run_.steps << ": a particle moved further in one step than was"
            << " foreseen when neighbours were sought, so that pairs may have"
            << " been missed in that step. A shorter time step (the Courant"
            << " numbers) helps. The log's line 'Missed pairs' counts on"
            << endl;
    }
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    riprapFoam -dry-run: entries and models that this scene does not need.
\*---------------------------------------------------------------------------*/

#include "picDem.H"
#include "modelTrial.H"
#include "restingWalls.H"
#include "unitConversion.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Zones that are not kept
static void absorberNeeds
(
    sceneNeeds& needs,
    const dictionary& zones,
    const riprap::PicConfig& c
)
{
    wordHashSet kept;
    for (const riprap::PicAbsorber& zone : c.absorbers)
    {
        kept.insert(zone.name);
    }
    for (const entry& e : zones)
    {
        if (kept.found(e.keyword())) continue;
        const bool rated = e.dict().getOrDefault<scalar>("rate", 0) > 0;
        needs.idle
        (
            zones,
            e.keyword(),
            rated ? "the zone begins beyond the mesh" : "its rate is 0"
        );
    }
}


static void seedNeeds
(
    sceneNeeds& needs,
    const dictionary& seeds,
    const riprap::PicConfig& c,
    bool goesOn
)
{
    if (goesOn)
    {
        needs.idle
        (
            seeds,
            wordList({"perDirection", "jitter"}),
            "the run goes on with the particles that there are"
        );
    }
    else if (c.seedsPerDirection == 0)
    {
        needs.idle(seeds, "jitter", "seeds/perDirection is 0");
    }
}


//- Seconds in kernels of viscosity, and in all
static Pair<scalar> viscousSeconds(const std::vector<riprap::KernelInfo>& all)
{
    Pair<scalar> sum(0, 0);
    for (const riprap::KernelInfo& kernel : all)
    {
        sum.second() += kernel.seconds;
        if (kernel.name == "diffuse" || kernel.name.compare(0, 7, "viscous") == 0)
        {
            sum.first() += kernel.seconds;
        }
    }
    return sum;
}

} // End namespace Foam


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

//- What it does to the shortest waves that the grid carries well, until endTime
void Foam::solverModules::picDem::viscosityNeeds(sceneNeeds& needs)
{
    const riprap::PicConfig& c = settings_.config;
    const scalar cellsAWave = 10, little = 0.01;
    const int steps = 8;

    const scalar nu = c.viscosity/c.density;
    const scalar k = constant::mathematical::twoPi/(cellsAWave*c.cellSize);
    const scalar length = runTime_.endTime().value() - scene_->time();
    // Lamb 1932, section 348: amplitudes go with exp(-2 nu k^2 t)
    const scalar damped = 2*nu*sqr(k)*length;
    if (!(nu > 0 && damped > 0 && damped < little)) return;

    scene_->timeKernels(true);
    const Pair<scalar> before(viscousSeconds(scene_->kernels()));
    int taken = 0;
    while (taken < steps && trialStep()) ++taken;
    const Pair<scalar> after(viscousSeconds(scene_->kernels()));
    scene_->timeKernels(false);
    const scalar all = after.second() - before.second();
    if (!taken || !(all > 0)) return;

    needs.costly
    (
        settings_.dict,
        "viscosity",
        "nu " + threeDigits(nu) + " m2/s damps waves of "
      + threeDigits(cellsAWave) + " cells by " + threeDigits(100*damped)
      + " % until endTime; nu dt/dx^2 is "
      + threeDigits(nu*report_.lastTimeStep/sqr(c.cellSize)) + ", and its kernels take "
      + threeDigits(100*(after.first() - before.first())/all)
      + " % of the time of all: `viscosity none` leaves them out"
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solverModules::picDem::needs(sceneNeeds& needs)
{
    const riprap::PicConfig& c = settings_.config;
    const dictionary& dict = settings_.dict;

    needs.idle(dict, settings_.unused, "of transfers that are not chosen");

    seedNeeds(needs, subDictOf(dict, "seeds"), c, hasPicRun(runTime_));
    absorberNeeds(needs, subDictOf(dict, "absorb"), c);

    if (!solids_)
    {
        needs.idle
        (
            dict,
            wordList({"contactVelocity", "contactVelocityTime", "coupling"}),
            "there are no solids"
        );
    }
    else if (settings_.contactVelocity == 1)
    {
        needs.idle(dict, "contactVelocityTime", "contactVelocity is 1");
    }
    if (c.reflection == 0)
    {
        needs.idle
        (
            mesh_.solverDict("p"),
            "reflectionTolerance",
            "reflection is no"
        );
    }
    if (settings_.guards.stopAtEscape)
    {
        needs.idle
        (
            subDictOf(dict, "guards"),
            "maxEscaped",
            "guards/escape is stop"
        );
    }

    restingWalls
    (
        needs,
        subDictOf(subDictOf(dict, "walls"), "motion"),
        bodies_,
        runTime_
    );
    controlNeeds(needs, c.adjustTimeStep, true);
    viscosityNeeds(needs);
    if (solids_)
    {
        solids_->needs(needs);
    }
}


// ************************************************************************* //

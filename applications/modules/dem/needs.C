/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    riprapFoam -dry-run: entries and models that this scene does not need.
\*---------------------------------------------------------------------------*/

#include "dem.H"
#include "modelTrial.H"
#include "restingWalls.H"
#include "solidNeeds.H"
#include "core/backend/gpus.hpp"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solverModules::dem::needs(sceneNeeds& needs)
{
    const riprap::DemConfig& own = settings_.config;
    const scalar room = scene_->device() == riprap::DeviceKind::gpu
      ? scalar(riprap::gpuInUse().free) : GREAT;
    const auto trial = [&](const riprap::DemConfig& config)
    {
        if (!roomForTrial(*scene_, room)) return modelCost();
        const auto with = riprap::createDemScene(own, input_);
        const auto without = riprap::createDemScene(config, input_);
        return tryWithout
        (
            *with,
            *without,
            runTime_.endTime().value(),
            [](riprap::DemScene& scene)
            {
                const riprap::DemState s(scene.motion());
                return std::make_tuple(s.id, s.position, s.velocity, s.spin);
            }
        );
    };
    solidNeeds(needs, settings_, input_, typeOfBondType_, trial);

    restingWalls
    (
        needs,
        subDictOf(subDictOf(settings_.dict, "walls"), "motion"),
        movingWalls_,
        runTime_
    );

    const bool adjusts =
        runTime_.controlDict().getOrDefault<Switch>("adjustTimeStep", false);
    controlNeeds(needs, adjusts, false);
    if (!adjusts)
    {
        needs.idle(settings_.dict, "stepFraction", "adjustTimeStep is no");
    }
}


// ************************************************************************* //

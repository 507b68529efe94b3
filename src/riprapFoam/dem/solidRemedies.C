// SPDX-License-Identifier: GPL-3.0-or-later

#include "solidRemedies.H"

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::solidRemedies
(
    remedies& helps,
    const demSettings& settings,
    const riprap::DemInput& input,
    bool inFluid
)
{
    const riprap::DemConfig& config = settings.config;

    helps.when
    (
        config.allowLargeStep,
        "allowLargeStep no of constant/solidProperties"
    );
    if (config.timeStep <= 0)
    {
        helps.above
        (
            "stepFraction of constant/solidProperties",
            config.stepFraction,
            0.2
        );
    }

    bool undamped = false;
    for (const riprap::DemBondType& type : input.bondTypes)
    {
        undamped = undamped || type.dampingRatio <= 0;
    }
    helps.when
    (
        inFluid && undamped && input.bonds.size() > 0,
        "dampingRatio 0.02 to 0.1 of the bonds (is 0)"
    );
}


// ************************************************************************* //

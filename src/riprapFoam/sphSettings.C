/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    What follows from the dictionaries and the particles together.
\*---------------------------------------------------------------------------*/

#include "sphDictionaries.H"
#include "sphRun.H"
#include "checkedDictionary.H"
#include "particleCloudIO.H"
#include "wallPoints.H"
#include "sph/eos/equationOfState.hpp"
#include "IOdictionary.H"
#include "Time.H"

namespace Foam
{

static vector toVector(const riprap::Vector3& v)
{
    return vector(v[0], v[1], v[2]);
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

scalar fluidSpacing(const Time& time)
{
    if (hasSphRun(time))
    {
        return readSphRun(time).spacing;
    }

    dictionary dict(readCloudProperties(time, "fluid"));
    if (!dict.found("spacing"))
    {
        // A cloud that setParticles did not write
        dict = IOdictionary
        (
            IOobject
            (
                "setParticlesDict",
                time.system(),
                time,
                IOobject::MUST_READ,
                IOobject::NO_WRITE,
                false
            )
        );
    }

    return checkedDictionary(dict).positive("spacing");
}


void setSpacing(sphSettings& settings, scalar spacing)
{
    riprap::SphConfig& config = settings.config;

    config.spacing = spacing;
    config.wallSpacing =
        settings.walls.spacing > 0 ? settings.walls.spacing : spacing;

    if (config.wallSpacing > 1.001*spacing)
    {
        IOWarningInFunction(settings.walls.dict)
            << "Entry spacing " << config.wallSpacing << " is larger than the"
            << " fluid's spacing " << spacing << ": particles may pass such"
            << " walls" << endl;
    }

    const scalar margin = wallThickness(settings);

    // A particle that is a whole spacing behind the walls has passed them
    config.escapeInset = max(margin - spacing, scalar(0));

    for (int i = 0; i < config.dimensions; ++i)
    {
        const int axis = config.axes[i];
        if (!config.periodic[axis])
        {
            config.domainMin[axis] -= margin;
            config.domainMax[axis] += margin;
        }
    }
}


void setMaxVelocity
(
    sphSettings& settings,
    const pointField& position,
    const vectorField& U
)
{
    riprap::SphConfig& config = settings.config;

    if (settings.autoMaxVelocity)
    {
        const vector g(toVector(config.gravity));

        scalar low = VGREAT;
        scalar high = -VGREAT;
        for (const point& x : position)
        {
            low = min(low, x & g);
            high = max(high, x & g);
        }

        // |g| H; half a spacing of fluid lies beyond the outermost particles
        const scalar gH =
            position.empty() ? 0 : high - low + mag(g)*config.spacing;

        scalar fastest = 0;
        for (const vector& u : U)
        {
            fastest = max(fastest, mag(u));
        }

        config.maxVelocity = max(sqrt(2*gH), fastest);

        if (!(config.maxVelocity > 0))
        {
            FatalIOErrorInFunction(settings.dict)
                << "Entry maxVelocity is auto, but there is neither gravity"
                << " nor an initial velocity to estimate it from: give the"
                << " largest speed that is expected [m/s]"
                << exit(FatalIOError);
        }
    }

    config.soundSpeed = settings.soundSpeedRatio*config.maxVelocity;
}


label wallLayers(const sphSettings& settings)
{
    const riprap::SphConfig& config = settings.config;

    if (settings.walls.layers > 0)
    {
        return settings.walls.layers;
    }

    scalar support = 2*config.smoothingRatio*config.spacing;
    if (config.variableSmoothing)
    {
        support *= config.maxSmoothingGrowth;
    }
    return wallPointsControls::layersFor(support, config.wallSpacing);
}


scalar wallThickness(const sphSettings& settings)
{
    return wallLayers(settings)*settings.config.wallSpacing;
}


scalar densityOfPressure(const riprap::SphConfig& config, scalar p)
{
    const auto eos = riprap::EquationOfState<double>::make
    (
        config.eos == riprap::EosKind::linear,
        config.gamma,
        config.soundSpeed,
        config.density
    );
    return config.density*(1 + eos.deviation(p));
}

} // End namespace Foam


// ************************************************************************* //

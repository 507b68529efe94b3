/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    What follows from the dictionaries and the particles together.
\*---------------------------------------------------------------------------*/

#include "sphDictionaries.H"
#include "sphRestart.H"
#include "checkedDictionary.H"
#include "particleCloudIO.H"
#include "particleDomain.H"
#include "wallPoints.H"
#include "solvers/sph/sphModels.hpp"
#include "sph/eos/equationOfState.hpp"
#include "IOdictionary.H"
#include "PstreamReduceOps.H"
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
                time.caseSystem(),
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


scalar lowestPlace(const polyMesh& mesh, const vector& g)
{
    scalar lowest = -VGREAT;
    for (const point& x : mesh.points())
    {
        lowest = max(lowest, x & g);
    }
    return lowest;
}


scalar largestEnergy
(
    const vector& g,
    scalar spacing,
    scalar lowest,
    const pointField& position,
    const vectorField& U
)
{
    scalar low = -VGREAT;
    for (const point& x : position)
    {
        low = max(low, x & g);
    }
    reduce(low, maxOp<scalar>());

    // Less than half a spacing: lattices need not fit
    const scalar half = 0.5*mag(g)*spacing;
    scalar drop = lowest - (low + half);
    if (!(drop > half))
    {
        drop = 0;
    }

    scalar most = 0;
    forAll(position, i)
    {
        const scalar gH = low - (position[i] & g) + mag(g)*spacing + drop;
        most = max(most, 2*gH + magSqr(U[i]));
    }
    return returnReduce(most, maxOp<scalar>());
}


void setMaxVelocity
(
    sphSettings& settings,
    const polyMesh& mesh,
    const pointField& position,
    const vectorField& U,
    const otherSpeeds& others
)
{
    riprap::SphConfig& config = settings.config;

    if (settings.autoMaxVelocity)
    {
        const vector g(toVector(config.gravity));
        const scalar energy = max
        (
            largestEnergy
            (
                g,
                config.spacing,
                lowestPlace(mesh, g) + others.deeper,
                position,
                U
            ),
            sqr(others.solids)
        );

        config.maxVelocity = sqrt(energy + sqr(others.walls));

        if (!(config.maxVelocity > 0))
        {
            FatalIOErrorInFunction(settings.dict)
                << "Entry maxVelocity is auto, but there is neither gravity"
                << " nor an initial velocity to estimate it from, nor anything"
                << " that moves: give the largest speed that is expected [m/s]"
                << exit(FatalIOError);
        }
    }

    config.soundSpeed = settings.soundSpeedRatio*config.maxVelocity;
}


//- Water that starts faster than sound, or that one layer's weight presses
//  together: a wrong unit
static void requireSound
(
    const sphSettings& settings,
    const vectorField& U
)
{
    const riprap::SphConfig& config = settings.config;
    scalar fastest = 0;
    for (const vector& u : U)
    {
        fastest = max(fastest, mag(u));
    }
    const scalar falls = sqrt(mag(toVector(config.gravity))*config.spacing);
    if (max(fastest, falls) <= config.soundSpeed) return;

    FatalIOErrorInFunction(settings.dict)
        << "Entries maxVelocity, " << config.maxVelocity << " m/s, and"
        << " soundSpeedRatio give the fluid a speed of sound of "
        << config.soundSpeed << " m/s, and "
        << (fastest > falls ? "it starts with " : "gravity moves it over a spacing with ")
        << max(fastest, falls) << " m/s" << exit(FatalIOError);
}


//- A step that no run could end with: a wrong unit
static void requireSteps(const sphSettings& settings, const Time& time)
{
    const riprap::SphConfig& config = settings.config;
    const scalar length = min(time.endTime().value() - time.value(), scalar(1));
    const scalar nu = config.viscosity/config.density;
    const scalar steps = length*nu/sqr(config.spacing);
    if (!(steps > 1e12)) return;
    FatalIOErrorInFunction(readConstant("fluidProperties", time))
        << "The viscosity, mu or nu, is " << nu << " m2/s: it spreads over a"
        << " spacing in " << sqr(config.spacing)/nu << " s, and " << length
        << " s would take about " << steps << " steps" << exit(FatalIOError);
}


void requireSpeeds
(
    const sphSettings& settings,
    const Time& time,
    const vectorField& U
)
{
    requireSound(settings, U);
    requireSteps(settings, time);
}


label wallLayers(const sphSettings& settings)
{
    const riprap::SphConfig& config = settings.config;

    if (settings.walls.layers > 0)
    {
        return settings.walls.layers;
    }

    scalar support = riprap::supportOf(config);
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


static riprap::EquationOfState<double> equationOfState
(
    const riprap::SphConfig& config,
    scalar c0
)
{
    return riprap::EquationOfState<double>::make(config, c0, config.density);
}


scalar densityOfPressure(const riprap::SphConfig& config, scalar p)
{
    const auto eos = equationOfState(config, config.soundSpeed);
    return config.density*(1 + eos.deviation(p));
}


scalar lowestPressure(const riprap::SphConfig& config)
{
    return equationOfState(config, config.soundSpeed).lowestPressure();
}


scalar pressureOfDensity(const riprap::SphConfig& config, scalar rho, scalar c0)
{
    return equationOfState(config, c0).pressure(rho/config.density - 1);
}

} // End namespace Foam


// ************************************************************************* //

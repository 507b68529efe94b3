/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "frontPosition.H"
#include "checkedDictionary.H"
#include "levelCrossing.hpp"
#include "particleCloudIO.H"
#include "sphDictionaries.H"
#include "sphRestart.H"
#include "solvers/sph/sphModels.hpp"
#include "OSspecific.H"
#include "addToRunTimeSelectionTable.H"
#include <map>

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(frontPosition, 0);
    addToRunTimeSelectionTable(functionObject, frontPosition, dictionary);
}
}


namespace
{
    // Of the kernel, as a multiple of the spacing, where no scene tells
    constexpr double usualSupport = 2.5;

    // Cloud that setParticles and riprapFoam write
    const Foam::word fluidCloud("fluid");
}


Foam::functionObjects::frontPosition::frontPosition
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fluidFunctionObject(name, runTime, dict)
{
    read(dict);
    writeAtStart();
}


Foam::scalar Foam::functionObjects::frontPosition::writtenSpacing
(
    const dictionary& dict
) const
{
    if (!dict.found("spacing"))
    {
        const fileName seeded
        (
            time_.globalPath()/time_.system()/"setParticlesDict"
        );
        if
        (
            hasSphRun(time_)
         || readCloudProperties(time_, fluidCloud).found("spacing")
         || isFile(seeded)
        )
        {
            return fluidSpacing(time_);
        }
        FatalIOErrorInFunction(dict)
            << "Entry spacing of function object " << name() << " is missing:"
            << " no particle scene is running, cloud " << fluidCloud
            << " at time " << time_.timeName() << " does not tell, and there is"
            << " no " << seeded << exit(FatalIOError);
    }

    return dict.get<scalar>("spacing");
}


bool Foam::functionObjects::frontPosition::read(const dictionary& dict)
{
    fluidFunctionObject::read(dict);
    checkedDictionary(dict).positive("spacing", 1);

    if (hasScene())
    {
        spacing_ = fluid().fluidConfig().spacing;
        rule_.support =
            onGrid()
          ? usualSupport*spacing_
          : riprap::supportOf(sph().config());
    }
    else
    {
        spacing_ = writtenSpacing(dict);
        rule_.support = usualSupport*spacing_;
    }

    rule_.origin =
        toVector3(dict.lookupOrDefault("origin", mesh_.bounds().min()));
    rule_.direction =
        toVector3(direction(dict, "direction", vector(1, 0, 0)));
    rule_.up = toVector3(upDirection(dict));

    floorHeight_ = notNegative(dict, "floorHeight", 4*spacing_);
    rule_.minNeighbours = notNegative(dict, "minNeighbours", 1);
    minThickness_ =
        notNegative(dict, "minThickness", hasScene() ? dropThickness() : 0);

    if (hasScene())
    {
        line_ = heightLine();
        solid_ = inSolid(line_.points);
    }

    return true;
}


riprap::FluidEnd Foam::functionObjects::frontPosition::farEnd
(
    scalar reach
) const
{
    if (hasScene())
    {
        return fluid().fluidScene().farEnd(rule_.direction, reach);
    }

    return riprap::farEnd
    (
        flatPoints(readParticleCloud(mesh_, fluidCloud).position),
        rule_.direction,
        reach
    );
}


Foam::gaugeLine Foam::functionObjects::frontPosition::heightLine() const
{
    const vector up(toVector(rule_.up));
    const vector across(toVector(rule_.direction) ^ up);

    // From origin to the middle of the span
    point foot(toVector(rule_.origin));
    foot += across*(across & (mesh_.bounds().centre() - foot));

    return makeGaugeLine(mesh_.bounds(), foot, up, spacing_);
}


Foam::scalar Foam::functionObjects::frontPosition::height() const
{
    if (!hasScene())
    {
        return 0;
    }

    return
        riprap::fluidLevel
        (
            line_.height,
            sample(line_.points).volumeFraction,
            minThickness_,
            solid_
        ).top;
}


bool Foam::functionObjects::frontPosition::writeSample()
{
    if (!hasScene() && !hasParticleCloud(mesh_, fluidCloud))
    {
        Log << "    No cloud " << fluidCloud << " in time directory "
            << time_.timeName() << ": no row" << nl;
        return true;
    }

    // Rules ask for the same ends
    std::map<scalar, riprap::FrontEnd> ends;
    const auto end = [&](scalar reach) -> const riprap::FrontEnd&
    {
        auto known = ends.find(reach);
        if (known == ends.end())
        {
            known = ends.emplace(reach, riprap::FrontEnd(farEnd(reach), rule_)).first;
        }
        return known->second;
    };
    const label particles = end(4*rule_.support).end.particles;

    // Edge of the furthest particle; 0 when there is none
    const auto edge = [&](const riprap::FrontRule& rule)
    {
        const double centre = riprap::fluidFrontOf(end, rule);
        return std::isfinite(centre) ? centre + 0.5*spacing_ : 0;
    };

    riprap::FrontRule onFloor(rule_), any(rule_);
    onFloor.maxHeight = floorHeight_;
    any.minNeighbours = 0;

    label atStart = particles;
    if (foundProperty("particlesAtStart"))
    {
        getProperty("particlesAtStart", atStart);
    }
    else
    {
        setProperty("particlesAtStart", atStart);
    }

    OFstream& os = row
    (
        typeName,
        {"front", "frontFloor", "height", "particles", "escaped", "max"}
    );
    add(os, edge(rule_));
    add(os, edge(onFloor));
    add(os, height());
    add(os, particles);
    add(os, atStart - particles);
    add(os, edge(any));
    os  << endl;

    return true;
}

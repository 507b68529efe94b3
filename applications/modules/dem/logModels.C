/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Every model in use, once, and what is off.
\*---------------------------------------------------------------------------*/

#include "dem.H"
#include "bodyLog.H"
#include "deviceChoice.H"
#include "listed.H"
#include "logPrecision.H"
#include "modelReader.H"
#include "moduleLog.H"
#include "solvers/dem/demLaws.hpp"
#include "api/sphScene.hpp"
#include "sphNames.H"
#include "touchingStart.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

Foam::wordList Foam::solverModules::dem::modelsOff() const
{
    const riprap::DemConfig& c = settings_.config;
    using namespace riprap;

    DynamicList<word> off;
    const LawChoice laws(lawChoice(c));
    if (tangentialLaws()[laws.tangential].off) off.append("tangential");
    if (rollingLaws()[laws.rolling].off) off.append("rolling");
    if (input_.bonds.size() == 0) off.append("bonds");
    if (input_.clumps.empty()) off.append("clumps");
    if (input_.walls.empty()) off.append("walls");
    if (movingWalls_.size() == 0) off.append("movingWalls");
    if (movingGroups_.size() == 0) off.append("movingGroups");
    if (!c.orientation) off.append("orientation");
    if (!(c.sleepSpeed > 0)) off.append("sleep");
    return wordList(off);
}


void Foam::solverModules::dem::logPairs() const
{
    const riprap::DemConfig& c = settings_.config;
    const riprap::LawChoice laws(riprap::lawChoice(c));
    const wordList names(settings_.materialNames());

    for (const riprap::DemPair& pair : input_.pairs)
    {
        const riprap::PairProperties& p = pair.properties;
        logItem("pair") << names[pair.a] << '-' << names[pair.b] << ':';
        const char* separator = " ";
        if (riprap::normalNeeds(laws).elasticConstants)
        {
            Info<< separator << "E* " << p.effectiveYoung() << " Pa";
            separator = ", ";
        }

        // Numbers first that are always there
        const auto print = [&](bool always, bool yesNo)
        {
            for (const riprap::PairEntry& e : riprap::lawEntries(laws))
            {
                const bool now =
                    bool(e.yesNo) == yesNo
                 && (e.shown == riprap::Shown::always) == always;
                if (now && isShown(e, p))
                {
                    Info<< separator;
                    printEntry(Info(), e, p, c.dimensions == 2);
                    separator = ", ";
                }
            }
        };
        print(true, false);
        print(false, false);
        print(false, true);
        Info<< nl;
    }
}


void Foam::solverModules::dem::logGroups() const
{
    labelList members(settings_.groups.size(), Zero);
    for (const std::int32_t g : input_.particles.group)
    {
        ++members[g];
    }

    forAll(members, i)
    {
        const riprap::DemGroup& g = input_.groups[i];
        if (members[i] == 0 && input_.clumps.empty()) continue;

        logItem("group") << g.name.c_str() << ": " << members[i] << " particles";
        for (int d = 0; d < 3; ++d)
        {
            if (g.held[d]) Info<< ", fixed " << "xyz"[d];
        }
        if (g.heldSpin) Info<< ", fixed spin";
        if (g.motion >= 0) Info<< ", motion " << movingGroups_.function(g.motion);
        if (!g.gravity) Info<< ", no gravity";
        if (g.force != riprap::Vector3{{0, 0, 0}})
        {
            Info<< ", force " << vector(g.force[0], g.force[1], g.force[2])
                << " N on each";
        }
        if (g.moment != riprap::Vector3{{0, 0, 0}})
        {
            Info<< ", moment " << vector(g.moment[0], g.moment[1], g.moment[2])
                << " N m on each";
        }
        if (g.localDamping > 0) Info<< ", localDamping " << g.localDamping;
        if (g.viscousDamping > 0)
        {
            Info<< ", viscousDamping " << g.viscousDamping << " 1/s";
        }
        if (g.viscousSpinDamping > 0)
        {
            Info<< ", viscousSpinDamping " << g.viscousSpinDamping << " 1/s";
        }
        Info<< nl;
    }
}


void Foam::solverModules::dem::logBonds() const
{
    labelList count(settings_.bondTypes.size(), Zero);
    for (const std::int32_t type : input_.bonds.type)
    {
        ++count[typeOfBondType_[type]];
    }

    forAll(count, i)
    {
        if (count[i] == 0) continue;

        const demBondType& bond = settings_.bondTypes[i];
        logItem("bonds") << bond.name << ": " << count[i] << ", calibration "
            << bond.calibration.c_str() << ", radius "
            << bond.type.radiusFactor << " x "
            << bond.type.radiusKind.c_str();
        if (bond.type.tensileStrength < 1e299)
        {
            Info<< ", tensileStrength " << bond.type.tensileStrength << " Pa";
        }
        if (bond.type.shearStrength < 1e299)
        {
            Info<< ", shearStrength " << bond.type.shearStrength << " Pa";
        }
        if (bond.type.dampingRatio > 0)
        {
            Info<< ", dampingRatio " << bond.type.dampingRatio;
        }
        Info<< nl;
    }
}


void Foam::solverModules::dem::logWalls() const
{
    for (const riprap::DemWall& wall : input_.walls)
    {
        logItem("wall") << wall.name.c_str() << ": "
            << settings_.materialNames()[wall.material] << ", ";
        if (wall.plane)
        {
            Info<< "plane";
        }
        else
        {
            Info<< label(wall.elements.size()/settings_.config.dimensions)
                << " elements";
        }
        if (wall.motion >= 0)
        {
            Info<< ", " << movingWalls_.name(wall.motion) << ": "
                << movingWalls_.function(wall.motion);
        }
        Info<< nl;
    }
}


void Foam::solverModules::dem::logTimeStep() const
{
    const riprap::DemConfig& c = settings_.config;
    const riprap::DemPlan plan(scene_->plan());

    logItem("timeIntegration") << c.integrator.c_str()
        << ", deltaT " << plan.timeStep << " s, limit: " << plan.cause.c_str()
        << nl;
    logItem("") << "hard stop " << plan.hardStop
                << " s (0.5 sqrt(m/k), of undamped bonds all of it, or a close packing's)"
                << (c.allowLargeStep ? ", overridden by allowLargeStep" : "") << nl;
    for (const std::string& warning : plan.warnings)
    {
        logItem("warning") << warning.c_str() << nl;
    }
}


void Foam::solverModules::dem::logModels() const
{
    const logPrecision digits;

    const riprap::DemConfig& c = settings_.config;
    const riprap::DeviceChoice choice =
        riprap::chooseDevice(c.device, run_.particles, c.dimensions);

    Info<< nl << "Discrete elements" << nl;
    logItem("particles") << "solids " << run_.particles << ", clumps "
        << label(input_.clumps.size()) << nl;
    logBodies(settings_.config, input_);
    logSpace(c);
    logDevice
    (
        scene_->deviceName(), choice.reason, scene_->device(), scene_->arrays()
    );
    logItem("precision") << sphNames::precision[c.precision] << nl;
    logItem("contact") << "normal " << c.normal.c_str()
        << ", tangential " << c.tangential.c_str()
        << ", rolling " << c.rolling.c_str();
    if (input_.bonds.size())
    {
        Info<< ", within bonds: " << (c.contactWithinBonds ? "yes" : "no");
    }
    Info<< nl;

    logPairs();
    logGroups();
    logBonds();

    logWalls();
    logTimeStep();

    if (c.sleepSpeed > 0)
    {
        logItem("sleep") << "slower than " << c.sleepSpeed << " m/s for "
            << c.sleepAfter << " s" << nl;
    }
    logItem("guards") << settings_.guards << nl;
    logUnused(settings_.unused, " of pairs: they are other laws'");
    logItem("off") << listed(modelsOff()).c_str() << nl << endl;
    if (!run_.steps) warnOfTouchingStart(*scene_, c, input_);
}


// ************************************************************************* //

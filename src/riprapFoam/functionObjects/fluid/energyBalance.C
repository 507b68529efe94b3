/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "energyBalance.H"
#include "wallBodies.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(energyBalance, 0);
    addToRunTimeSelectionTable(functionObject, energyBalance, dictionary);
}
}


namespace
{
    double total(const riprap::FluidEnergy& e)
    {
        return e.kinetic + e.potential + e.elastic;
    }
}


Foam::functionObjects::energyBalance::energyBalance
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fluidFunctionObject(name, runTime, dict)
{
    read(dict);
    begin();
    writeAtStart();
}


//- Of the run that is continued; as it was where nothing is kept
void Foam::functionObjects::energyBalance::readKept(const word& property, scalar& value) const
{
    const scalarList kept(saved(property));
    if (kept.size()) value = kept[0];
}


void Foam::functionObjects::energyBalance::begin()
{
    const riprap::FluidEnergy energy(fluid().fluidScene().energy());

    if (!foundProperty("totalAtStart"))
    {
        totalAtStart_ = total(energy);
        keep("totalAtStart", scalarList(1, totalAtStart_));
        return;
    }

    readKept("totalAtStart", totalAtStart_);
    readKept("largestKinetic", largestKinetic_);

    // Does the scene bring them along, or begin at 0?
    if (energy.wallWork == 0)
    {
        readKept("wallWork", workBefore_);
        readKept("wallPressureWork", pressureWorkBefore_);
    }
    if (energy.stiffening == 0) readKept("stiffening", stiffeningBefore_);
}


bool Foam::functionObjects::energyBalance::executeSample()
{
    if (time_.writeTime())
    {
        const riprap::FluidEnergy energy(fluid().fluidScene().energy());
        const auto keepOne = [this](const word& property, const scalar value)
        {
            keep(property, scalarList(1, value));
        };
        keepOne("largestKinetic", largestKinetic_);
        keepOne("wallWork", energy.wallWork + workBefore_);
        keepOne("wallPressureWork", energy.wallPressureWork + pressureWorkBefore_);
        keepOne("stiffening", energy.stiffening + stiffeningBefore_);
    }

    return true;
}


bool Foam::functionObjects::energyBalance::writeSample()
{
    const riprap::FluidEnergy energy(fluid().fluidScene().energy());
    const riprap::FluidExtremes now(fluid().fluidScene().extremes());

    const scalar work = energy.wallWork + workBefore_;
    const scalar stiffening = energy.stiffening + stiffeningBefore_;
    const scalar given = totalAtStart_ + work + stiffening;
    const scalar dissipated = given - total(energy);

    largestKinetic_ = max(largestKinetic_, energy.kinetic);
    const scalar drift =
        largestKinetic_ > 0
      ? (total(energy) - given)/largestKinetic_
      : 0;

    OFstream& os = row
    (
        typeName,
        {
            "kinetic", "potential", "elastic", "wallWork", "dissipated",
            "total", "maxSpeed", "maxDensityDeviation", "drift", "stiffening",
            "faceWork", "wallPressureWork"
        }
    );
    add(os, energy.kinetic);
    add(os, energy.potential);
    add(os, energy.elastic);
    add(os, work);
    add(os, dissipated);
    add(os, total(energy));
    add(os, now.speed);
    add(os, now.densityDeviation);
    add(os, drift);
    add(os, stiffening);
    add(os, energy.faceWork);
    add(os, energy.wallPressureWork + pressureWorkBefore_);
    os  << endl;

    return true;
}

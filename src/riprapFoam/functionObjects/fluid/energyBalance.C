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


void Foam::functionObjects::energyBalance::begin()
{
    const riprap::FluidEnergy energy(fluid().fluidScene().energy());

    if (!foundProperty("totalAtStart"))
    {
        totalAtStart_ = total(energy);
        setProperty("totalAtStart", totalAtStart_);
        return;
    }

    getProperty("totalAtStart", totalAtStart_);
    getProperty("largestKinetic", largestKinetic_);

    // Does the scene bring them along, or begin at 0?
    if (energy.wallWork == 0)
    {
        getProperty("wallWork", workBefore_);
        if (foundProperty("wallPressureWork"))
        {
            getProperty("wallPressureWork", pressureWorkBefore_);
        }
    }
    if (energy.stiffening == 0 && foundProperty("stiffening"))
    {
        getProperty("stiffening", stiffeningBefore_);
    }
}


bool Foam::functionObjects::energyBalance::executeSample()
{
    if (time_.writeTime())
    {
        setProperty("largestKinetic", largestKinetic_);
        const riprap::FluidEnergy energy(fluid().fluidScene().energy());
        setProperty("wallWork", scalar(energy.wallWork + workBefore_));
        setProperty
        (
            "wallPressureWork",
            scalar(energy.wallPressureWork + pressureWorkBefore_)
        );
        setProperty
        (
            "stiffening",
            scalar(energy.stiffening + stiffeningBefore_)
        );
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

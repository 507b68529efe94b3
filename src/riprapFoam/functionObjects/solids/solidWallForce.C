/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidWallForce.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(solidWallForce, 0);
    addToRunTimeSelectionTable(functionObject, solidWallForce, dictionary);
}
}


Foam::functionObjects::solidWallForce::solidWallForce
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    demFunctionObject(name, runTime, dict)
{
    read(dict);
    writeAtStart();
}


void Foam::functionObjects::solidWallForce::sample()
{
    if (sampledAt_ == time_.value()) return;

    forces_.clear();
    for (const riprap::DemWallForce& wall : dem().scene().wallForces())
    {
        for (const riprap::Vector3& v : {wall.force, wall.moment})
        {
            forces_.insert(forces_.end(), v.begin(), v.end());
        }
    }
    sampledAt_ = time_.value();
    if (mean_.on()) mean_.add(sampledAt_, forces_, dict_, name());
}


void Foam::functionObjects::solidWallForce::writeTable
(
    const word& table,
    const std::vector<double>& values
)
{
    wordList columns;
    for (const riprap::DemWall& wall : dem().input().walls)
    {
        for (const char* what : {"Fx", "Fy", "Fz", "Mx", "My", "Mz"})
        {
            columns.append(word(wall.name + what, false));
        }
    }

    OFstream& os = row(table, columns);
    for (const double value : values) add(os, value);
    os  << endl;
}


bool Foam::functionObjects::solidWallForce::read(const dictionary& dict)
{
    demFunctionObject::read(dict);
    mean_.begin(notNegative(dict, "average", 0), savedSamples(), 6*dem().input().walls.size());
    sampledAt_ = -GREAT;
    return true;
}


bool Foam::functionObjects::solidWallForce::executeSample()
{
    if (mean_.on()) sample();
    if (time_.writeTime()) save(mean_);
    return true;
}


bool Foam::functionObjects::solidWallForce::writeSample()
{
    sample();
    writeTable(typeName, forces_);
    if (mean_.on()) writeTable(word(typeName + "Mean"), mean_.mean());
    return true;
}

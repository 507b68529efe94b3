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


bool Foam::functionObjects::solidWallForce::writeSample()
{
    const std::vector<riprap::DemWallForce> forces(dem().scene().wallForces());
    const auto& walls = dem().input().walls;

    wordList columns;
    for (const riprap::DemWall& wall : walls)
    {
        for (const char* what : {"Fx", "Fy", "Fz", "Mx", "My", "Mz"})
        {
            columns.append(word(wall.name + what, false));
        }
    }

    OFstream& os = row(typeName, columns);
    for (std::size_t i = 0; i < walls.size(); ++i)
    {
        for (const riprap::Vector3& v : {forces.at(i).force, forces.at(i).moment})
        {
            for (const double component : v) add(os, component);
        }
    }
    os  << endl;
    return true;
}

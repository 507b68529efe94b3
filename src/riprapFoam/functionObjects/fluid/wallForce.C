/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallForce.H"
#include "sphDictionaries.H"
#include "wholeBoundary.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(wallForce, 0);
    addToRunTimeSelectionTable(functionObject, wallForce, dictionary);
}
}


Foam::functionObjects::wallForce::wallForce
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


bool Foam::functionObjects::wallForce::read(const dictionary& dict)
{
    fluidFunctionObject::read(dict);
    sph();

    groups_ = wordList(1, "fixed");
    for (const wallMotion& motion : readSphSettings(wholeBoundary(mesh_)).walls.motion)
    {
        groups_.append(motion.name);
    }

    return true;
}


bool Foam::functionObjects::wallForce::writeSample()
{
    const std::vector<riprap::Vector3> forces(sph().scene().wallForces());

    wordList columns;
    for (const word& group : groups_)
    {
        columns.append(wordList({group + "Fx", group + "Fy", group + "Fz"}));
    }

    OFstream& os = row(typeName, columns);
    forAll(groups_, i)
    {
        for (const double component : forces.at(i))
        {
            add(os, component);
        }
    }
    os  << endl;

    return true;
}

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "springForces.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(springForces, 0);
    addToRunTimeSelectionTable(functionObject, springForces, dictionary);
}
}


Foam::functionObjects::springForces::springForces
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


bool Foam::functionObjects::springForces::writeSample()
{
    const std::vector<riprap::DemSpringState> now(dem().scene().springs());
    if (now.empty())
    {
        FatalErrorInFunction
            << "Function object " << name() << " of type " << typeName
            << ": no group of constant/solidProperties has springs or moorings"
            << exit(FatalError);
    }

    wordList columns;
    DynamicList<scalar> values;
    for (const riprap::DemSpringState& s : now)
    {
        for (const char* what : {"Length", "Tension", "Fx", "Fy", "Fz"})
        {
            columns.append(word(s.name + what, false));
        }
        values.append(s.length);
        values.append(s.tension);
        for (const scalar f : s.force) values.append(f);
    }

    OFstream& os = row(typeName, columns);
    for (const scalar value : values) add(os, value);
    os  << endl;
    return true;
}

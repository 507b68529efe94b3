/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "momentumBalance.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(momentumBalance, 0);
    addToRunTimeSelectionTable(functionObject, momentumBalance, dictionary);
}
}


riprap::PicScene& Foam::functionObjects::momentumBalance::pic() const
{
    if (!onGrid())
    {
        noScene(picSceneObject::typeName, "solver picDem");
    }
    return mesh_.lookupObject<picSceneObject>(picSceneObject::typeName).scene();
}


Foam::functionObjects::momentumBalance::momentumBalance
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fluidFunctionObject(name, runTime, dict)
{
    read(dict);
    try
    {
        pic().watchMomentum(true);
    }
    catch (const std::invalid_argument& e)
    {
        FatalIOErrorInFunction(dict)
            << "Function object " << name << " of type " << typeName << ": "
            << e.what() << exit(FatalIOError);
    }
    writeAtStart();
}


bool Foam::functionObjects::momentumBalance::writeSample()
{
    const riprap::PicMomentum m(pic().momentum());

    wordList columns;
    DynamicList<scalar> values;
    const auto append = [&](const char* what, const vector& v)
    {
        for (const char* axis : {"X", "Y", "Z"}) columns.append(word(what) + axis);
        for (int d = 0; d < vector::nComponents; ++d) values.append(v[d]);
    };
    const vector water(toVector(m.water)), gravity(toVector(m.gravity));
    const vector walls(toVector(m.walls)), solids(toVector(m.solids));
    const vector other(toVector(m.other));
    append("water", water);
    append("gravity", gravity);
    append("walls", walls);
    append("solids", solids);
    append("other", other);
    append("residual", water - gravity - other + walls + solids);
    append("particles", toVector(m.particles));

    OFstream& os = row(typeName, columns);
    for (const scalar value : values)
    {
        add(os, value);
    }
    os  << endl;

    return true;
}

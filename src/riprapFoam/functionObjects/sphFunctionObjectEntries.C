/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Entries of riprap's function objects: read and checked.

\*---------------------------------------------------------------------------*/

#include "sphFunctionObject.H"
#include "gravityMeshObject.H"

Foam::vector Foam::functionObjects::sphFunctionObject::direction
(
    const dictionary& dict,
    const word& key,
    const vector& deflt
) const
{
    const vector v(dict.lookupOrDefault(key, deflt));

    if (mag(v) < VSMALL)
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << key << " of function object " << name()
            << " is " << v << ": a direction needs a length"
            << exit(FatalIOError);
    }

    return v/mag(v);
}


Foam::vector Foam::functionObjects::sphFunctionObject::upDirection
(
    const dictionary& dict
) const
{
    const vector g
    (
        hasScene()
      ? toVector(sph().config().gravity)
      : vector(meshObjects::gravity::New(time_).value())
    );

    return direction(dict, "up", mag(g) < VSMALL ? vector(0, 1, 0) : -g);
}


Foam::scalar Foam::functionObjects::sphFunctionObject::notNegative
(
    const dictionary& dict,
    const word& key,
    const scalar deflt
) const
{
    const scalar value(dict.lookupOrDefault(key, deflt));

    if (value < 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << key << " of function object " << name()
            << " is " << value << ": it must not be negative"
            << exit(FatalIOError);
    }

    return value;
}


Foam::wordList Foam::functionObjects::sphFunctionObject::fieldNames
(
    const dictionary& dict,
    const wordList& deflt,
    const wordList& valid
) const
{
    const wordList names(dict.lookupOrDefault("fields", deflt));

    for (const word& field : names)
    {
        if (!valid.found(field))
        {
            FatalIOErrorInFunction(dict)
                << "Entry fields of function object " << name()
                << ": unknown field " << field << nl
                << "    Valid fields: " << flatOutput(valid)
                << exit(FatalIOError);
        }
    }

    return names;
}


Foam::pointField Foam::functionObjects::sphFunctionObject::points
(
    const dictionary& dict,
    const word& key
) const
{
    const pointField list(dict.get<pointField>(key));

    if (list.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << key << " of function object " << name()
            << " is empty: it is a list of points" << exit(FatalIOError);
    }

    return list;
}

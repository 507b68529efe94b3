/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sceneFunctionObject.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(sceneFunctionObject, 0);
}
}


namespace
{
    constexpr Foam::label leastPrecision = 10;
}


// * * * * * * * * * * * * * * * *  Tables * * * * * * * * * * * * * * * * * //

Foam::OFstream& Foam::functionObjects::sceneFunctionObject::row
(
    const word& name,
    const wordList& columns,
    const UList<string>& comments
)
{
    if (!writeToFile())
    {
        return Snull;
    }

    const bool begun = tables_.found(name);

    if (!begun || tables_[name]->columns != columns)
    {
        autoPtr<table> fresh(new table);

        fresh->columns = columns;
        fresh->file =
            begun ? createFile(name, time_.value()) : createFile(name);

        OFstream& os = *fresh->file;

        for (const string& comment : comments)
        {
            writeHeader(os, comment);
        }
        writeCommented(os, "Time");
        for (const word& column : columns)
        {
            writeTabbed(os, column);
        }
        os  << endl;

        tables_.set(name, fresh.ptr());
    }

    OFstream& os = *tables_[name]->file;
    os  << setw(charWidth()) << time_.timeOutputValue();

    return os;
}


void Foam::functionObjects::sceneFunctionObject::add
(
    OFstream& os,
    const scalar value
) const
{
    os  << tab << setw(charWidth()) << value;
}


void Foam::functionObjects::sceneFunctionObject::writeAtStart()
{
    if (!postProcess && time_.timeIndex() == time_.startTimeIndex())
    {
        write();
    }
}


// * * * * * * * * * * * * * * * *  Entries * * * * * * * * * * * * * * * * //

Foam::vector Foam::functionObjects::sceneFunctionObject::direction
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


Foam::scalar Foam::functionObjects::sceneFunctionObject::notNegative
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


Foam::wordList Foam::functionObjects::sceneFunctionObject::fieldNames
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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::sceneFunctionObject::sceneFunctionObject
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(obr_, name),
    dict_(dict)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::sceneFunctionObject::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    writeFile::read(dict);

    dict_ = dict;

    if (!dict.found("writePrecision"))
    {
        writePrecision_ = max(writePrecision_, leastPrecision);
    }

    return true;
}


bool Foam::functionObjects::sceneFunctionObject::execute()
{
    return true;
}


// * * * * * * * * * * * * * * * *  Conversions  * * * * * * * * * * * * * * //

riprap::Vector3 Foam::functionObjects::toVector3(const vector& v)
{
    return {{v.x(), v.y(), v.z()}};
}


Foam::vector Foam::functionObjects::toVector(const riprap::Vector3& v)
{
    return vector(v[0], v[1], v[2]);
}

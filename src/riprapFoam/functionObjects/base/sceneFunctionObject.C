/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sceneFunctionObject.H"
#include "checkedDictionary.H"
#include "didYouMean.H"
#include "sceneState.H"
#include "timeWriter.H"
#include "wallTimes.H"

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

    //- What OpenFOAM reads of every function object
    const Foam::wordList common(
        {"type", "libs", "functionObjectLibs", "enabled", "log", "region", "subRegion", "timeStart",
            "timeEnd", "triggerStart", "triggerEnd", "deltaTCoeff", "nStepsToStartTimeChange",
            "executeControl", "executeInterval", "writeControl", "writeInterval", "writeFrequency",
            "outputControl", "outputInterval", "writePrecision", "writeToFile", "useUserTime"});
}


// * * * * * * * * * * * * * * * *  Tables * * * * * * * * * * * * * * * * * //

Foam::OFstream& Foam::functionObjects::sceneFunctionObject::row
(
    const word& name,
    const wordList& columns,
    const UList<string>& comments
)
{
    if (!Pstream::master() || !writeToFile() || timeWriter::ofRun().onTrial())
    {
        return Snull;
    }

    const bool begun = tables_.found(name);

    if (!begun || tables_[name]->columns != columns)
    {
        autoPtr<table> fresh(new table);

        fresh->columns = columns;
        fresh->file =
            begun ? openTable(name, time_.value()) : openTable(name);

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


Foam::scalarList Foam::functionObjects::sceneFunctionObject::saved(const word& property) const
{
    return foundProperty(property)
        ? exactList(stateDict().subDict(name()), property)
        : scalarList();
}


void Foam::functionObjects::sceneFunctionObject::keep
(
    const word& property,
    const UList<scalar>& numbers
)
{
    setProperty(property, exactStrings(numbers));
}


void Foam::functionObjects::sceneFunctionObject::save(const trailingMean& mean)
{
    if (mean.on()) keep(trailingMean::property, mean.state());
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
    vector v(dict.lookupOrDefault(key, deflt));
    for (Foam::direction d = 0; d < vector::nComponents; ++d)
    {
        if (mesh_.nGeometricD() == 2 && mesh_.geometricD()[d] < 0) v[d] = 0;
    }

    if (mag(v) < VSMALL)
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << key << " of function object " << name()
            << " has no length" << (mesh_.nGeometricD() == 2 ? " in the plane of the 2D mesh" : "")
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

    if (!(value >= 0))
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << key << " of function object " << name()
            << " is " << value << ": it must not be negative"
            << exit(FatalIOError);
    }

    return value;
}


Foam::scalar Foam::functionObjects::sceneFunctionObject::fraction
(
    const dictionary& dict,
    const word& key,
    const scalar deflt
) const
{
    return checkedDictionary(dict).between(key, deflt, 0, 1);
}


Foam::wordList Foam::functionObjects::sceneFunctionObject::fieldNames
(
    const dictionary& dict,
    const wordList& deflt,
    const wordList& valid
) const
{
    const wordList names(dict.lookupOrDefault("fields", deflt));

    if (names.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Entry fields of function object " << name() << " is empty; valid are "
            << listed(valid).c_str() << exit(FatalIOError);
    }

    for (const word& field : names)
    {
        if (!valid.found(field))
        {
            FatalIOErrorInFunction(dict)
                << "Entry fields of function object " << name()
                << ": unknown field " << field << "; valid are "
                << listedFor(field, valid).c_str() << exit(FatalIOError);
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
    writesTables(obr_, name),
    dict_(dict)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::sceneFunctionObject::read(const dictionary& dict)
{
    checkedDictionary known(dict);
    for (const word& entry : common) known.found(entry);
    for (const char* entry : laterFunctionEntries()) known.found(entry);
    for (const word& entry : entries()) known.found(entry);
    known.end();

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
    const wallTimes::part timed(name());
    return executeSample();
}


bool Foam::functionObjects::sceneFunctionObject::write()
{
    const wallTimes::part timed(name());
    return writeSample();
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

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sphFunctionObject.H"
#include "gravityMeshObject.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(sphFunctionObject, 0);
}
}


namespace
{
    constexpr Foam::label leastPrecision = 10;
}


// * * * * * * * * * * * * * * * *  The scene  * * * * * * * * * * * * * * * //

bool Foam::functionObjects::sphFunctionObject::hasScene() const
{
    return mesh_.foundObject<sphSceneObject>(sphSceneObject::typeName);
}


const Foam::sphSceneObject&
Foam::functionObjects::sphFunctionObject::sph() const
{
    const auto* scene =
        mesh_.cfindObject<sphSceneObject>(sphSceneObject::typeName);

    if (!scene)
    {
        FatalIOErrorInFunction(dict_)
            << "Function object " << name() << " of type " << type()
            << " needs a running particle scene, and there is no "
            << sphSceneObject::typeName << " on mesh " << mesh_.name() << "."
            << nl << "    It is there while riprapFoam runs with solver"
            << " sphDem; other solvers have none"
            << (postProcess ? ", nor has -postProcess" : "") << "."
            << exit(FatalIOError);
    }

    return *scene;
}


riprap::SampleResult Foam::functionObjects::sphFunctionObject::sample
(
    const pointField& points
) const
{
    return sph().scene().sample(flatPoints(points));
}


// * * * * * * * * * * * * * * * *  Entries  * * * * * * * * * * * * * * * * //

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


// * * * * * * * * * * * * * * * *  Tables * * * * * * * * * * * * * * * * * //

Foam::OFstream& Foam::functionObjects::sphFunctionObject::row
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


void Foam::functionObjects::sphFunctionObject::add
(
    OFstream& os,
    const scalar value
) const
{
    os  << tab << setw(charWidth()) << value;
}


void Foam::functionObjects::sphFunctionObject::writeAtStart()
{
    if (hasScene() && time_.timeIndex() == time_.startTimeIndex())
    {
        write();
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::sphFunctionObject::sphFunctionObject
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

bool Foam::functionObjects::sphFunctionObject::read(const dictionary& dict)
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


bool Foam::functionObjects::sphFunctionObject::execute()
{
    return true;
}


// * * * * * * * * * * * * * * * *  Conversions  * * * * * * * * * * * * * * //

std::vector<double> Foam::functionObjects::flatPoints(const pointField& points)
{
    std::vector<double> flat;
    flat.reserve(3*points.size());

    for (const point& p : points)
    {
        flat.insert(flat.end(), {p.x(), p.y(), p.z()});
    }

    return flat;
}


riprap::Vector3 Foam::functionObjects::toVector3(const vector& v)
{
    return {{v.x(), v.y(), v.z()}};
}


Foam::vector Foam::functionObjects::toVector(const riprap::Vector3& v)
{
    return vector(v[0], v[1], v[2]);
}

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sphFunctionObject.H"

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
            << nl << "    riprapFoam with solver sphDem has one, as has its"
            << " option -postProcess; other solvers and the utility postProcess"
            << " have none."
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


Foam::boundBox Foam::functionObjects::sphFunctionObject::reach() const
{
    boundBox bounds(mesh_.bounds());
    bounds.inflate(sph().config().spacing/bounds.mag());

    if (mesh_.nGeometricD() == 2)
    {
        const label empty = sph().config().axes[2];
        bounds.min()[empty] = -GREAT;
        bounds.max()[empty] = GREAT;
    }

    return bounds;
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
    if (!postProcess && time_.timeIndex() == time_.startTimeIndex())
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

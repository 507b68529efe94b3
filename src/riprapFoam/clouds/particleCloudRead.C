// SPDX-License-Identifier: GPL-3.0-or-later
/*  Reading of clouds. The entries of positions and coordinates: particlePositions.H */

#include "particleCloudIO.H"
#include "particlePositions.H"
#include "cloud.H"
#include "IOField.H"
#include "IOobjectList.H"
#include "listed.H"
#include "OSspecific.H"
#include "Time.H"
#include "api/particleLimit.hpp"

namespace Foam
{

// A positions or coordinates file, of any class that holds one
class positionsReader : public regIOobject
{
public:

    explicit positionsReader(const IOobject& io) : regIOobject(io) {}

    bool writeData(Ostream&) const override { return false; }

    // Stream behind the header
    Istream& stream() { return readStream(word::null); }
};


static fileName instanceOf(const polyMesh& mesh, const fileName& instance)
{
    return instance.empty() ? fileName(mesh.time().timeName()) : instance;
}


static IOobject cloudFile
(
    const polyMesh& mesh,
    const word& cloudName,
    const word& file,
    const fileName& instance
)
{
    return IOobject
    (
        file,
        instanceOf(mesh, instance),
        cloud::prefix/cloudName,
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
}


// A field whose header cannot be read would be taken as one that is not there
static void requireHeaders(const fileName& folder, const IOobjectList& files)
{
    for (const fileName& file : readDir(folder, fileName::FILE))
    {
        if (!files.found(word(file, false)))
        {
            FatalIOErrorInFunction(folder/file)
                << "The file is empty or cut short: it has no header of OpenFOAM's"
                << exit(FatalIOError);
        }
    }
}


template<class T>
static void readFields
(
    const IOobjectList& files,
    label n,
    HashTable<Field<T>>& fields
)
{
    for (const word& name : files.sortedNames(IOField<T>::typeName))
    {
        IOobject io(*files.findObject(name));
        io.readOpt() = IOobject::MUST_READ;
        io.registerObject() = false;
        IOField<T> values(io);
        if (values.size() != n)
        {
            FatalIOErrorInFunction(io.objectPath())
                << "holds " << values.size() << " values for " << n << " particles"
                << exit(FatalIOError);
        }
        fields.set(name, values);
    }
}


// More than a label holds is read as a number
static label readCount(Istream& is)
{
    const scalar count = readScalar(is);
    const scalar most = riprap::mostFluidParticles;
    if (!(count >= 0 && count <= most))
    {
        FatalIOErrorInFunction(is)
            << count << " particles; a cloud, which counts them in 32 bits, can have " << most
            << exit(FatalIOError);
    }
    return label(count);
}


// Positions are in the order of ids: so must be what belongs to them
static void putFieldsInOrder(particleCloud& c)
{
    const labelField* ids = idsOf(c);
    if (!ids) return;
    label i = 1;
    while (i < ids->size() && (*ids)[i] > (*ids)[i - 1]) ++i;
    if (i >= ids->size()) return;

    Info<< "Fields of lagrangian/" << c.name
        << " are not in the order of its positions, as reconstructPar leaves"
        << " them: they are put in the order of ids" << nl << endl;
    const pointField position(c.position);
    const labelList cell(c.cell);
    sortByLabel(c, c.labels.found("id") ? "id" : "origId");
    c.position = position;
    c.cell = cell;
}

} // namespace Foam


bool Foam::hasParticleCloud
(
    const polyMesh& mesh,
    const word& cloudName,
    const fileName& instance
)
{
    for (const word file : {"positions", "coordinates"})
    {
        IOobject io(cloudFile(mesh, cloudName, file, instance));
        if (positionsReader(io).headerOk()) return true;
    }
    return false;
}


bool Foam::isRounded(const polyMesh& mesh, const word& cloudName)
{
    IOobject io(cloudFile(mesh, cloudName, "positions", fileName()));
    return !positionsReader(io).headerOk() && hasParticleCloud(mesh, cloudName);
}


bool Foam::readUndivided
(
    const Time& time,
    const word& cloudName,
    pointField& positions,
    labelField& ids
)
{
    const fileName folder(time.globalPath()/time.timeName()/cloud::prefix/cloudName);
    const auto object = [&](const word& file)
    { return IOobject(file, folder, time, IOobject::MUST_READ, IOobject::NO_WRITE, false); };
    const IOobject io(object("positions"));
    if (!positionsReader(io).headerOk()) return false;

    particleCloud c(cloudName);
    bool ordered = false;
    {
        positionsReader file(io);
        Istream& is = file.stream();
        ordered = file.note() == inOrderOfIds;
        const label n = readCount(is);
        is.readBeginList(cloudName.c_str());
        c.position.setSize(n);
        c.cell.setSize(n);
        readPositions(nullptr, is, c);
        is.readEndList(cloudName.c_str());
        is.fatalCheck(FUNCTION_NAME);
        file.close();
    }
    for (const word field : {"id", "origId"})
    {
        IOobject values(object(field));
        if (values.typeHeaderOk<IOField<label>>(true)) c.labels.set(field, IOField<label>(values));
    }
    const labelField* found = idsOf(c);
    if (!found || found->size() != c.size()) return false;
    if (ordered) putFieldsInOrder(c);
    positions = c.position;
    ids = *idsOf(c);
    return true;
}


Foam::particleCloud Foam::readParticleCloud
(
    const polyMesh& mesh,
    const word& cloudName,
    const fileName& instance
)
{
    IOobject io(cloudFile(mesh, cloudName, "positions", instance));
    const bool asPositions = positionsReader(io).headerOk();
    if (!asPositions)
    {
        io = cloudFile(mesh, cloudName, "coordinates", instance);
    }

    particleCloud c(cloudName);
    bool ordered = false;
    {
        positionsReader file(io);
        Istream& is = file.stream();

        ordered = asPositions && file.note() == inOrderOfIds;
        const label n = readCount(is);
        is.readBeginList(cloudName.c_str());
        c.position.setSize(n);
        c.cell.setSize(n);
        if (asPositions)
        {
            readPositions(&mesh, is, c);
            if (c.cell.found(-1)) c.cell = locateParticles(mesh, c.position, c.cell, true);
        }
        else
        {
            readCoordinates(mesh, is, c);
        }
        is.readEndList(cloudName.c_str());
        is.fatalCheck(FUNCTION_NAME);
        file.close();
    }

    const IOobjectList files(mesh, instanceOf(mesh, instance), cloud::prefix/cloudName);
    requireHeaders(mesh.time().path()/instanceOf(mesh, instance)/cloud::prefix/cloudName, files);
    readFields(files, c.size(), c.labels);
    readFields(files, c.size(), c.scalars);
    readFields(files, c.size(), c.vectors);
    if (ordered) putFieldsInOrder(c);
    return c;
}


template<class T>
static const Foam::Field<T>& required
(
    const Foam::polyMesh& mesh,
    const Foam::particleCloud& c,
    const Foam::HashTable<Foam::Field<T>>& fields,
    const Foam::word& field
)
{
    using namespace Foam;

    if (!fields.found(field))
    {
        FatalIOErrorInFunction(mesh.time().timePath()/cloud::prefix/c.name)
            << "no " << pTraits<T>::typeName << " field " << field << "; there are "
            << listed(fields.sortedToc()).c_str() << exit(FatalIOError);
    }
    return fields[field];
}


const Foam::scalarField& Foam::requiredScalars
(
    const polyMesh& mesh,
    const particleCloud& c,
    const word& field
)
{
    return required(mesh, c, c.scalars, field);
}


const Foam::vectorField& Foam::requiredVectors
(
    const polyMesh& mesh,
    const particleCloud& c,
    const word& field
)
{
    return required(mesh, c, c.vectors, field);
}

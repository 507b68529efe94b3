// SPDX-License-Identifier: GPL-3.0-or-later
/*  Writing of clouds, and what reading and writing share. Reading: particleCloudRead.C, particlePositions.C. */

#include "particleCloudIO.H"
#include "cloud.H"
#include "IOdictionary.H"
#include "IOField.H"
#include "OSspecific.H"
#include "Time.H"

#include <cstring>

namespace Foam
{

// The positions file: class Cloud<passiveParticle>, entries "(x y z) celli"; binary: 3 scalars and one
// label in one block, as Foam::particle::writePosition writes them.
class positionsWriter : public regIOobject
{
    const pointField& position_;
    const labelList& cell_;

public:

    positionsWriter(const IOobject& io, const pointField& position, const labelList& cell)
    :
        regIOobject(io),
        position_(position),
        cell_(cell)
    {}

    virtual const word& type() const
    {
        static const word cloudClass("Cloud<passiveParticle>", false);
        return cloudClass;
    }

    virtual bool writeData(Ostream& os) const
    {
        constexpr std::size_t nBytes = sizeof(point) + sizeof(label);

        os  << position_.size() << nl << token::BEGIN_LIST << nl;
        forAll(position_, i)
        {
            if (os.format() == IOstream::ASCII)
            {
                os  << position_[i] << token::SPACE << cell_[i];
            }
            else
            {
                char block[nBytes];
                std::memcpy(block, &position_[i], sizeof(point));
                std::memcpy(block + sizeof(point), &cell_[i], sizeof(label));
                os.write(block, nBytes);
            }
            os  << nl;
        }
        os  << token::END_LIST << endl;

        return os.good();
    }
};


static bool ascending(const labelField* ids)
{
    for (label i = 1; ids && i < ids->size(); ++i)
    {
        if ((*ids)[i] <= (*ids)[i - 1]) return false;
    }
    return ids;
}


static IOobject cloudFile(const polyMesh& mesh, const word& cloudName, const word& file)
{
    return IOobject
    (
        file,
        mesh.time().timeName(),
        cloud::prefix/cloudName,
        mesh,
        IOobject::NO_READ,
        IOobject::NO_WRITE,
        false
    );
}


template<class T>
static void writeFields
(
    const polyMesh& mesh,
    const particleCloud& c,
    const HashTable<Field<T>>& fields
)
{
    for (const word& field : fields.sortedToc())
    {
        if (fields[field].size() != c.size())
        {
            FatalErrorInFunction
                << "field " << field << " of cloud " << c.name << " has "
                << fields[field].size() << " values for " << c.size() << " particles"
                << exit(FatalError);
        }
        IOField<T>(cloudFile(mesh, c.name, field), fields[field]).write();
    }
}


static IOobject propertiesFile(const objectRegistry& db, const word& cloudName, IOobject::readOption read)
{
    return IOobject
    (
        "cloudProperties",
        db.time().timeName(),
        "uniform"/cloud::prefix/cloudName,
        db,
        read,
        IOobject::NO_WRITE,
        false
    );
}


static void writeCloudProperties(const polyMesh& mesh, const particleCloud& c)
{
    IOdictionary properties(propertiesFile(mesh, c.name, IOobject::NO_READ));
    properties.merge(c.properties);
    properties.add("geometry", cloud::geometryTypeNames[cloud::geometryType::POSITIONS]);

    dictionary count;
    count.add("particleCount", c.size());
    properties.add(word("processor" + Foam::name(Pstream::myProcNo())), count);

    properties.writeObject
    (
        IOstream::ASCII,
        IOstream::currentVersion,
        mesh.time().writeCompression(),
        true
    );
}

} // namespace Foam


const char* const Foam::inOrderOfIds = "in the order of ids";


const Foam::labelField* Foam::idsOf(const particleCloud& c)
{
    for (const char* field : {"id", "origId"})
    {
        if (c.labels.found(field)) return &c.labels[field];
    }
    return nullptr;
}


void Foam::sortByLabel(particleCloud& c, const word& field)
{
    labelList order;
    sortedOrder(c.labels[field], order);

    c.position = pointField(c.position, order);
    if (c.cell.size()) c.cell = labelField(c.cell, order);
    forAllIters(c.labels, iter) iter.val() = labelField(iter.val(), order);
    forAllIters(c.scalars, iter) iter.val() = scalarField(iter.val(), order);
    forAllIters(c.vectors, iter) iter.val() = vectorField(iter.val(), order);
}


void Foam::writeParticleCloud(const polyMesh& mesh, const particleCloud& c)
{
    const labelList cell
    (
        c.cell.size() == c.size() ? c.cell : locateParticles(mesh, c.position, c.cell, true)
    );

    IOobject positions(cloudFile(mesh, c.name, "positions"));
    if (ascending(idsOf(c))) positions.note() = inOrderOfIds;
    positionsWriter(positions, c.position, cell).write();
    writeFields(mesh, c, c.labels);
    writeFields(mesh, c, c.scalars);
    writeFields(mesh, c, c.vectors);
    writeCloudProperties(mesh, c);
}


Foam::dictionary Foam::readCloudProperties(const Time& time, const word& cloudName)
{
    IOobject io(propertiesFile(time, cloudName, IOobject::MUST_READ));
    if (!isFile(io.objectPath())) return dictionary();

    if (!io.typeHeaderOk<IOdictionary>(true))
    {
        FatalIOErrorInFunction(io.objectPath())
            << "The file is empty or cut short: it has no header of OpenFOAM's" << exit(FatalIOError);
    }
    const IOdictionary properties(io);
    const bool written = properties.found("geometry");
    if (!written)
    {
        FatalIOErrorInFunction(properties)
            << "Entry geometry is missing: has the file been cut short?" << exit(FatalIOError);
    }
    return dictionary(properties);
}

// SPDX-License-Identifier: GPL-3.0-or-later
/*  Writing of clouds, and what reading and writing share. Reading: particleCloudRead.C,
    particlePositions.C. */

#include "particleCloudIO.H"
#include "allRanks.H"
#include "cloud.H"
#include "IOdictionary.H"
#include "IOField.H"
#include "localIOdictionary.H"
#include "OSspecific.H"
#include "pictures.H"
#include "sceneState.H"
#include "timeWriter.H"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace Foam
{

// Class Cloud<passiveParticle>, entries "(x y z) celli"; binary: 3 scalars and one label in one
// block, as Foam::particle::writePosition writes them
static void writePositions
(
    fileSink& sink,
    const pointField& position,
    const labelList& cell,
    const listFormat& format
)
{
    const label n = position.size();
    sink.write(std::to_string(n) + "\n(\n");
    if (format.format == IOstream::ASCII)
    {
        writeRows
        (
            sink, n, 4*(riprap::numberSize(format.precision) + 1) + 3,
            [&](char* to, label i)
            {
                to = putText(to, position[i], format.precision);
                *to++ = ' ';
                return putText(to, cell[i], 0);
            }
        );
    }
    else
    {
        writeRows
        (
            sink, n, sizeof(point) + sizeof(label) + 2,
            [&](char* to, label i)
            {
                *to++ = '(';
                std::memcpy(to, position[i].cdata(), sizeof(point));
                std::memcpy(to + sizeof(point), &cell[i], sizeof(label));
                to += sizeof(point) + sizeof(label);
                *to++ = ')';
                return to;
            }
        );
    }
    sink.write(")\n");
}


static bool ascending(const labelField* ids, const labelUList& order)
{
    for (label i = 1; ids && i < order.size(); ++i)
    {
        if ((*ids)[order[i]] <= (*ids)[order[i - 1]]) return false;
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


//- Ordered when it is written
template<class T>
static void writeFields
(
    const polyMesh& mesh,
    const writtenCloud& w,
    const wordList& names,
    HashTable<Field<T>> particleCloud::*fields
)
{
    for (const word& field : names)
    {
        if (!pictures::ofRun().holds(field)) continue;

        writtenFile file(cloudFile(mesh, w.name, field), IOField<T>::typeName, mesh.time());
        file.add
        (
            [content = w.content, fields, field](fileSink& sink, const listFormat& format)
            {
                const cloudContent& c = content.get();
                writeList(sink, Field<T>(((*c.cloud).*fields)[field], c.order), format);
            }
        );
        timeWriter::ofRun().put(std::move(file));
    }
}


template<class T>
static void checkSizes(const word& cloud, label n, const HashTable<Field<T>>& fields)
{
    forAllConstIters(fields, iter)
    {
        if (iter.val().size() == n) continue;

        throw std::runtime_error
        (
            "field " + iter.key() + " of cloud " + cloud + " has "
          + std::to_string(iter.val().size()) + " values for " + std::to_string(n) + " particles"
        );
    }
}


static IOobject propertiesFile(
    const objectRegistry& db, const word& cloudName, IOobject::readOption read)
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


static void writeCloudProperties(const polyMesh& mesh, const writtenCloud& w)
{
    IOdictionary properties(propertiesFile(mesh, w.name, IOobject::NO_READ));
    properties.merge(w.properties);
    properties.add("geometry", cloud::geometryTypeNames[cloud::geometryType::POSITIONS]);

    dictionary count;
    count.add("particleCount", w.size);
    properties.add(word("processor" + Foam::name(Pstream::myProcNo())), count);

    writtenFile file(
        properties, IOdictionary::typeName, IOstream::ASCII, mesh.time().writeCompression());
    file.addWritten([&](Ostream& os) { properties.writeData(os); });
    timeWriter::ofRun().put(std::move(file));
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


Foam::labelList Foam::orderOf(const labelUList& ids)
{
    // Mostly numbers from 0, of which few are missing
    const label n = ids.size();
    label least = 0, most = -1;
    for (const label id : ids)
    {
        least = min(least, id);
        most = max(most, id);
    }
    labelList order;
    if (least < 0 || most > 4*int64_t(n) + 1024)
    {
        sortedOrder(ids, order);
        return order;
    }

    labelList entryOf(most + 1, -1);
    forAll(ids, i)
    {
        label& entry = entryOf[ids[i]];
        if (entry >= 0)
        {
            sortedOrder(ids, order);
            return order;
        }
        entry = i;
    }
    order.setSize(n);
    label next = 0;
    for (const label i : entryOf)
    {
        if (i >= 0) order[next++] = i;
    }
    return order;
}


void Foam::sortByLabel(particleCloud& c, const word& field)
{
    const labelField& ids = c.labels[field];
    if (std::is_sorted(ids.begin(), ids.end())) return;

    const labelList order(orderOf(c.labels[field]));

    c.position = pointField(c.position, order);
    if (c.cell.size()) c.cell = labelField(c.cell, order);
    forAllIters(c.labels, iter) iter.val() = labelField(iter.val(), order);
    forAllIters(c.scalars, iter) iter.val() = scalarField(iter.val(), order);
    forAllIters(c.vectors, iter) iter.val() = vectorField(iter.val(), order);
}


void Foam::particleCloud::requireSize(label n) const
{
    if (position.size() != n)
    {
        throw std::runtime_error
        (
            "cloud " + name + " has " + std::to_string(position.size()) + " particles, not "
          + std::to_string(n)
        );
    }
    checkSizes(name, n, labels);
    checkSizes(name, n, scalars);
    checkSizes(name, n, vectors);
}


Foam::writtenCloud::writtenCloud(const particleCloud& c)
:
    name(c.name),
    size(c.size()),
    labels(c.labels.sortedToc()),
    scalars(c.scalars.sortedToc()),
    vectors(c.vectors.sortedToc())
{}


void Foam::writtenCloud::hold(cloudContent&& there)
{
    const particleCloud& c = *there.cloud;
    size = c.size();
    try
    {
        c.requireSize(size);
    }
    catch (const std::runtime_error& e)
    {
        FatalErrorInFunction << e.what() << exit(FatalError);
    }
    inOrder = ascending(idsOf(c), there.order);
    std::promise<cloudContent> made;
    made.set_value(std::move(there));
    content = made.get_future().share();
}


void Foam::writeParticleCloud(const polyMesh& mesh, const writtenCloud& w)
{
    IOobject positions(cloudFile(mesh, w.name, "positions"));
    if (w.inOrder) positions.note() = inOrderOfIds;
    writtenFile file(positions, word("Cloud<passiveParticle>", false), mesh.time());
    file.add
    (
        [content = w.content](fileSink& sink, const listFormat& format)
        {
            const cloudContent& c = content.get();
            writePositions(sink, pointField(c.cloud->position, c.order), c.cell, format);
        }
    );
    timeWriter::ofRun().put(std::move(file));
    writeFields(mesh, w, w.labels, &particleCloud::labels);
    writeFields(mesh, w, w.scalars, &particleCloud::scalars);
    writeFields(mesh, w, w.vectors, &particleCloud::vectors);
    writeCloudProperties(mesh, w);
}


void Foam::writeParticleCloud(const polyMesh& mesh, const particleCloud& c)
{
    writtenCloud w(c);
    w.properties = c.properties;
    w.hold
    (
        {
            std::make_shared<const particleCloud>(c),
            identity(c.size()),
            c.cell.size() == c.size() ? c.cell : locateParticles(mesh, c.position, c.cell, true)
        }
    );
    writeParticleCloud(mesh, w);
}


Foam::dictionary Foam::readCloudProperties(const Time& time, const word& cloudName)
{
    IOobject io(propertiesFile(time, cloudName, IOobject::MUST_READ));
    if (!onAnyRank(Pstream::master() && isFile(io.objectPath()))) return dictionary();

    if (Pstream::master() && !io.typeHeaderOk<localIOdictionary>(true))
    {
        FatalIOErrorInFunction(io.objectPath())
            << "The file is empty or cut short: it has no header of OpenFOAM's"
            << exit(FatalIOError);
    }
    dictionary properties(stateDictionary(io));
    const bool written = properties.found("geometry");
    if (!written)
    {
        FatalIOErrorInFunction(properties)
            << "Entry geometry is missing: has the file been cut short?" << exit(FatalIOError);
    }
    return properties;
}

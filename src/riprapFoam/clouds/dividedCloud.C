/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dividedCloud.H"
#include "allRanks.H"
#include "boundBox.H"
#include "cloud.H"
#include "indexedOctree.H"
#include "OSspecific.H"
#include "toStdVector.H"
#include "pstreamTransport.H"
#include "treeDataCell.H"
#include <set>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

using bytesOfRanks = std::vector<riprap::RankBytes>;


//- Fields of each type, by name
struct cloudFields
{
    wordList labels, scalars, vectors;
};


static std::string namesOf(const particleCloud& c)
{
    std::string text;
    for (const word& name : c.labels.sortedToc()) text += "0 " + name + '\n';
    for (const word& name : c.scalars.sortedToc()) text += "1 " + name + '\n';
    for (const word& name : c.vectors.sortedToc()) text += "2 " + name + '\n';
    return text;
}


//- Those of all processes. A process without particles may have no fields
static cloudFields fieldsOfRanks(const particleCloud& c)
{
    std::set<std::string> lines;
    for (const std::string& text : textsOfRanks(namesOf(c)))
    {
        std::istringstream in(text);
        for (std::string line; std::getline(in, line);) lines.insert(line);
    }
    cloudFields fields;
    for (const std::string& line : lines)
    {
        wordList& names =
            line[0] == '0' ? fields.labels
          : line[0] == '1' ? fields.scalars : fields.vectors;
        names.append(word(line.substr(2), false));
    }
    return fields;
}


template<class T>
static void addMissing
(
    HashTable<Field<T>>& fields,
    const wordList& names,
    const particleCloud& c
)
{
    std::string missing;
    for (const word& name : names)
    {
        if (fields.found(name)) continue;
        if (c.size()) missing += ' ' + name;
        fields.set(name, Field<T>(c.size(), Zero));
    }
    stopIfAny
    (
        missing.empty() ? missing
      : "lagrangian/" + c.name + " of processor"
      + std::to_string(Pstream::myProcNo()) + " has no field" + missing
      + ", which other processors have"
    );
}


//- Some entries of a cloud
static riprap::RankBytes pack
(
    const particleCloud& c,
    const cloudFields& fields,
    const labelUList& entries
)
{
    riprap::RankBytes to;
    const label n = entries.size();
    riprap::putValues(to, &n);
    const auto put = [&](const auto& values)
    {
        for (const label i : entries) riprap::putValues(to, &values[i]);
    };
    put(c.position);
    put(c.cell);
    for (const word& name : fields.labels) put(c.labels[name]);
    for (const word& name : fields.scalars) put(c.scalars[name]);
    for (const word& name : fields.vectors) put(c.vectors[name]);
    return to;
}


//- Clouds that were packed, one after the other
static void unpack
(
    const bytesOfRanks& all,
    const cloudFields& fields,
    particleCloud& c
)
{
    label n = 0;
    for (const riprap::RankBytes& bytes : all)
    {
        if (bytes.empty()) continue;
        label more;
        std::memcpy(&more, bytes.data(), sizeof(more));
        n += more;
    }
    c.position.setSize(n);
    c.cell.setSize(n);
    c.labels.clear();
    c.scalars.clear();
    c.vectors.clear();
    for (const word& name : fields.labels) c.labels.set(name, labelField(n));
    for (const word& name : fields.scalars) c.scalars.set(name, scalarField(n));
    for (const word& name : fields.vectors) c.vectors.set(name, vectorField(n));

    label first = 0;
    for (const riprap::RankBytes& bytes : all)
    {
        if (bytes.empty()) continue;
        const unsigned char* from = bytes.data();
        label more;
        takeBytes(from, &more);
        const auto take = [&](auto& values)
        {
            if (more) takeBytes(from, &values[first], std::size_t(more));
        };
        take(c.position);
        take(c.cell);
        for (const word& name : fields.labels) take(c.labels[name]);
        for (const word& name : fields.scalars) take(c.scalars[name]);
        for (const word& name : fields.vectors) take(c.vectors[name]);
        first += more;
    }
}


//- The same fields on all processes
static cloudFields agree(particleCloud& c)
{
    cloudFields fields(fieldsOfRanks(c));
    addMissing(c.labels, fields.labels, c);
    addMissing(c.scalars, fields.scalars, c);
    addMissing(c.vectors, fields.vectors, c);
    return fields;
}


static void gather(particleCloud& c)
{
    const cloudFields fields(agree(c));
    pstreamTransport ranks;
    bytesOfRanks all;
    ranks.exchange
    (
        bytesOfRanks(ranks.size(), pack(c, fields, identity(c.size()))), all
    );
    unpack(all, fields, c);
}


//- decomposePar writes barycentric coordinates, with as many digits as the case
//  writes: positions come back rounded. What it has divided has them all
static void takeExactPositions(const polyMesh& mesh, particleCloud& c)
{
    pointField positions;
    labelField ids;
    riprap::RankBytes bytes;
    if (Pstream::master() && readUndivided(mesh.time(), c.name, positions, ids))
    {
        riprap::putValues(bytes, ids.cdata(), ids.size());
        riprap::putValues(bytes, positions.cdata(), positions.size());
    }
    pstreamTransport ranks;
    bytesOfRanks all;
    ranks.exchange(bytesOfRanks(ranks.size(), bytes), all);
    const riprap::RankBytes& whole = all[0];
    const label n = whole.size()/(sizeof(label) + sizeof(point));
    const labelField* own = idsOf(c);
    if (!own || n != c.size()) return;

    ids.setSize(n);
    positions.setSize(n);
    const unsigned char* from = whole.data();
    takeBytes(from, ids.data(), n);
    takeBytes(from, positions.data(), n);

    Map<label> entryOf(2*n);
    forAll(ids, i) entryOf.insert(ids[i], i);
    const scalar digits =
        mesh.time().writeFormat() == IOstream::BINARY
      ? 0 : pow(10.0, 1 - scalar(IOstream::defaultPrecision()));
    const scalar close = max(1e-9, digits)*mesh.bounds().mag();
    forAll(*own, i)
    {
        const label k = entryOf.lookup((*own)[i], -1);
        if (k < 0 || !(mag(positions[k] - c.position[i]) <= close)) return;
    }
    forAll(*own, i) c.position[i] = positions[entryOf[(*own)[i]]];
    Info<< "Positions of lagrangian/" << c.name << " are those of the case: the"
        << " processors' are rounded" << nl << endl;
}


//- Of each process the box of its mesh, as bytes; none: it has no cells
static bytesOfRanks boxesOfRanks(pstreamTransport& ranks, const polyMesh& mesh)
{
    boundBox own(mesh.points(), false);
    if (mesh.nPoints()) own.inflate(1e-6);
    riprap::RankBytes bytes;
    if (mesh.nCells()) riprap::putValues(bytes, &own);
    bytesOfRanks boxes;
    ranks.exchange(bytesOfRanks(ranks.size(), bytes), boxes);
    return boxes;
}


//- Those of the points wanted that a process with this box may know; with
//  nearest all
static labelList pointsFor
(
    const riprap::RankBytes& bytes,
    const pointField& points,
    const boolList& wanted,
    bool nearest
)
{
    if (bytes.empty()) return labelList();
    DynamicList<label> some;
    boundBox box;
    const unsigned char* from = bytes.data();
    takeBytes(from, &box);
    forAll(points, i)
    {
        if (wanted[i] && (nearest || box.contains(points[i]))) some.append(i);
    }
    return labelList(std::move(some));
}


//- Of each point that a process asks for: the cell of this one, -1: none, and
//  with nearest how far it is
static riprap::RankBytes answerCells
(
    const polyMesh& mesh,
    const riprap::RankBytes& asked,
    bool nearest
)
{
    const unsigned char* from = asked.data();
    pointField there(label(asked.size()/sizeof(point)));
    takeBytes(from, there.data(), there.size());
    const labelList cell(locateParticles(mesh, there, labelList(), nearest));
    riprap::RankBytes answer;
    forAll(there, i)
    {
        scalar far = 0;
        if (nearest)
        {
            far = mag
            (
                mesh.cellTree().findNearest(there[i], sqr(GREAT)).hitPoint()
              - there[i]
            );
        }
        riprap::putValues(answer, &cell[i]);
        riprap::putValues(answer, &far);
    }
    return answer;
}


//- Which process has the cell that each point is in, and its number there;
//  asked of those whose meshes may have it. Else, with nearest, of all: the cell
//  that is nearest
static void askForCells
(
    const polyMesh& mesh,
    const pointField& points,
    const boolList& wanted,
    bool nearest,
    labelList& rankOf,
    labelList& cellOf
)
{
    pstreamTransport ranks;
    const bytesOfRanks boxes(boxesOfRanks(ranks, mesh));

    bytesOfRanks out(ranks.size()), in, back(ranks.size()), answers;
    std::vector<labelList> asked(ranks.size());
    for (int rank = 0; rank < ranks.size(); ++rank)
    {
        asked[rank] = pointsFor(boxes[rank], points, wanted, nearest);
        for (const label i : asked[rank]) riprap::putValues(out[rank], &points[i]);
    }
    ranks.exchange(out, in);

    for (int rank = 0; rank < ranks.size(); ++rank)
    {
        back[rank] = answerCells(mesh, in[rank], nearest);
    }
    ranks.exchange(back, answers);

    scalarField least(points.size(), GREAT);
    for (int rank = 0; rank < ranks.size(); ++rank)
    {
        const unsigned char* from = answers[rank].data();
        for (const label i : asked[rank])
        {
            label cell;
            scalar far;
            takeBytes(from, &cell);
            takeBytes(from, &far);
            if (cell < 0 || !(far < least[i])) continue;
            least[i] = far;
            rankOf[i] = rank;
            cellOf[i] = cell;
        }
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::particleCloud Foam::readWholeCloud
(
    const polyMesh& mesh,
    const word& cloudName
)
{
    if (!Pstream::parRun())
    {
        requireCloud(mesh, cloudName);
        return readParticleCloud(mesh, cloudName);
    }

    // What all processes must take part in, before some read coordinates
    mesh.tetBasePtIs();
    const bool here = hasParticleCloud(mesh, cloudName);
    if (!onAnyRank(here)) requireCloud(mesh, cloudName);
    particleCloud cloud(cloudName);
    if (here) cloud = readParticleCloud(mesh, cloudName);
    const bool rounded = onAnyRank(here && isRounded(mesh, cloudName));
    gather(cloud);
    if (rounded) takeExactPositions(mesh, cloud);
    return cloud;
}


bool Foam::hasCloudFolder(const Time& time, const word& cloudName)
{
    return onAnyRank(isDir(time.timePath()/"lagrangian"/cloudName));
}


Foam::label Foam::sendToCells(const polyMesh& mesh, particleCloud& c)
{
    // Cells' trees need it of all processes
    mesh.tetBasePtIs();
    const label n = max(c.size(), label(0));     // what g++ 12 cannot know
    labelList rankOf(n, -1), cellOf(n, -1);
    boolList wanted(n, true);
    askForCells(mesh, c.position, wanted, false, rankOf, cellOf);
    label outside = 0;
    forAll(wanted, i)
    {
        wanted[i] = rankOf[i] < 0;
        outside += wanted[i];
    }
    outside = returnReduce(outside, sumOp<label>());
    if (outside) askForCells(mesh, c.position, wanted, true, rankOf, cellOf);

    c.cell = cellOf;
    const cloudFields fields(agree(c));
    pstreamTransport ranks;
    bytesOfRanks out(ranks.size()), in;
    for (int rank = 0; rank < ranks.size(); ++rank)
    {
        DynamicList<label> some;
        forAll(rankOf, i)
        {
            if (rankOf[i] == rank) some.append(i);
        }
        out[rank] = pack(c, fields, some);
    }
    ranks.exchange(out, in);
    unpack(in, fields, c);
    return outside;
}


Foam::boolList Foam::inAnyCell(const polyMesh& mesh, const pointField& points)
{
    if (Pstream::parRun()) mesh.tetBasePtIs();
    const labelList cell(locateParticles(mesh, points, labelList(), false));
    std::vector<std::int64_t> found(cell.size());
    forAll(cell, i) found[i] = cell[i] >= 0;
    if (Pstream::parRun()) pstreamTransport().sum(found);

    boolList inside(points.size());
    forAll(inside, i) inside[i] = found[i] > 0;
    return inside;
}


// ************************************************************************* //

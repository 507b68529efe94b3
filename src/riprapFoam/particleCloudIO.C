// SPDX-License-Identifier: GPL-3.0-or-later
/*  Writing of clouds, and what reading and writing share. Reading: particleCloudRead.C, particlePositions.C. */

#include "particleCloudIO.H"
#include "cloud.H"
#include "IOdictionary.H"
#include "IOField.H"
#include "Time.H"
#include "indexedOctree.H"
#include "treeDataCell.H"

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

// From cell to cell through the face that the point is farthest outside of; -1: it leaves the mesh, or is too far for a walk. The search in
// OpenFOAM's tree of cells takes each of them apart into tetrahedra, a millisecond a point
static label walkToCell(const polyMesh& mesh, const point& p, label celli)
{
    constexpr label longest = 1000;
    for (label step = 0; step < longest; ++step)
    {
        label through = -1;
        scalar most = 0;
        for (const label facei : mesh.cells()[celli])
        {
            const scalar side = mesh.faceOwner()[facei] == celli ? 1 : -1;
            const vector& area = mesh.faceAreas()[facei];
            const scalar outside = side*((p - mesh.faceCentres()[facei]) & area)/mag(area);
            if (outside > most)
            {
                most = outside;
                through = facei;
            }
        }
        if (through < 0) return celli;
        if (!mesh.isInternalFace(through)) return -1;
        celli = mesh.faceOwner()[through] == celli ? mesh.faceNeighbour()[through] : mesh.faceOwner()[through];
    }
    return -1;
}

} // namespace Foam


Foam::labelList Foam::locateParticles
(
    const polyMesh& mesh,
    const pointField& points,
    const labelList& hint,
    bool nearest
)
{
    labelList cell(points.size(), -1);
    const auto& tree = mesh.cellTree();

    label last = -1;
    forAll(points, i)
    {
        const point& p = points[i];
        label guess = hint.size() == points.size() && hint[i] >= 0 ? hint[i] : last;
        if (guess >= 0 && guess < mesh.nCells()) guess = walkToCell(mesh, p, guess);

        if (guess >= 0 && guess < mesh.nCells() && mesh.pointInCell(p, guess))
        {
            cell[i] = guess;
        }
        else if (mesh.nCells())
        {
            cell[i] = tree.findInside(p);
            if (cell[i] < 0 && nearest)
            {
                cell[i] = tree.findNearest(p, sqr(GREAT)).index();
            }
        }
        if (cell[i] >= 0) last = cell[i];
    }
    return cell;
}


void Foam::writeParticleCloud(const polyMesh& mesh, const particleCloud& c)
{
    const labelList cell
    (
        c.cell.size() == c.size() ? c.cell : locateParticles(mesh, c.position, c.cell, true)
    );

    positionsWriter(cloudFile(mesh, c.name, "positions"), c.position, cell).write();
    writeFields(mesh, c, c.labels);
    writeFields(mesh, c, c.scalars);
    writeFields(mesh, c, c.vectors);
    writeCloudProperties(mesh, c);
}


Foam::dictionary Foam::readCloudProperties(const Time& time, const word& cloudName)
{
    IOobject io(propertiesFile(time, cloudName, IOobject::MUST_READ));
    return io.typeHeaderOk<IOdictionary>(true) ? dictionary(IOdictionary(io)) : dictionary();
}

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sceneCloud.H"
#include "cellLattice.H"
#include "dividedCloud.H"
#include "pictures.H"
#include "timeWriter.H"
#include "Time.H"
#include <utility>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(sceneCloud, 0);

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

template<class T>
static void addFields(const HashTable<Field<T>>& fields, objectRegistry& obr)
{
    forAllConstIters(fields, iter)
    {
        cloud::createIOField<T>(iter.key(), iter.val().size(), obr) = iter.val();
    }
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

vectorField toVectors(const std::vector<double>& xyz)
{
    vectorField v(label(xyz.size()/3));
    #pragma omp parallel for schedule(static) if (v.size() > 10000)
    for (label i = 0; i < v.size(); ++i)
    {
        const double* x = &xyz[3*std::size_t(i)];
        v[i] = vector(x[0], x[1], x[2]);
    }
    return v;
}

} // End namespace Foam


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

Foam::labelList Foam::sceneCloud::locate
(
    const pointField& position,
    const labelUList& id,
    label& nOutside,
    const cellLattice& lattice
) const
{
    labelList before;
    if (!lattice)
    {
        // setParticles numbers from 0: one label a particle that ever was
        cellOfId_.resize(max(cellOfId_.size(), id.empty() ? 0 : max(id) + 1), -1);
        before = labelList(cellOfId_, id);
    }
    labelList cell(locateParticles(mesh_, position, before, false, &lattice));

    DynamicList<label> outside;
    forAll(cell, i)
    {
        if (before.size()) cellOfId_[id[i]] = cell[i];
        if (cell[i] < 0)
        {
            outside.append(i);
        }
    }

    // OpenFOAM's utilities do not accept a particle that is in no cell
    const labelList nearest
    (
        locateParticles(
            mesh_, pointField(position, outside), labelList(), true, &lattice)
    );
    forAll(outside, i)
    {
        cell[outside[i]] = nearest[i];
    }

    nOutside = outside.size();
    return cell;
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

const Foam::word& Foam::sceneCloud::idField() const
{
    static const word name("id");
    return name;
}


const Foam::particleCloud& Foam::sceneCloud::fetch() const
{
    if (!particles_)
    {
        auto particles = std::make_shared<particleCloud>(name());
        fill(*particles);
        if (Pstream::parRun()) outside_ = sendToCells(mesh_, *particles);
        particles_ = particles;
    }
    return *particles_;
}


std::function<void(Foam::particleCloud&)> Foam::sceneCloud::fillLater
(
    particleCloud&,
    label&
) const
{
    return nullptr;
}


Foam::writtenCloud Foam::sceneCloud::writtenNow(label& outside) const
{
    const particleCloud& particles = fetch();
    const labelField& id = particles.labels[idField()];
    cloudContent content;
    content.cloud = particles_;
    content.order = orderOf(id);
    outside = outside_;
    content.cell = Pstream::parRun()
      ? labelList(labelField(particles.cell, content.order))
      : locate
        (
            pointField(particles.position, content.order),
            labelList(id, content.order),
            outside,
            latticeOfMesh::cells(mesh_)
        );
    writtenCloud written(particles);
    written.hold(std::move(content));
    return written;
}


//- Cells by place alone: other ways to them change what the mesh keeps.
//  Without content: it is to be made now
Foam::writtenCloud Foam::sceneCloud::writtenLater() const
{
    particleCloud names(name());
    writtenCloud written(names);
    if (particles_ || Pstream::parRun() || !timeWriter::ofRun().fillsLater()) return written;

    const cellLattice& lattice = latticeOfMesh::cells(mesh_);
    if (!lattice) return written;

    auto fill = fillLater(names, written.size);
    if (!fill) return written;

    const label size = written.size;
    written = writtenCloud(names);
    written.size = size;
    written.inOrder = true;
    auto make =
        [fill = std::move(fill), this, &lattice, size, at = time().timeName()]() mutable
        {
            auto particles = std::make_shared<particleCloud>(name());
            // What it holds on the device is given back with it
            std::exchange(fill, nullptr)(*particles);
            particles->requireSize(size);
            const labelField& id = particles->labels[idField()];
            cloudContent content;
            content.order = orderOf(id);
            label outside = 0;
            content.cell =
                locate(pointField(particles->position, content.order), id, outside, lattice);
            content.cloud = std::move(particles);
            if (outside)
            {
                timeWriter::ofRun().tell
                (
                    "Time " + at + ": " + std::to_string(outside)
                  + " of the written particles are outside the mesh"
                );
            }
            return content;
        };
    written.content = std::async(std::launch::deferred, std::move(make)).share();
    return written;
}


bool Foam::sceneCloud::writeAs(const IOstreamOption&, bool) const
{
    // First, since the scene then goes on as one that was given this state
    const bool picture = pictures::ofRun().now();
    writeState(picture);
    if (!picture) particles_.reset();

    label outside = 0;
    writtenCloud written(writtenLater());
    if (!written.content.valid()) written = writtenNow(outside);
    addProperties(written.properties);
    writeParticleCloud(mesh_, written);
    if (timeWriter::ofRun().onTrial()) return true;

    Info<< "Written " << time().timeName() << ": "
        << returnReduce(written.size, sumOp<label>()) << " particles"
        << (picture ? ", a picture" : "");
    if (outside)
    {
        Info<< ", " << outside << " of them outside the mesh";
    }
    Info<< nl << endl;

    return true;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::sceneCloud::sceneCloud(const polyMesh& mesh, const word& name)
:
    writesItself<cloud>(mesh, name),
    mesh_(mesh)
{}


Foam::sceneCloud::~sceneCloud() = default;


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::sceneCloud::fieldNames() const
{
    const particleCloud& particles = fetch();
    wordList names(particles.labels.sortedToc());
    names.append(particles.scalars.sortedToc());
    names.append(particles.vectors.sortedToc());
    return names;
}


Foam::label Foam::sceneCloud::nParcels() const
{
    return fetch().size();
}


void Foam::sceneCloud::writeObjects(objectRegistry& obr) const
{
    const particleCloud& particles = fetch();

    cloud::createIOField<point>("position", particles.size(), obr) =
        particles.position;
    addFields(particles.labels, obr);
    addFields(particles.scalars, obr);
    addFields(particles.vectors, obr);
}


// ************************************************************************* //

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
    label& nOutside
) const
{
    if (!lattice_) lattice_ = std::make_unique<const cellLattice>(mesh_);
    labelList before;
    if (!*lattice_)
    {
        // setParticles numbers from 0: one label a particle that ever was
        cellOfId_.resize(max(cellOfId_.size(), id.empty() ? 0 : max(id) + 1), -1);
        before = labelList(cellOfId_, id);
    }
    labelList cell(locateParticles(mesh_, position, before, false, lattice_.get()));

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
            mesh_, pointField(position, outside), labelList(), true, lattice_.get())
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


bool Foam::sceneCloud::writeAs(const IOstreamOption&, bool) const
{
    // First, since the scene then goes on as one that was given this state
    const bool picture = pictures::ofRun().now();
    writeState(picture);
    if (!picture) particles_.reset();

    const particleCloud& particles = fetch();
    const labelField& id = particles.labels[idField()];
    const labelList order(orderOf(id));
    label nOutside = outside_;
    writtenCloud written;
    written.cell = std::make_shared<const labelList>
    (
        Pstream::parRun()
      ? labelList(labelField(particles.cell, order))
      : locate
        (
            pointField(particles.position, order),
            labelList(id, order),
            nOutside
        )
    );
    written.cloud = particles_;
    written.order = std::make_shared<const labelList>(order);
    addProperties(written.properties);
    writeParticleCloud(mesh_, written);
    if (timeWriter::ofRun().onTrial()) return true;

    Info<< "Written " << time().timeName() << ": "
        << returnReduce(particles.size(), sumOp<label>()) << " particles"
        << (picture ? ", a picture" : "");
    if (nOutside)
    {
        Info<< ", " << nOutside << " of them outside the mesh";
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

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fluidCloud.H"
#include "Time.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(fluidCloud, 0);

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static vectorField toVectors(const std::vector<double>& xyz)
{
    vectorField v(label(xyz.size()/3));
    forAll(v, i)
    {
        v[i] = vector(xyz[3*i], xyz[3*i + 1], xyz[3*i + 2]);
    }
    return v;
}


template<class T, class S>
static Field<T> toField(const std::vector<S>& values)
{
    Field<T> field(label(values.size()));
    std::copy(values.begin(), values.end(), field.begin());
    return field;
}


template<class T>
static void addFields(const HashTable<Field<T>>& fields, objectRegistry& obr)
{
    forAllConstIters(fields, iter)
    {
        cloud::createIOField<T>(iter.key(), iter.val().size(), obr) = iter.val();
    }
}

} // End namespace Foam


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

const Foam::particleCloud& Foam::fluidCloud::fetch() const
{
    if (!fetched_)
    {
        const riprap::FluidState fluid(scene_.fluid());

        particles_.position = toVectors(fluid.position);
        particles_.vectors.set("U", toVectors(fluid.velocity));
        particles_.scalars.set("rho", toField<scalar>(fluid.density));
        particles_.scalars.set("p", toField<scalar>(fluid.pressure));
        particles_.scalars.set("h", toField<scalar>(fluid.smoothingLength));
        particles_.labels.set("id", toField<label>(fluid.id));
        particles_.cell.clear();
        fetched_ = true;
    }
    return particles_;
}


Foam::label Foam::fluidCloud::locate(particleCloud& particles) const
{
    const labelField& id = particles.labels["id"];

    // setParticles numbers from 0: one label a particle that ever was
    cellOfId_.resize(max(cellOfId_.size(), max(id) + 1), -1);
    labelList& cell = particles.cell;
    cell = locateParticles(mesh_, particles.position, labelList(cellOfId_, id), false);

    DynamicList<label> outside;
    forAll(cell, i)
    {
        cellOfId_[id[i]] = cell[i];
        if (cell[i] < 0)
        {
            outside.append(i);
        }
    }

    // OpenFOAM's utilities do not accept a particle that is in no cell
    const labelList nearest
    (
        locateParticles
        (
            mesh_,
            pointField(particles.position, outside),
            labelList(),
            true
        )
    );
    forAll(outside, i)
    {
        cell[outside[i]] = nearest[i];
    }

    return outside.size();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fluidCloud::fluidCloud
(
    const polyMesh& mesh,
    riprap::SphScene& scene,
    const sphRun& run
)
:
    cloud(mesh, "fluid"),
    mesh_(mesh),
    scene_(scene),
    run_(run),
    particles_("fluid")
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::fluidCloud::nParcels() const
{
    return fetch().size();
}


void Foam::fluidCloud::writeObjects(objectRegistry& obr) const
{
    const particleCloud& particles = fetch();

    cloud::createIOField<point>("position", particles.size(), obr) =
        particles.position;
    addFields(particles.labels, obr);
    addFields(particles.scalars, obr);
    addFields(particles.vectors, obr);
}


bool Foam::fluidCloud::writeObject
(
    IOstream::streamFormat,
    IOstream::versionNumber,
    IOstream::compressionType,
    const bool
) const
{
    // First, since the scene then goes on as one that was given this state
    const std::vector<std::int32_t> state(scene_.saveState());
    fetched_ = false;

    particleCloud particles(fetch());
    particles.properties.add("spacing", run_.spacing);
    const label nOutside = locate(particles);
    writeParticleCloud(mesh_, particles);

    writeSphState(time(), state);
    writeSphRun(time(), run_);

    Info<< "Written " << time().timeName() << ": " << particles.size()
        << " particles";
    if (nOutside)
    {
        Info<< ", " << nOutside << " of them outside the mesh";
    }
    Info<< nl << endl;

    return true;
}


// ************************************************************************* //

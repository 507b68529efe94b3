/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidCloud.H"
#include "core/ranks/joinRanks.hpp"
#include "idIndex.H"
#include "pstreamTransport.H"
#include "quaternion.H"
#include "sceneState.H"
#include "solidFiles.H"
#include "timeWriter.H"
#include <algorithm>

namespace Foam
{
    defineTypeNameAndDebug(solidCloud, 0);

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Axis times angle, from 0 to pi
static vectorField rotationVectors(const std::vector<double>& wxyz)
{
    vectorField turned(label(wxyz.size()/4));
    #pragma omp parallel for schedule(static) if (turned.size() > 10000)
    for (label i = 0; i < turned.size(); ++i)
    {
        const double* q = &wxyz[4*std::size_t(i)];
        const vector imaginary(sign(q[0])*vector(q[1], q[2], q[3]));
        const scalar length = mag(imaginary);
        turned[i] = length > VSMALL
          ? vector(2*atan2(length, mag(q[0]))/length*imaginary)
          : vector(Zero);
    }
    return turned;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solidCloud::solidCloud
(
    const polyMesh& mesh,
    riprap::DemScene& part,
    riprap::DemScene& scene,
    const demSettings& settings,
    const riprap::DemInput& input,
    const labelList& typeOfBondType,
    const demRestart& run,
    bool writesState
)
:
    sceneCloud(mesh, "solids"),
    part_(part),
    scene_(scene),
    settings_(settings),
    input_(input),
    typeOfBondType_(typeOfBondType),
    run_(run),
    writesState_(writesState),
    shapes_(readCloudProperties(mesh.time(), "solids").subOrEmptyDict("shapes")),
    surfaces_(readCloudProperties(mesh.time(), "solids").subOrEmptyDict("surfaces"))
{
    if (input_.bonds.size() || run_.brokenBefore > 0)
    {
        readBrokenBonds();
    }
}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::solidCloud::readBrokenBonds()
{
    // A process without particles may have no files
    std::vector<label> broken, id;
    if (!Pstream::parRun() || hasParticleCloud(mesh(), "solids"))
    {
        const particleCloud read(readParticleCloud(mesh(), "solids"));
        if (read.labels.found("brokenBonds") && read.labels.found("origId"))
        {
            const labelField& b = read.labels["brokenBonds"];
            const labelField& i = read.labels["origId"];
            broken.assign(b.begin(), b.end());
            id.assign(i.begin(), i.end());
        }
    }
    if (Pstream::parRun())
    {
        pstreamTransport ranks;
        riprap::join(ranks, broken);
        riprap::join(ranks, id);
    }
    if (id.empty()) return;

    for (std::size_t i = 0; i < id.size(); ++i)
    {
        brokenBefore_.insert(id[i], broken[i]);
    }

    const riprap::DemState now(scene_.particles());
    for (std::size_t i = 0; i < now.id.size(); ++i)
    {
        label& before = brokenBefore_(now.id[i], 0);
        before = max(before - now.brokenBonds[i], label(0));
    }
}


//- A continued run is given those alone, and shall write the same
riprap::DemBondState Foam::solidCloud::bonds
(
    const riprap::DemState& particles,
    int64_t& lost
) const
{
    const idIndex there(particles.id);

    const riprap::DemBondState all(scene_.bonds());
    riprap::DemBondState bonds;
    lost = 0;
    for (std::size_t k = 0; k < all.a.size(); ++k)
    {
        if (there(all.a[k]) < 0 || there(all.b[k]) < 0)
        {
            ++lost;
            continue;
        }
        bonds.a.push_back(all.a[k]);
        bonds.b.push_back(all.b[k]);
        bonds.type.push_back(typeOfBondType_[all.type[k]]);
        bonds.broken.push_back(all.broken[k]);
        bonds.gap.push_back(all.gap[k]);
        bonds.restGap.push_back(all.restGap[k]);
        for (int d = 0; d < 3; ++d)
        {
            bonds.force.push_back(all.force[3*k + d]);
            bonds.moment.push_back(all.moment[3*k + d]);
        }
    }
    return bonds;
}


//- What never changes as it was given, not as the scene's precision has
//  rounded it: a continued run must be given the same
void Foam::solidCloud::setConstants
(
    const riprap::DemState& now,
    particleCloud& particles
) const
{
    const riprap::DemParticles& given = input_.particles;
    const label n = particles.size();
    const bool inertias = given.inertia.size();
    scalarField radius(n), mass(n), inertia(inertias ? n : 0);
    #pragma omp parallel for schedule(static) if (n > 10000)
    for (label i = 0; i < n; ++i)
    {
        // The input is in the order of ids, mostly numbers from 0
        std::size_t j = now.id[i];
        if (j >= given.id.size() || given.id[j] != now.id[i])
        {
            j = std::lower_bound(given.id.begin(), given.id.end(), now.id[i])
              - given.id.begin();
        }
        radius[i] = given.radius[j];
        mass[i] = given.mass[j];
        if (inertias) inertia[i] = given.inertia[j];
    }
    particles.scalars.set("radius", std::move(radius));
    particles.scalars.set("mass", std::move(mass));
    if (inertias) particles.scalars.set("inertia", std::move(inertia));
}


void Foam::solidCloud::writeClumps() const
{
    const riprap::DemClumpState now(scene_.clumps());
    std::vector<riprap::DemClump> clumps(input_.clumps);
    for (std::size_t i = 0; i < clumps.size(); ++i)
    {
        if (!clumps[i].moved)
        {
            clumps[i].moved = true;
            clumps[i].start = {clumps[i].position, clumps[i].orientation};
        }
        for (int d = 0; d < 3; ++d)
        {
            clumps[i].position[d] = now.position[3*i + d];
            clumps[i].velocity[d] = now.velocity[3*i + d];
            clumps[i].spin[d] = now.spin[3*i + d];
        }
        for (int d = 0; d < 4; ++d)
        {
            clumps[i].orientation[d] = now.orientation[4*i + d];
        }
    }
    // Each process has them all
    if (Pstream::master()) writeClumpFiles(time(), clumps);
}


//- Where each process has all solids, as those in water are, it gives its share
//  of them to those whose cells they are in
riprap::DemState Foam::solidCloud::ownParticles() const
{
    riprap::DemState all(part_.particles());
    if (!Pstream::parRun() || &part_ != &scene_) return all;

    const std::size_t n = all.id.size();
    const std::size_t me = Pstream::myProcNo(), processes = Pstream::nProcs();
    const std::size_t first = n*me/processes, last = n*(me + 1)/processes;
    const auto keep = [=](auto& values)
    {
        const std::size_t each = values.size()/max(n, std::size_t(1));
        values = std::decay_t<decltype(values)>
        (
            values.begin() + first*each, values.begin() + last*each
        );
    };
    for (auto* v : {&all.position, &all.velocity, &all.spin, &all.force, &all.moment}) keep(*v);
    for (auto* v : {&all.orientation, &all.radius, &all.mass}) keep(*v);
    for (auto* v : {&all.material, &all.group, &all.clump}) keep(*v);
    for (auto* v : {&all.contacts, &all.brokenBonds, &all.id}) keep(*v);
    return all;
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

const Foam::word& Foam::solidCloud::idField() const
{
    static const word name("origId");
    return name;
}


void Foam::solidCloud::fill(particleCloud& particles) const
{
    const riprap::DemState now(ownParticles());
    take(now, now.orientation.size(), particles);
}


std::function<void(Foam::particleCloud&)> Foam::solidCloud::fillLater
(
    particleCloud& names,
    label& size
) const
{
    const auto put = [this](const riprap::DemState& now, particleCloud& particles)
    {
        take(now, settings_.config.orientation, particles);
    };
    return filledBy(part_.particlesLater(), put, names, size);
}


void Foam::solidCloud::take
(
    const riprap::DemState& now,
    bool turned,
    particleCloud& particles
) const
{
    particles.position = toVectors(now.position);
    particles.vectors.set("U", toVectors(now.velocity));
    particles.vectors.set("omega", toVectors(now.spin));
    particles.vectors.set("force", toVectors(now.force));
    particles.vectors.set("moment", toVectors(now.moment));
    setConstants(now, particles);
    particles.labels.set("material", toField<label>(now.material));
    particles.labels.set("group", toField<label>(now.group));
    particles.labels.set("contacts", toField<label>(now.contacts));
    labelField broken(toField<label>(now.brokenBonds));
    if (brokenBefore_.size())
    {
        forAll(broken, i)
        {
            broken[i] += brokenBefore_.lookup(now.id[i], 0);
        }
    }
    particles.labels.set("brokenBonds", std::move(broken));
    particles.labels.set("origId", toField<label>(now.id));
    if (input_.clumps.size())
    {
        particles.labels.set("clump", toField<label>(now.clump));
    }
    if (turned)
    {
        particles.vectors.set("turned", rotationVectors(now.orientation));
    }
}


void Foam::solidCloud::addProperties(dictionary& properties) const
{
    addSolidNames(properties, settings_);
    if (shapes_.size()) properties.add("shapes", shapes_, true);
    if (surfaces_.size()) properties.add("surfaces", surfaces_, true);
}


void Foam::solidCloud::writeState(bool picture) const
{
    if (writesState_ && !picture)
    {
        stateWords words(scene_.savedState(timeWriter::ofRun().fillsLater()));
        if (Pstream::master())
        {
            writeStateWords(time(), demRestart::stateFile, std::move(words));
        }
    }
    if (input_.clumps.size() && !picture)
    {
        writeClumps();
    }

    demRestart run(run_);
    if (input_.bonds.size())
    {
        const riprap::DemState particles(scene_.motion());
        int64_t lost = 0;
        const riprap::DemBondState now(bonds(particles, lost));
        // Each process has them all
        if (!picture && Pstream::master()) writeBondFiles(time(), now);
        writeBondLines(time(), settings_.config, particles, now);
        run.brokenBefore += lost;
    }
    if (!picture && Pstream::master()) writeDemRun(time(), run);
}


// ************************************************************************* //

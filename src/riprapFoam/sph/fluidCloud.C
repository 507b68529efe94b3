/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fluidCloud.H"
#include "sceneState.H"
#include "Time.H"
#include "timeWriter.H"

namespace Foam
{
    defineTypeNameAndDebug(fluidCloud, 0);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fluidCloud::fluidCloud
(
    const polyMesh& mesh,
    riprap::SphScene& part,
    riprap::SphScene& scene,
    const sphRestart& run
)
:
    sceneCloud(mesh, "fluid"),
    part_(part),
    scene_(scene),
    run_(run)
{}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::fluidCloud::take(const riprap::FluidState& fluid, particleCloud& particles)
{
    particles.position = toVectors(fluid.position);
    particles.vectors.set("U", toVectors(fluid.velocity));
    particles.scalars.set("rho", toField<scalar>(fluid.density));
    particles.scalars.set("p", toField<scalar>(fluid.pressure));
    particles.scalars.set("h", toField<scalar>(fluid.smoothingLength));
    particles.labels.set("id", toField<label>(fluid.id));
}


void Foam::fluidCloud::fill(particleCloud& particles) const
{
    take(part_.fluid(), particles);
}


std::function<void(Foam::particleCloud&)> Foam::fluidCloud::fillLater
(
    particleCloud& names,
    label& size
) const
{
    return filledBy(part_.fluidLater(), &take, names, size);
}


void Foam::fluidCloud::addProperties(dictionary& properties) const
{
    properties.add("spacing", exact(run_.spacing));
    properties.add("soundSpeed", exact(run_.soundSpeed));
    properties.add("density", exact(run_.density));
}


void Foam::fluidCloud::writeState(bool picture) const
{
    if (picture) return;

    // Of several processes the first has all of it
    stateWords words(scene_.savedState(timeWriter::ofRun().fillsLater()));
    if (!Pstream::master()) return;

    writeSphState(time(), std::move(words));
    writeSphRun(time(), run_);
}


// ************************************************************************* //

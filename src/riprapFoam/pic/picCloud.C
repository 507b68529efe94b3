/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "picCloud.H"
#include "Time.H"
#include "timeWriter.H"

namespace Foam
{
    defineTypeNameAndDebug(picCloud, 0);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::picCloud::picCloud
(
    const polyMesh& mesh,
    riprap::PicScene& part,
    riprap::PicScene& scene,
    const picRestart& run
)
:
    sceneCloud(mesh, "fluid"),
    part_(part),
    scene_(scene),
    run_(run)
{}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::picCloud::take(const riprap::FluidState& fluid, particleCloud& particles)
{
    particles.position = toVectors(fluid.position);
    particles.vectors.set("U", toVectors(fluid.velocity));
    particles.scalars.set("p", toField<scalar>(fluid.pressure));
    particles.labels.set("id", toField<label>(fluid.id));
}


void Foam::picCloud::fill(particleCloud& particles) const
{
    take(part_.fluid(), particles);
}


std::function<void(Foam::particleCloud&)> Foam::picCloud::fillLater
(
    particleCloud& names,
    label& size
) const
{
    return filledBy(part_.fluidLater(), &take, names, size);
}


void Foam::picCloud::addProperties(dictionary& properties) const
{
    properties.add("spacing", exact(run_.spacing));
}


void Foam::picCloud::writeState(bool picture) const
{
    if (picture) return;

    // Of several processes the first has all of it
    stateWords words(scene_.savedState(timeWriter::ofRun().fillsLater()));
    if (!Pstream::master()) return;

    writePicState(time(), std::move(words));
    writePicRun(time(), run_);
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fluidCloud.H"
#include "sceneState.H"
#include "Time.H"

namespace Foam
{
    defineTypeNameAndDebug(fluidCloud, 0);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fluidCloud::fluidCloud
(
    const polyMesh& mesh,
    riprap::SphScene& scene,
    const sphRun& run
)
:
    sceneCloud(mesh, "fluid"),
    scene_(scene),
    run_(run)
{}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::fluidCloud::fill(particleCloud& particles) const
{
    const riprap::FluidState fluid(scene_.fluid());

    particles.position = toVectors(fluid.position);
    particles.vectors.set("U", toVectors(fluid.velocity));
    particles.scalars.set("rho", toField<scalar>(fluid.density));
    particles.scalars.set("p", toField<scalar>(fluid.pressure));
    particles.scalars.set("h", toField<scalar>(fluid.smoothingLength));
    particles.labels.set("id", toField<label>(fluid.id));
}


void Foam::fluidCloud::addProperties(dictionary& properties) const
{
    properties.add("spacing", run_.spacing);
    properties.add("soundSpeed", exact(run_.soundSpeed));
    properties.add("density", exact(run_.density));
}


void Foam::fluidCloud::writeState(bool picture) const
{
    if (picture) return;

    writeSphState(time(), scene_.saveState());
    writeSphRun(time(), run_);
}


// ************************************************************************* //

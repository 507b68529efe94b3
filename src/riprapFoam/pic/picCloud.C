/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "picCloud.H"
#include "Time.H"

namespace Foam
{
    defineTypeNameAndDebug(picCloud, 0);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::picCloud::picCloud
(
    const polyMesh& mesh,
    riprap::PicScene& scene,
    const picRestart& run
)
:
    sceneCloud(mesh, "fluid"),
    scene_(scene),
    run_(run)
{}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::picCloud::fill(particleCloud& particles) const
{
    const riprap::FluidState fluid(scene_.fluid());

    particles.position = toVectors(fluid.position);
    particles.vectors.set("U", toVectors(fluid.velocity));
    particles.scalars.set("p", toField<scalar>(fluid.pressure));
    particles.labels.set("id", toField<label>(fluid.id));
}


void Foam::picCloud::addProperties(dictionary& properties) const
{
    properties.add("spacing", run_.spacing);
}


void Foam::picCloud::writeState(bool picture) const
{
    if (picture) return;

    writePicState(time(), scene_.saveState());
    writePicRun(time(), run_);
}


// ************************************************************************* //

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

void Foam::picCloud::fill(particleCloud& particles) const
{
    const riprap::FluidState fluid(part_.fluid());

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

    // Of several processes the first has all of it
    std::vector<std::int32_t> words(scene_.saveState());
    if (!Pstream::master()) return;

    writePicState(time(), std::move(words));
    writePicRun(time(), run_);
}


// ************************************************************************* //

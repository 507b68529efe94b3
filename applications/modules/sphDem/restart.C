/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    A written time holds the scene's exact state beside the cloud. It is used
    where it belongs to the cloud, so that a run continues bit for bit; where
    it does not (the cloud was edited, the device or the precision is another
    one), the cloud's fields are, and the log says so.
\*---------------------------------------------------------------------------*/

#include "sphDem.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static bool notUsed(const std::string& why)
{
    Info<< "State in uniform/riprap is not used: " << why.c_str() << nl
        << "The run continues from the fields of lagrangian/fluid: not bit for"
        << " bit" << nl << endl;
    return false;
}

} // End namespace Foam


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

bool Foam::solverModules::sphDem::canContinue(const particleCloud& cloud)
{
    if (!hasSphRun(runTime_))
    {
        Info<< "Starting from the fields of lagrangian/fluid at time "
            << runTime_.timeName() << nl << endl;
        return false;
    }

    run_ = readSphRun(runTime_);

    if (Time::timeName(run_.time) != runTime_.timeName())
    {
        return notUsed("it is of time " + Time::timeName(run_.time));
    }
    if (run_.particles != cloud.size())
    {
        return notUsed
        (
            "it has " + Foam::name(label(run_.particles)) + " particles, the"
            " cloud " + Foam::name(cloud.size())
        );
    }

    // The directory's name is rounded
    runTime_.setTime(run_.time, runTime_.timeIndex());
    return true;
}


bool Foam::solverModules::sphDem::loadState(const particleCloud& cloud)
{
    const std::vector<std::int32_t> state(readSphState(runTime_));

    try
    {
        scene_->loadState(state);
    }
    catch (const std::invalid_argument& e)
    {
        return notUsed(e.what());
    }

    if (!sameAs(cloud))
    {
        return notUsed("the cloud has been changed since it was written");
    }

    Info<< "Continuing exactly from time " << runTime_.timeName()
        << nl << endl;
    return true;
}


//- Is what was loaded what the cloud says, to the digits of an ascii file?
bool Foam::solverModules::sphDem::sameAs(const particleCloud& cloud) const
{
    const riprap::SphConfig& config = settings_.config;
    const scalar closeX = 1e-3*config.spacing + 1e-5*mesh_.bounds().mag();
    const scalar closeU = 1e-3*config.maxVelocity;

    const labelField& id = cloud.labels["id"];
    const vectorField& U = cloud.vectors["U"];
    Map<label> entryOfId(2*id.size());
    forAll(id, i)
    {
        entryOfId.insert(id[i], i);
    }

    const riprap::FluidState fluid(scene_->fluid());
    if (label(fluid.id.size()) != id.size())
    {
        return false;
    }

    for (std::size_t j = 0; j < fluid.id.size(); ++j)
    {
        const auto found = entryOfId.cfind(fluid.id[j]);
        if (!found.found())
        {
            return false;
        }

        for (int k = 0; k < config.dimensions; ++k)
        {
            const direction d = config.axes[k];
            const scalar x = cloud.position[found.val()][d];
            const scalar u = U[found.val()][d];

            // Not close is what NaN is, too
            if
            (
                !(mag(fluid.position[3*j + d] - x) <= closeX)
             || !(mag(fluid.velocity[3*j + d] - u) <= closeU + 1e-4*mag(u))
            )
            {
                return false;
            }
        }
    }

    return true;
}


// ************************************************************************* //

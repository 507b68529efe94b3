/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cloudComparison.H"
#include "Map.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

template<class Close>
Foam::label Foam::cloudComparison::others
(
    const word& field,
    const Close& close
) const
{
    if (!cloud_.scalars.found(field))
    {
        return 0;
    }
    const scalarField& values = cloud_.scalars[field];

    label n = 0;
    forAll(entry_, j)
    {
        if (!close(j, values[entry_[j]]))
        {
            ++n;
        }
    }
    return n;
}


bool Foam::cloudComparison::same
(
    const vectorField& values,
    const std::vector<double>& fluid,
    scalar close,
    scalar relative
) const
{
    forAll(entry_, j)
    {
        for (int k = 0; k < config_.dimensions; ++k)
        {
            const direction d = config_.axes[k];
            const scalar value = values[entry_[j]][d];

            if (!(mag(fluid[3*j + d] - value) <= close + relative*mag(value)))
            {
                return false;
            }
        }
    }
    return true;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cloudComparison::cloudComparison
(
    const riprap::SphConfig& config,
    const particleCloud& cloud,
    const riprap::FluidState& fluid
)
:
    config_(config),
    cloud_(cloud),
    fluid_(fluid),
    entry_(label(fluid.id.size()), -1)
{
    const labelField& id = cloud.labels["id"];
    Map<label> entryOfId(2*id.size());
    forAll(id, i)
    {
        entryOfId.insert(id[i], i);
    }

    forAll(entry_, j)
    {
        entry_[j] = entryOfId.lookup(fluid.id[j], -1);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::cloudComparison::samePositions(scalar close) const
{
    return
        entry_.size() == cloud_.size() && !entry_.found(-1)
     && same(cloud_.position, fluid_.position, close, 0);
}


bool Foam::cloudComparison::sameVelocities() const
{
    return same
    (
        cloud_.vectors["U"],
        fluid_.velocity,
        1e-3*config_.maxVelocity,
        1e-4
    );
}


bool Foam::cloudComparison::sameDensities(scalar reference) const
{
    return !others
    (
        "rho",
        [&](label j, scalar rho)
        {
            const scalar now = fluid_.density[j]/config_.density;
            return mag(now - rho/reference) <= 2e-5;
        }
    );
}


const char* Foam::cloudComparison::changed
(
    scalar closePosition,
    scalar referenceDensity
) const
{
    return
        !samePositions(closePosition) ? "positions"
      : !sameVelocities() ? "U"
      : !sameDensities(referenceDensity) ? "rho"
      : nullptr;
}


Foam::label Foam::cloudComparison::otherPressures() const
{
    const scalar scale = config_.density*sqr(config_.soundSpeed);

    return others
    (
        "p",
        [&](label j, scalar p)
        {
            return mag(fluid_.pressure[j] - p) <= 1e-4*mag(p) + 1e-6*scale;
        }
    );
}


Foam::label Foam::cloudComparison::otherSmoothingLengths() const
{
    return others
    (
        "h",
        [&](label j, scalar h)
        {
            return mag(fluid_.smoothingLength[j] - h) <= 1e-4*mag(h);
        }
    );
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidFiles.H"
#include "Map.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Entry i of the cloud and j of a scene, but for positions: to this part of
//  each number; radius and mass to a scene's precision
static bool sameFields
(
    const riprap::DemParticles& cloud,
    label i,
    const riprap::DemState& now,
    std::size_t j,
    scalar close
)
{
    const auto same = [](scalar a, scalar b, scalar part)
    {
        return mag(a - b) <= part*max(mag(a), mag(b));
    };
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        if
        (
            !same(cloud.velocity[3*i + d], now.velocity[3*j + d], close)
         || !same(cloud.spin[3*i + d], now.spin[3*j + d], close)
        )
        {
            return false;
        }
    }
    const scalar rounded = max(close, 1e-6);
    return
        same(cloud.radius[i], now.radius[j], rounded)
     && same(cloud.mass[i], now.mass[j], rounded)
     && cloud.material[i] == now.material[j]
     && cloud.group[i] == now.group[j];
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool Foam::matchesCloud
(
    const riprap::DemParticles& cloud,
    riprap::DemScene& scene,
    const riprap::DemConfig& config,
    scalar size,
    label digits
)
{
    const riprap::DemState now(scene.motion());
    if (now.id.size() != cloud.size())
    {
        return false;
    }

    Map<label> entryOfId(2*label(cloud.size()));
    scalar fastest = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
        entryOfId.insert(cloud.id[i], i);
        const double* u = &cloud.velocity[3*i];
        fastest = max(fastest, mag(vector(u[0], u[1], u[2])));
    }

    // A number of so many digits is off by half of the last one at most
    const scalar lastDigit = pow(10.0, 1 - scalar(digits));
    const scalar closeX = digits ? max(1e-9, lastDigit)*size : 1e-5*size;
    const scalar closeU = 1e-4*fastest;
    for (std::size_t j = 0; j < now.id.size(); ++j)
    {
        const label i = entryOfId.lookup(now.id[j], -1);
        if (i < 0)
        {
            return false;
        }
        for (int k = 0; k < config.dimensions; ++k)
        {
            const int d = config.axes[k];
            // Not close is what NaN is, too
            if
            (
                !(mag(now.position[3*j + d] - cloud.position[3*i + d]) <= closeX)
             || !(mag(now.velocity[3*j + d] - cloud.velocity[3*i + d]) <= closeU)
            )
            {
                return false;
            }
        }
        if (digits && !sameFields(cloud, i, now, j, max(1e-9, lastDigit)))
        {
            return false;
        }
    }
    return true;
}


// ************************************************************************* //

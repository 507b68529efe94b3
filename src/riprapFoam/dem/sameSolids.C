/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidFiles.H"
#include "Map.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool Foam::sameSolids
(
    const riprap::DemParticles& cloud,
    riprap::DemScene& scene,
    const riprap::DemConfig& config,
    scalar size
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

    const scalar closeX = 1e-5*size;
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
    }
    return true;
}


// ************************************************************************* //

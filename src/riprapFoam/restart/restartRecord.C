/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "restartRecord.H"
#include "sceneState.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::restartRecord::read(const dictionary& dict)
{
    time = dict.get<scalar>("time");
    particles = count(dict, "particles");
    initialParticles = count(dict, "initialParticles");
    escaped = count(dict, "escaped");
    outflow = dict.found("outflow") ? count(dict, "outflow") : 0;
    steps = count(dict, "steps");
    device = dict.get<word>("device");
    precision = dict.get<word>("precision");
    domain = exactList(dict, "domain");

    const bool cornered = domain.empty() || domain.size() == 6;
    if
    (
        particles < 0 || initialParticles < 0 || escaped < 0 || steps < 0
     || !cornered
    )
    {
        FatalIOErrorInFunction(dict)
            << "not what riprapFoam wrote: particles " << particles
            << ", initialParticles " << initialParticles << ", escaped "
            << escaped << ", steps " << steps << ", domain " << domain
            << exit(FatalIOError);
    }
}


void Foam::restartRecord::write(dictionary& dict) const
{
    dict.add("time", exact(time));
    dict.add("particles", exact(particles));
    dict.add("initialParticles", exact(initialParticles));
    dict.add("escaped", exact(escaped));
    dict.add("outflow", exact(outflow));
    dict.add("steps", exact(steps));
    dict.add("device", device);
    dict.add("precision", precision);
    if (domain.size())
    {
        dict.add("domain", exact(domain));
    }
}


// ************************************************************************* //

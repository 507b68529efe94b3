/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    particleProbes: when is sampled, means over time, and what a restart needs
\*---------------------------------------------------------------------------*/

#include "particleProbes.H"

namespace
{
    // Of a reading
    constexpr std::size_t nNumbers = 6;
}


void Foam::functionObjects::particleProbes::readAverage(const dictionary& dict)
{
    mean_.begin(notNegative(dict, "average", 0), savedSamples(), nNumbers*locations_.size());
    sampledAt_ = -GREAT;
}


std::vector<double> Foam::functionObjects::particleProbes::asNumbers
(
    const List<reading>& probes
)
{
    std::vector<double> all;
    for (const reading& r : probes)
    {
        all.insert
        (
            all.end(),
            {r.p, r.rho, r.volumeFraction, r.U.x(), r.U.y(), r.U.z()}
        );
    }
    return all;
}


Foam::List<Foam::functionObjects::particleProbes::reading>
Foam::functionObjects::particleProbes::asReadings
(
    const std::vector<double>& all
)
{
    List<reading> probes(all.size()/nNumbers);
    forAll(probes, i)
    {
        const double* v = &all[nNumbers*i];
        probes[i].p = v[0];
        probes[i].rho = v[1];
        probes[i].volumeFraction = v[2];
        probes[i].U = vector(v[3], v[4], v[5]);
    }
    return probes;
}


const Foam::List<Foam::functionObjects::particleProbes::reading>&
Foam::functionObjects::particleProbes::now()
{
    if (sampledAt_ != time_.value())
    {
        readings_ = readings();
        sampledAt_ = time_.value();
        if (mean_.on()) mean_.add(sampledAt_, asNumbers(readings_), dict_, name());
    }
    return readings_;
}


bool Foam::functionObjects::particleProbes::executeSample()
{
    if (mean_.on()) now();

    if (time_.writeTime())
    {
        save(mean_);
        if (body_.ofSolids())
        {
            keep(poseProperty(), gaugeBody::state(body_.pose()));
        }
    }

    return true;
}


// ************************************************************************* //

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

    const Foam::word samplesProperty("averageSamples");

    // In a mean; fewer are warned of
    constexpr std::size_t enough = 10;
}


void Foam::functionObjects::particleProbes::readAverage(const dictionary& dict)
{
    // Of the run so far where the dictionary was edited, else of the one that is continued
    std::vector<double> before(mean_.state());
    if (before.empty() && foundProperty(samplesProperty))
    {
        scalarList samples;
        getProperty(samplesProperty, samples);
        before.assign(samples.begin(), samples.end());
    }

    average_ = notNegative(dict, "average", 0);
    mean_ = riprap::RunningMean(average_);
    mean_.restore(before, nNumbers*locations_.size());
    sampledAt_ = -GREAT;
    warned_ = false;
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


void Foam::functionObjects::particleProbes::warnOfFewSamples()
{
    const std::size_t n = mean_.intervals();
    if (n == 0 || n >= enough || warned_) return;

    warned_ = true;
    IOWarningInFunction(dict_)
        << "Entry average of function object " << name() << ": " << average_
        << " s are " << label(n) << " samples. Take a sampleInterval in"
        << " system/controlDict of at most " << average_/enough << endl;
}


const Foam::List<Foam::functionObjects::particleProbes::reading>&
Foam::functionObjects::particleProbes::now()
{
    if (sampledAt_ != time_.value())
    {
        readings_ = readings();
        sampledAt_ = time_.value();
        if (average_ > 0)
        {
            mean_.add(sampledAt_, asNumbers(readings_));
            warnOfFewSamples();
        }
    }
    return readings_;
}


bool Foam::functionObjects::particleProbes::executeSample()
{
    if (average_ > 0)
    {
        now();
    }

    if (time_.writeTime())
    {
        if (average_ > 0)
        {
            const std::vector<double> state(mean_.state());
            scalarList samples(state.size());
            std::copy(state.begin(), state.end(), samples.begin());
            setProperty(samplesProperty, samples);
        }
        if (body_.ofSolids())
        {
            setProperty(poseProperty(), gaugeBody::state(body_.pose()));
        }
    }

    return true;
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "trailingMean.H"
#include "error.H"

#include <algorithm>

namespace
{
    // In a mean; fewer are warned of
    constexpr std::size_t enough = 10;
}

const Foam::word Foam::functionObjects::trailingMean::property("averageSamples");


void Foam::functionObjects::trailingMean::begin
(
    const scalar width,
    const scalarList& before,
    const label values
)
{
    std::vector<double> samples(mean_.state());
    if (samples.empty()) samples.assign(before.begin(), before.end());

    width_ = width;
    mean_ = riprap::RunningMean(width);
    mean_.restore(samples, values);
    warned_ = false;
}


void Foam::functionObjects::trailingMean::add
(
    const scalar time,
    const std::vector<double>& values,
    const dictionary& where,
    const word& functionObject
)
{
    mean_.add(time, values);

    const std::size_t n = mean_.intervals();
    if (n == 0 || n >= enough || warned_) return;

    warned_ = true;
    IOWarningInFunction(where)
        << "Entry average of function object " << functionObject << ": " << width_
        << " s are " << label(n) << " samples. Take a sampleInterval in"
        << " system/controlDict of at most " << width_/enough << endl;
}


Foam::scalarList Foam::functionObjects::trailingMean::state() const
{
    const std::vector<double> samples(mean_.state());
    scalarList all(samples.size());
    std::copy(samples.begin(), samples.end(), all.begin());
    return all;
}


// ************************************************************************* //

// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyGrading.H"

#include <cmath>

namespace Foam
{

static scalarList positives(checkedDictionary& dict, const word& entry)
{
    if (!dict.found(entry))
    {
        FatalIOErrorInFunction(dict.dict())
            << "Entry " << entry
            << " is missing: sizes need radii (<m> ..) and shares (<fraction> ..), one for each"
            << exit(FatalIOError);
    }
    const scalarList values(dict.dict().get<scalarList>(entry));
    for (const scalar value : values)
    {
        dict.require(value > 0 && std::isfinite(value), entry, value, "positive");
        // As a single radius
        dict.require(value >= 1e-18 && value <= 1e20, entry, value, "from 1e-18 to 1e20");
    }
    return values;
}

} // namespace Foam


Foam::bodyGrading Foam::readGrading(checkedDictionary& dict)
{
    bodyGrading grading;
    grading.radii = positives(dict, "radii");
    grading.shares = positives(dict, "shares");
    grading.ofNumber = dict.either("sharesOf", "number", "mass", false);
    if (grading.radii.empty() || grading.radii.size() != grading.shares.size())
    {
        FatalIOErrorInFunction(dict.dict())
            << "Entry radii has " << grading.radii.size() << " values and entry shares "
            << grading.shares.size() << ": each radius needs its share" << exit(FatalIOError);
    }
    const scalar total = sum(grading.shares);
    if (mag(total - 1) > 1e-3)
    {
        FatalIOErrorInFunction(dict.dict())
            << "Entry shares adds up to " << total << ": shares are fractions of the "
            << (grading.ofNumber ? "number" : "mass") << " that add up to 1" << exit(FatalIOError);
    }
    for (scalar& share : grading.shares) share /= total;
    return grading;
}


Foam::labelList Foam::bodyGrading::counts(scalar volume, bool planar) const
{
    scalar mean = 0;                    // volume of a body, where shares are of the number
    forAll(radii, k) mean += shares[k]*ballVolume(radii[k], planar);

    labelList n(radii.size());
    forAll(n, k)
    {
        n[k] = label(std::round(shares[k]*volume/(ofNumber ? mean : ballVolume(radii[k], planar))));
    }
    return n;
}


Foam::scalarField Foam::bodyGrading::fill(scalar volume, bool planar, const dictionary& dict) const
{
    const labelList n(counts(volume, planar));
    scalarField all(sum(n));
    label at = 0;
    forAll(n, k)
    {
        if (n[k] == 0)
        {
            FatalIOErrorInFunction(dict)
                << "Entry radii: the share " << shares[k] << " of the radius " << radii[k]
                << " is less than half a body of " << sum(n)
                << ": a larger region or share has some, or leave the radius out"
                << exit(FatalIOError);
        }
        for (label i = 0; i < n[k]; ++i) all[at++] = radii[k];
    }
    return all;
}

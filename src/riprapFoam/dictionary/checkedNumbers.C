/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    checkedDictionary: entries that are numbers, and their ranges
\*---------------------------------------------------------------------------*/

#include "checkedDictionary.H"
#include "inputFile.H"
#include <cmath>

static constexpr double smallestPositive = 1e-18;


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::checkedDictionary::require
(
    bool good,
    const word& entry,
    scalar value,
    const char* what
) const
{
    // Not written as !(value > 0): good must be false for NaN too
    if (!good)
    {
        FatalIOErrorInFunction(dict_)
            << "Entry " << entry << " is " << value << ": it must be " << what
            << exit(FatalIOError);
    }
}


Foam::scalar Foam::checkedDictionary::number(const word& entry)
{
    found(entry);
    const scalar value = dict_.get<scalar>(entry);
    require(std::isfinite(value), entry, value, "finite");
    // Macros and #calc: what a file holds itself has been looked at
    require(mag(value) <= largestNumber, entry, value, "at most 1e20");
    return value;
}


Foam::label Foam::checkedDictionary::whole
(
    const word& entry,
    label otherwise,
    label low,
    label high
)
{
    const scalar value = between(entry, otherwise, low, high);
    require(value == std::floor(value), entry, value, "a whole number");
    return label(value);
}


Foam::scalar Foam::checkedDictionary::positive(const word& entry)
{
    const scalar value = number(entry);
    require(value > 0, entry, value, "positive");
    // Its square must be a number of single precision
    require(value >= smallestPositive, entry, value, "at least 1e-18");
    return value;
}


Foam::scalar Foam::checkedDictionary::positive
(
    const word& entry,
    scalar otherwise
)
{
    return found(entry) ? positive(entry) : otherwise;
}


Foam::scalar Foam::checkedDictionary::notNegative
(
    const word& entry,
    scalar otherwise
)
{
    if (!found(entry))
    {
        return otherwise;
    }
    const scalar value = number(entry);
    require(value >= 0, entry, value, "zero or positive");
    return value;
}


Foam::scalar Foam::checkedDictionary::between
(
    const word& entry,
    scalar otherwise,
    scalar low,
    scalar high
)
{
    if (!found(entry))
    {
        return otherwise;
    }
    const scalar value = number(entry);
    if (!(value >= low && value <= high))
    {
        FatalIOErrorInFunction(dict_)
            << "Entry " << entry << " is " << value << ": it must be from "
            << low << " to " << high
            << exit(FatalIOError);
    }
    return value;
}


Foam::scalar Foam::checkedDictionary::notNegativeOrNone
(
    const word& entry,
    scalar otherwise
)
{
    return found(entry) && isWord(entry, "none")
      ? 0 : notNegative(entry, otherwise);
}


Foam::scalar Foam::checkedDictionary::positiveOrAuto(const word& entry)
{
    return !found(entry) || isWord(entry, "auto") ? 0 : positive(entry);
}


Foam::vector Foam::checkedDictionary::velocity(const word& entry)
{
    found(entry);
    const vector v(dict_.get<vector>(entry));
    require(mag(v) <= 1e5, entry, mag(v), "a velocity of at most 1e5 m/s");
    return v;
}


Foam::scalar Foam::checkedDictionary::positive
(
    const word& entry,
    const dimensionSet& dimensions
)
{
    found(entry);

    // As OpenFOAM's dimensioned scalars, [name] [dimensions] value, whose
    // own reader aborts at wrong dimensions
    ITstream& is = dict_.lookup(entry);
    token first(is);
    if (first.isWord() && is.nRemainingTokens())
    {
        is >> first;
    }
    if (first.isWord())
    {
        unknownWord(entry, first.wordToken(), {"<number>", "[<dimensions>] <number>"});
    }
    is.putBack(first);
    if (first == token::BEGIN_SQR)
    {
        const dimensionSet typed(is);
        if (typed != dimensions)
        {
            FatalIOErrorInFunction(dict_)
                << "Entry " << entry << " has the dimensions " << typed
                << ": they must be " << dimensions << exit(FatalIOError);
        }
    }

    scalar value = 0;
    is >> value;
    dict_.checkITstream(is, entry);
    require(value > 0 && std::isfinite(value), entry, value, "positive");
    require(
        value >= smallestPositive && value <= largestNumber, entry, value, "from 1e-18 to 1e20");
    return value;
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "checkedDictionary.H"
#include "listed.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

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


bool Foam::checkedDictionary::isWord
(
    const word& entry,
    const word& allowed
) const
{
    const token first(dict_.lookup(entry));
    if (first.isWord() && first.wordToken() != allowed)
    {
        unknownWord(entry, first.wordToken(), {allowed, "<number>"});
    }
    return first.isWord();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::checkedDictionary::found(const word& entry)
{
    if (!known_.found(entry))
    {
        known_.append(entry);
    }
    return dict_.found(entry, keyType::LITERAL);
}


Foam::scalar Foam::checkedDictionary::number(const word& entry)
{
    found(entry);
    return dict_.get<scalar>(entry);
}


Foam::scalar Foam::checkedDictionary::positive(const word& entry)
{
    const scalar value = number(entry);
    require(value > 0, entry, value, "positive");
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
    if (first.isWord())
    {
        is >> first;
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
    require(value > 0, entry, value, "positive");
    return value;
}


bool Foam::checkedDictionary::either
(
    const word& entry,
    const word& yes,
    const word& no,
    bool otherwise
)
{
    if (!found(entry))
    {
        return otherwise;
    }
    const word typed(dict_.get<word>(entry));
    if (typed != yes && typed != no)
    {
        unknownWord(entry, typed, {yes, no});
    }
    return typed == yes;
}


const Foam::dictionary& Foam::checkedDictionary::subDict(const word& entry)
{
    if (!found(entry))
    {
        return dictionary::null;
    }
    if (!dict_.isDict(entry))
    {
        FatalIOErrorInFunction(dict_)
            << "Entry " << entry << " must be a dictionary: " << entry
            << " { ... }" << exit(FatalIOError);
    }
    return dict_.subDict(entry);
}


void Foam::checkedDictionary::unknownWord
(
    const word& entry,
    const word& typed,
    const wordList& valid
) const
{
    FatalIOErrorInFunction(dict_)
        << "Entry " << entry << " has the unknown word " << typed
        << "; valid are " << listed(valid).c_str()
        << exit(FatalIOError);
}


void Foam::checkedDictionary::unknownEntry(const word& entry) const
{
    FatalIOErrorInFunction(dict_)
        << "Unknown entry " << entry
        << "; valid are " << listed(known_).c_str()
        << exit(FatalIOError);
}


void Foam::checkedDictionary::end() const
{
    for (const entry& e : dict_)
    {
        if (!known_.found(e.keyword())) unknownEntry(e.keyword());
    }
}


void Foam::checkedDictionary::endButNumbers() const
{
    for (const entry& e : dict_)
    {
        const bool number =
            e.isStream() && e.stream().size() == 1 && e.stream()[0].isNumber();

        if (!number && !known_.found(e.keyword())) unknownEntry(e.keyword());
    }
}


// ************************************************************************* //

// SPDX-License-Identifier: GPL-3.0-or-later

#include "remedies.H"

#include "StringStream.H"

// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

void Foam::remedies::when(bool holds, const string& remedy)
{
    if (holds) those_.append(remedy);
}


void Foam::remedies::above(const char* entry, scalar value, scalar limit)
{
    if (!(value > 1.0001*limit)) return;

    OStringStream what;
    what<< entry << " " << limit << " (is " << value << ")";
    those_.append(string(what.str()));
}


Foam::string Foam::remedies::text(const char* otherwise) const
{
    string all;
    forAll(those_, i)
    {
        all += (i ? "; " : "Try first: ") + those_[i];
    }
    return those_.empty() ? string(otherwise) : string(all + ". " + otherwise);
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "escapeCount.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::escapeGuard::read(checkedDictionary& dict)
{
    stopAtEscape = dict.either("escape", "stop", "warn", stopAtEscape);
    maxEscaped = dict.between("maxEscaped", maxEscaped, 0, 1);
}


Foam::Ostream& Foam::operator<<(Ostream& os, const escapeGuard& guard)
{
    return os
        << "escape " << (guard.stopAtEscape ? "stop" : "warn")
        << ", maxEscaped " << guard.maxEscaped;
}


void Foam::escapeCount::add(const std::vector<riprap::Vector3>& positions)
{
    for (const riprap::Vector3& x : positions)
    {
        const point where(x[0], x[1], x[2]);
        ++byPatch_(boundary_.patch(where), 0);
        if (boundary_.byOpening(where)) ++outflow_;
    }
}


void Foam::escapeCount::log
(
    label now,
    int64_t inAll,
    int64_t outflow
) const
{
    Info<< "Escaped " << now << " particles (" << inAll
        << " in all), by nearest patch:";
    for (const word& patch : byPatch_.sortedToc())
    {
        Info<< ' ' << patch << ' ' << byPatch_[patch];
    }
    Info<< nl << "Escaped through walls in all: " << inAll - outflow << endl;
}


// ************************************************************************* //

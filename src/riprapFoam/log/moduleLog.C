/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "moduleLog.H"
#include "HashTable.H"
#include "listed.H"
#include <cstdio>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::OSstream& Foam::logItem(std::string what)
{
    if (what.size() < 16) what.resize(16, ' ');
    OSstream& os = Info();
    os  << "    " << what.c_str() << ' ';
    return os;
}


void Foam::logUnused(const wordList& entries, const char* why)
{
    if (entries.size())
    {
        logItem("not used") << listed(entries).c_str() << why << nl;
    }
}


std::string Foam::bytesText(scalar n)
{
    static const char* const units[] = {"B", "kB", "MB", "GB", "TB"};

    int unit = 0;
    while (n >= 1000 && unit < 4)
    {
        n /= 1000;
        ++unit;
    }

    char text[32];
    std::snprintf(text, sizeof(text), "%.4g %s", double(n), units[unit]);
    return text;
}


void Foam::logMemory
(
    const std::vector<riprap::ArrayInfo>& arrays,
    scalar particles
)
{
    HashTable<scalar> bySet;
    for (const riprap::ArrayInfo& array : arrays)
    {
        bySet(word(array.set, false), 0) += array.bytes;
    }

    scalar total = 0;
    Info<< "Memory on the device" << nl;
    for (const word& set : bySet.sortedToc())
    {
        Info<< "    " << set << ": " << bytesText(bySet[set]).c_str() << nl;
        total += bySet[set];
    }
    Info<< "    all: " << bytesText(total).c_str() << ", "
        << bytesText(total/particles).c_str() << " a particle" << nl << endl;
}


// ************************************************************************* //

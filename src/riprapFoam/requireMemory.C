/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "requireMemory.H"
#include "error.H"
#include "core/machineMemory.hpp"

#include <cmath>

void Foam::requireMemory
(
    const dictionary& dict,
    const std::string& what,
    scalar count,
    const char* of,
    scalar bytes,
    const std::string& meant
)
{
    // Labels have 32 bits, and some count several of each
    const scalar most = min(scalar(5e8), scalar(riprap::freeMemory())/bytes);
    if (count <= most) return;

    FatalIOErrorInFunction(dict)
        << what.c_str() << " about " << count << ' ' << of << ", and this machine has memory for "
        << std::floor(most) << ": is the " << meant.c_str() << " meant?" << exit(FatalIOError);
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "requireMemory.H"
#include "error.H"
#include "core/backend/machineMemory.hpp"
#include "api/particleLimit.hpp"

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
    const scalar countable = riprap::mostFluidParticles;
    const scalar room = scalar(riprap::freeMemory())/bytes;
    if (count <= min(countable, room)) return;

    FatalIOErrorInFunction(dict) << what.c_str() << " about " << count << ' ' << of << ", and "
                                << (countable < room
                                            ? "a scene, which counts them in 32 bits, can have "
                                            : "this machine has memory for ")
                                << std::floor(min(countable, room)) << ": is the " << meant.c_str()
                                << " meant?" << exit(FatalIOError);
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "picNames.H"

namespace Foam
{
namespace picNames
{

const Enum<riprap::ViscousKind> viscosity
({
    {riprap::ViscousKind::automatic, "automatic"},
    {riprap::ViscousKind::explicitly, "explicit"},
    {riprap::ViscousKind::implicitly, "implicit"}
});

const Enum<riprap::OpeningKind> opening
({
    {riprap::OpeningKind::velocity, "velocity"},
    {riprap::OpeningKind::flowRate, "flowRate"},
    {riprap::OpeningKind::level, "level"}
});

const Enum<int> advection
({
    {2, "RungeKutta2"},
    {3, "RungeKutta3"}
});

} // End namespace picNames
} // End namespace Foam


// ************************************************************************* //

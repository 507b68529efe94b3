/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "picNames.H"

namespace Foam
{
namespace picNames
{

const Enum<int> viscosity
({
    {int(riprap::ViscousKind::automatic), "automatic"},
    {int(riprap::ViscousKind::explicitly), "explicit"},
    {int(riprap::ViscousKind::implicitly), "implicit"},
    {noViscosity, "none"}
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

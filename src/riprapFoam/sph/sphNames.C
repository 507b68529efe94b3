/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The words of device and precision.
\*---------------------------------------------------------------------------*/

#include "sphNames.H"

namespace Foam
{
namespace sphNames
{

const Enum<riprap::DeviceKind> device
({
    {riprap::DeviceKind::automatic, "auto"},
    {riprap::DeviceKind::cpu, "cpu"},
    {riprap::DeviceKind::gpu, "gpu"}
});

const Enum<riprap::PrecisionKind> precision
({
    {riprap::PrecisionKind::mixed, "mixed"},
    {riprap::PrecisionKind::doubled, "double"}
});

} // End namespace sphNames
} // End namespace Foam


// ************************************************************************* //

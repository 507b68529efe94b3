/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The words of the SPH choices: one line a word.
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

const Enum<riprap::EosKind> equationOfState
({
    {riprap::EosKind::Tait, "Tait"},
    {riprap::EosKind::linear, "linear"}
});

const Enum<riprap::ShiftingKind> shifting
({
    {riprap::ShiftingKind::none, "none"},
    {riprap::ShiftingKind::fickian, "fickian"}
});

const Enum<riprap::WallKind> wallModel
({
    {riprap::WallKind::stationary, "stationary"},
    {riprap::WallKind::extrapolated, "extrapolated"}
});

const Enum<riprap::IntegratorKind> timeIntegration
({
    {riprap::IntegratorKind::leapfrog, "leapfrog"},
    {riprap::IntegratorKind::symplectic, "symplectic"}
});

const Enum<riprap::CouplingKind> coupling
({
    {riprap::CouplingKind::stationary, "stationary"},
    {riprap::CouplingKind::pressureGradient, "pressureGradient"},
    {riprap::CouplingKind::pressureApproximation, "pressureApproximation"},
    {riprap::CouplingKind::extrapolated, "extrapolated"}
});

const Enum<riprap::FluidForceKind> fluidForce
({
    {riprap::FluidForceKind::held, "held"},
    {riprap::FluidForceKind::interpolated, "interpolated"},
    {riprap::FluidForceKind::impulse, "impulse"}
});

} // End namespace sphNames
} // End namespace Foam


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The words of constant/solidProperties: one line a word.
\*---------------------------------------------------------------------------*/

#include "demNames.H"

namespace Foam
{
namespace demNames
{

const Enum<riprap::NormalKind> normal
({
    {riprap::NormalKind::linear, "linear"},
    {riprap::NormalKind::incremental, "incremental"},
    {riprap::NormalKind::cellSpring, "cellSpring"},
    {riprap::NormalKind::hertz, "hertz"}
});

const Enum<riprap::TangentialKind> tangential
({
    {riprap::TangentialKind::none, "none"},
    {riprap::TangentialKind::history, "history"},
    {riprap::TangentialKind::oneStep, "oneStep"}
});

const Enum<riprap::RollingKind> rolling
({
    {riprap::RollingKind::none, "none"},
    {riprap::RollingKind::constantTorque, "constantTorque"},
    {riprap::RollingKind::spring, "spring"}
});

const Enum<riprap::DemIntegratorKind> timeIntegration
({
    {riprap::DemIntegratorKind::leapfrog, "leapfrog"},
    {riprap::DemIntegratorKind::velocityVerlet, "velocityVerlet"}
});

const Enum<riprap::BondRadiusKind> bondRadius
({
    {riprap::BondRadiusKind::mean, "mean"},
    {riprap::BondRadiusKind::harmonic, "harmonic"}
});

const Enum<calibrationKind> calibration
({
    {calibrationKind::direct, "direct"},
    {calibrationKind::moduli, "moduli"},
    {calibrationKind::planeStrain, "planeStrain"}
});

} // End namespace demNames
} // End namespace Foam


// ************************************************************************* //

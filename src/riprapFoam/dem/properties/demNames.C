/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The words of constant/solidProperties that no model card has: one line a word.
\*---------------------------------------------------------------------------*/

#include "demNames.H"

namespace Foam
{
namespace demNames
{

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

} // End namespace demNames
} // End namespace Foam


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "picNames.H"

namespace Foam
{
namespace picNames
{

const Enum<int> advection
({
    {2, "RungeKutta2"},
    {3, "RungeKutta3"}
});

} // End namespace picNames
} // End namespace Foam


// ************************************************************************* //

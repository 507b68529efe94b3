/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sphSceneObject.H"

namespace Foam
{
    defineTypeNameAndDebug(sphSceneObject, 0);
}

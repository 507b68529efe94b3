/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demSceneObject.H"

namespace Foam
{
    defineTypeNameAndDebug(demSceneObject, 0);
}

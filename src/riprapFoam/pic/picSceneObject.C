/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "picSceneObject.H"

namespace Foam
{
    defineTypeNameAndDebug(picSceneObject, 0);
}

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sphSceneObject.H"
#include "wallBodies.H"

namespace Foam
{
    defineTypeNameAndDebug(sphSceneObject, 0);
}


Foam::labelList Foam::sphSceneObject::bodyOfWall() const
{
    return bodies().bodyOf(walls_.names);
}

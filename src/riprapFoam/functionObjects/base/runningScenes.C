/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "runningScenes.H"
#include "picSceneObject.H"
#include "sphSceneObject.H"

const Foam::fluidSceneObject*
Foam::functionObjects::runningFluid(const objectRegistry& mesh)
{
    if (const auto* grid = mesh.cfindObject<picSceneObject>(picSceneObject::typeName)) return grid;
    return mesh.cfindObject<sphSceneObject>(sphSceneObject::typeName);
}


const Foam::demSceneObject*
Foam::functionObjects::runningSolids(const objectRegistry& mesh)
{
    return mesh.cfindObject<demSceneObject>(demSceneObject::typeName);
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demFunctionObject.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(demFunctionObject, 0);
}
}


const Foam::demSceneObject&
Foam::functionObjects::demFunctionObject::dem() const
{
    const auto* scene =
        mesh_.cfindObject<demSceneObject>(demSceneObject::typeName);

    if (!scene)
    {
        FatalIOErrorInFunction(dict_)
            << "Function object " << name() << " of type " << type()
            << " needs a running scene of solids, and there is no " << demSceneObject::typeName
            << " on mesh " << mesh_.name() << "." << nl
            << "    riprapFoam with solver dem has one, solver sphDem where the case"
            << " has solids, as has its option -postProcess; other solvers and the utility "
               "postProcess"
            << " have none." << exit(FatalIOError);
    }

    return *scene;
}


Foam::labelList Foam::functionObjects::demFunctionObject::groups
(
    const dictionary& dict
) const
{
    const demSettings& settings = dem().settings();
    if (!dict.found("groups"))
    {
        return identity(settings.groups.size());
    }

    labelList indices;
    for (const word& group : dict.get<wordList>("groups"))
    {
        indices.append(settings.group(group, dict));
    }
    if (indices.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Entry groups of function object " << name() << " is empty"
            << exit(FatalIOError);
    }
    return indices;
}

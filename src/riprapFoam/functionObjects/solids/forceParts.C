/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "forceParts.H"
#include "didYouMean.H"
#include "runningScenes.H"
#include "wallBodies.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

Foam::wordList Foam::functionObjects::forceParts::solidWallNames() const
{
    wordList names;
    if (solids())
    {
        for (const riprap::DemWall& wall : solids()->input().walls)
        {
            names.append(word(wall.name, false));
        }
    }
    return names;
}


Foam::wordList Foam::functionObjects::forceParts::validPatches() const
{
    const wordList ofFluid(fluid() ? fluid()->wallNames() : wordList());
    const wordList ofSolids(solidWallNames());

    wordList names;
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (ofFluid.found(patch.name()) || ofSolids.found(patch.name()))
        {
            names.append(patch.name());
        }
    }
    return names;
}


Foam::wordList Foam::functionObjects::forceParts::validSurfaces() const
{
    const wordList planes(validPlanes());

    wordList names;
    const auto add = [&](const wordList& walls)
    {
        for (const word& wall : walls)
        {
            if
            (
                mesh_.boundaryMesh().findPatchID(wall) < 0
             && !planes.found(wall) && !names.found(wall)
            )
            {
                names.append(wall);
            }
        }
    };
    add(fluid() ? fluid()->wallNames() : wordList());
    add(solidWallNames());
    return names;
}


Foam::wordList Foam::functionObjects::forceParts::validPlanes() const
{
    wordList names;
    if (solids())
    {
        for (const auto& plane : solids()->settings().walls.planes)
        {
            names.append(plane.first());
        }
    }
    return names;
}


Foam::wordList Foam::functionObjects::forceParts::validBodies() const
{
    wordList names;
    for (label body = 0; fluid() && body < fluid()->bodies().size(); ++body)
    {
        names.append(fluid()->bodies().name(body));
    }
    if (solids())
    {
        for (const wallMotion& motion : solids()->settings().walls.motion)
        {
            if (!names.found(motion.name)) names.append(motion.name);
        }
    }
    return names;
}


Foam::wordList Foam::functionObjects::forceParts::validGroups() const
{
    return solids() ? solids()->settings().groupNames() : wordList();
}


Foam::wordList Foam::functionObjects::forceParts::selected
(
    const word& entry,
    const wordList& valid
) const
{
    const wordRes patterns(dict_.get<wordRes>(entry));
    wordHashSet names;

    if (patterns.empty())
    {
        FatalIOErrorInFunction(dict_)
            << "Entry " << entry << " of function object " << functionObject_
            << " is empty; valid are " << listed(valid).c_str()
            << exit(FatalIOError);
    }

    for (const wordRe& pattern : patterns)
    {
        bool any = false;
        for (const word& name : valid)
        {
            if (pattern.match(name))
            {
                names.insert(name);
                any = true;
            }
        }
        if (!any)
        {
            FatalIOErrorInFunction(dict_)
                << "Entry " << entry << " of function object "
                << functionObject_ << ": " << pattern
                << " selects none; valid are " << listedFor(pattern, valid).c_str()
                << exit(FatalIOError);
        }
    }
    return names.sortedToc();
}


void Foam::functionObjects::forceParts::noEntry() const
{
    FatalIOErrorInFunction(dict_)
        << "Function object " << functionObject_ << " does not say of which"
        << " parts the force is wanted: one or more of the entries "
        << listed(entries()).c_str() << " are needed. Valid are patches "
        << listed(validPatches()).c_str() << ", surfaces "
        << listed(validSurfaces()).c_str() << ", planes "
        << listed(validPlanes()).c_str() << ", bodies "
        << listed(validBodies()).c_str() << ", groups "
        << listed(validGroups()).c_str() << exit(FatalIOError);
}


void Foam::functionObjects::forceParts::addWalls(const wordList& names)
{
    if (fluid())
    {
        const wordList walls(fluid()->wallNames());
        forAll(walls, i)
        {
            if (names.found(walls[i])) ofFluid_[i] = true;
        }
    }
    const wordList walls(solidWallNames());
    forAll(walls, i)
    {
        if (names.found(walls[i])) ofSolids_[i] = true;
    }
}


void Foam::functionObjects::forceParts::addBodies(const wordList& names)
{
    if (fluid())
    {
        const labelList bodyOf(fluid()->bodyOfWall());
        forAll(bodyOf, i)
        {
            if (bodyOf[i] >= 0 && names.found(fluid()->bodies().name(bodyOf[i])))
            {
                ofFluid_[i] = true;
            }
        }
    }
    for (label i = 0; i < ofSolids_.size(); ++i)
    {
        const label motion = solids()->input().walls[i].motion;
        if
        (
            motion >= 0
         && names.found(solids()->settings().walls.motion[motion].name)
        )
        {
            ofSolids_[i] = true;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::forceParts::forceParts
(
    const polyMesh& mesh,
    const dictionary& dict,
    const word& functionObject
)
:
    mesh_(mesh),
    dict_(dict),
    functionObject_(functionObject)
{
    if (!fluid() && !solids())
    {
        FatalIOErrorInFunction(dict)
            << "Function object " << functionObject
            << " needs a running particle scene, and there is none on mesh "
            << mesh.name() << "." << nl << "    riprapFoam has one, as has its"
            << " option -postProcess; other solvers and the utility"
            << " postProcess have none." << exit(FatalIOError);
    }

    ofFluid_.setSize(fluid() ? fluid()->wallNames().size() : 0, false);
    ofSolids_.setSize(solids() ? solids()->input().walls.size() : 0, false);
    groups_.setSize(validGroups().size(), false);

    bool any = false;
    for (const word& entry : entries())
    {
        any = any || dict.found(entry);
    }
    if (!any)
    {
        noEntry();
    }

    if (dict.found("patches")) addWalls(selected("patches", validPatches()));
    if (dict.found("surfaces")) addWalls(selected("surfaces", validSurfaces()));
    if (dict.found("planes")) addWalls(selected("planes", validPlanes()));
    if (dict.found("bodies")) addBodies(selected("bodies", validBodies()));
    if (dict.found("groups"))
    {
        const wordList names(selected("groups", validGroups()));
        const wordList all(validGroups());
        forAll(all, i)
        {
            groups_[i] = names.found(all[i]);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::fluidSceneObject*
Foam::functionObjects::forceParts::fluid() const
{
    return runningFluid(mesh_);
}


const Foam::demSceneObject*
Foam::functionObjects::forceParts::solids() const
{
    return runningSolids(mesh_);
}


Foam::wordList Foam::functionObjects::forceParts::entries()
{
    return wordList({"patches", "surfaces", "planes", "bodies", "groups"});
}


// ************************************************************************* //

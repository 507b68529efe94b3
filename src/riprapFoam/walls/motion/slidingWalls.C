/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "slidingWalls.H"
#include "listed.H"
#include "SubField.H"
#include "wallPolyPatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- A side of the mesh's box: its axis, and 0 for the lower one
struct boxSide
{
    direction axis;
    int upper;
};


static const polyPatch& wallNamed
(
    const dictionary& dict,
    const word& name,
    const polyMesh& mesh
)
{
    DynamicList<word> walls;
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<wallPolyPatch>(patch))
        {
            walls.append(patch.name());
        }
    }
    if (!walls.found(name))
    {
        FatalIOErrorInFunction(dict)
            << "There is no wall " << name << "; the mesh's walls are "
            << listed(wordList(walls)).c_str() << exit(FatalIOError);
    }
    return mesh.boundaryMesh()[name];
}


//- All of the patch's faces lie in one side, and fill it
static boxSide sideOf
(
    const dictionary& dict,
    const polyPatch& patch,
    const polyMesh& mesh
)
{
    const boundBox& box = mesh.bounds();
    const vector span(box.span());
    const scalar hair = 1e-6*mag(span);

    for (direction axis = 0; axis < vector::nComponents; ++axis)
    {
        for (int upper = 0; upper < 2; ++upper)
        {
            const scalar at = (upper ? box.max() : box.min())[axis];
            scalar area = 0;
            bool within = patch.size() > 0;
            forAll(patch, facei)
            {
                within =
                    within
                 && mag(patch.faceCentres()[facei][axis] - at) < hair;
                area += mag(patch.faceAreas()[facei][axis]);
            }
            const scalar whole = span[(axis + 1) % 3]*span[(axis + 2) % 3];
            if (within && area > (1 - 1e-6)*whole)
            {
                return boxSide{axis, upper};
            }
        }
    }

    FatalIOErrorInFunction(dict)
        << "Wall " << patch.name() << " is not one whole side of the mesh: only"
        << " a whole side can slide" << exit(FatalIOError);
    return boxSide{0, 0};
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::readSlidingWalls
(
    const dictionary& velocities,
    const polyMesh& mesh,
    riprap::PicConfig& config
)
{
    if (velocities.size() && !config.noSlip)
    {
        FatalIOErrorInFunction(velocities)
            << "A wall that slides needs `slip noSlip;`" << exit(FatalIOError);
    }

    for (const entry& e : velocities)
    {
        const word& name = e.keyword();
        const boxSide side =
            sideOf(velocities, wallNamed(velocities, name, mesh), mesh);

        const vector v(velocities.get<vector>(name));
        if (mag(v[side.axis]) > 0)
        {
            FatalIOErrorInFunction(velocities)
                << "Wall " << name << " has the velocity " << v
                << ": it can slide in its own plane only, its "
                << vector::componentNames[side.axis] << " must be 0"
                << exit(FatalIOError);
        }
        for (direction d = 0; d < vector::nComponents; ++d)
        {
            config.slide[side.axis][side.upper][d] = v[d];
        }
    }
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nearestPatch.H"
#include "emptyPolyPatch.H"
#include "StringStream.H"
#include "wallPolyPatch.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

bool Foam::nearestPatch::isOpening(const polyPatch& patch) const
{
    return
        patch.size() && !patch.coupled() && !isA<emptyPolyPatch>(patch)
     && !isA<wallPolyPatch>(patch);
}


const Foam::nearestPatch::faceTree& Foam::nearestPatch::tree
(
    bool openings
) const
{
    autoPtr<faceTree>& tree = openings ? openTree_ : tree_;
    if (!tree.valid())
    {
        DynamicList<label> faces(mesh_.nFaces() - mesh_.nInternalFaces());
        for (const polyPatch& patch : mesh_.boundaryMesh())
        {
            if (openings ? isOpening(patch) : !isA<emptyPolyPatch>(patch))
            {
                forAll(patch, i)
                {
                    faces.append(patch.start() + i);
                }
            }
        }

        // Not degenerate where the mesh is flat
        treeBoundBox box(mesh_.points());
        box.inflate(0.01);

        tree.reset
        (
            new faceTree
            (
                treeDataFace(true, mesh_, faces),
                box,
                8,      // levels at most
                10,     // faces a leaf
                3       // copies of a face
            )
        );
    }
    return *tree;
}


Foam::label Foam::nearestPatch::nearest
(
    const point& x,
    bool openings,
    scalar& distance
) const
{
    const faceTree& t = tree(openings);
    distance = GREAT;
    if (t.shapes().size() == 0)
    {
        return -1;
    }
    const pointIndexHit hit(t.findNearest(x, magSqr(x) + sqr(GREAT)));
    if (!hit.hit())
    {
        return -1;
    }
    distance = mag(hit.hitPoint() - x);
    return t.shapes().faceLabels()[hit.index()];
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::word& Foam::nearestPatch::patch(const point& x) const
{
    scalar distance, toOpening;
    label face = nearest(x, false, distance);
    const label opening = nearest(x, true, toOpening);
    if (opening >= 0 && toOpening <= (1 + 1e-6)*distance)
    {
        face = opening;
    }

    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    return face < 0 ? word::null : patches[patches.whichPatch(face)].name();
}


bool Foam::nearestPatch::byOpening(const point& x) const
{
    const label patchi = mesh_.boundaryMesh().findPatchID(patch(x));
    return patchi >= 0 && isOpening(mesh_.boundaryMesh()[patchi]);
}


std::string Foam::nearestPatch::particle
(
    label id,
    const riprap::Vector3& x
) const
{
    const point where(x[0], x[1], x[2]);
    OStringStream text;
    text<< "particle " << id << " at " << where << " (nearest patch: "
        << patch(where) << ')';
    return text.str();
}


// ************************************************************************* //

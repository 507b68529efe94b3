/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "boundaryFinder.H"
#include "emptyPolyPatch.H"
#include "StringStream.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

const Foam::indexedOctree<Foam::treeDataFace>&
Foam::boundaryFinder::tree() const
{
    if (!tree_.valid())
    {
        DynamicList<label> faces(mesh_.nFaces() - mesh_.nInternalFaces());
        for (const polyPatch& patch : mesh_.boundaryMesh())
        {
            if (!isA<emptyPolyPatch>(patch))
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

        tree_.reset
        (
            new indexedOctree<treeDataFace>
            (
                treeDataFace(true, mesh_, faces),
                box,
                8,      // levels at most
                10,     // faces a leaf
                3       // copies of a face
            )
        );
    }
    return *tree_;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::word& Foam::boundaryFinder::patch(const point& x) const
{
    const pointIndexHit hit(tree().findNearest(x, magSqr(x) + sqr(GREAT)));
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();

    if (!hit.hit())
    {
        return word::null;
    }
    return patches[patches.whichPatch(tree().shapes().faceLabels()[hit.index()])].name();
}


std::string Foam::boundaryFinder::particle
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

// SPDX-License-Identifier: GPL-3.0-or-later
/*  Baffles: walls of no thickness, whose two sides are boundary faces in the same place. Points
    behind either side would be in the fluid of the other.
*/

#include "wallSurface.H"
#include "emptyPolyPatch.H"
#include "pointGrid.H"

namespace Foam
{

// Faces nearer than this, in spacings, with opposite normals are the two sides of a baffle
static constexpr scalar samePlace = 0.01;

} // namespace Foam


void Foam::refuseBaffles(const wallSpace& space, const labelList& patchIDs)
{
    const polyBoundaryMesh& patches = space.mesh.boundaryMesh();

    DynamicList<point> centres;
    DynamicList<vector> normals;
    DynamicList<label> patchOf;
    for (const polyPatch& patch : patches)
    {
        if (isA<emptyPolyPatch>(patch)) continue;
        for (const face& f : patch)
        {
            centres.append(f.centre(space.mesh.points()));
            normals.append(f.unitNormal(space.mesh.points()));
            patchOf.append(patch.index());
        }
    }

    const pointGrid grid(samePlace*space.spacing, centres);
    forAll(centres, i)
    {
        if (!patchIDs.found(patchOf[i])) continue;

        label behind = -1;
        grid.near(centres[i],
            [&](label j, const vector&, scalar)
            {
                if ((normals[i] & normals[j]) < -0.9) behind = j;
            });
        if (behind < 0) continue;

        FatalErrorInFunction
            << "Patch " << patches[patchOf[i]].name() << " is a baffle: a face of patch "
            << patches[patchOf[behind]].name() << " is right behind it, at " << centres[i]
            << ". There is no room for wall points. Leave it out (walls { patches (..); } of"
            << " constant/sphProperties) and put a plate in its place into constant/geometry"
            << " (searchablePlate, searchableDisk, or an open triSurfaceMesh), or give it a "
               "thickness"
            << exit(FatalError);
    }
}

// SPDX-License-Identifier: GPL-3.0-or-later
/*  Wall patches of the mesh as oriented elements. A 2D wall face is a strip from the front to the
    back of the mesh: its edges on the front, moved to the mid-plane, are its segments.
*/

#include "wallSurface.H"
#include "cyclicPolyPatch.H"

namespace Foam
{

// Normal of the cyclic patch that a mesh point lies on, else zero
static vectorField cyclicNormals(const polyMesh& mesh)
{
    vectorField normal(mesh.nPoints(), Zero);
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (!isA<cyclicPolyPatch>(patch)) continue;
        for (const face& f : patch)
        {
            for (const label p : f) normal[p] = f.unitNormal(mesh.points());
        }
    }
    return normal;
}


static void addSegments
(
    const wallSpace& space,
    const face& f,
    const vector& intoFluid,
    label source,
    const std::function<label(label)>& local,
    wallElements& all
)
{
    const pointField& points = space.mesh.points();
    auto front = [&](label p) { return points[p][space.empty] < space.middle; };

    forAll(f, v)
    {
        label a = f[v], b = f.nextLabel(v);
        if (!front(a) || !front(b)) continue;
        if ((space.left(points[b] - points[a]) & intoFluid) < 0) std::swap(a, b);
        all.add(local(a), local(b), -1, source);
    }
}


static void addTriangles
(
    const wallSpace& space,
    const face& f,
    label source,
    const std::function<label(label)>& local,
    wallElements& all
)
{
    faceList tris(f.nTriangles());
    label n = 0;
    f.triangles(space.mesh.points(), n, tris);
    for (const face& t : tris)
    {
        // Patch faces point out of the mesh, these into the fluid
        all.add(local(t[0]), local(t[2]), local(t[1]), source);
    }
}

} // namespace Foam


Foam::wallElements Foam::patchElements(const wallSpace& space, const labelList& patchIDs)
{
    const polyMesh& mesh = space.mesh;
    const vectorField cyclicNormal(cyclicNormals(mesh));

    wallElements all;
    labelList localLabel(mesh.nPoints(), -1);
    const std::function<label(label)> local = [&](label p)
    {
        if (localLabel[p] < 0)
        {
            point x(mesh.points()[p]);
            if (space.planar) x[space.empty] = space.middle;
            localLabel[p] = all.addPoint(x, cyclicNormal[p]);
        }
        return localLabel[p];
    };

    forAll(patchIDs, i)
    {
        for (const face& f : mesh.boundaryMesh()[patchIDs[i]])
        {
            if (space.planar)
            {
                addSegments(space, f, -f.unitNormal(mesh.points()), i, local, all);
            }
            else
            {
                addTriangles(space, f, i, local, all);
            }
        }
    }
    return all;
}

// SPDX-License-Identifier: GPL-3.0-or-later
/*  The cells that particles are in.

    From the cell of the particle before, or where it was last, one goes through the face whose plane the point is farthest beyond, until the point is on the inner
    side of all faces: a few products a particle, where the mesh's octree takes hundreds of tests in flat cells. What this does not settle (a point on a face, cells
    with warped faces, a boundary on the way) the octree decides.
*/

#include "particleCloudIO.H"
#include "indexedOctree.H"
#include "treeDataCell.H"

namespace Foam
{

class cellWalk
{
    static constexpr scalar tolerance = 1e-9;       // of a face's distance: nearer to it a point counts as on it
    const polyMesh& mesh_;
    const label longest_;
    label flat_ = -1;                               // the last cell found to have plane faces

    //- Are the faces of a cell planes?
    bool flat(const label c)
    {
        if (c == flat_) return true;
        for (const label f : mesh_.cells()[c])
        {
            const vector& area = mesh_.faceAreas()[f];
            const scalar room = tolerance*Foam::pow(magSqr(area), 0.75);
            for (const label v : mesh_.faces()[f])
                if (mag((mesh_.points()[v] - mesh_.faceCentres()[f]) & area) > room) return false;
        }
        flat_ = c;
        return true;
    }

public:

    explicit cellWalk(const polyMesh& mesh)
    :
        mesh_(mesh),
        longest_(100 + 3*label(Foam::sqrt(scalar(mesh.nCells()))))
    {}

    //- The cell that a point is in; -1: not settled
    label find(const point& p, label c)
    {
        for (label step = 0; step < longest_; ++step)
        {
            const point& middle = mesh_.cellCentres()[c];
            scalar farthest = -1;                   // beyond a face, over that face's distance from the cell's middle
            label through = -1;
            for (const label f : mesh_.cells()[c])
            {
                const vector& area = mesh_.faceAreas()[f];
                const point& on = mesh_.faceCentres()[f];
                const scalar reach = mag((on - middle) & area);
                const scalar outward = mesh_.faceOwner()[f] == c ? 1 : -1;
                const scalar beyond = outward*((p - on) & area)/max(reach, VSMALL);
                if (beyond > farthest)
                {
                    farthest = beyond;
                    through = f;
                }
            }
            if (farthest < -tolerance) return flat(c) ? c : -1;
            if (farthest <= tolerance || !mesh_.isInternalFace(through)) return -1;
            c = mesh_.faceOwner()[through] == c ? mesh_.faceNeighbour()[through] : mesh_.faceOwner()[through];
        }
        return -1;
    }
};

} // namespace Foam


Foam::labelList Foam::locateParticles
(
    const polyMesh& mesh,
    const pointField& points,
    const labelList& hint,
    bool nearest
)
{
    labelList cell(points.size(), -1);
    if (!mesh.nCells()) return cell;

    const auto hinted = [&](label i)
    {
        return hint.size() == points.size() && hint[i] >= 0 && hint[i] < mesh.nCells();
    };

    // What the walk needs of the mesh is there before the threads ask for it. A point within a cell is in no other: chunks do not matter
    mesh.cells();
    mesh.cellCentres();
    mesh.faceAreas();
    boundBox around(mesh.bounds());
    around.inflate(1e-6);
    const label chunk = 4096, chunks = (points.size() + chunk - 1)/chunk;
    #pragma omp parallel for schedule(dynamic, 1) if (chunks > 1)
    for (label k = 0; k < chunks; ++k)
    {
        cellWalk walk(mesh);
        label last = 0;
        for (label i = k*chunk; i < min((k + 1)*chunk, points.size()); ++i)
        {
            cell[i] = walk.find(points[i], hinted(i) ? hint[i] : last);
            if (cell[i] >= 0) last = cell[i];
        }
    }

    // The rest, one by one: the mesh builds its tree for them, but not for those that are clear of it
    label last = 0;
    forAll(points, i)
    {
        if (cell[i] < 0 && (nearest || around.contains(points[i])))
        {
            const point& p = points[i];
            const label guess = hinted(i) ? hint[i] : last;
            if (mesh.pointInCell(p, guess))
            {
                cell[i] = guess;
            }
            else
            {
                cell[i] = mesh.cellTree().findInside(p);
                if (cell[i] < 0 && nearest)
                {
                    cell[i] = mesh.cellTree().findNearest(p, sqr(GREAT)).index();
                }
            }
        }
        if (cell[i] >= 0) last = cell[i];
    }
    return cell;
}

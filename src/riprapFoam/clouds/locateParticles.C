// SPDX-License-Identifier: GPL-3.0-or-later
/*  The cells that particles are in.

    From the cell of the particle before, or where it was last, one goes through the face whose
    plane the point is farthest beyond, until the point is on the inner side of all faces: a few
    products a particle, where the mesh's octree takes hundreds of tests in flat cells. A point on
    faces is in the first of the cells about it, wherever the search began. What this does not
    settle (cells with warped faces, a boundary on the way) the octree decides. Where all cells are
    equal boxes, a point's place tells the same (cellLattice).
*/

#include "cellLattice.H"
#include "particleCloudIO.H"
#include "DynamicList.H"
#include "indexedOctree.H"
#include "treeDataCell.H"

namespace Foam
{

//- Of a face's distance: nearer to it a point counts as on it
static constexpr scalar tolerance = 1e-9;

class cellWalk
{
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

    //- How far a point is beyond a face of a cell, over that face's distance from the cell's middle
    scalar beyond(const point& p, const label c, const label f) const
    {
        const vector& area = mesh_.faceAreas()[f];
        const point& on = mesh_.faceCentres()[f];
        const scalar reach = mag((on - mesh_.cellCentres()[c]) & area);
        const scalar outward = mesh_.faceOwner()[f] == c ? 1 : -1;
        return outward*((p - on) & area)/max(reach, VSMALL);
    }

    //- The cell on the other side, -1: there is none
    label other(const label c, const label f) const
    {
        if (!mesh_.isInternalFace(f)) return -1;
        return mesh_.faceOwner()[f] == c ? mesh_.faceNeighbour()[f] : mesh_.faceOwner()[f];
    }

    //- The first of the cells that have the point on their faces, of which c is one; -1: not
    //  settled
    label firstAbout(const point& p, const label c)
    {
        about_.clear();
        about_.append(c);
        label first = c;
        for (label k = 0; k < about_.size(); ++k)
        {
            const label cell = about_[k];
            if (!flat(cell)) return -1;
            first = min(first, cell);
            for (const label f : mesh_.cells()[cell])
            {
                if (beyond(p, cell, f) < -tolerance) continue;
                const label next = other(cell, f);
                if (next < 0 || about_.found(next)) continue;

                scalar farthest = -1;
                for (const label g : mesh_.cells()[next])
                    farthest = max(farthest, beyond(p, next, g));
                if (farthest <= tolerance) about_.append(next);
            }
        }
        return first;
    }

    DynamicList<label> about_;

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
            scalar farthest = -1;
            label through = -1;
            for (const label f : mesh_.cells()[c])
            {
                const scalar far = beyond(p, c, f);
                if (far > farthest)
                {
                    farthest = far;
                    through = f;
                }
            }
            if (farthest < -tolerance) return flat(c) ? c : -1;
            if (farthest <= tolerance) return firstAbout(p, c);
            c = other(c, through);
            if (c < 0) return -1;
        }
        return -1;
    }
};

static bool hinted(const polyMesh& mesh, const labelList& hint, label i)
{
    return i < hint.size() && hint[i] >= 0 && hint[i] < mesh.nCells();
}


//- By walks; -1 for what they do not settle
static labelList walkedTo
(
    const polyMesh& mesh,
    const pointField& points,
    const labelList& hint
)
{
    // What a walk needs of the mesh is there before the threads ask for it. A point within a cell
    // is in no other: chunks do not matter
    mesh.cells();
    mesh.cellCentres();
    mesh.faceAreas();
    labelList cell(points.size());
    const label chunk = 4096, chunks = (points.size() + chunk - 1)/chunk;
    #pragma omp parallel for schedule(dynamic, 1) if (chunks > 1)
    for (label k = 0; k < chunks; ++k)
    {
        cellWalk walk(mesh);
        label last = 0;
        for (label i = k*chunk; i < min((k + 1)*chunk, points.size()); ++i)
        {
            cell[i] = walk.find(points[i], hinted(mesh, hint, i) ? hint[i] : last);
            if (cell[i] >= 0) last = cell[i];
        }
    }
    return cell;
}


//- By place; outside -1 or the nearest
static labelList placedIn(const cellLattice& lattice, const pointField& points, bool nearest)
{
    labelList cell(points.size());
    #pragma omp parallel for schedule(static) if (points.size() > 10000)
    for (label i = 0; i < points.size(); ++i)
    {
        cell[i] = nearest ? lattice.nearest(points[i], tolerance)
                          : lattice.find(points[i], tolerance);
    }
    return cell;
}


//- The cell of a point that no walk has found: the mesh builds its tree for it
static label searchCell(const polyMesh& mesh, const point& p, label guess, bool nearest)
{
    if (mesh.pointInCell(p, guess)) return guess;
    const label found = mesh.cellTree().findInside(p);
    return found < 0 && nearest ? mesh.cellTree().findNearest(p, sqr(GREAT)).index() : found;
}

} // namespace Foam


Foam::labelList Foam::locateParticles
(
    const polyMesh& mesh,
    const pointField& points,
    const labelList& hint,
    bool nearest,
    const cellLattice* lattice
)
{
    if (!mesh.nCells()) return labelList(points.size(), -1);

    const cellLattice& equal = lattice ? *lattice : latticeOfMesh::cells(mesh);
    if (equal) return placedIn(equal, points, nearest);

    const labelList none;
    const labelList& guess = hint.size() == points.size() ? hint : none;
    labelList cell(walkedTo(mesh, points, guess));

    // The rest, one by one, but not those that are clear of the mesh
    boundBox around(mesh.bounds());
    around.inflate(1e-6);
    label last = 0;
    forAll(points, i)
    {
        if (cell[i] < 0 && (nearest || around.contains(points[i])))
        {
            const label near = hinted(mesh, guess, i) ? guess[i] : last;
            cell[i] = searchCell(mesh, points[i], near, nearest);
        }
        if (cell[i] >= 0) last = cell[i];
    }
    return cell;
}

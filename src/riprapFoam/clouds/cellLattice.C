/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellLattice.H"
#include <cmath>
#include <limits>

namespace Foam
{
    defineTypeNameAndDebug(latticeOfMesh, 0);

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- How far points, centres and volumes may be off, of a cell's size
static constexpr scalar off = 1e-3;

//- The same for points of one plane
static constexpr scalar offPlane = 1e-10;

} // End namespace Foam


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

//- The mesh need not know the faces of all cells for it
Foam::boundBox Foam::cellLattice::firstCell(const polyMesh& mesh)
{
    boundBox box(boundBox::invertedBox);
    const labelList& owner = mesh.faceOwner();
    forAll(owner, f)
    {
        if (owner[f] == 0 || (mesh.isInternalFace(f) && mesh.faceNeighbour()[f] == 0))
        {
            box.add(mesh.points(), mesh.faces()[f]);
        }
    }
    return box;
}


bool Foam::cellLattice::setPlanes(const polyMesh& mesh)
{
    const boundBox whole(mesh.points(), false);
    const boundBox first(firstCell(mesh));
    scalar cells = 1;
    for (direction d = 0; d < 3; ++d)
    {
        const scalar length = whole.max()[d] - whole.min()[d];
        size_[d] = first.max()[d] - first.min()[d];
        low_[d] = whole.min()[d];
        if (size_[d] <= 0 || length/size_[d] > mesh.nCells() + 0.5) return false;
        n_[d] = label(std::lround(length/size_[d]));
        if (n_[d] < 1) return false;
        size_[d] = length/n_[d];
        cells *= n_[d];
    }
    if (cells != mesh.nCells()) return false;

    const pointField& points = mesh.points();
    for (direction d = 0; d < 3; ++d)
    {
        planes_[d].assign(n_[d] + 1, std::numeric_limits<scalar>::infinity());
        for (const point& p : points)
        {
            const scalar at = (p[d] - low_[d])/size_[d];
            const label i = label(std::lround(at));
            if (i < 0 || i > n_[d] || mag(at - i) > off) return false;
            scalar& there = planes_[d][i];
            if (std::isinf(there)) there = p[d];
            if (mag(p[d] - there) > offPlane*size_[d]) return false;
        }
        for (const scalar x : planes_[d]) if (std::isinf(x)) return false;
    }
    return true;
}


void Foam::cellLattice::setCells(const polyMesh& mesh)
{
    const scalar volume = size_[0]*size_[1]*size_[2];
    labelList cell(mesh.nCells(), -1);
    forAll(cell, c)
    {
        label place[3];
        for (direction d = 0; d < 3; ++d)
        {
            const scalar at = (mesh.cellCentres()[c][d] - low_[d])/size_[d] - 0.5;
            place[d] = label(std::lround(at));
            if (place[d] < 0 || place[d] >= n_[d] || mag(at - place[d]) > off) return;
        }
        label& there = cell[place[0] + n_[0]*(place[1] + n_[1]*place[2])];
        if (there >= 0 || mag(mesh.cellVolumes()[c] - volume) > 10*off*volume) return;
        there = c;
    }
    cell_.transfer(cell);
}


int Foam::cellLattice::along
(
    direction d,
    scalar x,
    scalar tolerance,
    label* found
) const
{
    const std::vector<scalar>& planes = planes_[d];
    const scalar at = min(max((x - low_[d])/size_[d], scalar(0)), scalar(n_[d] - 1));
    label i = label(at);
    if (i > 0 && x < planes[i]) --i;
    if (i < n_[d] - 1 && x >= planes[i + 1]) ++i;

    const auto holds = [&](label k)
    {
        const scalar room = tolerance*0.5*(planes[k + 1] - planes[k]);
        return x - planes[k] >= -room && planes[k + 1] - x >= -room;
    };
    int n = 0;
    if (i > 0 && holds(i - 1)) found[n++] = i - 1;
    if (holds(i)) found[n++] = i;
    if (i < n_[d] - 1 && holds(i + 1)) found[n++] = i + 1;
    return min(n, 2);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellLattice::cellLattice(const polyMesh& mesh)
{
    if (mesh.nCells() && setPlanes(mesh)) setCells(mesh);
}


Foam::latticeOfMesh::latticeOfMesh(const polyMesh& mesh)
:
    MeshObject<polyMesh, Foam::GeometricMeshObject, latticeOfMesh>(mesh),
    cells_(mesh)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::cellLattice::find(const point& p, scalar tolerance) const
{
    label place[3][3];
    int n[3];
    for (direction d = 0; d < 3; ++d)
    {
        // One that is not a number is nowhere
        n[d] = std::isfinite(p[d]) ? along(d, p[d], tolerance, place[d]) : 0;
    }
    label first = -1;
    for (int k = 0; k < n[2]; ++k)
    {
        for (int j = 0; j < n[1]; ++j)
        {
            for (int i = 0; i < n[0]; ++i)
            {
                const label c = cell_
                [
                    place[0][i] + n_[0]*(place[1][j] + n_[1]*place[2][k])
                ];
                if (first < 0 || c < first) first = c;
            }
        }
    }
    return first;
}


Foam::label Foam::cellLattice::nearest(const point& p, scalar tolerance) const
{
    point within(p);
    for (direction d = 0; d < 3; ++d)
    {
        if (!std::isfinite(p[d])) return -1;
        within[d] = min(max(p[d], planes_[d].front()), planes_[d].back());
    }
    return find(within, tolerance);
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wholeBoundary.H"
#include "allRanks.H"
#include "labelIOList.H"
#include "mergePoints.H"
#include "processorCyclicPolyPatch.H"
#include "pstreamTransport.H"
#include "Time.H"
#include <algorithm>
#include <map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- A face of the boundary, in the numbers of the whole mesh
struct boundaryFace
{
    label patch = 0, number = 0;
    std::vector<label> points;

    bool operator<(const boundaryFace& other) const
    {
        return patch != other.patch ? patch < other.patch : number < other.number;
    }
};


//- The patch that has these faces in the whole mesh; -1: none
static label wholePatch(const polyPatch& patch)
{
    const polyBoundaryMesh& patches = patch.boundaryMesh();
    if (const auto* cyclic = isA<processorCyclicPolyPatch>(patch))
    {
        return patches.findPatchID(cyclic->referPatchName());
    }
    return isA<processorPolyPatch>(patch) ? -1 : patch.index();
}


//- Faces and points of this process; numbered as decomposePar does, or, where
//  it does not say, one process after the other
static riprap::RankBytes ownFaces(const polyMesh& mesh)
{
    const labelList faceNumber(processorAddressing(mesh, "faceProcAddressing"));
    const labelList pointNumber(processorAddressing(mesh, "pointProcAddressing"));
    const bool known = onAllRanks
    (
        faceNumber.size() == mesh.nFaces() && pointNumber.size() == mesh.nPoints()
    );
    label firstFace = 0, firstPoint = 0;
    const std::vector<std::string> sizes
    (
        textsOfRanks(std::to_string(mesh.nFaces()) + ' ' + std::to_string(mesh.nPoints()))
    );
    for (int rank = 0; rank < Pstream::myProcNo(); ++rank)
    {
        const std::size_t gap = sizes[rank].find(' ');
        firstFace += std::stoi(sizes[rank].substr(0, gap));
        firstPoint += std::stoi(sizes[rank].substr(gap));
    }

    riprap::RankBytes bytes;
    const label merge = !known;
    riprap::putValues(bytes, &merge);
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        const label whole = wholePatch(patch);
        if (whole < 0) continue;
        forAll(patch, i)
        {
            // Counted from 1 there
            const label f = patch.start() + i;
            const label head[3] =
            {
                whole,
                known ? mag(faceNumber[f]) - 1 : firstFace + f,
                patch[i].size()
            };
            riprap::putValues(bytes, head, 3);
            for (const label p : patch[i])
            {
                const label number = known ? pointNumber[p] : firstPoint + p;
                riprap::putValues(bytes, &number);
                riprap::putValues(bytes, &mesh.points()[p]);
            }
        }
    }
    return bytes;
}


//- The boundaries of all processes
struct wholeFaces
{
    std::vector<boundaryFace> faces;        // sorted
    std::map<label, point> pointOf;         // by numbers of the whole mesh
    bool merge = false;                     // processes share points, each by a number of its own
};


//- \return the face that was put at from, which goes on to the next
static boundaryFace takeFace
(
    const unsigned char*& from,
    std::map<label, point>& pointOf
)
{
    label head[3];
    takeBytes(from, head, 3);
    boundaryFace f;
    f.patch = head[0];
    f.number = head[1];
    for (label v = 0; v < head[2]; ++v)
    {
        label number;
        point x;
        takeBytes(from, &number);
        takeBytes(from, &x);
        f.points.push_back(number);
        pointOf[number] = x;
    }
    return f;
}


static wholeFaces gatherFaces(const polyMesh& mesh)
{
    pstreamTransport ranks;
    std::vector<riprap::RankBytes> all;
    ranks.exchange
    (
        std::vector<riprap::RankBytes>(ranks.size(), ownFaces(mesh)), all
    );

    wholeFaces whole;
    label merge = 0;
    for (const riprap::RankBytes& bytes : all)
    {
        const unsigned char* from = bytes.data();
        const unsigned char* const end = from + bytes.size();
        takeBytes(from, &merge);
        while (from < end)
        {
            whole.faces.push_back(takeFace(from, whole.pointOf));
        }
    }
    whole.merge = merge;
    std::sort(whole.faces.begin(), whole.faces.end());
    return whole;
}


//- Points one after the other, those at one place as one; of each number its
//  index
static std::map<label, label> numberPoints
(
    const polyMesh& mesh,
    const wholeFaces& whole,
    pointField& points
)
{
    std::map<label, label> indexOf;
    points.setSize(label(whole.pointOf.size()));
    label n = 0;
    for (const auto& p : whole.pointOf)
    {
        points[n] = p.second;
        indexOf[p.first] = n++;
    }
    if (!whole.merge) return indexOf;

    // What it returns depends on the version
    labelList merged(identity(points.size()));
    mergePoints(points, 1e-8*mesh.bounds().mag(), false, merged);
    pointField unique(max(merged) + 1);
    forAll(points, i) unique[merged[i]] = points[i];
    points.transfer(unique);
    for (auto& index : indexOf) index.second = merged[index.second];
    return indexOf;
}


static faceList shapesOf
(
    const std::vector<boundaryFace>& faces,
    const std::map<label, label>& indexOf
)
{
    faceList shapes(label(faces.size()));
    forAll(shapes, i)
    {
        shapes[i].setSize(label(faces[i].points.size()));
        forAll(shapes[i], v)
        {
            shapes[i][v] = indexOf.at(faces[i].points[v]);
        }
    }
    return shapes;
}


//- Those of the mesh but between processes, with the faces that they have in all
static void addPatches
(
    const polyMesh& mesh,
    const std::vector<boundaryFace>& faces,
    polyMesh& whole
)
{
    labelList sizes(mesh.boundaryMesh().size(), Zero);
    for (const boundaryFace& f : faces) ++sizes[f.patch];

    DynamicList<label> kept;
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (!isA<processorPolyPatch>(patch)) kept.append(patch.index());
    }
    PtrList<polyPatch> patches(kept.size());
    label start = 0;
    forAll(kept, i)
    {
        const polyPatch& patch = mesh.boundaryMesh()[kept[i]];
        patches.set
        (
            i, patch.clone(whole.boundaryMesh(), i, sizes[kept[i]], start)
        );
        start += sizes[kept[i]];
    }
    whole.addPatches(patches);
}


static autoPtr<polyMesh> makeWhole(const polyMesh& mesh, const word& name)
{
    const wholeFaces boundary(gatherFaces(mesh));
    pointField points;
    const std::map<label, label> indexOf(numberPoints(mesh, boundary, points));
    faceList shapes(shapesOf(boundary.faces, indexOf));

    labelList owner(shapes.size(), Zero), neighbour;
    auto whole = autoPtr<polyMesh>::New
    (
        IOobject
        (
            name,
            mesh.time().constant(),
            mesh.time(),
            IOobject::NO_READ,
            IOobject::NO_WRITE
        ),
        std::move(points),
        std::move(shapes),
        std::move(owner),
        std::move(neighbour),
        false
    );
    addPatches(mesh, boundary.faces, *whole);
    return whole;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::processorAddressing(const polyMesh& mesh, const word& name)
{
    const labelIOList numbers
    (
        IOobject
        (
            name,
            mesh.facesInstance(),
            polyMesh::meshSubDir,
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        )
    );
    return labelList(numbers);
}


const Foam::polyMesh& Foam::wholeBoundary(const polyMesh& mesh)
{
    if (!Pstream::parRun()) return mesh;

    const word name(mesh.name() + "Boundary");
    if (const auto* whole = mesh.time().cfindObject<polyMesh>(name))
    {
        return *whole;
    }
    return regIOobject::store(makeWhole(mesh, name));
}


// ************************************************************************* //

// SPDX-License-Identifier: GPL-3.0-or-later

#include "checkWalls.H"
#include "allRanks.H"
#include "dividedRegion.H"
#include "emptyPolyPatch.H"
#include "indexedOctree.H"
#include "pointGrid.H"
#include "treeDataCell.H"
#include "triSurface.H"
#include "triSurfaceSearch.H"
#include "wholeBoundary.H"
#include "solvers/sph/sphModels.hpp"

namespace Foam
{

// Faces of patches that are neither wall nor empty
static triSurface openPatches(const polyMesh& mesh, const labelList& wallIDs)
{
    List<labelledTri> tris;
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(patch) || wallIDs.found(patch.index())) continue;
        for (const face& f : patch)
        {
            faceList cut(f.nTriangles());
            label n = 0;
            f.triangles(mesh.points(), n, cut);
            for (const face& t : cut) tris.append(labelledTri(t[0], t[1], t[2], 0));
        }
    }
    const triSurface all(tris, mesh.points());
    return triSurface(all.localFaces(), all.localPoints());
}


// A grid of points through the support of a particle; in 2D in the plane
static DynamicList<vector> probes(const polyMesh& mesh, scalar radius, scalar every)
{
    DynamicList<vector> all;
    const label n = label(radius/every);
    for (label i = -n; i <= n; ++i)
    {
        for (label j = -n; j <= n; ++j)
        {
            for (label k = -n; k <= n; ++k)
            {
                const label index[3] = {i, j, k};
                vector d;
                bool solved = true;
                for (direction c = 0; c < vector::nComponents; ++c)
                {
                    solved = solved && (mesh.geometricD()[c] > 0 || index[c] == 0);
                    d[c] = index[c]*every;
                }
                if (solved && mag(d) <= radius) all.append(d);
            }
        }
    }
    return all;
}


// Does the support of a particle reach a patch that is no wall, or space for fluid that holds none?
class surfaceFinder
{
    const polyMesh& mesh_;
    const geometryWalls* bodies_;
    const scalar support_, nearFluid_;
    const triSurface open_;
    const triSurfaceSearch openSearch_;
    const pointGrid fluid_, walls_;         // what is near them is filled
    const DynamicList<vector> probes_;

    bool inMesh(const point& x) const
    {
        return mesh_.nCells() && mesh_.cellTree().findInside(x) >= 0;
    }

    bool inSolid(const point& x) const
    {
        const pointField one(1, x);
        for (label b = 0; bodies_ && b < bodies_->size(); ++b)
        {
            if (bodies_->inSolid(b, one)[0]) return true;
        }
        return false;
    }

public:

    surfaceFinder
    (
        const polyMesh& mesh,
        const geometryWalls* bodies,
        const labelList& wallIDs,
        const wallPoints& walls,
        const pointField& fluid,
        scalar spacing,
        scalar support
    )
    :
        mesh_(mesh),
        bodies_(bodies),
        support_(support),
        nearFluid_(0.9*spacing),
        open_(openPatches(wholeBoundary(mesh), wallIDs)),
        openSearch_(open_),
        fluid_(nearFluid_, fluid),
        walls_(0.75*walls.spacing, walls.position),
        probes_(probes(mesh, support, 0.5*spacing))
    {}

    //- elsewhere: gets places without fluid that are not in this process's cells. Not asked for: 0
    bool reaches(const point& x, DynamicList<point>* elsewhere) const
    {
        if (open_.size() && openSearch_.nearest(x, vector::one*support_).hit()) return true;

        for (const vector& d : probes_)
        {
            const point p(x + d);
            if (fluid_.nearest(p, -1) < nearFluid_) continue;

            // A plate of constant/geometry has no inside: points near its own are filled too
            bool filled = false;
            walls_.near(p, [&](label, const vector&, scalar) { filled = true; });
            if (filled) continue;
            const bool here = inMesh(p);
            if (here && !inSolid(p)) return true;
            if (!here && elsewhere && !inSolid(p)) elsewhere->append(p);
        }
        return false;
    }

    //- Of points of this process: in cells of any other?
    boolList inOthers(const pointField& points) const
    {
        const std::vector<labelList> asked(pointsNearParts(mesh_, points, 0));
        std::vector<riprap::RankBytes> out(asked.size()), in, back(asked.size()), answers;
        for (std::size_t rank = 0; rank < asked.size(); ++rank)
            for (const label i : asked[rank]) riprap::putValues(out[rank], &points[i]);
        pstreamTransport ranks;
        ranks.exchange(out, in);
        for (std::size_t rank = 0; rank < in.size(); ++rank)
        {
            const unsigned char* from = in[rank].data();
            for (std::size_t i = 0; i < in[rank].size()/sizeof(point); ++i)
            {
                point x;
                takeBytes(from, &x);
                back[rank].push_back(inMesh(x));
            }
        }
        ranks.exchange(back, answers);
        boolList found(points.size(), false);
        for (std::size_t rank = 0; rank < asked.size(); ++rank)
            forAll(asked[rank], i) if (answers[rank][i]) found[asked[rank][i]] = true;
        return found;
    }

    boolList reaches(const pointField& points) const
    {
        const bool divided = Pstream::parRun();
        boolList all(points.size());
        DynamicList<point> elsewhere;
        DynamicList<label> of;
        forAll(points, i)
        {
            all[i] = reaches(points[i], divided ? &elsewhere : nullptr);
            if (all[i]) elsewhere.setSize(of.size());
            of.append(labelList(elsewhere.size() - of.size(), i));
        }
        if (!divided) return all;
        const boolList found(inOthers(pointField(elsewhere)));
        forAll(of, k) if (found[k]) all[of[k]] = true;
        return all;
    }
};


// Shares of a particle's kernel sum that walls and fluid give
class shepardSums
{
    const riprap::KernelModel& kernel_;
    const label dimensions_;
    const scalar h_, fluidVolume_, wallVolume_;
    const pointGrid fluid_, walls_;

    scalar weight(scalar r) const { return kernel_.weight(dimensions_, r, h_); }

public:
    shepardSums(label dimensions, const wallPoints& walls, const pointField& fluid,
        const riprap::SphConfig& config)
        : kernel_(riprap::kernelOf(config.kernel)), dimensions_(dimensions),
          h_(config.smoothingRatio*config.spacing),
          fluidVolume_(std::pow(config.spacing, dimensions)),
          wallVolume_(std::pow(walls.spacing, dimensions)), fluid_(support(), fluid),
          walls_(support(), walls.position)
    {}

    scalar support() const { return kernel_.support*h_; }

    //- Of the fluid alone, on a square lattice
    scalar ofLattice(const polyMesh& mesh, scalar spacing) const
    {
        scalar sum = 0;
        for (const vector& d : probes(mesh, support(), spacing)) sum += fluidVolume_*weight(mag(d));
        return sum;
    }

    //- false: no wall is near
    bool addWalls(const point& x, scalar& sum) const
    {
        bool near = false;
        walls_.near
        (
            x,
            [&](label, const vector&, scalar d)
            {
                near = true;
                sum += wallVolume_*weight(d);
            }
        );
        return near;
    }

    void addFluid(const point& x, scalar& sum) const
    {
        fluid_.near(x, [&](label, const vector&, scalar d) { sum += fluidVolume_*weight(d); });
    }
};

// Those of this process, then those of others that are near its cells
static pointField withNearOnes(const polyMesh& mesh, const pointField& own, scalar reach)
{
    pointField all(own);
    if (!Pstream::parRun()) return all;
    const std::vector<labelList> near(pointsNearParts(mesh, own, reach));
    std::vector<riprap::RankBytes> out(near.size()), in;
    for (std::size_t rank = 0; rank < near.size(); ++rank)
        for (const label i : near[rank]) riprap::putValues(out[rank], &own[i]);
    pstreamTransport().exchange(out, in);
    for (const riprap::RankBytes& bytes : in)
    {
        const unsigned char* from = bytes.data();
        pointField some(label(bytes.size()/sizeof(point)));
        takeBytes(from, some.data(), some.size());
        all.append(some);
    }
    return all;
}


static void joinRanges(shepardRange& range)
{
    range.checked = label(sumOfRanks(range.checked));
    range.leftOut = label(sumOfRanks(range.leftOut));
    reduce(range.meanSquare, sumOp<scalar>());
    if (!Pstream::parRun()) return;
    struct { scalar sum; point at; } least{range.least, range.leastAt},
        most{range.most, range.mostAt};
    ofLeast(least.sum, true, least);
    ofLeast(-most.sum, true, most);
    range.least = least.sum;
    range.leastAt = least.at;
    range.most = most.sum;
    range.mostAt = most.at;
}

} // namespace Foam


Foam::shepardRange Foam::checkWalls
(
    const polyMesh& mesh,
    const geometryWalls* bodies,
    const labelList& patchIDs,
    const wallPoints& walls,
    const pointField& own,
    const riprap::SphConfig& config
)
{
    // What the search in cells needs of all processes
    if (Pstream::parRun()) mesh.tetBasePtIs();
    const scalar support = riprap::kernelOf(config.kernel).support*config.smoothingRatio
        *config.spacing;
    const pointField fluid(withNearOnes(mesh, own, support + config.spacing));
    const shepardSums sums(mesh.nGeometricD(), walls, fluid, config);
    const surfaceFinder surface(
        mesh, bodies, patchIDs, walls, fluid, config.spacing, sums.support());

    shepardRange range;
    range.lattice = sums.ofLattice(mesh, config.spacing);
    DynamicList<point> near;
    DynamicList<scalar> sum;
    for (const point& x : own)
    {
        scalar ofWalls = 0;
        if (!sums.addWalls(x, ofWalls)) continue;
        near.append(x);
        sum.append(ofWalls);
    }
    const boolList reaches(surface.reaches(pointField(near)));
    forAll(near, i)
    {
        if (reaches[i])
        {
            ++range.leftOut;
            continue;
        }
        sums.addFluid(near[i], sum[i]);

        ++range.checked;
        const scalar part = sum[i]/range.lattice;
        range.meanSquare += sqr(part - 1);
        if (part < range.least) { range.least = part; range.leastAt = near[i]; }
        if (part > range.most) { range.most = part; range.mostAt = near[i]; }
    }
    joinRanges(range);
    if (range.checked) range.meanSquare /= range.checked;
    return range;
}

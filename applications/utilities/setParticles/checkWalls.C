// SPDX-License-Identifier: GPL-3.0-or-later

#include "checkWalls.H"
#include "emptyPolyPatch.H"
#include "indexedOctree.H"
#include "pointGrid.H"
#include "treeDataCell.H"
#include "triSurface.H"
#include "triSurfaceSearch.H"
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
        open_(openPatches(mesh, wallIDs)),
        openSearch_(open_),
        fluid_(nearFluid_, fluid),
        walls_(0.75*walls.spacing, walls.position),
        probes_(probes(mesh, support, 0.5*spacing))
    {}

    bool reaches(const point& x) const
    {
        if (open_.size() && openSearch_.nearest(x, vector::one*support_).hit()) return true;

        for (const vector& d : probes_)
        {
            const point p(x + d);
            if (fluid_.nearest(p, -1) < nearFluid_) continue;

            // A plate of constant/geometry has no inside: points near its own are filled too
            bool filled = false;
            walls_.near(p, [&](label, const vector&, scalar) { filled = true; });
            if (!filled && mesh_.cellTree().findInside(p) >= 0 && !inSolid(p)) return true;
        }
        return false;
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

} // namespace Foam


Foam::shepardRange Foam::checkWalls
(
    const polyMesh& mesh,
    const geometryWalls* bodies,
    const labelList& patchIDs,
    const wallPoints& walls,
    const pointField& fluid,
    const riprap::SphConfig& config
)
{
    const shepardSums sums(mesh.nGeometricD(), walls, fluid, config);
    const surfaceFinder surface(
        mesh, bodies, patchIDs, walls, fluid, config.spacing, sums.support());

    shepardRange range;
    range.lattice = sums.ofLattice(mesh, config.spacing);
    for (const point& x : fluid)
    {
        scalar sum = 0;
        if (!sums.addWalls(x, sum)) continue;
        if (surface.reaches(x))
        {
            ++range.leftOut;
            continue;
        }
        sums.addFluid(x, sum);

        ++range.checked;
        sum /= range.lattice;
        range.meanSquare += sqr(sum - 1);
        if (sum < range.least) { range.least = sum; range.leastAt = x; }
        if (sum > range.most) { range.most = sum; range.mostAt = x; }
    }
    if (range.checked) range.meanSquare /= range.checked;
    return range;
}

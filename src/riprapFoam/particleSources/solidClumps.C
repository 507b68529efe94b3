// SPDX-License-Identifier: GPL-3.0-or-later
/*  source clumpsFromSurface;  file "rock.stl";  spheres 30;  centres ((0 0 0.1) (0 0 0.3));

    A rigid body for each centre: spheres that fill the closed surface, while mass and inertia are those of the surface
    itself. Spheres touch the surface from inside; the largest that is not yet covered comes next (a greedy cover by
    inscribed balls, as Bradshaw & O'Sullivan 2004 begin). `resolution`: lattice points along the longest side at which
    balls are tried. Without centres the body is where the file has it.
*/

#include "closedSurface.H"
#include "momentOfInertia.H"
#include "principalAxes.H"
#include "mathematicalConstants.H"
#include "quaternion.H"
#include "solidRegions.H"
#include "triSurfaceSearch.H"

namespace Foam
{

struct ball
{
    point centre;
    scalar radius;
};


// Balls that touch the surface from inside, at the points of a lattice
static DynamicList<ball> inscribed(const triSurface& surface, label resolution)
{
    const triSurfaceSearch search(surface);
    const boundBox box(surface.points(), false);
    const scalar step = cmptMax(box.span())/resolution;
    DynamicList<point> lattice;
    const Vector<label> n
    (
        label(box.span().x()/step) + 1, label(box.span().y()/step) + 1, label(box.span().z()/step) + 1
    );
    const vector margin(0.5*(box.span() - step*vector(n.x() - 1, n.y() - 1, n.z() - 1)));
    for (label k = 0; k < n.z(); ++k)
    {
        for (label j = 0; j < n.y(); ++j)
        {
            for (label i = 0; i < n.x(); ++i) lattice.append(box.min() + margin + step*vector(i, j, k));
        }
    }

    const pointField points(lattice);
    const boolList in(search.calcInside(points));
    DynamicList<ball> balls;
    forAll(points, i)
    {
        if (!in[i]) continue;
        const pointIndexHit hit(search.nearest(points[i], box.span()));
        if (hit.hit()) balls.append({points[i], mag(hit.hitPoint() - points[i])});
    }
    return balls;
}


static DynamicList<ball> cover(DynamicList<ball> candidates, label most, scalar smallest)
{
    std::stable_sort
    (
        candidates.begin(),
        candidates.end(),
        [](const ball& a, const ball& b) { return a.radius > b.radius; }
    );

    DynamicList<ball> chosen;
    for (const ball& b : candidates)
    {
        if (chosen.size() >= most || b.radius < smallest) break;
        bool covered = false;
        for (const ball& c : chosen)
        {
            // Its centre well within another: it would add little
            covered = covered || mag(b.centre - c.centre) < 0.8*c.radius;
        }
        if (!covered) chosen.append(b);
    }
    return chosen;
}

} // namespace Foam


void Foam::readClumps(checkedDictionary& dict, const solidSpace& space, solidRegion& region)
{
    if (space.settings.config.dimensions != 3)
    {
        FatalIOErrorInFunction(dict.dict())
            << "Source clumpsFromSurface needs a case in 3D" << exit(FatalIOError);
    }

    const auto surface = readClosedSurface(dict, space.mesh.time());
    const label most = dict.whole("spheres", 50, 1, 10000);
    const label resolution = dict.whole("resolution", 40, 4, 400);
    const scalar longest = cmptMax(boundBox(surface->points(), false).span());
    const scalar smallest = dict.positive("smallestRadius", 0.02*longest);

    scalar volume = 0;
    point middle(Zero);
    tensor J(Zero);
    momentOfInertia::massPropertiesSolid(*surface, 1, volume, middle, J);

    const DynamicList<ball> balls(cover(inscribed(*surface, resolution), most, smallest));
    if (balls.empty())
    {
        FatalIOErrorInFunction(dict.dict())
            << "No sphere of at least smallestRadius " << smallest << " m fits into the surface"
            << exit(FatalIOError);
    }

    pointField centres(1, middle);
    if (dict.found("centres")) centres = dict.dict().get<pointField>("centres");
    if (centres.empty())
    {
        FatalIOErrorInFunction(dict.dict()) << "Entry centres is empty" << exit(FatalIOError);
    }

    tensor axes;
    const vector moments(principalMoments(J, axes));
    const quaternion turn(axes);

    DynamicList<point> position;
    DynamicList<scalar> radius, mass;
    DynamicList<label> clump;
    for (const point& centre : centres)
    {
        riprap::DemClump body;
        body.mass = volume;
        for (direction d = 0; d < vector::nComponents; ++d)
        {
            body.position[d] = centre[d];
            body.inertia[d] = moments[d];
            body.orientation[d + 1] = turn.v()[d];
        }
        body.orientation[0] = turn.w();
        for (const ball& b : balls)
        {
            position.append(b.centre + centre - middle);
            radius.append(b.radius);
            clump.append(region.clumps.size());
        }
        region.clumps.append(body);
    }
    region.position = position;
    region.radius = radius;
    region.clump = clump;

    scalar filled = 0;
    for (const ball& b : balls) filled = max(filled, b.radius);
    Info<< "    " << region.name << ": " << centres.size() << " clumps of " << balls.size()
        << " spheres, radius " << balls.last().radius << " to " << filled << " m; volume " << volume
        << " m3, principal moments of inertia per density " << moments << " m5" << nl;
}

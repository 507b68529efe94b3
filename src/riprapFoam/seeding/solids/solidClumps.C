// SPDX-License-Identifier: GPL-3.0-or-later
/*  source clumpsFromSurface;  file "rock.stl";                     // 3D
    source clumpsFromOutline;  outline ((0 0 0) (2 0 0) (1 1 0)); // 2D: a closed line of points,
                               without crossings
    spheres 30;  centres ((0 0 0.1) (0 0 0.3));
    orientation random;  seed 1; // or turned; axis (0 0 1); angle 30; default: given, as the shape
                         stands

    A rigid body for each centre: spheres (disks) that fill the shape, while mass and inertia are
    those of the shape itself. They touch it from inside; the largest that is not yet covered comes
    next (a greedy cover by inscribed balls, as Bradshaw & O'Sullivan 2004 begin). `resolution`:
    lattice points along the longest side at which balls are tried. Without centres the body is
    where the shape was given. Random: uniform over all rotations (Shoemake 1992).
*/

#include "clumpShape.H"
#include "mathematicalConstants.H"
#include "quaternion.H"
#include "solidRegions.H"
#include "uniformNumbers.H"
#include "unitConversion.H"

namespace Foam
{

struct ball
{
    point centre;
    scalar radius;
};


// Balls that touch the surface from inside, at the points of a lattice
static DynamicList<ball> inscribed(const clumpShape& shape, label resolution)
{
    const pointField points(shapeLattice(shape.box, resolution));
    const scalarField distance(shape.distance(points));
    DynamicList<ball> balls;
    forAll(points, i) if (distance[i] < 0) balls.append({points[i], -distance[i]});
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


enum class orientationKind {given, turned, random};

static const Enum<orientationKind> orientationNames
({
    {orientationKind::given, "given"},
    {orientationKind::turned, "turned"},
    {orientationKind::random, "random"}
});


// A rotation for each of so many bodies. In 2D about the empty direction
static tensorField readOrientations(
    checkedDictionary& dict, const riprap::DemConfig& config, label n)
{
    using constant::mathematical::twoPi;
    tensorField all(n, tensor::I);
    const bool planar = config.dimensions == 2;
    vector out(Zero);
    out[config.axes[2]] = 1;

    const orientationKind kind = dict.choice(
        "orientation", orientationNames, orientationKind::given);
    if (kind == orientationKind::turned)
    {
        const scalar angle = degToRad(dict.number("angle"));
        vector axis(out);
        if (!planar)
        {
            dict.found("axis");
            axis = dict.dict().get<vector>("axis");
        }
        if (!(mag(axis) > SMALL))
        {
            FatalIOErrorInFunction(dict.dict())
                << "Entry axis is " << axis << ": it needs a length" << exit(FatalIOError);
        }
        all = quaternion(axis/mag(axis), angle).R();
    }
    if (kind == orientationKind::random)
    {
        uniformNumbers uniform(dict.whole("seed", 1, 0, labelMax));
        for (tensor& R : all)
        {
            if (planar)
            {
                R = quaternion(out, twoPi*uniform()).R();
                continue;
            }
            const scalar u = uniform(), a = twoPi*uniform(), b = twoPi*uniform();
            const scalar p = Foam::sqrt(1 - u), q = Foam::sqrt(u);
            R = quaternion(
                q*Foam::cos(b), vector(p*Foam::sin(a), p*Foam::cos(a), q*Foam::sin(b)))
                    .R();
        }
    }
    return all;
}


static void requireDimensions(const dictionary& dict, const word& source, bool planar)
{
    const bool outline = source == "clumpsFromOutline";
    if (planar == outline) return;
    FatalIOErrorInFunction(dict) << "Source " << source << " needs a case in "
                                << (outline ? "2D" : "3D") << "; in " << (planar ? "2D" : "3D")
                                << " it is "
                                << (planar ? "clumpsFromOutline" : "clumpsFromSurface")
                                << exit(FatalIOError);
}


static DynamicList<ball> readBalls(
    checkedDictionary& dict, label most, label resolution, const clumpShape& shape, bool planar)
{
    const scalar smallest = dict.positive("smallestRadius", 0.02*shape.longest());
    DynamicList<ball> balls(cover(inscribed(shape, resolution), most, smallest));
    if (balls.empty())
    {
        FatalIOErrorInFunction(dict.dict())
            << "No sphere of at least smallestRadius " << smallest << " m fits into the "
            << (planar ? "outline" : "surface") << exit(FatalIOError);
    }
    return balls;
}


static pointField readCentres(checkedDictionary& dict, const point& otherwise)
{
    pointField centres(1, otherwise);
    if (dict.found("centres")) centres = dict.dict().get<pointField>("centres");
    if (centres.empty())
    {
        FatalIOErrorInFunction(dict.dict()) << "Entry centres is empty" << exit(FatalIOError);
    }
    return centres;
}


// For unit density, and at rest
static riprap::DemClump clumpAt(
    const clumpShape& shape, const point& centre, const tensor& rotation)
{
    riprap::DemClump body;
    body.mass = body.volume = shape.volume;
    const quaternion turn(rotation & shape.axes);
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        body.position[d] = centre[d];
        body.inertia[d] = shape.moments[d];
        body.orientation[d + 1] = turn.v()[d];
    }
    body.orientation[0] = turn.w();
    return body;
}


static void placeClumps
(
    const clumpShape& shape,
    const DynamicList<ball>& balls,
    const pointField& centres,
    const tensorField& rotation,
    solidRegion& region
)
{
    DynamicList<point> position;
    DynamicList<scalar> radius;
    DynamicList<label> clump;
    forAll(centres, c)
    {
        for (const ball& b : balls)
        {
            position.append(centres[c] + (rotation[c] & (b.centre - shape.middle)));
            radius.append(b.radius);
            clump.append(region.clumps.size());
        }
        region.clumps.append(clumpAt(shape, centres[c], rotation[c]));
    }
    region.position = position;
    region.radius = radius;
    region.clump = clump;
}


static void logClumps(const word& region, label n, const DynamicList<ball>& balls,
    const clumpShape& shape, bool planar)
{
    scalar largest = 0;
    for (const ball& b : balls) largest = max(largest, b.radius);
    Info<< "    " << region << ": " << n << " clumps of " << balls.size() << " spheres, radius "
        << balls.last().radius << " to " << largest << " m; " << (planar ? "area " : "volume ")
        << shape.volume << (planar ? " m2" : " m3")
        << ", principal moments of inertia per density " << shape.moments
        << (planar ? " m4" : " m5") << nl;
}

} // namespace Foam


void Foam::readClumps(
    checkedDictionary& dict, const word& source, const solidSpace& space, solidRegion& region)
{
    const riprap::DemConfig& config = space.settings.config;
    const bool planar = config.dimensions == 2;
    requireDimensions(dict.dict(), source, planar);

    const label most = dict.whole("spheres", 50, 1, 10000);
    const label resolution = dict.whole("resolution", 40, 4, 400);
    const clumpShape shape(readShape(dict, space.mesh.time(), config.dimensions, config.axes));
    region.shape = shapeEntries(dict.dict());
    const DynamicList<ball> balls(readBalls(dict, most, resolution, shape, planar));

    pointField centres(readCentres(dict, shape.middle));
    const tensorField rotation(readOrientations(dict, config, centres.size()));
    if (planar)
    {
        for (point& centre : centres)
            centre[config.axes[2]] = space.mesh.bounds().midpoint()[config.axes[2]];
    }
    placeClumps(shape, balls, centres, rotation, region);
    logClumps(region.name, centres.size(), balls, shape, planar);
}

// SPDX-License-Identifier: GPL-3.0-or-later
/*  Particles of solids in a volume: on a lattice, at random, or so that they follow its surface. */

#include "bodyFaces.H"
#include "bodyGrading.H"
#include "fittedPacking.H"
#include "mathematicalConstants.H"
#include "particleSource.H"
#include "randomPacking.H"
#include "solidRegions.H"

namespace Foam
{

// A body lies wholly in a volume if its centre and points of its surface do
class wholeBody
{
    const volumeSource& volume_;
    DynamicList<vector> ways_;

public:

    wholeBody(const volumeSource& volume, const particlePacking& frame) : volume_(volume)
    {
        ways_.append(Zero);
        for (label i = 0; i < 27; ++i)
        {
            const label step[3] = {i % 3 - 1, (i/3) % 3 - 1, i/9 - 1};
            vector way(Zero);
            for (label d = 0; d < (frame.planar() ? 2 : 3); ++d) way[frame.axis(d)] = step[d];
            if (magSqr(way) > 0) ways_.append(normalised(way));
        }
    }

    bool inside(const point& x, scalar radius) const
    {
        const boundBox box(volume_.bounds());
        pointField probes(ways_.size());
        forAll(probes, i)
        {
            probes[i] = x + (1 - 1e-6)*radius*ways_[i];
            if (!box.contains(probes[i])) return false;
        }
        for (const bool in : volume_.inside(probes))
        {
            if (!in) return false;
        }
        return true;
    }
};


// By counting a fine lattice
static scalar volumeOf(const volumeSource& volume, const particlePacking& frame)
{
    const boundBox box(volume.bounds());
    const label n = frame.planar() ? 300 : 60;
    scalar cell = 1;
    label count[3] = {1, 1, 1};
    for (label d = 0; d < (frame.planar() ? 2 : 3); ++d)
    {
        count[d] = n;
        cell *= box.span()[frame.axis(d)]/n;
    }

    pointField probes(count[0]*count[1]*count[2]);
    forAll(probes, i)
    {
        const label index[3] = {i % n, (i/n) % n, i/(n*n)};
        point x(Zero);
        for (label d = 0; d < (frame.planar() ? 2 : 3); ++d)
        {
            const direction axis = frame.axis(d);
            x[axis] = box.min()[axis] + (index[d] + 0.5)*box.span()[axis]/n;
        }
        probes[i] = frame.inPlane(x);
    }
    label in = 0;
    for (const bool i : volume.inside(probes)) in += i;
    return in*cell;
}


// Entry particleRadius; or radius, where that is no entry of the region's own shape; or half the
// spacing
static scalar particleRadius(checkedDictionary& dict, const solidRegion& region, bool spaced)
{
    const bool ofRegion = dict.isKnown("radius");
    const bool own = dict.found("particleRadius");
    const bool plain = !ofRegion && dict.found("radius");
    if (own && plain)
    {
        FatalIOErrorInFunction(dict.dict()) << "Entries radius and particleRadius are both there: "
                                               "one of them is the particles' radius"
                                            << exit(FatalIOError);
    }
    if (own) return dict.positive("particleRadius");
    if (plain) return dict.positive("radius");
    if (spaced && dict.found("spacing")) return 0.5*dict.positive("spacing");

    OStringStream why;
    if (ofRegion)
    {
        why << "radius " << dict.dict().get<scalar>("radius") << " is that of the "
            << dict.dict().get<word>("source") << ", not of its particles. ";
    }
    FatalIOErrorInFunction(dict.dict())
        << "Region " << region.name << ": " << why.str().c_str()
        << "How large are the particles? Write `particleRadius <m>;`"
        << (spaced ? " or `spacing <m>;`, the distance between the centres of neighbours" : "")
        << exit(FatalIOError);
    return 0;
}


// The radii that entries give with shares, else none
static bodyGrading gradingOf(checkedDictionary& dict, bool sameMass)
{
    bodyGrading grading;
    if (!dict.found("radii")) return grading;
    grading = readGrading(dict);
    for (const char* other : {"particleRadius", "largestRadius", "radius"})
    {
        if (!dict.isKnown(other) && dict.found(other))
        {
            FatalIOErrorInFunction(dict.dict())
                << "Entries radii and " << other
                << " are both there: one of them says how large the particles are"
                << exit(FatalIOError);
        }
    }
    if (sameMass && !grading.ofNumber)
    {
        FatalIOErrorInFunction(dict.dict()) << "Entry sharesOf is mass, but with `mass cell;` all "
                                               "particles have one mass: valid is number"
                                            << exit(FatalIOError);
    }
    return grading;
}


static randomPacking readRandom(
    checkedDictionary& dict, const solidRegion& region, const bodyGrading& grading)
{
    randomPacking packing;
    if (grading.radii.size())
    {
        packing.smallest = min(grading.radii);
        packing.largest = max(grading.radii);
    }
    else
    {
        packing.smallest = packing.largest = particleRadius(dict, region, false);
        packing.largest = dict.positive("largestRadius", packing.largest);
    }
    packing.solidFraction = dict.positive("solidFraction");
    // All of space
    dict.between("solidFraction", 1, 0, 1);
    packing.seed = dict.whole("seed", 1, 0, labelMax);
    if (packing.largest < packing.smallest)
    {
        FatalIOErrorInFunction(dict.dict())
            << "Entry largestRadius is " << packing.largest << ", less than the particles' radius "
            << packing.smallest << exit(FatalIOError);
    }
    return packing;
}


static void placeRandom
(
    checkedDictionary& dict,
    const volumeSource& volume,
    const particlePacking& frame,
    bool sameMass,
    solidRegion& region
)
{
    const bodyGrading grading(gradingOf(dict, sameMass));
    const randomPacking packing(readRandom(dict, region, grading));
    region.sizes = grading.radii;

    const wholeBody whole(volume, frame);
    const scalar space = volumeOf(volume, frame);
    checkCount
    (
        region.dict,
        region.name,
        space/(frame.planar() ? sqr(packing.smallest) : pow3(packing.smallest)),
        "particles' radius"
    );
    region.radius = grading.radii.size()
      ? grading.fill(packing.solidFraction*space, frame.planar(), dict.dict())
      : packing.radii(space, frame.planar());
    const bool placed = packing.place
    (
        volume.bounds(),
        [&](const point& x, scalar radius) { return whole.inside(x, radius); },
        frame,
        region.radius,
        region.position
    );
    if (!placed)
    {
        FatalIOErrorInFunction(dict.dict())
            << "Region " << region.name << ": " << region.radius.size()
            << " bodies cannot be brought apart at"
            << " solidFraction " << packing.solidFraction
            << "; random packings reach about 0.8 in 2D and 0.6"
            << " in 3D, less beside walls" << exit(FatalIOError);
    }
}


// On a lattice, or by what fills the shape
static void placeRegular
(
    checkedDictionary& dict,
    const volumeSource& volume,
    const particlePacking& frame,
    solidPackingKind kind,
    solidRegion& region
)
{
    if (dict.dict().found("radii"))
    {
        FatalIOErrorInFunction(dict.dict())
            << "Entry radii needs `packing random;`: on a lattice all particles have one radius"
            << exit(FatalIOError);
    }
    solidLattice lattice;
    lattice.kind = kind;
    lattice.radius = particleRadius(dict, region, true);
    lattice.spacing = dict.positive("spacing", 2*lattice.radius);
    scalar count = 1;
    for (label d = 0; d < (frame.planar() ? 2 : 3); ++d)
    {
        count *= volume.bounds().span()[frame.axis(d)]/lattice.spacing;
    }
    checkCount(region.dict, region.name, count, "particles' radius or spacing");

    if (kind == solidPackingKind::fitted)
    {
        const scalar off = max(lattice.radius, 0.5*lattice.spacing);
        region.position = fittedPacking{*region.exact, frame, lattice.spacing, off, true}.fill();
        lattice.kind = solidPackingKind::square;
    }
    else
    {
        const wholeBody whole(volume, frame);
        DynamicList<point> in;
        for (const point& x : lattice.fill(volume.bounds(), frame))
        {
            if (whole.inside(x, lattice.radius)) in.append(x);
        }
        region.position = in;
    }
    region.radius = scalarField(region.size(), lattice.radius);
    region.cells = region.size()*lattice.cell(frame.planar());
}

} // namespace Foam


Foam::scalarField Foam::placeInVolume(
    checkedDictionary& dict, bool rigid, const solidSpace& space, solidRegion& region)
{
    using constant::mathematical::pi;

    const auto source = particleSource::New(dict, space.mesh.time());
    const auto& volume = dynamic_cast<const volumeSource&>(source());
    const auto& g = space.settings.config.gravity;
    const particlePacking frame(
        space.mesh, particlePacking::kind::square, 1, vector(g[0], g[1], g[2]));
    const auto kind = dict.choice
    (
        "packing",
        solidPackingNames,
        rigid && !volume.straight() ? solidPackingKind::fitted : solidPackingKind::square
    );
    const bool cells = !rigid && dict.either("mass", "cell", "particle", false);
    if (rigid || (cells && kind != solidPackingKind::random))
    {
        region.exact = std::make_shared<const clumpShape>(volume.shape(frame));
        if (rigid)
        {
            region.shape = volume.surfaceEntries(frame);
            region.surface = bodySurface(dict.dict());
        }
    }
    if (!rigid && kind == solidPackingKind::fitted)
    {
        FatalIOErrorInFunction(dict.dict())
            << "Entry packing is fitted, which is for one rigid body: with `rigid yes;`"
            << exit(FatalIOError);
    }

    if (kind == solidPackingKind::random)
    {
        placeRandom(dict, volume, frame, cells, region);
        region.cells = volumeOf(volume, frame);
    }
    else placeRegular(dict, volume, frame, kind, region);

    const scalarField own(frame.planar() ? scalarField(pi*sqr(region.radius))
                                         : scalarField(4*pi/3*pow3(region.radius)));
    if (rigid) return scalarField(region.exact->volume/max(sum(own), VSMALL)*own);
    return cells ? scalarField(region.size(), region.cells/max(region.size(), 1)) : own;
}

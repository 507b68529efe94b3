// SPDX-License-Identifier: GPL-3.0-or-later

#include "solidRegions.H"
#include "mathematicalConstants.H"
#include "particleSource.H"
#include "randomPacking.H"

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


// Entry particleRadius; or radius, where that is no entry of the region's own shape; or half the spacing
static scalar particleRadius(checkedDictionary& dict, const solidRegion& region, bool spaced)
{
    const bool ofRegion = dict.isKnown("radius");
    const bool own = dict.found("particleRadius");
    const bool plain = !ofRegion && dict.found("radius");
    if (own && plain)
    {
        FatalIOErrorInFunction(dict.dict())
            << "Entries radius and particleRadius are both there: one of them is the particles' radius"
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


static void placeRandom
(
    checkedDictionary& dict,
    const volumeSource& volume,
    const particlePacking& frame,
    solidRegion& region
)
{
    randomPacking packing;
    packing.smallest = packing.largest = particleRadius(dict, region, false);
    packing.largest = dict.positive("largestRadius", packing.largest);
    packing.solidFraction = dict.positive("solidFraction");
    // All of space
    dict.between("solidFraction", 1, 0, 1);
    packing.seed = dict.whole("seed", 1, 0, labelMax);
    if (packing.largest < packing.smallest)
    {
        FatalIOErrorInFunction(dict.dict())
            << "Entry largestRadius is " << packing.largest << ", less than the particles' radius " << packing.smallest
            << exit(FatalIOError);
    }

    const wholeBody whole(volume, frame);
    const scalar space = volumeOf(volume, frame);
    checkCount
    (
        region.dict,
        region.name,
        space/(frame.planar() ? sqr(packing.smallest) : pow3(packing.smallest)),
        "particles' radius"
    );
    region.radius = packing.radii(space, frame.planar());
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
            << "Region " << region.name << ": " << region.radius.size() << " bodies cannot be brought apart at"
            << " solidFraction " << packing.solidFraction << "; random packings reach about 0.8 in 2D and 0.6"
            << " in 3D, less beside walls" << exit(FatalIOError);
    }
}


// Particles of a volume; the mass of each for unit density
static scalarField placeInVolume(checkedDictionary& dict, const solidSpace& space, solidRegion& region)
{
    using constant::mathematical::pi;

    const auto source = particleSource::New(dict, space.mesh.time());
    const auto& volume = dynamic_cast<const volumeSource&>(source());
    const auto kind = dict.choice("packing", solidPackingNames, solidPackingKind::square);
    const auto& g = space.settings.config.gravity;
    const particlePacking frame(space.mesh, particlePacking::kind::square, 1, vector(g[0], g[1], g[2]));

    scalar cell = 0;
    if (kind == solidPackingKind::random)
    {
        placeRandom(dict, volume, frame, region);
        cell = volumeOf(volume, frame)/max(region.size(), 1);
    }
    else
    {
        solidLattice lattice;
        lattice.kind = kind;
        lattice.radius = particleRadius(dict, region, true);
        lattice.spacing = dict.positive("spacing", 2*lattice.radius);
        const wholeBody whole(volume, frame);
        scalar count = 1;
        for (label d = 0; d < (frame.planar() ? 2 : 3); ++d)
        {
            count *= volume.bounds().span()[frame.axis(d)]/lattice.spacing;
        }
        checkCount(region.dict, region.name, count, "particles' radius or spacing");

        DynamicList<point> in;
        for (const point& x : lattice.fill(volume.bounds(), frame))
        {
            if (whole.inside(x, lattice.radius)) in.append(x);
        }
        region.position = in;
        region.radius = scalarField(region.size(), lattice.radius);
        cell = lattice.cell(frame.planar());
    }

    if (dict.either("mass", "cell", "particle", false)) return scalarField(region.size(), cell);
    return frame.planar() ? scalarField(pi*sqr(region.radius)) : scalarField(4*pi/3*pow3(region.radius));
}


static label readName
(
    checkedDictionary& dict,
    const word& entry,
    const std::function<label(const word&)>& indexOf,
    label otherwise
)
{
    return dict.found(entry) ? indexOf(dict.dict().get<word>(entry)) : otherwise;
}


static solidRegion readRegion(const namedDictionary& entries, const solidSpace& space)
{
    const demSettings& settings = space.settings;

    solidRegion region;
    region.name = entries.name;
    region.dict = entries.dict;
    checkedDictionary dict(region.dict);
    dict.found("set");
    region.clip = dict.either("clip", "yes", "no", false);

    const label material = readName
    (
        dict, "material",
        [&](const word& w) { return settings.material(w, region.dict); },
        settings.materials.size() == 1 ? 0 : -1
    );
    if (material < 0) region.dict.get<word>("material");
    const label group = readName
    (
        dict, "group",
        [&](const word& w) { return settings.group(w, region.dict); },
        settings.group("free", region.dict)
    );
    vector velocity(Zero), spin(Zero);
    if (dict.found("velocity")) velocity = region.dict.get<vector>("velocity");
    if (dict.found("spin")) spin = region.dict.get<vector>("spin");
    const bool rigid = dict.either("rigid", "yes", "no", false);

    dict.found("source");
    const word source(region.dict.get<word>("source"));
    if (rigid && source == "clumpsFromSurface")
    {
        FatalIOErrorInFunction(region.dict)
            << "Entry rigid is yes, but the bodies of source clumpsFromSurface are rigid ones already: leave it out" << exit(FatalIOError);
    }
    scalarField unitMass;
    if (source == "csv")
    {
        readSolidList(dict, space, region);
    }
    else if (source == "clumpsFromSurface" || source == "clumpsFromOutline")
    {
        readClumps(dict, source, space, region);
    }
    else
    {
        const wordList volumes(particleSource::dictionaryConstructorTablePtr_->sortedToc());
        if (!volumes.found(source))
        {
            wordList valid(volumes);
            valid.append("clumpsFromSurface");
            valid.append("clumpsFromOutline");
            dict.unknownWord("source", source, valid);
        }
        unitMass = placeInVolume(dict, space, region);
    }
    dict.end();

    // Those that the source has not brought itself
    const label n = region.size();
    if (region.velocity.empty()) region.velocity = vectorField(n, velocity);
    if (region.spin.empty()) region.spin = vectorField(n, spin);
    if (region.material.empty()) region.material = labelField(n, material);
    if (region.group.empty()) region.group = labelField(n, group);
    if (region.clump.empty()) region.clump = labelField(n, -1);
    for (riprap::DemClump& clump : region.clumps)
    {
        clump.group = group;
        clump.mass *= settings.materials[material].density;
        for (direction d = 0; d < vector::nComponents; ++d)
        {
            clump.inertia[d] *= settings.materials[material].density;
            clump.velocity[d] = velocity[d];
            clump.spin[d] = spin[d];
        }
    }
    if (region.mass.empty())
    {
        region.mass.setSize(n);
        forAll(region.mass, i)
        {
            const scalar R = region.radius[i];
            using constant::mathematical::pi;
            const scalar volume =
                unitMass.size() ? unitMass[i] : settings.config.dimensions == 2 ? pi*sqr(R) : 4*pi/3*pow3(R);
            region.mass[i] = settings.materials[region.material[i]].density*volume;
        }
    }
    if (rigid && n) makeRigid(space, group, velocity, spin, region);
    return region;
}

} // namespace Foam


Foam::List<Foam::solidRegion> Foam::readSolidRegions(const dictionary& all, const solidSpace& space)
{
    const scalar tolerance = checkedDictionary(all).notNegative("overlapTolerance", 1e-4);
    DynamicList<solidRegion> regions;
    for (const namedDictionary& entries : namedDictionaries(all, "regions"))
    {
        if (setOf(entries) == "fluid") continue;

        solidRegion region(readRegion(entries, space));
        checkSolidPlace(region, space, tolerance);
        if (region.size() == 0)
        {
            FatalIOErrorInFunction(region.dict)
                << "Region " << region.name << " holds no particle" << (region.clip ? " after clipping" : "")
                << ": bodies must lie wholly in it. The mesh is " << space.mesh.bounds().min() << " to "
                << space.mesh.bounds().max() << exit(FatalIOError);
        }
        regions.append(region);
    }
    return List<solidRegion>(std::move(regions));
}

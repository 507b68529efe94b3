// SPDX-License-Identifier: GPL-3.0-or-later

#include "solidRegions.H"
#include "bodyGrading.H"
#include "particleSource.H"

namespace Foam
{

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


// A rigid body moves as one: what a list says of each particle's motion or group would be lost
static void requireOneMotion(const solidRegion& region)
{
    const char* columns = region.velocity.size() ? "u, v, w"
        : region.spin.size() ? "wx, wy, wz"
        : region.group.size() ? "group"
                                                 : nullptr;
    if (!columns) return;
    FatalIOErrorInFunction(region.dict)
        << "Region " << region.name << " is one rigid body, and its list has the columns "
        << columns << " for each particle: leave them out;"
        << " the entries velocity, spin and group of the region are the body's"
        << exit(FatalIOError);
}


// What entries of a region say of all its particles, and of its rigid bodies
struct regionEntries
{
    label material = 0, group = 0;      // material -1: none is named
    vector velocity = Zero, spin = Zero;
    bool rigid = false;
};


static regionEntries readEntries(checkedDictionary& dict, const demSettings& settings)
{
    regionEntries entries;
    entries.material = readName
    (
        dict, "material",
        [&](const word& w) { return settings.material(w, dict.dict()); },
        settings.materials.size() == 1 ? 0 : -1
    );
    entries.group = readName
    (
        dict, "group",
        [&](const word& w) { return settings.group(w, dict.dict()); },
        settings.group("free", dict.dict())
    );
    if (dict.found("velocity")) entries.velocity = dict.velocity("velocity");
    if (dict.found("spin")) entries.spin = dict.dict().get<vector>("spin");
    entries.rigid = dict.either("rigid", "yes", "no", false);
    return entries;
}


static bool holdsClumps(const word& source)
{
    return source == "clumpsFromSurface" || source == "clumpsFromOutline";
}


static void requireVolume(const checkedDictionary& dict, const word& source)
{
    const wordList volumes(particleSource::dictionaryConstructorTablePtr_->sortedToc());
    if (volumes.found(source)) return;
    wordList valid(volumes);
    valid.append("clumpsFromSurface");
    valid.append("clumpsFromOutline");
    dict.unknownWord("source", source, valid);
}


// Particles of the entry source; the mass of each for unit density, where it is not that of a ball
static scalarField readSource
(
    checkedDictionary& dict,
    const word& source,
    bool rigid,
    const rigidEntries& body,
    const solidSpace& space,
    solidRegion& region
)
{
    if (source == "csv")
    {
        readSolidList(dict, space, region);
        if (rigid)
        {
            requireOneMotion(region);
            readRigidSurface(dict, body, space, region);
        }
        return scalarField();
    }
    if (holdsClumps(source))
    {
        readClumps(dict, source, space, region);
        return scalarField();
    }
    requireVolume(dict, source);
    return placeInVolume(dict, rigid, space, region);
}


// Fields that the source has not brought itself
static void fillMissing(const regionEntries& entries, solidRegion& region)
{
    const label n = region.size();
    if (region.velocity.empty()) region.velocity = vectorField(n, entries.velocity);
    if (region.spin.empty()) region.spin = vectorField(n, entries.spin);
    if (region.material.empty())
    {
        if (entries.material < 0) region.dict.get<word>("material");
        region.material = labelField(n, entries.material);
    }
    if (region.group.empty()) region.group = labelField(n, entries.group);
    if (region.clump.empty()) region.clump = labelField(n, -1);
}


// Clumps are read for unit density, and at rest
static void completeClumps(const regionEntries& entries, scalar density, solidRegion& region)
{
    for (riprap::DemClump& clump : region.clumps)
    {
        clump.group = entries.group;
        clump.mass *= density;
        for (direction d = 0; d < vector::nComponents; ++d)
        {
            clump.inertia[d] *= density;
            clump.velocity[d] = entries.velocity[d];
            clump.spin[d] = entries.spin[d];
        }
    }
}


// What a turning body gives its particles
static void moveWithClumps(const riprap::DemConfig& config, solidRegion& region)
{
    forAll(region.clump, i)
    {
        if (region.clump[i] < 0) continue;
        const riprap::DemClump& c = region.clumps[region.clump[i]];
        vector spin(c.spin[0], c.spin[1], c.spin[2]);
        // in 2D bodies turn in the plane
        if (config.dimensions == 2) for (int d = 0; d < 2; ++d) spin[config.axes[d]] = 0;
        const point centre(c.position[0], c.position[1], c.position[2]);
        region.velocity[i] = vector(c.velocity[0], c.velocity[1], c.velocity[2])
            + (spin ^ (region.position[i] - centre));
    }
}


// unitMass: of each particle for unit density; empty: its volume
static void setMasses(const demSettings& settings, const scalarField& unitMass, solidRegion& region)
{
    const bool planar = settings.config.dimensions == 2;
    region.mass.setSize(region.size());
    forAll(region.mass, i)
    {
        const scalar volume = unitMass.size() ? unitMass[i] : ballVolume(region.radius[i], planar);
        region.mass[i] = settings.materials[region.material[i]].density*volume;
    }
}


static solidRegion readRegion(const namedDictionary& named, const solidSpace& space)
{
    const demSettings& settings = space.settings;

    solidRegion region;
    region.name = named.name;
    region.dict = named.dict;
    checkedDictionary dict(region.dict);
    dict.found("set");
    region.clip = dict.either("clip", "yes", "no", false);
    const regionEntries entries(readEntries(dict, settings));

    dict.found("source");
    const word source(region.dict.get<word>("source"));
    // a list may have a column of it
    if (entries.material < 0 && source != "csv") region.dict.get<word>("material");
    if (entries.rigid && holdsClumps(source))
    {
        FatalIOErrorInFunction(region.dict)
            << "Entry rigid is yes, but the bodies of source " << source
            << " are rigid ones already: leave it out" << exit(FatalIOError);
    }
    rigidEntries body;
    if (entries.rigid) body = readRigid(dict, settings.config.dimensions == 2, source != "csv");
    const scalarField unitMass(readSource(dict, source, entries.rigid, body, space, region));
    dict.end();

    fillMissing(entries, region);
    if (region.clumps.size())
        completeClumps(entries, settings.materials[entries.material].density, region);
    if (region.mass.empty()) setMasses(settings, unitMass, region);
    if (entries.rigid && region.size())
        makeRigid(space, entries.group, entries.velocity, entries.spin, body, region);
    moveWithClumps(settings.config, region);
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
                << "Region " << region.name << " holds no particle"
                << (region.clip ? " after clipping" : "")
                << ": bodies must lie wholly in it. The mesh is " << space.mesh.bounds().min()
                << " to " << space.mesh.bounds().max() << exit(FatalIOError);
        }
        regions.append(region);
    }
    return List<solidRegion>(std::move(regions));
}

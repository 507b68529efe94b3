// SPDX-License-Identifier: GPL-3.0-or-later

#include "solidRegions.H"
#include "mathematicalConstants.H"
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
    if (dict.found("velocity")) velocity = dict.velocity("velocity");
    if (dict.found("spin")) spin = region.dict.get<vector>("spin");
    const bool rigid = dict.either("rigid", "yes", "no", false);

    dict.found("source");
    const word source(region.dict.get<word>("source"));
    const bool shaped = source == "clumpsFromSurface" || source == "clumpsFromOutline";
    if (rigid && shaped)
    {
        FatalIOErrorInFunction(region.dict)
            << "Entry rigid is yes, but the bodies of source " << source
            << " are rigid ones already: leave it out" << exit(FatalIOError);
    }
    rigidEntries given;
    if (rigid) given = readRigid(dict, settings.config.dimensions == 2, source != "csv");
    scalarField unitMass;
    if (source == "csv")
    {
        readSolidList(dict, space, region);
        if (rigid)
        {
            requireOneMotion(region);
            readRigidSurface(dict, given, space, region);
        }
    }
    else if (shaped)
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
        unitMass = placeInVolume(dict, rigid, space, region);
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
            const scalar volume = unitMass.size() ? unitMass[i]
                : settings.config.dimensions == 2 ? pi*sqr(R)
                                                  : 4*pi/3*pow3(R);
            region.mass[i] = settings.materials[region.material[i]].density*volume;
        }
    }
    if (rigid && n) makeRigid(space, group, velocity, spin, given, region);
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

// SPDX-License-Identifier: GPL-3.0-or-later

#include "particleRegions.H"
#include "checkedDictionary.H"
#include "particleSource.H"

namespace Foam
{

// Height against gravity, along the up direction
static vector upward(const vector& gravity)
{
    return mag(gravity) > SMALL ? -gravity/mag(gravity) : vector(Zero);
}


static scalarField hydrostatic
(
    checkedDictionary& dict,
    const particleRegion& region,
    const particlePacking& packing,
    const regionSpace& space
)
{
    const vector up(upward(space.gravity));
    const scalarField height(region.position & up);

    scalar level = height.size() ? max(height) + 0.5*packing.spacing() : 0;
    if (dict.found("freeSurface")) level = dict.number("freeSurface");

    return max(space.density*mag(space.gravity)*(level - height), scalar(0));
}


static void readPressure
(
    checkedDictionary& dict,
    particleRegion& region,
    const particlePacking& packing,
    const regionSpace& space
)
{
    const token first
    (
        dict.found("pressure") ? token(dict.dict().lookup("pressure")) : token(word("hydrostatic"))
    );
    if (first.isNumber())
    {
        region.pressure = scalarField(region.size(), dict.number("pressure"));
    }
    else if (first.isWord() && first.wordToken() == "zero")
    {
        region.pressure = scalarField(region.size(), Zero);
    }
    else if (first.isWord() && first.wordToken() == "hydrostatic")
    {
        region.pressure = hydrostatic(dict, region, packing, space);
    }
    else
    {
        dict.unknownWord
        (
            "pressure",
            first.isWord() ? first.wordToken() : word("?", false),
            wordList({"hydrostatic", "zero", "<number>"})
        );
    }
    dict.found("freeSurface");
}


static void readSet(checkedDictionary& dict)
{
    dict.found("set");
    const word set(dict.dict().get<word>("set"));
    if (set != "fluid") dict.unknownWord("set", set, wordList({"fluid", "solids"}));
}


// Nothing may take the machine down by a slip in the spacing
static void checkCount(const dictionary& dict, const word& name, scalar n)
{
    if (n > 1e9)
    {
        FatalIOErrorInFunction(dict)
            << "Region " << name << " would hold about " << n
            << " particles: is the spacing meant?" << exit(FatalIOError);
    }
}


static particleRegion readRegion
(
    const entry& e,
    const dictionary& all,
    const particlePacking& packing,
    const regionSpace& space
)
{
    if (!e.isDict())
    {
        FatalIOErrorInFunction(all)
            << "Entry regions: " << e.keyword() << " is no dictionary" << exit(FatalIOError);
    }

    particleRegion region;
    region.name = e.keyword();
    region.dict = namedRegion(e.dict(), region.name, all);
    checkedDictionary dict(region.dict);

    readSet(dict);
    region.clip = dict.either("clip", "yes", "no", false);
    vector velocity(Zero);
    if (dict.found("velocity")) velocity = dict.dict().get<vector>("velocity");

    const auto source = particleSource::New(dict, space.mesh.time());
    region.regular = source->regular();

    // Entries are all known now, apart from those of the pressure
    dict.found("pressure");
    dict.found("freeSurface");
    dict.end();

    boundBox limits(-vector::one*GREAT, vector::one*GREAT);
    if (region.clip)
    {
        limits = space.mesh.bounds();
        limits.inflate(1e-6);
    }
    else
    {
        checkCount(region.dict, region.name, source->estimate(packing));
    }

    source->place(packing, limits, region.position, region.velocity);
    region.pressure = source->pressure();
    if (region.velocity.empty()) region.velocity = vectorField(region.size(), velocity);

    checkPlace(region, packing, space);
    if (region.position.empty())
    {
        FatalIOErrorInFunction(region.dict)
            << "Region " << region.name << " holds no particle" << (region.clip ? " after clipping" : "")
            << ". The mesh is " << space.mesh.bounds().min() << " to " << space.mesh.bounds().max()
            << (packing.planar() ? ", and its mid-plane must be in the region" : "")
            << exit(FatalIOError);
    }
    // The source's own, unless the region says otherwise
    if (region.pressure.empty() || dict.found("pressure")) readPressure(dict, region, packing, space);
    return region;
}

} // namespace Foam


void Foam::particleRegion::keep(const boolList& those)
{
    label n = 0;
    forAll(those, i)
    {
        if (!those[i]) continue;
        position[n] = position[i];
        if (pressure.size()) pressure[n] = pressure[i];
        velocity[n++] = velocity[i];
    }
    clipped += position.size() - n;
    position.setSize(n);
    velocity.setSize(n);
    if (pressure.size()) pressure.setSize(n);
}


Foam::dictionary Foam::namedRegion(const dictionary& region, const word& name, const dictionary& all)
{
    dictionary d(region);
    d.name() = all.name() + ".regions." + name;
    for (entry& e : d)
    {
        if (e.isStream()) e.stream().name() = d.name() + '.' + e.keyword();
    }
    return d;
}


Foam::particlePacking Foam::readPacking
(
    const dictionary& all,
    const polyMesh& mesh,
    const vector& gravity
)
{
    checkedDictionary dict(all);
    const scalar spacing = dict.positive("spacing");
    const auto kind = dict.choice("packing", particlePacking::names, particlePacking::kind::square);
    for (const char* other : {"regions", "bonds", "overlapTolerance"}) dict.found(other);
    dict.endButMacros();
    return particlePacking(mesh, kind, spacing, gravity);
}


Foam::List<Foam::particleRegion> Foam::readRegions
(
    const dictionary& all,
    const particlePacking& packing,
    const regionSpace& space
)
{
    const PtrList<entry> entries(all.lookup("regions"));
    if (entries.empty())
    {
        FatalIOErrorInFunction(all) << "Entry regions is empty" << exit(FatalIOError);
    }

    DynamicList<particleRegion> regions;
    for (const entry& e : entries)
    {
        // Those are read elsewhere (solidRegions)
        if (e.isDict() && e.dict().getOrDefault<word>("set", word::null) == "solids") continue;

        const particleRegion region(readRegion(e, all, packing, space));
        for (const particleRegion& other : regions)
        {
            if (other.name != region.name) continue;
            FatalIOErrorInFunction(all)
                << "Entry regions: two are named " << region.name << exit(FatalIOError);
        }
        regions.append(region);
    }
    checkOverlap(regions, packing);
    return regions;
}

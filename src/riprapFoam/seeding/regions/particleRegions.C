// SPDX-License-Identifier: GPL-3.0-or-later

#include "particleRegions.H"
#include "allRanks.H"
#include "checkedDictionary.H"
#include "dividedRegion.H"
#include "fluidClip.H"
#include "requireMemory.H"

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

    scalar level = returnReduce(height.size() ? max(height) : -GREAT, maxOp<scalar>());
    level = level > -GREAT ? level + 0.5*packing.spacing() : 0;
    if (dict.found("freeSurface")) level = dict.number("freeSurface");

    return scalarField(max(space.density*mag(space.gravity)*(level - height), scalar(0)));
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
    // Of one word only: the next entry follows where a semicolon is missing
    if (first.isWord() && dict.found("pressure")) dict.dict().get<word>("pressure");
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
        OStringStream typed;
        typed << first;
        dict.unknownWord(
            "pressure", word(typed.str(), false), wordList({"hydrostatic", "zero", "<number>"}));
    }

    if (dict.found("freeSurface") && !(first.isWord() && first.wordToken() == "hydrostatic"))
    {
        FatalIOErrorInFunction(region.dict)
            << "Entry freeSurface is used by pressure hydrostatic alone" << exit(FatalIOError);
    }
}


static void placeAll
(
    const particleSource& source,
    const particlePacking& packing,
    const regionSpace& space,
    const boundBox& limits,
    particleRegion& region
)
{
    if (Pstream::parRun())
    {
        placePart(source, packing, space, limits, region);
        return;
    }
    checkCount(region.dict, region.name, source.estimate(packing, limits), "spacing");
    source.place(packing, limits, region.position, region.velocity);
    region.pressure = source.pressure();
}


static particleRegion readRegion
(
    const namedDictionary& entries,
    const particlePacking& packing,
    const regionSpace& space
)
{
    particleRegion region;
    region.name = entries.name;
    region.dict = entries.dict;
    checkedDictionary dict(region.dict);

    dict.found("set");
    region.clip = dict.either("clip", "yes", "no", false);
    vector velocity(Zero);
    if (dict.found("velocity")) velocity = dict.velocity("velocity");

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
    placeAll(source(), packing, space, limits, region);
    if (region.velocity.empty()) region.velocity = vectorField(region.size(), velocity);

    checkPlace(region, packing, space);
    const auto* volume = dynamic_cast<const volumeSource*>(&source());
    if (volume) region.lattice = volume->bounds();
    if (region.clip) clipAtSolids(region, packing, space.solids, space.mesh);
    if (!onAnyRank(region.size()))
    {
        FatalIOErrorInFunction(region.dict)
            << "Region " << region.name << " holds no particle"
            << (region.clip ? " after clipping" : "") << ". The mesh is "
            << space.mesh.bounds().min() << " to " << space.mesh.bounds().max()
            << (packing.planar() ? ", and its mid-plane must be in the region" : "")
            << exit(FatalIOError);
    }
    // The source's own, unless the region says otherwise
    if (dict.found("pressure") || !onAnyRank(region.pressure.size()))
        readPressure(dict, region, packing, space);
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
        if (velocity.size()) velocity[n] = velocity[i];
        if (pressure.size()) pressure[n] = pressure[i];
        if (number.size()) number[n] = number[i];
        if (cell.size()) cell[n] = cell[i];
        ++n;
    }
    clipped += position.size() - n;
    position.setSize(n);
    if (velocity.size()) velocity.setSize(n);
    if (pressure.size()) pressure.setSize(n);
    if (number.size()) number.setSize(n);
    if (cell.size()) cell.setSize(n);
}


Foam::List<Foam::namedDictionary> Foam::namedDictionaries(const dictionary& all, const word& entry)
{
    checkedDictionary(all).found(entry);
    const PtrList<Foam::entry> entries(all.lookup(entry));

    DynamicList<namedDictionary> dicts;
    for (const Foam::entry& e : entries)
    {
        const word& name = e.keyword();
        if (!e.isDict())
        {
            FatalIOErrorInFunction(all)
                << "Entry " << entry << ": " << name << " is no dictionary" << exit(FatalIOError);
        }
        for (const namedDictionary& other : dicts)
        {
            if (other.name != name) continue;
            FatalIOErrorInFunction(all)
                << "Entry " << entry << ": two are named " << name << exit(FatalIOError);
        }

        dictionary d(e.dict());
        d.name() = all.name() + '.' + entry + '.' + name;
        for (Foam::entry& each : d)
        {
            if (each.isStream()) each.stream().name() = d.name() + '.' + each.keyword();
        }
        dicts.append({name, d});
    }
    return List<namedDictionary>(std::move(dicts));
}


Foam::word Foam::setOf(const namedDictionary& region)
{
    checkedDictionary dict(region.dict);
    dict.found("set");
    word set(region.dict.get<word>("set"));
    if (set != "fluid" && set != "solids")
        dict.unknownWord("set", set, wordList({"fluid", "solids"}));
    return set;
}


bool Foam::hasSet(const dictionary& all, const word& set)
{
    for (const namedDictionary& region : namedDictionaries(all, "regions"))
    {
        if (setOf(region) == set) return true;
    }
    return false;
}


// Nothing may take the machine down by a slip in the spacing
void Foam::checkCount(const dictionary& dict, const word& name, scalar n, const word& meant)
{
    // While a region is filled: positions, cells, who is near, and the cloud itself
    const scalar bytes = 300;
    requireMemory(dict, "Region " + name + " would hold", n, "particles", bytes, meant);
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
    dict.found("regions");
    const wordList ofSolids({"bonds", "overlapTolerance"});
    if (hasSet(all, "solids"))
    {
        for (const word& other : ofSolids) dict.found(other);
    }
    dict.endButMacros(ofSolids);
    return particlePacking(mesh, kind, spacing, gravity);
}


Foam::List<Foam::particleRegion> Foam::readRegions
(
    const dictionary& all,
    const particlePacking& packing,
    const regionSpace& space
)
{
    const List<namedDictionary> entries(namedDictionaries(all, "regions"));
    if (entries.empty())
    {
        FatalIOErrorInFunction(all) << "Entry regions is empty" << exit(FatalIOError);
    }

    DynamicList<particleRegion> regions;
    for (const namedDictionary& region : entries)
    {
        // Those are read elsewhere (solidRegions)
        if (setOf(region) == "fluid") regions.append(readRegion(region, packing, space));
    }
    checkOverlap(space.mesh, regions, packing);
    return regions;
}

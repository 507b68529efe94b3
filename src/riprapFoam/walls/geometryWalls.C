// SPDX-License-Identifier: GPL-3.0-or-later

#include "geometryWalls.H"
#include "checkedDictionary.H"
#include "Enum.H"
#include "didYouMean.H"
#include "volumeType.H"

namespace Foam
{

static const Enum<geometryWalls::solidSide> sideNames
({
    {geometryWalls::solidSide::inside, "inside"},
    {geometryWalls::solidSide::outside, "outside"},
    {geometryWalls::solidSide::both, "both"}
});


// Entries of each type, after type, name, regions and solidSide
static const HashTable<wordList>& entriesOf()
{
    static const wordList box({"min", "max"}), rotated({"origin", "span", "e1", "e3"}),
        plate({"origin", "span"});
    static const wordList cylinder({"point1", "point2", "radius"}),
        disk({"origin", "normal", "radius"});
    static const wordList sphere({"origin", "centre", "radius"}),
        surface({"file", "scale", "minQuality"});
    static const HashTable<wordList> entries
    ({
        {"searchableBox", box}, {"box", box},
        {"searchableRotatedBox", rotated}, {"rotatedBox", rotated},
        {"searchablePlate", plate}, {"plate", plate},
        {"searchableCylinder", cylinder}, {"cylinder", cylinder},
        {"searchableDisk", disk}, {"disk", disk},
        {"searchableSphere", sphere}, {"sphere", sphere},
        {"triSurfaceMesh", surface}, {"closedTriSurfaceMesh", surface}
    });
    return entries;
}


// Two corners or ends of something that has a size
static void requireApart(checkedDictionary& dict, const word& a, const word& b, bool everyWay)
{
    if (!dict.found(a) || !dict.found(b)) return;
    const vector span(dict.dict().get<point>(b) - dict.dict().get<point>(a));
    if (everyWay ? cmptMin(span) <= 0 : mag(span) < SMALL)
    {
        FatalIOErrorInFunction(dict.dict())
            << "Entries " << a << " and " << b << " are " << dict.dict().get<point>(a) << " and "
            << dict.dict().get<point>(b) << ": there is nothing between them" << exit(FatalIOError);
    }
}


static void requireLength(checkedDictionary& dict, const word& entry)
{
    if (dict.found(entry) && mag(dict.dict().get<vector>(entry)) < SMALL)
    {
        FatalIOErrorInFunction(dict.dict())
            << "Entry " << entry << " is the null vector: it needs a length" << exit(FatalIOError);
    }
}


// Before OpenFOAM constructs them, which divides by what has no size: each must be a dictionary of
// a type that can be tessellated
static const dictionary& checked(const dictionary& all)
{
    for (const entry& e : all)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(all)
                << "Entry " << e.keyword()
                << " is no dictionary: each surface needs one with its type" << exit(FatalIOError);
        }

        checkedDictionary dict(e.dict());
        dict.found("type");
        const word type(e.dict().get<word>("type"));
        if (!entriesOf().found(type))
        {
            FatalIOErrorInFunction(e.dict())
                << "Unknown type " << type << " of " << e.keyword() << "; valid types are "
                << listedFor(type, entriesOf().sortedToc()).c_str() << exit(FatalIOError);
        }

        for (const word& entry : entriesOf()[type]) dict.found(entry);
        for (const char* entry : {"solidSide", "name"}) dict.found(entry);
        dict.subDict("regions");
        dict.end();

        for (const char* entry : {"radius", "scale"}) dict.positive(entry, 1.0);
        requireApart(dict, "min", "max", true);
        requireApart(dict, "point1", "point2", false);
        for (const char* entry : {"span", "normal", "e1", "e3"}) requireLength(dict, entry);
    }
    return all;
}

} // namespace Foam


Foam::geometryWalls::geometryWalls(const Time& time, const dictionary& all)
:
    searchableSurfaces
    (
        IOobject("geometry", time.constant(), "triSurface", time, IOobject::MUST_READ),
        checked(all),
        true
    ),
    dicts_(size()),
    side_(size())
{
    label i = 0;
    for (const entry& e : all)
    {
        dicts_[i] = e.dict();
        const bool closed = operator[](i).hasVolumeType();
        side_[i] = closed ? solidSide::inside : solidSide::both;

        word typed;
        if (dicts_[i].readIfPresent("solidSide", typed))
        {
            if (!sideNames.found(typed))
            {
                FatalIOErrorInFunction(dicts_[i])
                    << "Unknown solidSide " << typed << "; valid ones are "
                    << listedFor(typed, sideNames.toc()).c_str() << exit(FatalIOError);
            }
            side_[i] = sideNames.get(typed);
            if (!closed && side_[i] != solidSide::both)
            {
                FatalIOErrorInFunction(dicts_[i])
                    << "solidSide " << typed << " of " << names()[i]
                    << ", which is no closed surface: only both is possible" << exit(FatalIOError);
            }
        }
        ++i;
    }
}


Foam::boolList Foam::geometryWalls::inSolid(label bodyi, const pointField& points) const
{
    boolList in(points.size(), false);
    if (side_[bodyi] == solidSide::both) return in;

    List<volumeType> type;
    operator[](bodyi).getVolumeType(points, type);
    const auto solid = side_[bodyi] == solidSide::inside ? volumeType::INSIDE : volumeType::OUTSIDE;
    forAll(in, i) in[i] = (type[i] == solid);
    return in;
}

// SPDX-License-Identifier: GPL-3.0-or-later

#include "geometryWalls.H"
#include "Enum.H"
#include "listed.H"
#include "volumeType.H"

namespace Foam
{

static const Enum<geometryWalls::solidSide> sideNames
({
    {geometryWalls::solidSide::inside, "inside"},
    {geometryWalls::solidSide::outside, "outside"},
    {geometryWalls::solidSide::both, "both"}
});


// Before OpenFOAM constructs them: each must be a dictionary of a type that can be tessellated
static const dictionary& checked(const dictionary& all)
{
    static const wordList valid
    ({
        "closedTriSurfaceMesh", "searchableBox", "searchableCylinder", "searchableDisk",
        "searchablePlate", "searchableRotatedBox", "searchableSphere", "triSurfaceMesh",
        "box", "cylinder", "disk", "plate", "rotatedBox", "sphere"
    });

    for (const entry& e : all)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(all)
                << "Entry " << e.keyword() << " is no dictionary: each surface needs one with its type"
                << exit(FatalIOError);
        }
        const word type(e.dict().get<word>("type"));
        if (!valid.found(type))
        {
            FatalIOErrorInFunction(e.dict())
                << "Unknown type " << type << " of " << e.keyword() << "; valid types are "
                << listed(valid).c_str() << exit(FatalIOError);
        }
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
                    << listed(sideNames.toc()).c_str() << exit(FatalIOError);
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

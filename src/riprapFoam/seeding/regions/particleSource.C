// SPDX-License-Identifier: GPL-3.0-or-later

#include "particleSource.H"
#include "latticeRows.H"

namespace Foam
{
    defineTypeNameAndDebug(particleSource, 0);
    defineRunTimeSelectionTable(particleSource, dictionary);
}


Foam::autoPtr<Foam::particleSource> Foam::particleSource::New
(
    checkedDictionary& dict,
    const Time& time
)
{
    dict.found("source");
    const word type(dict.dict().get<word>("source"));
    const auto constructor = dictionaryConstructorTablePtr_->cfind(type);
    if (!constructor.found())
    {
        dict.unknownWord("source", type, dictionaryConstructorTablePtr_->sortedToc());
    }
    return (*constructor)(dict, time);
}


void Foam::volumeSource::place
(
    const particlePacking& packing,
    const boundBox& limits,
    pointField& position,
    vectorField&
) const
{
    const pointField lattice(packing.fill(bounds(), limits));
    const boolList in(inside(lattice));

    label n = 0;
    position.setSize(lattice.size());
    forAll(lattice, i)
    {
        if (in[i]) position[n++] = lattice[i];
    }
    position.setSize(n);
}


std::int64_t Foam::volumeSource::numbers(
    const particlePacking& packing, const boundBox& limits) const
{
    return latticeRows(packing, bounds(), limits).numbers();
}


void Foam::volumeSource::placePart
(
    const particlePacking& packing,
    const boundBox& limits,
    const boundBox& part,
    std::int64_t first,
    std::int64_t end,
    numberedPoints& points
) const
{
    DynamicList<point> lattice;
    DynamicList<std::int64_t> number;
    latticeRows(packing, bounds(), limits).each
    (
        part, first, end,
        [&](const point& p, std::int64_t n)
        {
            lattice.append(p);
            number.append(n);
        }
    );
    const boolList in(inside(pointField(lattice)));
    forAll(in, i)
    {
        if (!in[i]) continue;
        points.position.append(lattice[i]);
        points.number.append(number[i]);
    }
}

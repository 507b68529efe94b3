// SPDX-License-Identifier: GPL-3.0-or-later

#include "particleSource.H"

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

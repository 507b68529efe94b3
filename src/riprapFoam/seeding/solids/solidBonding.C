// SPDX-License-Identifier: GPL-3.0-or-later
/*  Which particles are bonded: those of the groups named whose surfaces are near enough, and no
    others. */

#include "solidRegions.H"
#include "HashSet.H"
#include "labelPair.H"
#include "pointGrid.H"
#include "sceneCloud.H"

namespace Foam
{

// Particles of any of the groups
static labelList membersOf(const solidSet& all, const labelList& groups)
{
    DynamicList<label> members;
    for (std::size_t i = 0; i < all.particles.size(); ++i)
    {
        if (groups.found(all.particles.group[i])) members.append(i);
    }
    return labelList(std::move(members));
}


static label addBonds
(
    const solidSet& all,
    const labelList& members,
    label type,
    scalar tolerance,
    HashSet<labelPair, labelPair::Hash<>>& bonded,
    riprap::DemBondState& bonds
)
{
    const auto& p = all.particles;
    const vectorField x(toVectors(p.position));
    scalar largest = 0;
    for (const label i : members) largest = max(largest, p.radius[i]);

    pointGrid grid(2*largest + tolerance);
    label n = 0;
    for (const label i : members)
    {
        DynamicList<label> partners;
        grid.near
        (
            x[i],
            [&](label j, const vector&, scalar distance)
            {
                if (distance <= p.radius[i] + p.radius[j] + tolerance) partners.append(j);
            }
        );
        grid.insert(x[i], i);
        Foam::sort(partners);
        for (const label j : partners)
        {
            if (!bonded.insert(labelPair(j, i))) continue;
            bonds.a.push_back(p.id[j]);
            bonds.b.push_back(p.id[i]);
            bonds.type.push_back(type);
            bonds.broken.push_back(0);
            bonds.restGap.push_back(mag(x[i] - x[j]) - p.radius[i] - p.radius[j]);
            ++n;
        }
    }
    return n;
}

} // namespace Foam


riprap::DemBondState Foam::bondSolids
(
    const dictionary& all,
    const solidSet& solids,
    const demSettings& settings
)
{
    riprap::DemBondState bonds;
    if (!all.found("bonds")) return bonds;

    HashSet<labelPair, labelPair::Hash<>> bonded;
    for (const namedDictionary& named : namedDictionaries(all, "bonds"))
    {
        const dictionary& entries = named.dict;
        checkedDictionary dict(entries);
        dict.found("type");
        dict.found("groups");
        const label type = settings.bondType(entries.get<word>("type"), entries);
        labelList groups;
        for (const word& name : entries.get<wordList>("groups"))
            groups.append(settings.group(name, entries));
        const scalar tolerance = (dict.number("gapTolerance"), dict.notNegative("gapTolerance", 0));
        dict.end();

        const label n = addBonds(solids, membersOf(solids, groups), type, tolerance, bonded, bonds);
        Info<< "    bonds " << named.name << ": " << n << nl;
        if (n == 0)
        {
            FatalIOErrorInFunction(entries)
                << "Entry bonds: " << named.name
                << " bonds nothing: no two particles of these groups are nearer"
                << " than gapTolerance " << tolerance << " m" << exit(FatalIOError);
        }
    }
    return bonds;
}

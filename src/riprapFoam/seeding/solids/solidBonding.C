// SPDX-License-Identifier: GPL-3.0-or-later
/*  Which particles are bonded: those of the groups named whose surfaces are near enough, and no
    others. */

#include "solidRegions.H"
#include "HashSet.H"
#include "labelPair.H"
#include "pointGrid.H"
#include "sceneCloud.H"

#include <algorithm>

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


static bool inOneBody(const riprap::DemParticles& p, label i, label j)
{
    return p.clump.size() && p.clump[i] >= 0 && p.clump[i] == p.clump[j];
}


//- Pairs that were near enough: those that were bonded, and those that had been before
struct bondCount { label added = 0, before = 0; };

static bondCount addBonds
(
    const solidSet& all,
    const labelList& members,
    const riprap::DemConfig& config,
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
    grid.repeat(config);
    bondCount n;
    for (const label i : members)
    {
        std::vector<std::pair<label, scalar>> partners;
        grid.nearOrImage
        (
            x[i],
            [&](label j, const vector&, scalar distance)
            {
                if (!inOneBody(p, i, j) && distance <= p.radius[i] + p.radius[j] + tolerance)
                    partners.emplace_back(j, distance);
            }
        );
        grid.insert(x[i], i);
        std::sort(partners.begin(), partners.end());
        for (const auto& [j, distance] : partners)
        {
            if (!bonded.insert(labelPair(j, i)))
            {
                ++n.before;
                continue;
            }
            bonds.a.push_back(p.id[j]);
            bonds.b.push_back(p.id[i]);
            bonds.type.push_back(type);
            bonds.broken.push_back(0);
            bonds.restGap.push_back(distance - p.radius[i] - p.radius[j]);
            ++n.added;
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

        const bondCount n = addBonds(solids, membersOf(solids, groups), settings.config, type,
            tolerance, bonded, bonds);
        Info<< "    bonds " << named.name << ": " << n.added << nl;
        if (n.added == 0)
        {
            FatalIOErrorInFunction(entries) << "Entry bonds: " << named.name << " bonds nothing: ";
            if (n.before)
                FatalIOError << "all pairs of these groups that are nearer than gapTolerance "
                             << tolerance << " m are bonded already, by an entry before it";
            else
                FatalIOError << "no two particles of these groups are nearer than gapTolerance "
                             << tolerance << " m";
            FatalIOError << exit(FatalIOError);
        }
    }
    return bonds;
}

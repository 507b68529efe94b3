/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidNeeds.H"
#include "solvers/dem/demLaws.hpp"
#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Which materials solids have, and which solids or walls
struct usedMaterials
{
    std::vector<bool> solids, all;

    usedMaterials(const demSettings& settings, const riprap::DemInput& input)
    :
        solids(settings.materials.size(), false)
    {
        for (std::size_t i = 0; i < input.particles.size(); ++i)
        {
            const auto& material = input.particles.material;
            solids[material.empty() ? 0 : material[i]] = true;
        }
        all = solids;
        for (const riprap::DemWall& wall : input.walls)
        {
            all[wall.material] = true;
        }
    }

    //- Walls do not meet walls
    bool meet(const riprap::DemPair& p) const
    {
        return (solids[p.a] && all[p.b]) || (solids[p.b] && all[p.a]);
    }
};


//- What leaving out pairs would change: the step, by what limits it, and how far
//  neighbours are sought
struct withoutPairs
{
    riprap::DemInput& input;
    const riprap::DemConfig& config;
    const bool reaches;             // by numbers of a law
    scalar step, gap;

    withoutPairs(riprap::DemInput& in, const riprap::DemConfig& c)
    :
        input(in),
        config(c),
        reaches
        (
            riprap::lawEffects(riprap::lawChoice(c), riprap::PairProperties())
           .normalReaches
        )
    {
        measure(step, gap);
    }

    void measure(scalar& dt, scalar& largest) const
    {
        dt = riprap::planDemScene(config, input).timeStep;
        largest = 0;
        for (const riprap::DemPair& p : input.pairs)
        {
            largest = max(largest, scalar(p.properties.gap));
        }
    }

    //- Names an entry without which pairs are as change(pairs) leaves them
    template<class Change>
    void name
    (
        sceneNeeds& needs,
        const dictionary& dict,
        const word& entry,
        const std::string& why,
        const Change& change
    )
    {
        if (reaches || !dict.found(entry, keyType::LITERAL)) return;

        const std::vector<riprap::DemPair> all(input.pairs);
        change(input.pairs);
        scalar dt, largest;
        measure(dt, largest);
        input.pairs = all;
        if (largest != gap) return;
        if (dt == step)
        {
            needs.idle(dict, entry, why);
        }
        else
        {
            needs.costly
            (
                dict,
                entry,
                why + ", but its stiffness sets the time step: "
              + threeDigits(step) + " s, and " + threeDigits(dt)
              + " s without it"
            );
        }
    }
};


template<class Leave>
static void remove(std::vector<riprap::DemPair>& pairs, const Leave& leave)
{
    pairs.erase(std::remove_if(pairs.begin(), pairs.end(), leave), pairs.end());
}


static void materialNeeds
(
    sceneNeeds& needs,
    const demSettings& settings,
    const usedMaterials& used,
    withoutPairs& pairs
)
{
    const dictionary& all = subDictOf(settings.dict, "materials");
    const wordList names(settings.materialNames());
    const riprap::LawChoice laws(riprap::lawChoice(settings.config));
    const bool elastic = riprap::normalNeeds(laws).elasticConstants;
    forAll(names, i)
    {
        if (!used.all[i])
        {
            pairs.name
            (
                needs,
                all,
                names[i],
                "no solid and no wall is of this material",
                [i](std::vector<riprap::DemPair>& all)
                {
                    remove(all, [i](const riprap::DemPair& p) { return p.a == i || p.b == i; });
                }
            );
        }
        else if (!elastic)
        {
            needs.idle
            (
                subDictOf(all, names[i].c_str()),
                "E",
                "contacts of normal law " + settings.config.normal
              + " take their stiffness from pairs"
            );
        }
    }
}


//- The entries of pairs: their own, or default
class pairEntries
{
    const dictionary& dict_;
    const List<riprap::DemPair>& pairs_;
    const wordList names_;              // of the materials

public:

    explicit pairEntries(const demSettings& settings)
    :
        dict_(subDictOf(settings.dict, "pairs")),
        pairs_(settings.pairs),
        names_(settings.materialNames())
    {}

    const dictionary& dict() const
    {
        return dict_;
    }

    //- Empty: default
    word own(const riprap::DemPair& p) const
    {
        const word ab(names_[p.a] + '-' + names_[p.b]);
        const word ba(names_[p.b] + '-' + names_[p.a]);
        return dict_.found(ab, keyType::LITERAL) ? ab
          : dict_.found(ba, keyType::LITERAL) ? ba : word();
    }

    bool hasDefault() const
    {
        return dict_.found("default", keyType::LITERAL);
    }

    //- What default says; null: no pair takes it
    const riprap::PairProperties* ofDefault() const
    {
        const riprap::PairProperties* properties = nullptr;
        for (const riprap::DemPair& p : pairs_)
        {
            if (own(p).empty()) properties = &p.properties;
        }
        return properties;
    }

    //- Does default say what pairs that can meet are like?
    bool needsDefault(const usedMaterials& used) const
    {
        for (const riprap::DemPair& p : pairs_)
        {
            if (own(p).empty() && used.meet(p)) return true;
        }
        return false;
    }
};


//- Without an entry of its own a pair is as default says (others; null: there is
//  no default)
static void dropOwn
(
    std::vector<riprap::DemPair>& pairs,
    const riprap::DemPair& p,
    const riprap::PairProperties* others
)
{
    const auto same = [&p](const riprap::DemPair& q)
    {
        return q.a == p.a && q.b == p.b;
    };
    if (others)
    {
        std::find_if(pairs.begin(), pairs.end(), same)->properties = *others;
    }
    else
    {
        remove(pairs, same);
    }
}


static void pairNeeds
(
    sceneNeeds& needs,
    const demSettings& settings,
    const usedMaterials& used,
    withoutPairs& pairs
)
{
    const pairEntries entries(settings);
    const riprap::PairProperties* others = entries.ofDefault();
    const bool defaults = entries.hasDefault();
    for (const riprap::DemPair& p : settings.pairs)
    {
        if (used.meet(p) || entries.own(p).empty() || (defaults && !others)) continue;
        pairs.name
        (
            needs,
            entries.dict(),
            entries.own(p),
            "no solid of one meets a solid or wall of the other",
            [&](std::vector<riprap::DemPair>& changed)
            {
                dropOwn(changed, p, defaults ? others : nullptr);
            }
        );
    }
    if (!entries.needsDefault(used))
    {
        pairs.name
        (
            needs,
            entries.dict(),
            "default",
            "all pairs that can meet have entries of their own",
            [&](std::vector<riprap::DemPair>& changed)
            {
                remove(changed, [&](const riprap::DemPair& q) { return entries.own(q).empty(); });
            }
        );
    }
}


//- Are positions and spin all held?
static bool isFixed(const demGroup& group, const riprap::DemConfig& config)
{
    bool fixed = group.group.heldSpin && !group.moves;
    for (label d = 0; d < config.dimensions; ++d)
    {
        fixed = fixed && group.group.held[config.axes[d]];
    }
    return fixed;
}


static void groupNeeds
(
    sceneNeeds& needs,
    const demSettings& settings,
    const riprap::DemInput& input
)
{
    labelList members(settings.groups.size(), Zero);
    for (std::size_t i = 0; i < input.particles.size(); ++i)
    {
        ++members[input.particles.group.empty() ? 0 : input.particles.group[i]];
    }
    for (const riprap::DemClump& clump : input.clumps)
    {
        ++members[clump.group];
    }

    const dictionary& all = subDictOf(settings.dict, "groups");
    const riprap::Vector3& g = settings.config.gravity;
    const bool weightless = g[0] == 0 && g[1] == 0 && g[2] == 0;
    forAll(members, i)
    {
        const demGroup& group = settings.groups[i];
        const word name(group.group.name, false);
        if (members[i])
        {
            if (weightless)
            {
                needs.idle(subDictOf(all, name.c_str()), "gravity", "constant/g is zero");
            }
            // Gravity is in their energy, outer forces are written, and localDamping
            // may choose fluidForce
            if (isFixed(group, settings.config))
            {
                needs.idle
                (
                    subDictOf(all, name.c_str()),
                    wordList({"viscousDamping", "viscousSpinDamping"}),
                    "its solids are fixed"
                );
            }
        }
        // A motion decides how large the domain is, whoever moves with it
        else if (!group.moves)
        {
            needs.idle(all, name, "no solid is in this group");
        }
    }
}


static void bondNeeds
(
    sceneNeeds& needs,
    const demSettings& settings,
    const riprap::DemInput& input,
    const labelList& typeOfBondType
)
{
    std::vector<bool> used(settings.bondTypes.size(), false);
    for (const std::int32_t type : input.bonds.type)
    {
        used[typeOfBondType[type]] = true;
    }
    const dictionary& all = subDictOf(settings.dict, "bonds");
    forAll(settings.bondTypes, i)
    {
        if (!used[i])
        {
            needs.idle(all, settings.bondTypes[i].name, "there are no such bonds");
        }
    }
    if (input.bonds.size() == 0)
    {
        needs.idle
        (
            subDictOf(settings.dict, "contact"),
            "withinBonds",
            "there are no bonds"
        );
    }
}


static word wordOff(const std::vector<riprap::LawCard>& laws)
{
    for (const riprap::LawCard& law : laws)
    {
        if (law.off) return law.word;
    }
    return word();
}


//- Laws that do nothing with the numbers of all pairs that can meet
static void lawNeeds
(
    sceneNeeds& needs,
    const demSettings& settings,
    const usedMaterials& used,
    const solidTrial& trial
)
{
    const riprap::LawChoice laws(riprap::lawChoice(settings.config));
    bool slides = true, rolls = true;
    for (const riprap::DemPair& p : settings.pairs)
    {
        if (!used.meet(p)) continue;
        const riprap::LawEffects effects(riprap::lawEffects(laws, p.properties));
        slides = slides && effects.slides;
        rolls = rolls && effects.rolls;
    }
    const std::vector<riprap::LawCard> tangential(riprap::tangentialLaws());
    const std::vector<riprap::LawCard> rolling(riprap::rollingLaws());
    const bool noRolling = rolls && !rolling[laws.rolling].off;
    const dictionary& contact = subDictOf(settings.dict, "contact");
    const dictionary& where = contact.size() ? contact : settings.dict;
    const std::string pairs(" is 0 in all pairs that can meet");

    riprap::DemConfig config(settings.config);
    if (noRolling)
    {
        const word off(wordOff(rolling));
        config.rolling = off;
        needs.on(where, "rolling", "rollingFriction" + pairs, off, trial(config));
    }
    // Bodies that slide without friction may still be kept from rolling
    if (rolls && slides && !tangential[laws.tangential].off)
    {
        const word off(wordOff(tangential));
        config.tangential = off;
        needs.on
        (
            where,
            "tangential",
            "friction" + pairs + (noRolling ? ", and rolling does nothing" : ""),
            off,
            trial(config)
        );
    }
}


static bool isOfLaw(const word& name)
{
    for (const riprap::PairEntry& e : riprap::allLawEntries())
    {
        if (name == e.name) return true;
    }
    return false;
}


static bool isWord(const dictionary& dict, const word& name)
{
    const entry* e = dict.findEntry(name, keyType::LITERAL);
    return e && e->isStream() && e->stream().size() && e->stream()[0].isWord();
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::solidNeeds
(
    sceneNeeds& needs,
    const demSettings& settings,
    riprap::DemInput& input,
    const labelList& typeOfBondType,
    const solidTrial& trial
)
{
    const usedMaterials used(settings, input);
    withoutPairs pairs(input, settings.config);
    materialNeeds(needs, settings, used, pairs);
    pairNeeds(needs, settings, used, pairs);
    groupNeeds(needs, settings, input);
    bondNeeds(needs, settings, input, typeOfBondType);
    lawNeeds(needs, settings, used, trial);

    for (const entry& e : subDictOf(settings.dict, "pairs"))
    {
        if (!e.isDict()) continue;
        for (const word& name : settings.unused)
        {
            // E, G and nu are a stiffness' where it is a word
            const bool laws = isOfLaw(name);
            if (laws || !isWord(e.dict(), "stiffness"))
            {
                needs.idle
                (
                    e.dict(),
                    name,
                    laws ? "it is of a law that is not chosen"
                  : "the stiffness is no calibration"
                );
            }
        }
    }
    if (settings.guards.stopAtEscape)
    {
        needs.idle
        (
            subDictOf(settings.dict, "guards"),
            "maxEscaped",
            "guards/escape is stop"
        );
    }
}


// ************************************************************************* //

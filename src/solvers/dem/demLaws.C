/*  The cards of all contact laws, and the choice among them.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <algorithm>
#include <iterator>
#include <stdexcept>
#include "solvers/dem/demFamilies.hpp"

namespace riprap
{

namespace
{

template<class Laws>
std::vector<LawCard> cardsOf()
{
    std::vector<LawCard> all;
    Laws::each([&](auto law)
    {
        using L = typename decltype(law)::type;
        all.push_back(
            LawCard{L::word, L::text, {std::begin(L::entries), std::end(L::entries)}, L::off});
    });
    return all;
}

void add(std::vector<PairEntry>& to, const LawCard& card)
{
    to.insert(to.end(), card.entries.begin(), card.entries.end());
}

//- A contact that slips and rolls, in steps
constexpr int D = 3, steps = 4;

ContactGeometry<D, double> contact(int step)
{
    ContactGeometry<D, double> g{};
    g.n.c[1] = 1;
    g.overlap = 1e-4*(1 + step);
    g.approach = 0.1 - 0.05*step;
    g.slip.c[0] = 0.2;
    g.slip.c[2] = -0.1;
    g.roll.c[0] = 3;
    g.roll.c[2] = 1 - step;
    g.reducedMass = g.meanMass = 0.01;
    g.reducedRadius = 0.005;
    g.dt = g.since = 1e-4;
    return g;
}

//- f(contact, force, history) of each step: is all that comes back and stays 0?
template<int H, class F>
bool addsNothing(const F& f)
{
    const NormalForce<double> load{1, 1, 1e4, 2, 1};
    double h[H + 1] = {};
    bool nothing = true;
    for (int k = 0; k < steps; ++k)
    {
        const auto added = f(contact(k), load, h);
        for (const double a : added.c) nothing = nothing && a == 0;
        for (const double past : h) nothing = nothing && past == 0;
    }
    return nothing;
}

} // namespace

std::vector<LawCard> normalLaws() { return cardsOf<NormalLaws>(); }
std::vector<LawCard> tangentialLaws() { return cardsOf<TangentialLaws>(); }
std::vector<LawCard> rollingLaws() { return cardsOf<RollingLaws>(); }

LawChoice lawChoice(const DemConfig& c)
{
    const auto known = [](int found, const char* kind, const std::string& word,
                           const std::vector<std::string>& words)
    {
        if (found < 0)
            throw std::invalid_argument(
                std::string("unknown ") + kind + " law " + word + "; valid are " + listOf(words));
    };
    LawChoice l{NormalLaws::find(c.normal), TangentialLaws::find(c.tangential),
        RollingLaws::find(c.rolling)};
    known(l.normal, "normal", c.normal, wordsOf(normalLaws()));
    known(l.tangential, "tangential", c.tangential, wordsOf(tangentialLaws()));
    known(l.rolling, "rolling", c.rolling, wordsOf(rollingLaws()));
    NormalLaws::at(l.normal, [&](auto normal)
    {
        using Normal = typename decltype(normal)::type;
        l.tangential = TangentialLaws::find(
            c.tangential, [](auto t) { return decltype(t)::type::template goesWith<Normal>; });
    });
    if (l.tangential < 0)
        throw std::invalid_argument(
            "tangential law " + c.tangential + " does not go with normal law " + c.normal);
    TangentialLaws::at(l.tangential, [&](auto tangential)
    {
        using Tangential = typename decltype(tangential)::type;
        l.rolling = RollingLaws::find(
            c.rolling, [](auto r) { return decltype(r)::type::template goesWith<Tangential>; });
    });
    if (l.rolling < 0)
        throw std::invalid_argument("rolling friction needs friction: with tangential "
            + c.tangential + " bodies slide, and nothing makes them roll");
    return l;
}

std::vector<PairEntry> lawEntries(const LawChoice& c)
{
    std::vector<PairEntry> all;
    add(all, normalLaws().at(c.normal));
    add(all, tangentialLaws().at(c.tangential));
    add(all, rollingLaws().at(c.rolling));
    return all;
}

std::vector<PairEntry> allLawEntries()
{
    std::vector<PairEntry> all;
    for (const auto& laws : {normalLaws(), tangentialLaws(), rollingLaws()})
        for (const LawCard& law : laws) add(all, law);
    return all;
}

NormalNeeds normalNeeds(const LawChoice& c)
{
    NormalNeeds n{};
    NormalLaws::at(c.normal, [&](auto law)
    {
        using L = typename decltype(law)::type;
        n = NormalNeeds{L::elasticConstants, L::gravity, L::stiffenedBy, L::stiffening};
    });
    return n;
}

LawEffects lawEffects(const LawChoice& laws, const PairProperties& p)
{
    LawEffects e;
    NormalLaws::at(laws.normal, [&](auto law) { e.normalReaches = decltype(law)::type::reaches; });
    TangentialLaws::at(laws.tangential, [&](auto law)
    {
        using Law = typename decltype(law)::type;
        const auto numbers = Law::make(p);
        e.slides = addsNothing<Law::template history<D>>(
            [&](const auto& g, const auto& load, double* h)
            { return Law::template force<D, double>(numbers, g, load, h); });
    });
    RollingLaws::at(laws.rolling, [&](auto law)
    {
        using Law = typename decltype(law)::type;
        const auto numbers = Law::make(p);
        e.rolls = addsNothing<Law::template history<D>>(
            [&](const auto& g, const auto& load, double* h)
            { return Law::template moment<D, double>(numbers, g, load, h); });
    });
    return e;
}

} // namespace riprap

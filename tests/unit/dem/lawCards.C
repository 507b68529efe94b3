/*  What each contact law's card says, over the whole tables: its words and entries; that its
    stiffness is the slope of its force or bounds it, and its energy the force's integral; that the
    stiffness of the step limit is not exceeded in an impact; that no impact, oblique and with spin,
    gains energy; packs against scalars. lawScenes.C: GPU against CPU. A law that is added to a
    table is tested by these.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <map>
#include <set>
#include <gtest/gtest.h>
#include "dem/bond/bondRadius.hpp"
#include "dem/bond/calibration.hpp"
#include "dem/motion/integrators.hpp"
#include "guide.hpp"
#include "impact.hpp"
#include "lawTables.hpp"

namespace riprap
{
namespace
{

//- Entries without a name of their own would be lost, a default that the struct does not have would
//  not be taken
TEST(LawCards, EntriesAreComplete)
{
    const auto check = [](auto law)
    {
        using L = typename decltype(law)::type;
        EXPECT_GT(std::string(L::word).size(), 0u);
        EXPECT_GT(std::string(L::text).size(), 10u) << L::word;
        std::set<std::string> names;
        for (const PairEntry& e : L::entries)
        {
            EXPECT_TRUE(names.insert(e.name).second) << L::word << " " << e.name;
            EXPECT_GT(std::string(e.what).size(), 0u) << e.name;
            if (e.yesNo || !e.required)
            {
                EXPECT_EQ(e.value(PairProperties()), e.otherwise) << L::word << " " << e.name;
            }
            if (!e.yesNo) { EXPECT_TRUE(e.allows(e.typical)) << L::word << " " << e.name; }
            if (!e.yesNo) { EXPECT_FALSE(e.allows(-1)) << L::word << " " << e.name; }
            PairProperties p;
            e.set(p, 0.25);
            EXPECT_EQ(e.value(p), e.yesNo ? 1 : 0.25) << L::word << " " << e.name;
        }
    };
    NormalLaws::each(check);
    TangentialLaws::each(check);
    RollingLaws::each(check);
}

//- The same entry means the same in all laws that have it
TEST(LawCards, SharedEntriesAgree)
{
    std::map<std::string, PairEntry> seen;
    for (const PairEntry& e : allLawEntries())
    {
        const auto [at, isNew] = seen.emplace(e.name, e);
        if (isNew) continue;
        EXPECT_TRUE(at->second.number == e.number && at->second.yesNo == e.yesNo
            && at->second.range == e.range)
            << e.name;
        EXPECT_STREQ(at->second.unit, e.unit) << e.name;
    }
}

TEST(LawCards, WordsFindTheirLaws)
{
    DemConfig c;
    for (const std::string& n : wordsOf(normalLaws()))
        for (const std::string& t : wordsOf(tangentialLaws()))
            for (const std::string& r : wordsOf(rollingLaws()))
            {
                c.normal = n;
                c.tangential = t;
                c.rolling = r;
                if (t == "none" && r != "none")
                {
                    EXPECT_THROW(lawChoice(c), std::invalid_argument);
                    continue;
                }
                int calls = 0;
                withLaw(lawChoice(c), [&](auto law)
                {
                    ++calls;
                    EXPECT_EQ(n, decltype(law)::NormalLaw::word);
                    EXPECT_EQ(t, decltype(law)::TangentialLaw::word);
                    EXPECT_EQ(r, decltype(law)::RollingLaw::word);
                });
                EXPECT_EQ(calls, 1) << n << " " << t << " " << r;
            }
    c = DemConfig();
    c.normal = "soft";
    try { lawChoice(c); FAIL(); }
    catch (const std::invalid_argument& e)
    {
        const std::string said = e.what();
        for (const std::string& w : wordsOf(normalLaws()))
            EXPECT_NE(said.find(w), std::string::npos) << said;
    }
}

//- The user's guide has each word, and each entry in its table of pairs
TEST(LawCards, GuideHasThem)
{
    const Guide guide("docs/guide/solids.md");
    if (guide.empty()) GTEST_SKIP() << "RIPRAP_DIR is not set";
    for (const auto& words :
        {wordsOf(normalLaws()), wordsOf(tangentialLaws()), wordsOf(rollingLaws()),
            wordsOf(calibrations()), wordsOf<BondRadii>(), wordsOf<DemIntegrators>()})
        guide.expectWords(words);
    for (const PairEntry& e : allLawEntries()) guide.expectEntry(e);
    for (const CalibrationCard& c : calibrations())
        for (const CalibrationEntry& e : c.entries) guide.expectWord(e.name);
}

//- Other families of words: each once, with a line of text; another is refused with those there are
template<class Table>
void expectFamily()
{
    std::set<std::string> words;
    Table::each([&](auto model)
    {
        using M = typename decltype(model)::type;
        EXPECT_TRUE(words.insert(M::word).second) << M::word;
        EXPECT_GT(std::string(M::text).size(), 10u) << M::word;
        EXPECT_EQ(choiceOf<Table>("entry", M::word), int(words.size()) - 1);
    });
    try { choiceOf<Table>("entry", "other"); ADD_FAILURE() << "there is no such model"; }
    catch (const std::invalid_argument& e)
    { EXPECT_EQ(e.what(), "unknown entry other; valid are " + listOf(wordsOf<Table>())); }
}
TEST(LawCards, OtherFamilies)
{
    expectFamily<Calibrations>();
    expectFamily<BondRadii>();
    expectFamily<DemIntegrators>();
    for (const CalibrationCard& c : calibrations())
        for (const CalibrationEntry& e : c.entries)
        {
            EXPECT_TRUE(e.allows(e.typical)) << c.word << " " << e.name;
            EXPECT_FALSE(e.allows(-1)) << c.word << " " << e.name;
        }
    EXPECT_EQ(radiusOf(Model<BondRadii>(), bondRadiusChoice("mean"), 2.0, 6.0, 8.0), 4);
    EXPECT_EQ(radiusOf(Model<BondRadii>(), bondRadiusChoice("harmonic"), 2.0, 6.0, 8.0), 1.5);
}

//- Two bodies pressed together and let go, slowly: the rise of the force is its stiffness, and the
//  rise of the energy its work. Trapezia: of second order in the steps, 2000 on the way
template<class L>
void pressAndRelease()
{
    const PairProperties p = typical(entriesOf<L>(), true);
    const auto q = L::make(p);
    const double deepest = 1e-4, reach = L::reach(p, p.largestRadius), step = deepest/2000;
    ContactGeometry<3, double> g{};
    g.n = Vec<3, double>{{1, 0, 0}};
    g.reducedMass = 0.01;
    g.meanMass = 0.02;
    g.reducedRadius = 0.005;
    g.dt = g.since = 1e-3;
    // before the slope is infinite
    const double own = L::reaches ? 0.9*L::reach(p, g.reducedRadius) : 0;
    double h[L::history + 1] = {}, force = 0, stiffness = 0, energy = 0;
    bool first = true;
    const auto go = [&](double overlap, double by)
    {
        g.overlap = overlap + reach;
        g.approach = by/g.dt;
        const auto f = L::template force<3, double>(q, g, h);
        const double stored = L::template energy<3, double>(q, g, h);
        if (!first)
        {
            const double slope = (f.elastic - force)/by, mean = 0.5*(f.stiffness + stiffness);
            if (L::bounds) { ASSERT_LE(slope, mean*(1 + 1e-9)) << L::word << " " << overlap; }
            else { ASSERT_NEAR(slope, mean, 1e-3*mean) << L::word << " " << overlap; }
            const double work = 0.5*(f.elastic + force)*by,
                         scale = std::abs(work) + 1e-6*mean*std::abs(by);
            ASSERT_NEAR(stored - energy, work, 2e-3*scale) << L::word << " " << overlap;
        }
        force = f.elastic;
        stiffness = f.stiffness;
        energy = stored;
        first = false;
    };
    for (int k = 20; k <= 2000; ++k) ASSERT_NO_FATAL_FAILURE(go(k*step, step));
    EXPECT_GT(force, 0) << L::word;
    for (int k = 1999; k*step > std::max(20*step, -own); --k)
        ASSERT_NO_FATAL_FAILURE(go(k*step, -step));
    if (!L::reaches) return;
    for (int k = 20; k*step > -own; --k) ASSERT_NO_FATAL_FAILURE(go(k*step, -step));
    EXPECT_LT(force, 0) << L::word;
}
TEST(LawCards, StiffnessIsTheSlopeAndEnergyTheWork)
{
    NormalLaws::each([](auto law) { pressAndRelease<typename decltype(law)::type>(); });
}

//- What the step limit takes is the largest slope of an impact on a wall, and not less than that of
//  two equal bodies
template<class L>
void stiffnessOfImpacts()
{
    using Law = Contact<L, Frictionless, NoRolling>;
    for (const double speed : {0.01, 0.3})
    {
        const PairProperties p = typical(entriesOf<L>(), true);
        Body<3> a, b;
        a.radius = b.radius = 0.01;
        a.mass = b.mass = 0.011;
        const double k = L::stiffness(p, Impact{a.mass, a.radius, speed});
        approach(a, b, 2*speed, 0);
        const ImpactResult two = collide<Law>(a, b, p, 1e-3*std::sqrt(a.mass/k), 0.1);
        EXPECT_LE(two.stiffest, k*(1 + 1e-3)) << L::word << " " << speed;
        EXPECT_GT(two.stiffest, 0.3*k) << L::word << " " << speed;
    }
}
TEST(LawCards, StepLimitHasTheLargestSlope)
{
    NormalLaws::each([](auto law) { stiffnessOfImpacts<typename decltype(law)::type>(); });
}

//- Beyond what leapfrog leaves at a thousandth of sqrt(m/k)
template<class Law, int D>
void gainsNothing(const LawChoice& c, bool lossless)
{
    const PairProperties p = typical(lawEntries(c), lossless);
    Body<D> a, b;
    const double speed = 0.5;
    for (int degrees = 0; degrees < 90; degrees += 15)
    {
        a.radius = 0.01;
        b.radius = 0.015;
        a.mass = 0.011;
        b.mass = 0.031;
        approach(a, b, speed, degrees*3.14159265358979/180);
        if (degrees % 30) a.w.c[spins<D> - 1] = 40;
        const double before = a.kinetic() + b.kinetic();
        const double k = Law::NormalLaw::stiffness(p, Impact{0.031, 0.015, speed});
        collide<Law>(a, b, p, 1e-3*std::sqrt(0.01/k), 0.2);
        EXPECT_LT(a.kinetic() + b.kinetic(), before*(1 + 2e-5))
            << nameOf(c) << " " << degrees << " " << D << "D";
    }
}
TEST(LawCards, ImpactsGainNoEnergy)
{
    eachLaw([](auto law, const LawChoice& c)
    {
        using Law = decltype(law);
        for (const bool lossless : {false, true})
        {
            gainsNothing<Law, 2>(c, lossless);
            gainsNothing<Law, 3>(c, lossless);
        }
    });
}

//- A register of contacts is as many contacts one by one, to rounding of the operations
template<class Law, int D, class R>
void packsAreScalars(const LawChoice& c)
{
    using T = Pack<R>;
    constexpr int H = Law::template history<D>, lanes = T::width;
    const R rounding = sizeof(R) == 4 ? R(3e-5) : R(1e-12);
    const PairProperties p = typical(lawEntries(c), false);
    const auto scalar = Law::template make<R>(p);
    typename Law::template Parameters<T> packed;
    const R* from = reinterpret_cast<const R*>(&scalar);
    T* to = reinterpret_cast<T*>(&packed);
    for (std::size_t k = 0; k < sizeof(scalar)/sizeof(R); ++k) to[k] = T(from[k]);
    ContactGeometry<D, R> g[lanes];
    ContactGeometry<D, T> pack{};
    R h[lanes][H + 1];
    T hp[H + 1];
    const R reach = R(Law::NormalLaw::reach(p, p.largestRadius));
    for (int l = 0; l < lanes; ++l)
    {
        g[l] = ContactGeometry<D, R>{};
        g[l].n = filled<D>(R(0));
        g[l].n.c[0] = R(0.6);
        g[l].n.c[1] = R(0.8);
        g[l].overlap = R(1e-5)*R(l + 1) + reach;
        g[l].approach = R(0.01)*R(l - 3);
        for (int s = 0; s < spins<D>; ++s) g[l].roll.c[s] = R(0.3)*R(l + s);
        Vec<D, R> slip = filled<D>(R(0));
        slip.c[0] = R(0.08)*R(l);
        slip.c[1] = R(-0.06)*R(l);
        if (D == 3) slip.c[D - 1] = R(0.02);
        g[l].slip = toTangent(g[l].n, slip);
        g[l].reducedMass = R(0.01);
        g[l].meanMass = R(0.02);
        g[l].reducedRadius = R(0.005);
        g[l].dt = g[l].since = R(1e-6);
        const R* word = reinterpret_cast<const R*>(&g[l]);
        T* words = reinterpret_cast<T*>(&pack);
        for (std::size_t k = 0; k < sizeof(g[l])/sizeof(R); ++k) words[k].v[l] = word[k];
        for (int k = 0; k <= H; ++k) hp[k].v[l] = h[l][k] = R(1e-4)*R(k - l);
    }
    NormalForce<T> fp;
    const auto r = Law::template evaluate<D, T>(packed, pack, T(R(0.01)), T(R(0.01)), hp, fp);
    const T energy = Law::template energy<D, T>(packed, pack, fp, hp);
    for (int l = 0; l < lanes; ++l)
    {
        NormalForce<R> f;
        const auto one = Law::template evaluate<D, R>(scalar, g[l], R(0.01), R(0.01), h[l], f);
        const R scale = std::abs(f.force) + std::abs(f.load);
        for (int d = 0; d < D; ++d)
            EXPECT_NEAR(r.force.c[d].v[l], one.force.c[d], rounding*scale + R(1e-12))
                << nameOf(c) << " " << l;
        for (int s = 0; s < spins<D>; ++s)
        {
            EXPECT_NEAR(
                r.momentA.c[s].v[l], one.momentA.c[s], rounding*R(0.02)*scale + R(1e-12))
                << nameOf(c) << " " << l;
            EXPECT_NEAR(
                r.momentB.c[s].v[l], one.momentB.c[s], rounding*R(0.02)*scale + R(1e-12))
                << nameOf(c) << " " << l;
        }
        for (int k = 0; k < H; ++k)
            EXPECT_NEAR(hp[k].v[l], h[l][k], rounding*std::abs(h[l][k]) + R(1e-10))
                << nameOf(c) << " " << l;
        const R stored = Law::template energy<D, R>(scalar, g[l], f, h[l]);
        EXPECT_NEAR(energy.v[l], stored, 10*rounding*std::abs(stored) + R(1e-12))
            << nameOf(c) << " " << l;
    }
}
TEST(LawCards, PacksAreScalars)
{
    eachLaw([](auto law, const LawChoice& c)
    {
        using Law = decltype(law);
        packsAreScalars<Law, 2, float>(c);
        packsAreScalars<Law, 3, float>(c);
        packsAreScalars<Law, 2, double>(c);
        packsAreScalars<Law, 3, double>(c);
    });
}

//- Without its own coefficient a law adds and remembers nothing; with it it does, unless it is none
TEST(LawEffects, AreThoseOfTheFormulas)
{
    const auto normals = normalLaws(), tangentials = tangentialLaws(), rollings = rollingLaws();
    for (int n = 0; n < int(normals.size()); ++n)
        for (int t = 0; t < int(tangentials.size()); ++t)
            for (int r = 0; r < int(rollings.size()); ++r)
            {
                PairProperties p;
                p.youngA = p.youngB = 1e7;
                for (const LawCard& card : {normals[n], tangentials[t], rollings[r]})
                    for (const PairEntry& e : card.entries)
                        if (!e.yesNo && e.required) e.set(p, e.typical);
                const LawChoice laws{n, t, r};
                EXPECT_EQ(lawEffects(laws, p).slides, tangentials[t].off) << tangentials[t].word;
                EXPECT_EQ(lawEffects(laws, p).rolls, rollings[r].off) << rollings[r].word;
                p.friction = p.rollingFriction = 0;
                EXPECT_TRUE(lawEffects(laws, p).slides) << tangentials[t].word;
                EXPECT_TRUE(lawEffects(laws, p).rolls) << rollings[r].word;
                EXPECT_EQ(
                    lawEffects(laws, p).normalReaches, std::string(normals[n].word) == Jkr::word);
            }
}

} // namespace
} // namespace riprap

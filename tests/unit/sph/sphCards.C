/*  What the cards of kernels and pair terms say, over the whole tables: words and entries,
    messages, the guide; that terms act and react equally, dissipate where they are viscosities, and
    are the same for packs; that the types of a case have what is chosen, and nothing else costs.
    kernels.hpp and terms.hpp: the formulas, GPU against CPU. What is added to a table is tested by
    these.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <random>
#include <set>
#include <typeinfo>
#include <gtest/gtest.h>
#include "coupling/couplings.hpp"
#include "coupling/fluidForces.hpp"
#include "guide.hpp"
#include "solvers/sph/sphFamilies.hpp"
#include "solvers/sph/termEffects.hpp"
#include "termTables.hpp"

namespace riprap
{
namespace
{

TEST(SphCards, EntriesAreComplete)
{
    for (const KernelModel& k : kernels())
    {
        EXPECT_GT(std::string(k.word).size(), 0u);
        EXPECT_GT(std::string(k.text).size(), 10u) << k.word;
        EXPECT_GT(k.support, 0) << k.word;
    }
    std::set<std::string> words, byName;
    for (const TermModel& t : pairTerms())
    {
        EXPECT_TRUE(words.insert(t.word).second) << t.word;
        EXPECT_GT(std::string(t.text).size(), 10u) << t.word;
        EXPECT_EQ(t.words.empty(), std::string(t.chosenBy.entry).empty()) << t.word;
        std::set<std::string> names;
        for (const TermEntry& e : t.entries)
        {
            EXPECT_TRUE(names.insert(e.name).second) << t.word << " " << e.name;
            EXPECT_GT(std::string(e.what).size(), 0u) << e.name;
            // two terms would read each other's number
            if (!e.number && !e.yesNo)
            {
                EXPECT_TRUE(byName.insert(e.name).second) << t.word << " " << e.name;
            }
            if (!e.yesNo)
            {
                EXPECT_TRUE(e.required || e.allows(e.otherwise)) << t.word << " " << e.name;
                EXPECT_TRUE(e.allows(e.typical)) << t.word << " " << e.name;
                EXPECT_FALSE(e.allows(-1)) << t.word << " " << e.name;
            }
            TermProperties p;
            e.set(p, 0.25);
            EXPECT_EQ(e.value(p), e.yesNo ? 1 : 0.25) << t.word << " " << e.name;
        }
        // by its number: there must be one, and 0 must be allowed
        if (t.words.empty())
        {
            ASSERT_FALSE(t.entries.empty()) << t.word;
            EXPECT_TRUE(t.entries[0].allows(0)) << t.word;
            EXPECT_STREQ(t.entries[0].name, t.word);
            EXPECT_STREQ(t.coeffs, "") << t.word;
        }
        else { EXPECT_GT(std::string(t.coeffs).size(), 0u) << t.word; }
    }
}

TEST(SphCards, WordsChooseTheirTerms)
{
    for (const TermSwitch& s : termSwitches())
    {
        const std::vector<std::string> valid = wordsOf(s);
        ASSERT_FALSE(valid.empty());
        EXPECT_EQ(valid[0], "none");
        EXPECT_EQ(std::set<std::string>(valid.begin(), valid.end()).size(), valid.size());
        EXPECT_NE(std::find(valid.begin(), valid.end(), s.otherwise), valid.end()) << s.entry;
        for (const std::string& word : valid)
        {
            TermProperties p;
            s.set(p, word);
            EXPECT_EQ(s.word(p), word);
            int on = 0;
            for (const TermModel& t : pairTerms())
            {
                if (t.chosenBy.entry != std::string(s.entry)) continue;
                const bool has = std::find(t.words.begin(), t.words.end(), word) != t.words.end();
                EXPECT_EQ(t.chosen(p), has) << t.word << " " << word;
                on += has;
            }
            EXPECT_EQ(on == 0, word == "none") << word;
        }
    }
    for (const TermModel& t : pairTerms())
    {
        if (!t.words.empty()) continue;
        TermProperties p;
        t.entries[0].set(p, 0);
        EXPECT_FALSE(t.chosen(p)) << t.word;
        t.entries[0].set(p, 0.1);
        EXPECT_TRUE(t.chosen(p)) << t.word;
    }
}

template<class Change>
std::string refusal(Change change)
{
    SphConfig c;
    change(c);
    try { checkModels(c); }
    catch (const std::invalid_argument& e) { return e.what(); }
    return "";
}

TEST(SphCards, WhatIsWrongIsRefusedWithWhatIsValid)
{
    EXPECT_EQ(refusal([](SphConfig&) {}), "");
    const std::string kernel = refusal([](SphConfig& c) { c.kernel = "box"; });
    EXPECT_NE(kernel.find("kernel box"), std::string::npos) << kernel;
    for (const std::string& w : kernelWords())
        EXPECT_NE(kernel.find(w), std::string::npos) << kernel;
    for (const TermSwitch& s : termSwitches())
    {
        const std::string word = refusal([&](SphConfig& c) { s.set(c, "much"); });
        EXPECT_NE(word.find(std::string(s.entry) + " much"), std::string::npos) << word;
        for (const std::string& w : wordsOf(s)) EXPECT_NE(word.find(w), std::string::npos) << word;
    }
    for (const TermModel& t : pairTerms())
        for (const TermEntry& e : t.entries)
        {
            if (e.yesNo) continue;
            const std::string number = refusal([&](SphConfig& c)
            {
                if (!t.words.empty()) t.chosenBy.set(c, t.words[0]);
                e.set(c, -1);
            });
            EXPECT_NE(number.find(e.name), std::string::npos) << t.word << " " << number;
            EXPECT_NE(number.find(e.rangeText()), std::string::npos) << t.word << " " << number;
        }
}

//- The user's guide has each word, and each entry in its table
TEST(SphCards, GuideHasThem)
{
    const Guide guide("docs/guide/sphProperties.md");
    if (guide.empty()) GTEST_SKIP() << "RIPRAP_DIR is not set";
    guide.expectWords(kernelWords());
    guide.expectWords(wordsOf(equationsOfState()));
    guide.expectWords(wordsOf(integrators()));
    guide.expectWords(wordsOf(shiftings()));
    guide.expectWords(wordsOf<Couplings>());
    guide.expectWords(wordsOf<FluidForces>());
    for (const TermSwitch& s : termSwitches())
    {
        guide.expectWord(s.entry);
        guide.expectWords(wordsOf(s));
    }
    for (const TermModel& t : pairTerms())
    {
        if (*t.coeffs) guide.expectWord(t.coeffs);
        for (const TermEntry& e : t.entries) guide.expectEntry(e);
    }
    for (const EquationModel& equation : equationsOfState())
        for (const EquationEntry& e : equation.entries) guide.expectEntry(e);

    const Guide walls("docs/guide/walls.md");
    walls.expectWords(wordsOf(wallModels()));
}

//- Families of words without numbers of their own: each word once, and a line of text
template<class Card>
void expectComplete(const std::vector<Card>& cards)
{
    EXPECT_GT(cards.size(), 1u);
    std::set<std::string> words;
    for (const Card& c : cards)
    {
        EXPECT_TRUE(words.insert(c.word).second) << c.word;
        EXPECT_GT(std::string(c.text).size(), 10u) << c.word;
    }
}
TEST(SphCards, FamiliesAreComplete)
{
    expectComplete(equationsOfState());
    expectComplete(wallModels());
    expectComplete(integrators());
    expectComplete(shiftings());
    expectComplete(cardsOf<CouplingCard, Couplings>());
    expectComplete(cardsOf<FluidForceCard, FluidForces>());
    const EquationProperties otherwise;
    for (const EquationModel& equation : equationsOfState())
        for (const EquationEntry& e : equation.entries)
        {
            EXPECT_TRUE(e.allows(e.typical)) << e.name;
            EXPECT_FALSE(e.allows(-1)) << e.name;
            if (!e.required) { EXPECT_EQ(e.value(otherwise), e.otherwise) << e.name; }
        }
    for (const IntegratorModel& i : integrators())
    {
        EXPECT_GT(i.passes, 0) << i.word;
        EXPECT_GT(i.acousticCourant, 0) << i.word;
        EXPECT_LT(i.acousticCourant, i.highestCourant) << i.word;
    }
}

//- A word that no card has, where it would choose a model
TEST(SphCards, UnknownWordsAreRefused)
{
    const auto expectRefused = [](auto change, const std::vector<std::string>& valid)
    {
        const std::string said = refusal(change);
        EXPECT_NE(said.find("other; valid are " + listOf(valid)), std::string::npos) << said;
    };
    expectRefused([](SphConfig& c) { c.eos = "other"; }, wordsOf(equationsOfState()));
    expectRefused([](SphConfig& c) { c.wallModel = "other"; }, wordsOf(wallModels()));
    expectRefused([](SphConfig& c) { c.integrator = "other"; }, wordsOf(integrators()));
    expectRefused([](SphConfig& c) { c.shifting = "other"; }, wordsOf(shiftings()));
    EXPECT_THROW(couplingOf("other"), std::invalid_argument);
    EXPECT_THROW(fluidForceOf("other"), std::invalid_argument);
    for (const EquationModel& equation : equationsOfState())
        for (const EquationEntry& e : equation.entries)
        {
            const std::string said = refusal([&](SphConfig& c)
            {
                c.eos = equation.word;
                e.set(c, -1);
            });
            EXPECT_NE(said.find(e.name), std::string::npos) << said;
            EXPECT_NE(said.find(e.rangeText()), std::string::npos) << said;
        }
}

//- In equal steps a force that does not change is given as it is, at each moment or in two blows of
//  half a step
TEST(SphCards, FluidForcesKeepTheImpulse)
{
    for (const FluidForceCard& f : cardsOf<FluidForceCard, FluidForces>())
        for (const double fraction : {0.1, 0.5, 0.9})
        {
            const ForceShares s = f.shares(1, fraction);
            EXPECT_NEAR(s.now + s.before + (f.blows ? 2*0.5 : 0), 1, 1e-15) << f.word;
            if (!f.eachSubstep) { EXPECT_EQ(s.before, 0) << f.word; }
        }
}

constexpr double spacing = 0.01, h = 0.0125;

template<int D, class T>
struct RandomPair
{
    PairParticle<D, T> i, j;
    PairGeometry<D, T> g;

    Channels<T> channels() const { return Channels<T>{T(0.0f), T(0.0f), T(0.0f), T(0.0f)}; }

    template<class Term>
    Channels<T> of(const Term& term) const
    {
        Channels<T> c = channels();
        term(i, j, g, c);
        return c;
    }

    RandomPair swapped() const
    {
        RandomPair s{j, i, g};
        for (int d = 0; d < D; ++d)
        {
            s.g.dx.c[d] = -g.dx.c[d];
            s.g.dv.c[d] = -g.dv.c[d];
        }
        return s;
    }
};

template<int D, class R>
RandomPair<D, R> randomPair(std::mt19937& engine)
{
    const auto random = [&](double low, double high)
    { return low + (high - low)*(engine()/4294967296.0); };
    RandomPair<D, R> p;
    p.g.r2 = p.g.approach = R(0);
    for (int d = 0; d < D; ++d)
    {
        p.i.velocity.c[d] = R(random(-1, 1));
        p.j.velocity.c[d] = R(random(-1, 1));
        p.g.dx.c[d] = R(spacing*random(-1, 1));
        p.g.dv.c[d] = p.i.velocity.c[d] - p.j.velocity.c[d];
        p.g.r2 += p.g.dx.c[d]*p.g.dx.c[d];
        p.g.approach += p.g.dx.c[d]*p.g.dv.c[d];
    }
    for (auto* a : {&p.i, &p.j})
    {
        a->density = R(random(900, 1100));
        a->pressureTerm = R(random(-0.01, 0.02));
        a->h = R(h);
    }
    p.g.h = R(h);
    p.g.f = R(-1e4*random(0.1, 1));
    p.g.w = R(1e4*random(0.1, 1));
    p.g.wRatio = R(random(0.1, 2));
    return p;
}

//- To rounding of numbers of the size of `of`
template<class R>
void expectSame(const Channels<R>& a, const Channels<R>& b, double rounding,
    const std::string& what, const Channels<R>& of)
{
    const auto near = [&](R x, R y, R size, const char* channel)
    { EXPECT_NEAR(x, y, rounding*std::abs(double(size)) + 1e-300) << what << " " << channel; };
    near(a.radial, b.radial, of.radial, "radial");
    near(a.cross, b.cross, of.cross, "cross");
    near(a.rate, b.rate, of.rate, "rate");
    near(a.smooth, b.smooth, of.smooth, "smooth");
}
template<class R>
void expectSame(const Channels<R>& a, const Channels<R>& b, double rounding,
    const std::string& what)
{ expectSame(a, b, rounding, what, b); }

//- f(its type, a case that chooses it, its parameters): for each term and word, D and precision
template<int D, class R, class F>
void eachCase(F f)
{
    PairTerms<D, R>::each([&](auto model)
    {
        using Term = typename decltype(model)::type;
        for (const TermProperties& p : typicalTerms<Term>())
            f(p, Term::make(p, triedFluid(D, spacing, h)));
    });
}

//- Forces and drifts are equal and opposite, so that momentum is kept, at walls too; and terms add
//  to what their card says
template<int D>
void actionIsReaction()
{
    std::mt19937 engine(3);
    eachCase<D, double>([&](const TermProperties&, const auto& term)
    {
        using Term = std::decay_t<decltype(term)>;
        bool acts = false;
        for (int k = 0; k < 100; ++k)
        {
            const auto pair = randomPair<D, double>(engine);
            const Channels<double> there = pair.of(term), back = pair.swapped().of(term);
            EXPECT_NEAR(there.radial, back.radial, 1e-12*std::abs(there.radial)) << Term::word;
            EXPECT_NEAR(there.cross, back.cross, 1e-12*std::abs(there.cross)) << Term::word;
            EXPECT_NEAR(there.smooth, back.smooth, 1e-12*std::abs(there.smooth)) << Term::word;
            const bool momentum = there.radial != 0 || there.cross != 0;
            const bool density = there.rate != 0 || there.smooth != 0;
            if (Term::part == Part::momentum) { EXPECT_FALSE(density) << Term::word; }
            if (Term::part == Part::density) { EXPECT_FALSE(momentum) << Term::word; }
            if (!Term::smooths) { EXPECT_EQ(there.smooth, 0) << Term::word; }
            acts = acts || momentum || density;
        }
        EXPECT_TRUE(acts) << Term::word;
    });
}
TEST(SphCards, ActionIsReaction)
{
    actionIsReaction<2>();
    actionIsReaction<3>();
}

//- Without needsW the loop sets neither W nor W/W(dp)
TEST(SphCards, OnlyWhoSaysSoNeedsW)
{
    std::mt19937 engine(5);
    eachCase<3, double>([&](const TermProperties&, const auto& term)
    {
        using Term = std::decay_t<decltype(term)>;
        if (Term::needsW) return;
        auto pair = randomPair<3, double>(engine);
        const Channels<double> with = pair.of(term);
        pair.g.w = pair.g.wRatio = std::nan("");
        expectSame(with, pair.of(term), 0, Term::word);
    });
}

//- What limits the step as a viscosity takes energy from every pair:
//  m_i m_j F (radial v.x + cross v^2) <= 0, F < 0
template<int D>
void viscositiesDissipate()
{
    std::mt19937 engine(7);
    eachCase<D, double>([&](const TermProperties& p, const auto& term)
    {
        using Term = std::decay_t<decltype(term)>;
        const double nu = Term::viscosity(p, triedFluid(D, spacing, h));
        EXPECT_TRUE(nu >= 0 && std::isfinite(nu)) << Term::word;
        if (nu == 0) return;
        double sum = 0;
        for (int k = 0; k < 200; ++k)
        {
            const auto pair = randomPair<D, double>(engine);
            const Channels<double> c = pair.of(term);
            const double power = c.radial*pair.g.approach + c.cross*squaredNorm(pair.g.dv);
            EXPECT_GE(power, 0) << Term::word;
            sum += power;
        }
        EXPECT_GT(sum, 0) << Term::word;
    });
}
TEST(SphCards, ViscositiesDissipate)
{
    viscositiesDissipate<2>();
    viscositiesDissipate<3>();
}

//- A register of pairs is as many pairs one by one
template<int D, class R>
void packsAreScalars()
{
    using T = Pack<R>;
    constexpr int lanes = T::width;
    std::mt19937 engine(11);
    eachCase<D, R>([&](const TermProperties&, const auto& term)
    {
        using Term = std::decay_t<decltype(term)>;
        RandomPair<D, R> one[lanes];
        RandomPair<D, T> pack;
        for (int l = 0; l < lanes; ++l)
        {
            one[l] = randomPair<D, R>(engine);
            const R* from = reinterpret_cast<const R*>(&one[l]);
            T* to = reinterpret_cast<T*>(&pack);
            for (std::size_t k = 0; k < sizeof(one[l])/sizeof(R); ++k) to[k].v[l] = from[k];
        }
        const Channels<T> together = pack.of(term);
        for (int l = 0; l < lanes; ++l)
        {
            const Channels<R> lane{together.radial.v[l], together.cross.v[l], together.rate.v[l],
                together.smooth.v[l]};
            expectSame(lane, one[l].of(term), sizeof(R) == 4 ? 3e-6 : 1e-14, Term::word);
        }
    });
}
TEST(SphCards, PacksAreScalars)
{
    packsAreScalars<2, float>();
    packsAreScalars<3, float>();
    packsAreScalars<2, double>();
    packsAreScalars<3, double>();
}

//- Every choice of words, and of terms that a number switches
std::vector<SphConfig> everyChoice()
{
    SphConfig first;
    first.spacing = spacing;
    first.viscosity = 0.7;
    first.gravity = {{0.5, -9.81, 2}};
    for (const TermModel& t : pairTerms())
        for (const TermEntry& e : t.entries) e.set(first, t.words.empty() ? 0 : e.typical);
    std::vector<SphConfig> all{first};
    const auto multiply = [&](int n, auto change)
    {
        std::vector<SphConfig> more;
        for (const SphConfig& c : all)
            for (int k = 0; k < n; ++k)
            {
                more.push_back(c);
                change(more.back(), k);
            }
        all = more;
    };
    for (const TermSwitch& s : termSwitches())
    {
        const std::vector<std::string> words = wordsOf(s);
        multiply(int(words.size()), [&](SphConfig& c, int k) { s.set(c, words[std::size_t(k)]); });
    }
    for (const TermModel& t : pairTerms())
    {
        if (!t.words.empty()) continue;
        const TermEntry& e = t.entries[0];
        multiply(2, [&](SphConfig& c, int k) { e.set(c, k*e.typical); });
    }
    multiply(2, [](SphConfig& c, int k) { c.noSlip = k; });
    multiply(2, [](SphConfig& c, int k) { if (k) c.shifting = "fickian"; });
    multiply(2, [](SphConfig& c, int k) { c.artificialAtWalls = k; });
    return all;
}

template<class R> void add(Channels<R>& to, const Channels<R>& c)
{
    to.radial += c.radial;
    to.cross += c.cross;
    to.rate += c.rate;
    to.smooth += c.smooth;
}

//- What the passes of a case are given is the sum of the terms that it has chosen, and of no others
template<int D, class R, Part part, bool Specialised>
void passesHaveWhatIsChosen(const SphConfig& c, const RandomPair<D, R>& pair)
{
    const Channels<R> continuity = pair.of(Continuity{});
    Channels<R> always = pair.channels(), fluid = always, wall, solid = always, size = always;
    const auto grow = [&](const Channels<R>& c)
    {
        add(size, Channels<R>{std::abs(c.radial), std::abs(c.cross), std::abs(c.rate),
            std::abs(c.smooth)});
    };
    if (part != Part::density) add(always, pair.of(Pressure{}));
    wall = always;
    add(wall, continuity);      // in every part: there is nothing to save
    if (part != Part::momentum) add(always, continuity);
    grow(wall);
    bool smooths = false;
    PairTerms<D, R>::each([&](auto model)
    {
        using Term = typename decltype(model)::type;
        if (!isChosen<Term>(c) || (part != Part::all && Term::part != part)) return;
        const Channels<R> own = pair.of(Term::make(c, termFluid(c)));
        add(fluid, own);
        grow(own);
        smooths = smooths || Term::smooths;
        if (!Term::atWalls || !Term::actsAtWalls(c)) return;
        add(solid, own);
        if (c.noSlip) add(wall, own);
    });
    add(fluid, always);
    const double rounding = sizeof(R) == 4 ? 1e-5 : 1e-13;
    const TermParameters<D, R> terms(c);
    int calls = 0;
    const bool drifts = c.shifting != "none";
    terms.template withFluidTerms<part, Specialised>(
        [&](const auto& fluidTerms, const auto& wallTerms, auto shifts)
    {
        ++calls;
        using FluidTerms = std::decay_t<decltype(fluidTerms)>;
        expectSame(pair.of(fluidTerms), fluid, rounding, "fluid", size);
        expectSame(pair.of(wallTerms), wall, rounding, "wall", size);
        EXPECT_EQ(decltype(shifts)::value, part != Part::momentum && drifts);
        if (smooths) { EXPECT_TRUE(FluidTerms::smooths); }
        else if (!decltype(shifts)::value) { EXPECT_FALSE(FluidTerms::smooths) << "idle channels"; }
    });
    EXPECT_EQ(calls, 1);
    if (part == Part::density) return;
    if (part == Part::momentum)
    {
        Channels<R> pressure = pair.of(Pressure{});
        add(pressure, continuity);
        const auto expect = [&](const Channels<R>& sum, const char* what)
        {
            return [&pair, &calls, &size, rounding, sum, what](const auto& t)
            {
                ++calls;
                expectSame(pair.of(t), sum, rounding, what, size);
            };
        };
        terms.withWallTerms(true, expect(wall, "wall force"));
        terms.withWallTerms(false, expect(pressure, "pressure on walls"));
        terms.withSolidTerms(true, expect(solid, "solids"));
        terms.withSolidTerms(false, expect(pair.channels(), "inviscid solids"));
        EXPECT_EQ(calls, 5);
    }
    if (part == Part::all) { EXPECT_EQ(terms.drifts(), smooths || drifts); }
}
TEST(SphCards, PassesHaveWhatIsChosen)
{
    std::mt19937 engine(13);
    const auto choices = everyChoice();
    EXPECT_GE(choices.size(), 300u);
    for (const SphConfig& c : choices)
    {
        SCOPED_TRACE(c.viscosityModel + ", " + c.diffusion + ", antiClump "
          + std::to_string(c.antiClump) + ", XSPH " + std::to_string(c.xsph));
        const auto pair = randomPair<2, float>(engine);
        passesHaveWhatIsChosen<2, float, Part::all, true>(c, pair);
        passesHaveWhatIsChosen<2, float, Part::momentum, true>(c, pair);
        passesHaveWhatIsChosen<2, float, Part::density, true>(c, pair);
        passesHaveWhatIsChosen<2, float, Part::all, false>(c, pair);
        if (HasFailure()) return;
        const auto exact = randomPair<2, double>(engine);
        passesHaveWhatIsChosen<2, double, Part::momentum, false>(c, exact);
        passesHaveWhatIsChosen<2, double, Part::density, false>(c, exact);
        double nu = 0;
        PairTerms<2, double>::each([&](auto model)
        {
            using Term = typename decltype(model)::type;
            if (isChosen<Term>(c)) nu += Term::viscosity(c, termFluid(c));
        });
        EXPECT_DOUBLE_EQ((TermParameters<2, double>::viscosity(c)), nu);
        if (HasFailure()) return;
    }
}

//- A term that only some case in a thousand takes
template<class R>
struct RareTerm : TermCard
{
    static constexpr const char* word = "rareTerm";
    static constexpr TermSwitch chosenBy = termSwitch::viscosity;
    static constexpr std::array words{"rare"};
    static constexpr TermEntry entries[] = {TermEntry("rare", "", "rare")};
    static constexpr bool atWalls = true;
    R one = R(1);

    static RareTerm make(const TermProperties&, const TermFluid&) { return {}; }

    template<class Q, class G, class T>
    HD void operator()(const Q&, const Q&, const G&, Channels<T>& c) const { c.cross += T(one); }
};

template<class Table> struct WithRare;
template<class... M> struct WithRare<Models<M...>> { using type = Models<RareTerm<double>, M...>; };

//- The types of the passes are those of a table without it, as long as it is not chosen
TEST(SphCards, RareTermsCostNothingUnlessChosen)
{
    using Plain = TermParameters<2, double>;
    using Rare = TermParameters<2, double, typename WithRare<PairTerms<2, double>>::type>;
    const auto types = [](const auto& terms)
    {
        std::vector<std::string> all;
        const auto note = [&](const auto& fluidTerms, const auto& wallTerms, auto shifts)
        {
            all.emplace_back(typeid(fluidTerms).name());
            all.emplace_back(typeid(wallTerms).name());
            all.emplace_back(typeid(shifts).name());
        };
        terms.template withFluidTerms<Part::all, true>(note);
        terms.template withFluidTerms<Part::momentum, true>(note);
        terms.template withFluidTerms<Part::density, true>(note);
        terms.template withFluidTerms<Part::all, false>(note);
        terms.withWallTerms(true, [&](const auto& t) { all.emplace_back(typeid(t).name()); });
        terms.withSolidTerms(true, [&](const auto& t) { all.emplace_back(typeid(t).name()); });
        return all;
    };
    for (const SphConfig& c : everyChoice())
    {
        bool usesRare = false;
        PairTerms<2, double>::each([&](auto model)
        {
            using Term = typename decltype(model)::type;
            usesRare = usesRare || (!Term::frequent && isChosen<Term>(c));
        });
        if (!usesRare) { ASSERT_EQ(types(Plain(c)), types(Rare(c))); }
    }

    SphConfig c;
    c.viscosityModel = "rare";
    std::mt19937 engine(17);
    const auto pair = randomPair<2, double>(engine);
    Rare(c).withFluidTerms<Part::momentum, true>(
        [&](const auto& fluidTerms, const auto& wallTerms, auto)
    {
        EXPECT_EQ(pair.of(fluidTerms).cross, 1);
        EXPECT_EQ(pair.of(wallTerms).cross, 1);
    });
    Rare(c).withSolidTerms(true, [&](const auto& t) { EXPECT_EQ(pair.of(t).cross, 1); });
}

//- A term whose first number is not 0 does something; with 0, where that is allowed, it may do
//  nothing, as artificial viscosity. One that does not see the viscosity does the same without it
TEST(TermEffects, AreThoseOfTheFormulas)
{
    SphConfig c;
    c.spacing = 0.01;
    c.viscosity = 1e-3;
    const std::vector<TermModel>& terms = pairTerms();
    for (std::size_t i = 0; i < terms.size(); ++i)
    {
        const TermModel& t = terms[i];
        SphConfig some(c), none(c);
        for (const TermEntry& e : t.entries)
            if (!e.yesNo)
            {
                e.set(some, e.typical);
                e.set(none, 0);
            }
        EXPECT_FALSE(termEffects(some)[i].idle) << t.word;
        const bool mayBeNothing = !t.entries.empty() && t.entries[0].allows(0);
        if (!mayBeNothing) { EXPECT_FALSE(termEffects(none)[i].idle) << t.word; }
        if (std::string(t.word) == ArtificialViscosity<double>::word)
        {
            EXPECT_TRUE(termEffects(none)[i].idle);
        }
        none = some;
        none.viscosity = 0;
        const bool sees = termEffects(some)[i].seesViscosity;
        if (std::string(t.word) == LaminarViscosity<double>::word)
        {
            EXPECT_TRUE(sees && termEffects(none)[i].idle);
        }
        if (!sees) { EXPECT_FALSE(termEffects(none)[i].idle) << t.word; }
    }
    c.artificialAtWalls = false;
    const auto walls = termEffects(c);
    const auto of = [&](const std::string& word)
    {
        std::size_t i = 0;
        while (i < terms.size() && word != terms[i].word) ++i;
        return walls.at(i);
    };
    EXPECT_TRUE(of(LaminarViscosity<double>::word).atWalls);
    EXPECT_FALSE(of(ArtificialViscosity<double>::word).atWalls);
}

} // namespace
} // namespace riprap

/*  The cards of all models of the fluid, and the choice among them.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <algorithm>
#include <iterator>
#include <stdexcept>
#include "solvers/sph/sphModels.hpp"
#include "sph/models.hpp"

namespace riprap
{

namespace
{

using TermTable = PairTerms<3, double>;
using EquationTable = EquationsOfState<double>;

std::vector<KernelModel> kernelModels()
{
    std::vector<KernelModel> all;
    Kernels::each([&](auto kernel)
    {
        using K = typename decltype(kernel)::type;
        all.push_back(KernelModel{K::word, K::text, K::support, K::alpha,
            K::template value<double>, K::template slope<double>});
    });
    return all;
}

std::vector<TermModel> termModels()
{
    std::vector<TermModel> all;
    TermTable::each([&](auto term)
    {
        using T = typename decltype(term)::type;
        all.push_back(TermModel{T::word, T::text, T::chosenBy, {T::words.begin(), T::words.end()},
            T::coeffs, {std::begin(T::entries), std::end(T::entries)}, isChosen<T>});
    });
    return all;
}

std::vector<EquationModel> equationModels()
{
    std::vector<EquationModel> all;
    EquationTable::each([&](auto equation)
    {
        using E = typename decltype(equation)::type;
        all.push_back({E::word, E::text, {std::begin(E::entries), std::end(E::entries)}});
    });
    return all;
}

std::vector<WallModel> wallModelCards()
{
    std::vector<WallModel> all;
    WallModels::each([&](auto model)
    {
        using W = typename decltype(model)::type;
        all.push_back({W::word, W::text, W::followsFluid});
    });
    return all;
}

std::vector<IntegratorModel> integratorModels()
{
    std::vector<IntegratorModel> all;
    Integrators::each([&](auto model)
    {
        using I = typename decltype(model)::type;
        all.push_back({I::word, I::text, I::passes, I::seesWallsFirst, I::acousticCourant,
            I::highestCourant});
    });
    return all;
}

std::vector<ShiftingChoice> shiftingCards()
{
    std::vector<ShiftingChoice> all;
    Shiftings::each([&](auto model)
    {
        using S = typename decltype(model)::type;
        all.push_back({S::word, S::text, S::shifts});
    });
    return all;
}

bool isOf(const TermModel& t, const TermSwitch& s)
{ return !t.words.empty() && std::string(t.chosenBy.entry) == s.entry; }

//- How many terms a word of an entry switches on
int countOf(const TermSwitch& s, const std::string& word)
{
    int n = 0;
    for (const TermModel& t : pairTerms())
        if (isOf(t, s)) n += int(std::count(t.words.begin(), t.words.end(), word));
    return n;
}

} // namespace

double KernelModel::weight(int D, double r, double h) const
{ return alpha(D)*value(r/h)/std::pow(h, D); }

double KernelModel::gradient(int D, double r, double h) const
{ return alpha(D)*slope(r/h)/std::pow(h, D + 2); }

const std::vector<KernelModel>& kernels()
{
    static const std::vector<KernelModel> all = kernelModels();
    return all;
}

std::vector<std::string> kernelWords() { return wordsOf(kernels()); }

int kernelChoice(const std::string& word)
{
    const int found = Kernels::find(word);
    if (found >= 0) return found;
    throw std::invalid_argument("unknown kernel " + word + "; valid are " + listOf(kernelWords()));
}

const KernelModel& kernelOf(const std::string& word)
{ return kernels()[std::size_t(kernelChoice(word))]; }

double supportOf(const SphConfig& c)
{ return kernelOf(c.kernel).support*c.smoothingRatio*c.spacing; }

const std::vector<TermModel>& pairTerms()
{
    static const std::vector<TermModel> all = termModels();
    return all;
}

std::vector<TermSwitch> termSwitches()
{
    std::vector<TermSwitch> all;
    for (const TermModel& t : pairTerms())
    {
        const auto same = [&](const TermSwitch& s) { return isOf(t, s); };
        const bool isNew = !t.words.empty() && std::none_of(all.begin(), all.end(), same);
        if (isNew) all.push_back(t.chosenBy);
    }
    return all;
}

std::vector<std::string> wordsOf(const TermSwitch& s)
{
    std::vector<std::string> all{"none"};
    for (const TermModel& t : pairTerms())
        if (isOf(t, s))
            for (const std::string& w : t.words)
                if (std::find(all.begin(), all.end(), w) == all.end()) all.push_back(w);
    std::stable_sort(all.begin(), all.end(), [&](const std::string& a, const std::string& b)
    { return countOf(s, a) < countOf(s, b); });
    return all;
}

const std::vector<EquationModel>& equationsOfState()
{
    static const std::vector<EquationModel> all = equationModels();
    return all;
}

const std::vector<WallModel>& wallModels()
{
    static const std::vector<WallModel> all = wallModelCards();
    return all;
}

const std::vector<IntegratorModel>& integrators()
{
    static const std::vector<IntegratorModel> all = integratorModels();
    return all;
}

const std::vector<ShiftingChoice>& shiftings()
{
    static const std::vector<ShiftingChoice> all = shiftingCards();
    return all;
}

const EquationModel& equationOf(const SphConfig& c)
{ return equationsOfState()[std::size_t(choiceOf<EquationTable>("equationOfState", c.eos))]; }

const WallModel& wallModelOf(const SphConfig& c)
{ return wallModels()[std::size_t(choiceOf<WallModels>("wall model", c.wallModel))]; }

const IntegratorModel& integratorOf(const SphConfig& c)
{ return integrators()[std::size_t(choiceOf<Integrators>("timeIntegration", c.integrator))]; }

const ShiftingChoice& shiftingOf(const SphConfig& c)
{ return shiftings()[std::size_t(choiceOf<Shiftings>("shifting", c.shifting))]; }

TermFluid termFluid(const SphConfig& c)
{
    TermFluid f;
    f.dimensions = c.dimensions;
    f.density = c.density;
    f.viscosity = c.viscosity;
    f.soundSpeed = c.soundSpeed;
    f.spacing = c.spacing;
    f.h = c.smoothingRatio*c.spacing;
    for (int d = 0; d < c.dimensions; ++d) f.gravity[d] = c.gravity[c.axes[d]];
    return f;
}

void checkModels(const SphConfig& c)
{
    kernelChoice(c.kernel);
    equationOf(c);
    wallModelOf(c);
    integratorOf(c);
    shiftingOf(c);
    for (const EquationModel& equation : equationsOfState())
        for (const EquationEntry& e : equation.entries)
        {
            const bool needed = !e.required || c.eos == equation.word;
            if (!needed || e.allows(e.value(c))) continue;
            throw std::invalid_argument(std::string("a coefficient of ") + equation.word + ", "
              + e.name + ", must be " + e.rangeText());
        }
    for (const TermSwitch& s : termSwitches())
    {
        const std::vector<std::string> valid = wordsOf(s);
        if (std::find(valid.begin(), valid.end(), s.word(c)) != valid.end()) continue;
        throw std::invalid_argument(std::string("unknown ") + s.entry + " " + s.word(c)
          + "; valid are " + listOf(valid));
    }
    for (const TermModel& t : pairTerms())
        for (const TermEntry& e : t.entries)
        {
            // what is not chosen need not be there
            const bool needed = !e.yesNo && (!e.required || t.chosen(c));
            if (!needed || e.allows(e.value(c))) continue;
            throw std::invalid_argument(std::string("a coefficient of ") + t.word + ", " + e.name
              + ", must be " + e.rangeText());
        }
}

} // namespace riprap

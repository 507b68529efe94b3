/*  All pair terms there are, with numbers to try them by.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <string>
#include <utility>
#include <vector>
#include "solvers/sph/sphModels.hpp"
#include "sph/models.hpp"

namespace riprap
{
namespace
{

TermFluid triedFluid(int dimensions, double spacing, double h)
{
    TermFluid f;
    f.dimensions = dimensions;
    f.viscosity = 0.7;
    f.spacing = spacing;
    f.h = h;
    f.gravity[0] = 0.5;
    f.gravity[1] = -9.81;
    f.gravity[2] = dimensions == 3 ? 2 : 0;
    return f;
}

//- Chosen by each of its words, or by its first number
template<class Term>
std::vector<TermProperties> typicalTerms()
{
    TermProperties p;
    // by the cards without types: nvcc does not know how many entries a term of a precision has
    for (const TermModel& card : pairTerms())
        if (std::string(card.word) == Term::word)
            for (const TermEntry& e : card.entries) e.set(p, e.typical);
    if constexpr (Term::words.size() == 0) return {p};
    std::vector<TermProperties> all;
    for (const char* word : Term::words)
    {
        all.push_back(p);
        Term::chosenBy.set(all.back(), word);
    }
    return all;
}

template<class Table, class Other> struct Pairs;
template<class... M, class... N>
struct Pairs<Models<M...>, Models<N...>>
{
    template<class F> static void each(F f) { (f(Model<M>(), Model<N>()), ...); }
};

//- f(Model<term in the precision R>, Model<the same in double>)
template<int D, class R, class F>
void eachTerm(F f) { Pairs<PairTerms<D, R>, PairTerms<D, double>>::each(f); }

} // namespace
} // namespace riprap

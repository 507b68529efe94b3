/*  What pair terms say about themselves besides word, text, entries and formula: defaults of their
    cards, and what is switched.

    A term is chosen by a word of an entry that several terms share (`chosenBy`, `words`), or by its
    first number (none or 0: off).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <array>
#include "sph/terms/term.hpp"
#include "api/termProperties.hpp"

namespace riprap
{

namespace termSwitch
{
    inline constexpr TermSwitch
        number{"", ""},
        viscosity{"viscosity", "laminarAndArtificial", &TermProperties::viscosityModel},
        densityDiffusion{"densityDiffusion", "fourtakas", &TermProperties::diffusion};
}

struct TermCard : TermTraits
{
    static constexpr TermSwitch chosenBy = termSwitch::number;
    static constexpr std::array<const char*, 0> words{};
    static constexpr const char* coeffs = "";       // dictionary of its numbers; empty: the file
    static constexpr Part part = Part::momentum;    // density: it adds to density rate or drift
    static constexpr bool atWalls = false;          // acts at walls that do not slip, and at solids
    static constexpr bool frequent = false;         // in combinations of cases without rare terms

    //- Of terms with atWalls
    static bool actsAtWalls(const TermProperties&) { return true; }

    //- The kinematic viscosity that it acts as [m2/s], for the step
    static double viscosity(const TermProperties&, const TermFluid&) { return 0; }
};

//- Has the case chosen it?
template<class Term>
bool isChosen(const TermProperties& p)
{
    if constexpr (Term::words.size() > 0)
    {
        const std::string word = Term::chosenBy.word(p);
        for (const char* w : Term::words) if (word == w) return true;
        return false;
    }
    else return Term::entries[0].value(p) > 0;
}

} // namespace riprap

/*  What the cards of all contact laws say, without their types: for whoever reads, checks or prints
    a configuration.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "api/demScene.hpp"

namespace riprap
{

struct LawCard
{
    const char* word;
    const char* text;
    std::vector<PairEntry> entries;
    bool off;                   // none of its kind
};

//- All there are, in the order of their tables. Two may share a word, where another choice decides
//  between them
std::vector<LawCard> normalLaws();
std::vector<LawCard> tangentialLaws();
std::vector<LawCard> rollingLaws();

//- Places in the tables
struct LawChoice { int normal, tangential, rolling; };

//- By the words of a configuration; std::invalid_argument if there is no such law, or if they do
//  not go together
LawChoice lawChoice(const DemConfig&);

//- Entries of the chosen laws, or of all, as often as there are laws that have them
std::vector<PairEntry> lawEntries(const LawChoice&);
std::vector<PairEntry> allLawEntries();

//- Of a normal law
struct NormalNeeds
{
    bool elasticConstants, gravity;
    // where contacts are too soft: what is to be larger, and by 1/overlap to which power
    const char* stiffenedBy;
    double stiffening;
};
NormalNeeds normalNeeds(const LawChoice&);

//- What laws do with the numbers of a pair, found by their own formulas
struct LawEffects
{
    // contacts act beyond the surfaces, as far as the pair's numbers say
    bool normalReaches = false;
    // the tangential law adds nothing and remembers nothing, to the bit
    bool slides = false;
    bool rolls = false;             // nor does the rolling law
};
LawEffects lawEffects(const LawChoice&, const PairProperties&);

} // namespace riprap

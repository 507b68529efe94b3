/*  What the cards of the fluid's models say, without their types: for whoever reads, checks or
    prints a configuration. Of couplings: coupling/couplings.hpp, coupling/fluidForces.hpp.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "api/sphScene.hpp"

namespace riprap
{

struct KernelModel
{
    const char* word;
    const char* text;
    double support;                     // [h]
    double (*alpha)(int D);
    double (*value)(double q);          // W h^D/alpha
    double (*slope)(double q);          // (dW/dq)/q h^D/alpha

    //- W [1/m^D], and grad W = F (x_i - x_j), F [1/m^(D+2)]
    double weight(int D, double r, double h) const;
    double gradient(int D, double r, double h) const;
};

//- All there are, in the order of their table
const std::vector<KernelModel>& kernels();
std::vector<std::string> kernelWords();

//- By its word; std::invalid_argument with the valid ones if there is no such kernel
int kernelChoice(const std::string& word);
const KernelModel& kernelOf(const std::string& word);

//- How far a kernel reaches at rest density [m]
double supportOf(const SphConfig&);

struct TermModel
{
    const char* word;
    const char* text;
    TermSwitch chosenBy;                // entry "": by its first number
    std::vector<std::string> words;     // of that entry, for which it is on
    const char* coeffs;                 // dictionary of its numbers; empty: sphProperties itself
    std::vector<TermEntry> entries;
    bool (*chosen)(const TermProperties&);
};

//- All there are, in the order of their table
const std::vector<TermModel>& pairTerms();

//- The entries whose words choose terms, each once, and the valid words: none, and those that
//  choose more terms after those of fewer
std::vector<TermSwitch> termSwitches();
std::vector<std::string> wordsOf(const TermSwitch&);

struct EquationModel
{
    const char* word;
    const char* text;
    std::vector<EquationEntry> entries;
};

struct WallModel
{
    const char* word;
    const char* text;
    bool followsFluid;                  // needs the fluid about each point in each step
};

struct IntegratorModel
{
    const char* word;
    const char* text;
    int passes;                         // over the pairs, a step
    bool seesWallsFirst;
    double acousticCourant, highestCourant;
};

struct ShiftingChoice
{
    const char* word;
    const char* text;
    bool shifts;
};

//- All there are, in the order of their tables
const std::vector<EquationModel>& equationsOfState();
const std::vector<WallModel>& wallModels();
const std::vector<IntegratorModel>& integrators();
const std::vector<ShiftingChoice>& shiftings();

//- By their words; std::invalid_argument with the valid ones if there is no such model
const EquationModel& equationOf(const SphConfig&);
const WallModel& wallModelOf(const SphConfig&);
const IntegratorModel& integratorOf(const SphConfig&);
const ShiftingChoice& shiftingOf(const SphConfig&);

//- What terms may know of the fluid
TermFluid termFluid(const SphConfig&);

//- std::invalid_argument: an unknown word, or a number that the card of its term does not allow
void checkModels(const SphConfig&);

} // namespace riprap

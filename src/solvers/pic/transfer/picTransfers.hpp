/*  What the cards of all transfer schemes and splines say, without their types: for whoever reads,
    checks or prints a configuration.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "api/picScene.hpp"

namespace riprap
{

struct TransferCard
{
    const char* word;
    const char* text;
    std::vector<TransferEntry> entries;
    bool gradient;                          // particles keep it whatever `affine` says
    bool keepsLinear;
    int memory;                             // reals of a component of the velocity
    std::vector<int> orders;                // of the splines that it goes with
    double (*timeStep)(const TransferProperties&);      // the longest that it bears [s]

    bool has(const std::string& entry) const;
};

struct SplineCard
{
    const char* word;
    int order;
};

//- All there are, in the order of their tables
std::vector<TransferCard> transfers();
std::vector<SplineCard> splines();

//- Place in the table; std::invalid_argument if there is no such scheme, or if it does not go with
//  the splines
int transferChoice(const PicConfig&);

//- Of the configuration's; std::invalid_argument too if a number is out of its range, or the step
//  longer than the scheme bears
TransferCard transferOf(const PicConfig&);

//- Do particles keep the gradient of the grid's velocity?
bool keepsGradient(const TransferCard&, const TransferProperties&);

//- Entries of all schemes, each once
std::vector<TransferEntry> allTransferEntries();

} // namespace riprap

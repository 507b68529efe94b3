/*  The experiments of couplingStability; rows are printed as they come, and as CSV.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cmath>
#include <string>
#include <vector>
#include "stirredBlock.hpp"

namespace riprap
{

struct CouplingRow
{
    std::string test, coupling, force, body, quantity;
    double setting = NAN, measured = NAN, theory = NAN;
    std::string note;
};

class CouplingRows
{
public:
    explicit CouplingRows(std::string csv) : csv_(std::move(csv)) {}
    void add(const CouplingRow&);
    void write() const;

private:
    std::string csv_;
    std::vector<CouplingRow> rows_;
};

//- Lightest body that stays: density over that of water, 0.05 to 3
void density(CouplingRows&);

//- Longest step of the fluid, c0 dt/h
void step(CouplingRows&);

//- Bonds of all stiffnesses: what undamped ones gain, and the dashpots that hold them
void bonds(CouplingRows&);

//- Solid particles larger and smaller than the water's: how many of these are found in the body
void leak(CouplingRows&);

} // namespace riprap

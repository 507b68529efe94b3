/*  What the experiments found, beside theory: printed as it comes, and as CSV.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cmath>
#include <string>
#include <vector>
#include "../stability/experiments.hpp"

namespace riprap
{

struct DemResult
{
    std::string test, scene, integrator, quantity;
    double measured = NAN, theory = NAN;
    std::string note;
};

class DemResults
{
public:
    explicit DemResults(std::string csv) : csv_(std::move(csv)) {}
    void add(const DemResult&);
    void write() const;

private:
    std::string csv_;
    std::vector<DemResult> rows_;
};

//- The experiments
void contactLimits(DemResults&);
void energy(DemResults&);
void laws(DemResults&);

} // namespace riprap

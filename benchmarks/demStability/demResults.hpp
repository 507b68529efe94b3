/*  What the experiments found, beside theory: printed as it comes, and as CSV.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cmath>
#include <string>
#include <vector>

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

//- The largest x in [low, high] for which good(x), assuming one crossing; low if none is good, high if all are
template<class Good>
double largest(double low, double high, double tolerance, const Good& good)
{
    if (!good(low)) return low;
    if (good(high)) return high;
    while (high - low > tolerance)
    {
        const double middle = 0.5*(low + high);
        (good(middle) ? low : high) = middle;
    }
    return 0.5*(low + high);
}

//- The experiments
void contactLimits(DemResults&);
void energy(DemResults&);
void laws(DemResults&);

} // namespace riprap

// SPDX-License-Identifier: GPL-3.0-or-later
/*  Where the fluid's surface cuts a line.

    Along the line, s_0 < s_1 < ..., f_i is the volume fraction sum_j V_j W_ij. The surface is where f
    falls, with increasing s, through half of what it is inside the fluid. That inside value is the
    median of all f_i > wet: it is 1 in the open, but about 1/2 along a wall (half of the kernel's
    support is dry there) and less where a wall model keeps a gap, so that a fixed threshold would
    fail exactly where columns are measured. Between samples f is linear.

    A straight surface smoothed by a symmetric kernel has half its inside value on the surface itself,
    whatever the kernel: hence the half.
*/
#ifndef levelCrossing_hpp
#define levelCrossing_hpp

#include <algorithm>
#include <cstddef>
#include <vector>

namespace riprap
{

struct FluidLevel
{
    bool wet = false;       // is there fluid on the line at all?
    double top = 0;         // highest crossing: what one sees from above, jets and splashes included
    double lowest = 0;      // lowest crossing: the top of the fluid that the line meets first
    double reference = 0;   // the inside value
};

inline double medianOf(std::vector<double> values)
{
    const std::size_t middle = values.size()/2;
    std::nth_element(values.begin(), values.begin() + middle, values.end());
    return values[middle];
}

//- Surface crossings on a line
//  @param s  positions, increasing [m]
//  @param f  volume fraction at them
//  @param wet  fractions above it count as fluid when the inside value is found
inline FluidLevel fluidLevel
(
    const std::vector<double>& s,
    const std::vector<double>& f,
    double wet = 0.1
)
{
    FluidLevel level;

    std::vector<double> inside;
    for (const double value : f)
    {
        if (value > wet) inside.push_back(value);
    }
    if (inside.empty()) return level;

    level.reference = medianOf(std::move(inside));
    const double threshold = 0.5*level.reference;

    for (std::size_t i = 0; i < s.size(); ++i)
    {
        if (f[i] < threshold) continue;

        const bool end = i + 1 == s.size();             // still fluid where the line ends
        if (!end && f[i + 1] >= threshold) continue;

        const double crossing =
            end ? s[i]
          : s[i] + (s[i + 1] - s[i])*(f[i] - threshold)/(f[i] - f[i + 1]);

        if (!level.wet) level.lowest = crossing;
        level.top = crossing;
        level.wet = true;
    }

    return level;
}

} // namespace riprap

#endif

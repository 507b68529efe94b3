// SPDX-License-Identifier: GPL-3.0-or-later
/*  Where the fluid's surface cuts a line.

    Along the line, s_0 < s_1 < ..., f_i is the volume fraction sum_j V_j W_ij. The surface is where
    f falls, with increasing s, through half of what it is inside the fluid. That inside value is
    the median of all f_i > wet: it is 1 in the open, but about 1/2 along a wall (half of the
    kernel's support is dry there) and less where a wall model keeps a gap, so that a fixed
    threshold would fail exactly where columns are measured. Between samples f is linear.

    Drops and thin sheets: the level is the highest place below which water stands minThickness deep
    without a gap. What begins within minThickness of the line's foot, or of a solid that the line
    passes through, stands on the bed and counts, however shallow.
    Thicknesses are those of the smoothed f. Cut at half of the least inside value, 0.05, a lone
    particle looks 2.7 spacings thick with h = 1.25 spacings, 3.0 with 1.7 (Wendland C2 in 2D; 2.3
    and 1.8 in 3D): with a minThickness of 3 spacings none counts.

    A straight surface smoothed by a symmetric kernel has half its inside value on the surface
    itself, whatever the kernel: hence the half.
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
    double top = 0;         // highest crossing above water that is thick enough; 0: there is none
    // lowest crossing: the top of the fluid that the line meets first, drops included
    double lowest = 0;
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
//  @param minThickness  of water that is no drop [m]; 0: all counts
//  @param solid  is there a solid at these places? empty: nowhere
//  @param wet  fractions above it count as fluid when the inside value is found
inline FluidLevel fluidLevel
(
    const std::vector<double>& s,
    const std::vector<double>& f,
    double minThickness = 0,
    const std::vector<bool>& solid = {},
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

    // Between a sample in fluid and its dry neighbour
    const auto crossing = [&](std::size_t in, std::size_t out)
    {
        return s[in] + (s[out] - s[in])*(f[in] - threshold)/(f[in] - f[out]);
    };

    double bottom = 0, bed = s[0];
    for (std::size_t i = 0; i < s.size(); ++i)
    {
        if (!solid.empty() && solid[i]) bed = s[i];
        if (f[i] < threshold) continue;

        if (i == 0) bottom = s[i];
        else if (f[i - 1] < threshold) bottom = crossing(i, i - 1);

        const bool end = i + 1 == s.size();             // still fluid where the line ends
        if (!end && f[i + 1] >= threshold) continue;

        const double top = end ? s[i] : crossing(i, i + 1);
        const bool stands = bottom - bed <= minThickness;

        if (!level.wet) level.lowest = top;
        if (stands || top - bottom >= minThickness) level.top = top;
        level.wet = true;
    }

    return level;
}

} // namespace riprap

#endif

/*  Cells for particles of several sizes: particles are sorted by size class, small ones first, and
    each class has a grid of cells of its own size. A particle looks in each class's grid just as
    far as it must, so that a mixture of sizes costs what its contacts cost, not what the largest
    radius squared with the smallest spacing would.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <vector>
#include "core/neighbours/cellGrid.hpp"

namespace riprap
{

//- Radii of a set of particles, from which the search follows: what must be remembered where the
//  largest or the smallest have gone
struct RadiusClasses
{
    static constexpr int most = 6;

    double smallest = 0, largest = 0;       // [m]
    double classes = 0;
    // largest radius and number of particles, from the largest class down
    double top[most] = {}, count[most] = {};

    //- Classes of radii within a factor of `ratio`
    static RadiusClasses of(const std::vector<double>& given, double ratio = 1.6)
    {
        RadiusClasses r;
        const auto extremes = std::minmax_element(given.begin(), given.end());
        r.smallest = *extremes.first;
        r.largest = *extremes.second;
        if (r.smallest > r.largest/ratio)
        {
            r.classes = 1;
            r.top[0] = r.largest;
            r.count[0] = double(given.size());
            return r;
        }
        std::vector<double> radii(given);
        std::sort(radii.begin(), radii.end());
        int k = 0;
        for (std::size_t end = radii.size(); end > 0; ++k)
        {
            const double high = radii[end - 1];
            const std::size_t begin = k + 1 == most
                ? 0
                : std::size_t(std::lower_bound(radii.begin(), radii.begin() + end, high/ratio)
                    - radii.begin());
            r.top[k] = high;
            r.count[k] = double(end - begin);
            end = begin;
        }
        r.classes = k;
        return r;
    }
};

template<int D, class P>
struct SizeClasses
{
    using real = typename P::real;
    static constexpr int most = RadiusClasses::most;

    int classes = 0;
    CellGrid<D, P> grid[most];
    int firstCell[most + 1];
    real largest[most];         // radius [m], ascending

    HD int cells() const { return firstCell[classes]; }

    HD int classOf(real radius) const
    {
        int k = 0;
        while (k + 1 < classes && radius > largest[k]) ++k;
        return k;
    }

    HD int cellOf(const Vec<D, real>& x, real radius) const
    {
        const int k = classOf(radius);
        return firstCell[k] + grid[k].cellOf(x);
    }

    //- reach: what is added to two radii
    void set(const Box<D, P>& box, const RadiusClasses& radii, double reach, bool shortFirst)
    {
        classes = int(radii.classes);
        firstCell[0] = 0;
        for (int k = 0; k < classes; ++k)
        {
            const int from = classes - 1 - k;
            largest[k] = real(radii.top[from]);
            if (double(largest[k]) < radii.top[from])
                largest[k] = std::nextafter(largest[k], real(1e30));
            const double cells = std::min(1e8, std::max(1e3, 8*radii.count[from]));
            grid[k].set(box, 2*radii.top[from] + reach, 1, 2, cells, shortFirst);
            firstCell[k + 1] = firstCell[k] + grid[k].cells;
        }
    }
};

} // namespace riprap

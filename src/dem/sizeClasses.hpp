/*  Cells for particles of several sizes: particles are sorted by size class, small ones first, and each class has a grid of cells of
    its own size. A particle looks in each class's grid just as far as it must, so that a mixture of sizes costs what its
    contacts cost, not what the largest radius squared with the smallest spacing would.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <vector>
#include "core/cellGrid.hpp"

namespace riprap
{

template<int D, class P>
struct SizeClasses
{
    using real = typename P::real;
    static constexpr int most = 6;

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

    //- Classes of radii within a factor of `ratio`, from the largest down; reach: what is added to two radii
    void set(const Box<D, P>& box, const std::vector<double>& radii, double reach, double ratio = 1.6)
    {
        std::vector<double> sorted(radii);
        std::sort(sorted.begin(), sorted.end());
        std::vector<double> top;
        std::vector<std::size_t> count;
        std::size_t end = sorted.size();
        while (end > 0)
        {
            const double high = sorted[end - 1];
            const std::size_t begin = int(top.size()) + 1 == most ? 0
                : std::size_t(std::lower_bound(sorted.begin(), sorted.begin() + end, high/ratio) - sorted.begin());
            top.push_back(high);
            count.push_back(end - begin);
            end = begin;
        }
        classes = std::max(1, int(top.size()));
        if (top.empty()) { top.push_back(1); count.push_back(0); }
        firstCell[0] = 0;
        for (int k = 0; k < classes; ++k)
        {
            const int from = classes - 1 - k;
            largest[k] = real(top[from]);
            if (double(largest[k]) < top[from]) largest[k] = std::nextafter(largest[k], real(1e30));
            const double most = std::min(1e8, std::max(1e3, 8.0*double(count[from])));
            grid[k].set(box, 2*top[from] + reach, 1, 2, most);
            firstCell[k + 1] = firstCell[k] + grid[k].cells;
        }
    }
};

} // namespace riprap

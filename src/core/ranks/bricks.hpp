/*  The division of space over ranks: each has a brick, cut from the whole by recursive bisection of
    cost.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace riprap
{

class Bricks
{
public:

    using Point = std::array<double, 3>;

    Bricks() = default;

    //- So that ranks have about the same of the costs, which are of points. The same numbers give
    //  the same bricks on all ranks
    Bricks(int ranks, const std::vector<Point>& points, const std::vector<std::int64_t>& costs);

    int ranks() const { return ranks_; }
    int rankOf(const Point& x) const;

private:

    //- Below `at` along `axis` is node `below`, else node `above`; a leaf has axis -1 and a rank
    struct Node { int axis = -1; double at = 0; int below = 0, above = 0, rank = 0; };

    int divide(int first, int last, std::vector<int>& some, const std::vector<Point>& points,
        const std::vector<std::int64_t>& costs);

    int ranks_ = 0;
    std::vector<Node> nodes_;
};

} // namespace riprap

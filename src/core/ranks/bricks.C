// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/ranks/bricks.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace riprap
{

Bricks::Bricks(int ranks, const std::vector<Point>& points, const std::vector<std::int64_t>& costs)
:
    ranks_(ranks)
{
    std::vector<int> some;
    for (std::size_t k = 0; k < points.size(); ++k) if (costs[k] > 0) some.push_back(int(k));
    divide(0, ranks, some, points, costs);
}

int Bricks::rankOf(const Point& x) const
{
    int node = 0;
    while (nodes_[node].axis >= 0)
        node = x[nodes_[node].axis] < nodes_[node].at ? nodes_[node].below : nodes_[node].above;
    return nodes_[node].rank;
}

//- Ranks first .. last-1 share these points; returns their node
int Bricks::divide(int first, int last, std::vector<int>& some, const std::vector<Point>& points,
    const std::vector<std::int64_t>& costs)
{
    const int node = int(nodes_.size());
    nodes_.emplace_back();
    nodes_[node].rank = first;
    if (last - first == 1) return node;
    const int middle = (first + last)/2;

    // across the longest side
    int axis = 0;
    double longest = -1;
    for (int d = 0; d < 3; ++d)
    {
        double low = std::numeric_limits<double>::max(), high = -low;
        for (const int k : some)
        {
            low = std::min(low, points[k][d]);
            high = std::max(high, points[k][d]);
        }
        if (high - low > longest) { longest = high - low; axis = d; }
    }
    std::sort(some.begin(), some.end(), [&](int a, int b)
    { return points[a][axis] < points[b][axis] || (points[a][axis] == points[b][axis] && a < b); });
    double all = 0;
    for (const int k : some) all += double(costs[k]);
    const double wanted = all*(middle - first)/(last - first);

    // between two points: the cut that comes nearest to it
    double sum = 0, least = std::numeric_limits<double>::max(),
           at = std::numeric_limits<double>::max();
    std::size_t cut = some.size();
    for (std::size_t k = 0; k < some.size(); ++k)
    {
        const double x = points[some[k]][axis];
        if ((k == 0 || x > points[some[k - 1]][axis]) && std::abs(sum - wanted) < least)
        {
            least = std::abs(sum - wanted);
            cut = k;
            at = k == 0 ? -std::numeric_limits<double>::max() : 0.5*(points[some[k - 1]][axis] + x);
        }
        sum += double(costs[some[k]]);
    }
    if (!(std::abs(sum - wanted) >= least))
    {
        cut = some.size();
        at = std::numeric_limits<double>::max();
    }
    std::vector<int> below(some.begin(), some.begin() + cut), above(some.begin() + cut, some.end());
    const int left = divide(first, middle, below, points, costs),
              right = divide(middle, last, above, points, costs);
    nodes_[node].axis = axis;
    nodes_[node].at = at;
    nodes_[node].below = left;
    nodes_[node].above = right;
    return node;
}

} // namespace riprap

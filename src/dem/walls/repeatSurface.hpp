/*  A surface at rest, repeated across periodic sides: elements within `reach` of a side are there a
    second time, a period away, so that a particle feels beside the other side what is there.
    Vertices on a side are put on it exactly, so that what continues on the other side shares them,
    and no edge is felt between the two.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace riprap
{

//- vertices: D a vertex; elements: D vertices an element. low, high: the domain along axis d
template<int D>
void repeatSurface(std::vector<double>& vertices, std::vector<int>& elements, int d, double low,
    double high, double reach)
{
    const double period = high - low, near = 1e-9*period;
    const auto snapped = [&](double x)
    { return std::abs(x - low) < near ? low : (std::abs(x - high) < near ? high : x); };
    for (std::size_t v = 0; v < vertices.size(); v += D) vertices[v + d] = snapped(vertices[v + d]);
    const std::size_t given = elements.size();
    for (const bool up : {true, false})
    {
        std::vector<int> copyOf(vertices.size()/D, -1);
        for (std::size_t e = 0; e < given; e += D)
        {
            double least = 1e300, most = -1e300;
            for (int k = 0; k < D; ++k)
            {
                least = std::min(least, vertices[elements[e + k]*D + d]);
                most = std::max(most, vertices[elements[e + k]*D + d]);
            }
            if (up ? least > low + reach : most < high - reach) continue;
            for (int k = 0; k < D; ++k)
            {
                const int v = elements[e + k];
                if (copyOf[v] < 0)
                {
                    copyOf[v] = int(vertices.size()/D);
                    for (int c = 0; c < D; ++c)
                    {
                        const double x = vertices[std::size_t(v)*D + c];
                        vertices.push_back(c == d ? snapped(x + (up ? period : -period)) : x);
                    }
                }
                elements.push_back(copyOf[v]);
            }
        }
    }
}

} // namespace riprap

/*  Surfaces for tests of ranks: boxes, balls and sheets, at random if wanted.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cmath>
#include <random>
#include "api/picScene.hpp"

namespace riprap
{

//- In 2D the rectangle of its first two axes. closed: else a sheet around it
inline PicObstacle boxObstacle(
    int dimensions, const Vector3& low, const Vector3& high, bool closed = true)
{
    PicObstacle o;
    o.name = "box";
    o.closed = closed;
    for (int k = 0; k < (dimensions == 2 ? 4 : 8); ++k)
    {
        const bool right = dimensions == 2 ? k == 1 || k == 2 : k & 1,
                   top = dimensions == 2 ? k > 1 : k & 2, back = k & 4;
        o.vertices.insert(o.vertices.end(),
            {right ? high[0] : low[0], top ? high[1] : low[1],
                dimensions == 3 ? (back ? high[2] : low[2]) : 0});
    }
    if (dimensions == 2) o.elements = {0, 1, 1, 2, 2, 3, 3, 0};
    else
        o.elements = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4,
            6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
    return o;
}

//- A polygon, or a polyhedron of rings of points
inline PicObstacle ballObstacle(int dimensions, const Vector3& centre, double radius)
{
    constexpr int around = 10, rings = 4;
    const double turn = 2*std::acos(-1.0)/around;
    PicObstacle o;
    o.name = "ball";
    const auto add = [&](double x, double y, double z)
    {
        o.vertices.insert(o.vertices.end(),
            {centre[0] + radius*x, centre[1] + radius*y,
                dimensions == 3 ? centre[2] + radius*z : 0});
    };
    if (dimensions == 2)
    {
        for (int k = 0; k < around; ++k)
        {
            add(std::cos(turn*k), std::sin(turn*k), 0);
            o.elements.insert(o.elements.end(), {k, (k + 1) % around});
        }
        return o;
    }
    add(0, -1, 0);
    for (int r = 1; r <= rings; ++r)
        for (int k = 0; k < around; ++k)
        {
            const double tilt = std::acos(-1.0)*r/(rings + 1);
            add(std::sin(tilt)*std::cos(turn*k), -std::cos(tilt), std::sin(tilt)*std::sin(turn*k));
        }
    add(0, 1, 0);
    const int last = 1 + rings*around;
    for (int k = 0; k < around; ++k)
    {
        const int next = (k + 1) % around;
        o.elements.insert(o.elements.end(), {0, 1 + k, 1 + next});
        for (int r = 0; r + 1 < rings; ++r)
        {
            const int a = 1 + r*around + k, b = 1 + r*around + next;
            o.elements.insert(o.elements.end(), {a, a + around, b, b, a + around, b + around});
        }
        const int top = 1 + (rings - 1)*around;
        o.elements.insert(o.elements.end(), {top + k, last, top + next});
    }
    return o;
}

//- A wall without thickness from one point to another, of all depths in 3D
inline PicObstacle sheetObstacle(
    int dimensions, const std::array<double, 2>& from, const std::array<double, 2>& to)
{
    PicObstacle o;
    o.name = "sheet";
    o.closed = false;
    for (const double z : {-9.0, 9.0})
        for (const auto& p : {from, to})
            o.vertices.insert(o.vertices.end(), {p[0], p[1], dimensions == 3 ? z : 0});
    if (dimensions == 2) o.elements = {0, 1};
    else o.elements = {0, 1, 3, 0, 3, 2};
    return o;
}

//- Boxes, balls and a sheet at random places of the domain, of two cells to a third of it, each a
//  part of its own from 10 on
inline std::vector<PicObstacle> randomObstacles(const PicConfig& c, unsigned seed)
{
    std::mt19937 engine(seed);
    const auto random = [&](double low, double high)
    { return low + (high - low)*(engine()/4294967296.0); };
    std::vector<PicObstacle> all;
    for (int k = 0; k < 5; ++k)
    {
        Vector3 low, high, middle;
        double least = 1e300;
        for (int d = 0; d < 3; ++d)
        {
            const double length = c.domainMax[d] - c.domainMin[d],
                         size = random(2.2*c.cellSize, 0.33*length);
            // some of them beyond a side
            low[d] = c.domainMin[d] + random(-0.1*length, length - 0.7*size);
            high[d] = low[d] + size;
            middle[d] = 0.5*(low[d] + high[d]);
            if (d < c.dimensions) least = std::min(least, size);
        }
        if (k < 2) all.push_back(boxObstacle(c.dimensions, low, high));
        else if (k < 4) all.push_back(ballObstacle(c.dimensions, middle, 0.5*least));
        else all.push_back(sheetObstacle(c.dimensions, {{low[0], low[1]}}, {{high[0], high[1]}}));
        all.back().part = 10 + k;
        all.back().name += std::to_string(k);
    }
    return all;
}

} // namespace riprap

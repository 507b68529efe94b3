/*  Walls as the device sees them: planes, and surfaces of segments or triangles in a frame of their
    own that moves rigidly.

    A surface keeps, for each edge and vertex of each element, the other vertices of the elements
    that share it: a closest point on an edge or vertex is a contact only where it is closest on all
    of these (elsewhere a neighbour has a closer one). A grid of cells, made once in the wall's
    frame, finds the elements near a particle whatever the wall's pose.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>
#include "core/backend/backend.hpp"
#include "core/simd/closestPoint.hpp"

namespace riprap
{

//- x = R X + T, with its rate of change; components in the solver's axes, the third is 0 in 2D
struct WallFrame
{
    double R[9], T[3];
    double velocity[3], spin[3];        // of the frame's origin; about it
};

struct WallData
{
    int material, plane, motion;        // motion -1: at rest
    int firstElement, elements;
    // grid of the surface; no bits but those that are set, since a written state holds them
    int firstCell, n[3], padding;
    double point[3], normal[3];         // plane, in the wall's frame
    double low[3], high[3];             // extent in the wall's frame
    double inverseCell[3];
    WallFrame frame;
    double referenceR[9], referenceT[3];    // when neighbours were found
};

static_assert(sizeof(WallData) == 10*4 + 15*8 + sizeof(WallFrame) + 12*8, "WallData has padding");

//- Surfaces of all walls; element numbers count through
template<int D>
struct SurfaceView
{
    const double* vertex;               // D a vertex
    const int* element;                 // D vertices an element
    const int* sharedFirst;             // of each feature of each element
    const int* shared;                  // vertices
    const int* cellFirst;
    const int* cellElement;

    HD Vec<D, double> at(int v) const
    {
        Vec<D, double> r;
        for (int d = 0; d < D; ++d) r.c[d] = vertex[v*D + d];
        return r;
    }

    //- Is p, on a feature of the element, the surface's closest point to x around there?
    HD bool closestThere(int e, int feature, const Vec<D, double>& p, const Vec<D, double>& x) const
    {
        const Vec<D, double> line = x - p;
        const double length2 = squaredNorm(line);
        const int f = e*featureCount<D> + feature;
        for (int k = sharedFirst[f]; k < sharedFirst[f + 1]; ++k)
        {
            const Vec<D, double> along = at(shared[k]) - p;
            const double s = dot(line, along);
            // rounding must not lose an edge that two faces of one plane share: both point the same
            // way, and are merged
            if (s > 0 && s*s > 1e-18*length2*squaredNorm(along)) return false;
        }
        return true;
    }
};

//- Makes the tables of surfaces, on the host
template<int D>
class SurfaceBuilder
{
public:
    std::vector<double> vertex{};
    std::vector<int> element, sharedFirst{0}, shared, cellFirst{0}, cellElement;

    //- Append a surface (vertices in the solver's axes, D a vertex); fills the wall's numbers.
    //  cell: at least this large
    void add(const std::vector<double>& vertices, const std::vector<int>& elements, double cell,
        WallData& wall)
    {
        wall.firstElement = int(element.size())/D;
        wall.elements = int(elements.size())/D;
        const int offset = merge(vertices);
        std::vector<int> own(elements.size());
        for (std::size_t k = 0; k < elements.size(); ++k)
        {
            own[k] = offset + same_[elements[k]];
            element.push_back(own[k]);
        }
        shareFeatures(own);
        makeCells(own, cell, wall);
    }

private:

    std::vector<int> same_;     // first vertex at the same place, for each as given

    //- Vertices at one place become one
    int merge(const std::vector<double>& vertices)
    {
        const int offset = int(vertex.size())/D;
        std::map<std::vector<double>, int> found;
        same_.clear();
        for (std::size_t k = 0; k < vertices.size(); k += D)
        {
            const std::vector<double> x(vertices.begin() + k, vertices.begin() + k + D);
            const auto it = found.emplace(x, int(found.size())).first;
            if (it->second == int(vertex.size())/D - offset)
                vertex.insert(vertex.end(), x.begin(), x.end());
            same_.push_back(it->second);
        }
        return offset;
    }

    void shareFeatures(const std::vector<int>& own)
    {
        // feature's vertices: those of its elements that are not its own
        std::map<std::vector<int>, std::vector<int>> others;
        const auto feature = [&](std::size_t e, int f)
        {
            std::vector<int> v;
            if (D == 2) v = {own[e + f]};
            else if (f >= 3) v = {own[e + f - 3]};
            else v = {own[e + f], own[e + (f + 1) % 3]};
            std::sort(v.begin(), v.end());
            return v;
        };
        for (std::size_t e = 0; e < own.size(); e += D)
            for (int f = 0; f < featureCount<D>; ++f)
            {
                const std::vector<int> key = feature(e, f);
                for (int k = 0; k < D; ++k)
                    if (!std::binary_search(key.begin(), key.end(), own[e + k]))
                        others[key].push_back(own[e + k]);
            }
        for (std::size_t e = 0; e < own.size(); e += D)
            for (int f = 0; f < featureCount<D>; ++f)
            {
                std::vector<int> list = others[feature(e, f)];
                std::sort(list.begin(), list.end());
                list.erase(std::unique(list.begin(), list.end()), list.end());
                shared.insert(shared.end(), list.begin(), list.end());
                sharedFirst.push_back(int(shared.size()));
            }
    }

    //- Of the element that begins with own[e]
    void extent(const std::vector<int>& own, std::size_t e, int d, double& low, double& high) const
    {
        low = 1e300;
        high = -1e300;
        for (int k = 0; k < D; ++k)
        {
            low = std::min(low, vertex[own[e + k]*D + d]);
            high = std::max(high, vertex[own[e + k]*D + d]);
        }
    }

    //- As large as an element is on average, at least `cell`, and not too many
    void setGrid(const std::vector<int>& own, double cell, WallData& wall) const
    {
        double size = 0;
        for (int d = 0; d < 3; ++d)
        {
            wall.low[d] = d < D ? 1e300 : 0;
            wall.high[d] = d < D ? -1e300 : 0;
            wall.n[d] = 1;
        }
        for (std::size_t e = 0; e < own.size(); e += D)
            for (int d = 0; d < D; ++d)
            {
                double low, high;
                extent(own, e, d, low, high);
                wall.low[d] = std::min(wall.low[d], low);
                wall.high[d] = std::max(wall.high[d], high);
                size += (high - low)/double(own.size());
            }
        size = std::max(size, cell);
        for (double total = 1e300; total > 4e6; size *= 1.3)
        {
            total = 1;
            for (int d = 0; d < D; ++d)
            {
                wall.n[d] = std::max(1, int((wall.high[d] - wall.low[d])/size));
                total *= wall.n[d];
            }
        }
        for (int d = 0; d < D; ++d)
            wall.inverseCell[d] = wall.n[d]/std::max(wall.high[d] - wall.low[d], 1e-300);
    }

    void makeCells(const std::vector<int>& own, double cell, WallData& wall)
    {
        setGrid(own, cell, wall);
        std::vector<std::vector<int>> cells(std::size_t(wall.n[0])*wall.n[1]*wall.n[2]);
        for (std::size_t e = 0; e < own.size(); e += D)
        {
            int from[3] = {0, 0, 0}, to[3] = {0, 0, 0};
            for (int d = 0; d < D; ++d)
            {
                double low, high;
                extent(own, e, d, low, high);
                from[d] = wallCell(wall, d, low);
                to[d] = wallCell(wall, d, high);
            }
            for (int z = from[2]; z <= to[2]; ++z)
                for (int y = from[1]; y <= to[1]; ++y)
                    for (int x = from[0]; x <= to[0]; ++x)
                        cells[(std::size_t(z)*wall.n[1] + y)*wall.n[0] + x].push_back(
                            wall.firstElement + int(e)/D);
        }
        wall.firstCell = int(cellFirst.size()) - 1;
        for (const auto& c : cells)
        {
            cellElement.insert(cellElement.end(), c.begin(), c.end());
            cellFirst.push_back(int(cellElement.size()));
        }
    }

public:

    HD static int wallCell(const WallData& w, int d, double x)
    {
        const double c = (x - w.low[d])*w.inverseCell[d];
        return c <= 0 ? 0 : (c >= w.n[d] ? w.n[d] - 1 : int(c));
    }
};

//- x in the wall's frame
template<int D>
HD Vec<D, double> intoFrame(const double* R, const double* T, const Vec<D, double>& x)
{
    Vec<D, double> r;
    for (int d = 0; d < D; ++d)
    {
        r.c[d] = 0;
        for (int e = 0; e < D; ++e) r.c[d] += R[3*e + d]*(x.c[e] - T[e]);
    }
    return r;
}

//- A direction out of the wall's frame
template<int D>
HD Vec<D, double> outOfFrame(const double* R, const Vec<D, double>& a)
{
    Vec<D, double> r;
    for (int d = 0; d < D; ++d)
    {
        r.c[d] = 0;
        for (int e = 0; e < D; ++e) r.c[d] += R[3*d + e]*a.c[e];
    }
    return r;
}

} // namespace riprap

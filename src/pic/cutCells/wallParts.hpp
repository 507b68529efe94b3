/*  Where the water of a grid presses on which part of its walls: the faces of the sides, and the
    surfaces of obstacles, cut along the planes of the grid.

    On a piece the pressure is that of the middle of the cell before it and what water at rest
    weighs from there, p + rho g.(x - x_cell). So the force on an obstacle in water at rest is the
    weight of what it displaces, wherever it lies between the planes. Of the sides only what
    obstacles leave of their faces counts.

    Elements of a surface are turned alike; which way, its volume says. Surfaces without a volume,
    and thin ones, are pressed from both sides.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include "pic/cutCells/cutObstacles.hpp"

namespace riprap
{

//- A piece of a wall, no larger than a face of a cell
template<int D>
struct WallPiece
{
    int part, obstacle;         // obstacle: its number, -1: a side
    bool thin;                  // the water before it is in a cell whose middle lies before it
    Vec<D, double> middle, area;        // area times its normal into the wall [m]
};

template<int D>
struct WallParts
{
    std::vector<WallPiece<D>> pieces;
    std::vector<double> aperture[D];                // what is open of faces
    std::vector<double> distance;                   // to the nearest obstacle, at the nodes
    std::vector<int> part;                          // of each obstacle
    std::vector<std::vector<double>> distanceOf;    // to each that is closed, at the nodes
};

//- The parts of a convex polygon (2D: a segment) between the planes of a grid: f(points)
template<int D, class F>
void eachBetweenPlanes(
    const UniformGrid<D>& grid, std::vector<Vec<D, double>> points, int d, const F& f)
{
    if (d == D) { f(points); return; }
    constexpr double hair = 1e-9;               // cells: nearer to a plane is on it
    const auto at = [&](const Vec<D, double>& x) { return (x[d] - grid.origin[d])/grid.h; };
    double low = 1e300, high = -1e300;
    for (const auto& x : points) { low = std::min(low, at(x)); high = std::max(high, at(x)); }
    const int last = std::min(int(std::ceil(std::min(high, 1e9) - hair)) - 1, grid.n[d]);
    for (int plane = std::max(int(std::floor(std::max(low, -1e9) + hair)) + 1, 0); plane <= last;
         ++plane)
    {
        std::vector<Vec<D, double>> below, above;
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            const auto &p = points[i], &q = points[(i + 1) % points.size()];
            const double a = at(p) - plane, b = at(q) - plane;
            if (a <= 0) below.push_back(p);
            if (a >= 0) above.push_back(p);
            if (a*b >= 0 || (D == 2 && i == 1)) continue;       // a segment has one edge
            Vec<D, double> cut = p + (a/(a - b))*(q - p);
            cut[d] = grid.origin[d] + grid.h*plane;
            below.push_back(cut);
            above.push_back(cut);
        }
        if (below.size() >= D) eachBetweenPlanes(grid, below, d + 1, f);
        points = std::move(above);
        if (points.size() < D) return;
    }
    eachBetweenPlanes(grid, points, d + 1, f);
}

//- Area and middle; 2D: the normal is right of the segment
template<int D>
void measurePiece(
    const std::vector<Vec<D, double>>& points, Vec<D, double>& area, Vec<D, double>& middle)
{
    if constexpr (D == 2)
    {
        area = {{points[1][1] - points[0][1], points[0][0] - points[1][0]}};
        middle = 0.5*(points[0] + points[1]);
    }
    else
    {
        area = middle = filled<D>(0.0);
        double sum = 0;
        for (std::size_t i = 1; i + 1 < points.size(); ++i)
        {
            const Vec<D, double> own = 0.5*cross(points[i] - points[0], points[i + 1] - points[0]);
            const double size = std::sqrt(squaredNorm(own));
            area = area + own;
            middle = middle + (size/3)*(points[0] + points[i] + points[i + 1]);
            sum += size;
        }
        if (sum > 0) middle = (1/sum)*middle;
    }
}

template<int D>
std::vector<Vec<D, double>> elementPoints(const Obstacle<D>& o, int e)
{
    std::vector<Vec<D, double>> points;
    points.reserve(D);
    for (int k = 0; k < D; ++k) points.push_back(o.vertices[o.elements[e][k]]);
    return points;
}

//- 1: measurePiece's normals lead into the solid, -1: out of it
template<int D>
double turnedInto(const Obstacle<D>& o)
{
    double volume = 0;
    for (int e = 0; e < int(o.elements.size()); ++e)
    {
        Vec<D, double> area, middle;
        measurePiece(elementPoints(o, e), area, middle);
        volume += dot(area, middle - o.vertices[0]);
    }
    return (volume > 0) == o.solidOutside ? 1 : -1;
}

//- Beyond the sides of the domain, where no water is: a piece lies on one side of each
template<int D>
bool isBeyond(const UniformGrid<D>& grid, const Vec<D, double>& x)
{
    constexpr double hair = 1e-6;               // cells
    for (int d = 0; d < D; ++d)
    {
        const double at = (x[d] - grid.origin[d])/grid.h;
        if (at < -hair || at > grid.n[d] + hair) return true;
    }
    return false;
}

template<int D>
void addObstacle(const UniformGrid<D>& grid, const Obstacle<D>& o, int part, WallParts<D>& parts)
{
    parts.part.push_back(part);
    parts.distanceOf.push_back(o.closed ? obstacleDistance(grid, o) : std::vector<double>());
    const bool thin = isThin(grid, o, parts.distanceOf.back());
    const double sense = o.closed ? turnedInto(o) : 1;
    for (int e = 0; e < int(o.elements.size()); ++e)
        eachBetweenPlanes(grid, elementPoints(o, e), 0,
            [&](const std::vector<Vec<D, double>>& points)
            {
                WallPiece<D> piece{part, int(parts.part.size()) - 1, thin, {}, {}};
                measurePiece(points, piece.area, piece.middle);
                if (!(squaredNorm(piece.area) > 0) || isBeyond(grid, piece.middle)) return;
                piece.area = sense*piece.area;
                parts.pieces.push_back(piece);
                if (o.closed) return;
                piece.area = -1.0*piece.area;
                parts.pieces.push_back(piece);
            });
}

//- Linear along each axis between the nodes; beyond the grid that of the nearest cell
template<int D>
double distanceAt(
    const NodeGrid<D>& nodes, const std::vector<double>& distance, const Vec<D, double>& x)
{
    typename UniformGrid<D>::Index low{{0, 0, 0}};
    double part[D], sum = 0;
    for (int d = 0; d < D; ++d)
    {
        const double s = (x[d] - nodes.grid.origin[d])/nodes.grid.h;
        low.c[d] = std::max(0, std::min(int(std::floor(s)), nodes.grid.n[d] - 1));
        part[d] = s - low.c[d];
    }
    for (int corner = 0; corner < (1 << D); ++corner)
    {
        double w = 1;
        int node = nodes.node(low);
        for (int d = 0; d < D; ++d)
        {
            const int up = corner >> d & 1;
            w *= up ? part[d] : 1 - part[d];
            node += up*nodes.stride(d);
        }
        sum += w*distance[node];
    }
    return sum;
}

//- By how often a line from there along the first axis crosses the surface
template<int D>
bool isSolidAt(const Obstacle<D>& o, const Vec<D, double>& x)
{
    int passed = 0;
    for (int e = 0; e < int(o.elements.size()); ++e)
        eachCrossing(o, e, 0, x, [&](double at) { passed += at > x[0]; });
    return (passed % 2 == 1) != o.solidOutside;
}

//- After all obstacles, which these are: pieces that another one covers are dry
template<int D>
void dropCovered(
    const UniformGrid<D>& grid, const std::vector<Obstacle<D>>& obstacles, WallParts<D>& parts)
{
    constexpr double before = 1e-3;             // cells
    const NodeGrid<D> nodes{grid};
    const auto covered = [&](const WallPiece<D>& piece)
    {
        const Vec<D, double> x = piece.middle
            - (before*grid.h/std::sqrt(squaredNorm(piece.area)))*piece.area;
        for (int k = 0; k < int(obstacles.size()); ++k)
            if (k != piece.obstacle && obstacles[k].closed
                && distanceAt(nodes, parts.distanceOf[k], x) < grid.h && isSolidAt(obstacles[k], x))
                return true;
        return false;
    };
    parts.pieces.erase(
        std::remove_if(parts.pieces.begin(), parts.pieces.end(), covered), parts.pieces.end());
}

//- Mean of a face's corners
template<int D>
double distanceOfFace(const NodeGrid<D>& nodes, int d, const typename UniformGrid<D>::Index& face,
    const double* distance)
{
    double sum = 0;
    for (int corner = 0; corner < (1 << D); ++corner)
    {
        if (corner >> d & 1) continue;
        int node = nodes.node(face);
        for (int e = 0; e < D; ++e) node += (corner >> e & 1)*nodes.stride(e);
        sum += distance[node];
    }
    return sum/(1 << (D - 1));
}

//- Closed faces of the sides. sides: what is open of faces without obstacles; partOf: of the faces
//  of the sides, -1: none
template<int D>
void addSides(const UniformGrid<D>& grid, const std::vector<double>* sides,
    const std::vector<int>* partOf, WallParts<D>& parts)
{
    const NodeGrid<D> nodes{grid};
    for (int d = 0; d < D; ++d)
        for (int f = 0; f < grid.faces(d) && !partOf[d].empty(); ++f)
        {
            if (partOf[d][f] < 0 || sides[d][f] > 0) continue;
            const auto x = grid.faceIndex(d, f);
            const SolidPart<D> none{}, covered = solidOfFace(nodes, d, x, parts.distance.data());
            const double left = 1 - covered.share;
            if (!(left > smallestAperture)) continue;
            WallPiece<D> piece{partOf[d][f], -1, false, {}, filled<D>(0.0)};
            piece.middle = (1/left)
                *(solidMiddle(nodes, d, x, none)
                    - covered.share*solidMiddle(nodes, d, x, covered));
            piece.middle[d] = grid.origin[d] + grid.h*x.c[d];
            piece.area[d] = (x.c[d] == 0 ? -1 : 1)*left*grid.area();
            parts.pieces.push_back(piece);
        }
}

//- The cell of the water before a piece, -1: there is none. p: 0 in dry cells
template<int D>
int cellBefore(const UniformGrid<D>& grid, const WallPiece<D>& piece, const std::vector<double>& p)
{
    const Vec<D, double> out = (-1/std::sqrt(squaredNorm(piece.area)))*piece.area;
    for (const double way : {1e-6, 0.5, 1.0})   // cells
    {
        typename UniformGrid<D>::Index c{{0, 0, 0}};
        bool in = true;
        double before = 0;
        for (int d = 0; d < D; ++d)
        {
            c.c[d] = int(std::floor((piece.middle[d] - grid.origin[d])/grid.h + way*out[d]));
            in = in && c.c[d] >= 0 && c.c[d] < grid.n[d];
            before += out[d]*(grid.origin[d] + grid.h*(c.c[d] + 0.5) - piece.middle[d]);
        }
        if (!in || (piece.thin && before < 0)) continue;
        const int i = grid.cell(c);
        if (p[i] != 0) return i;
    }
    return -1;
}

//- Force on a piece [N]. weight: rho g. Of a pressure what is carried to the piece makes no
//  suction: the water ends before it
template<int D>
Vec<D, double> pressureForce(const UniformGrid<D>& grid, const WallPiece<D>& piece,
    const std::vector<double>& p, const Vec<D, double>& weight)
{
    const int i = cellBefore(grid, piece, p);
    if (i < 0) return filled<D>(0.0);
    const auto c = grid.cellIndex(i);
    double carried = p[i];
    for (int d = 0; d < D; ++d)
        carried += weight[d]*(piece.middle[d] - grid.origin[d] - grid.h*(c.c[d] + 0.5));
    return (p[i] > 0 ? std::max(carried, 0.0) : carried)*piece.area;
}

} // namespace riprap

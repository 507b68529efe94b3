/*  SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "solvers/pic/picObstacles.hpp"
#include <stdexcept>
#include "pic/cutCells/cutObstacles.hpp"

namespace riprap
{

namespace
{

template<int D>
UniformGrid<D> gridOf(const PicConfig& c)
{
    UniformGrid<D> g;
    g.h = c.cellSize;
    for (int d = 0; d < D; ++d)
    {
        g.origin[d] = c.domainMin[c.axes[d]];
        g.n[d] = c.cells[c.axes[d]];
        g.periodic[d] = c.periodic[c.axes[d]];
    }
    return g;
}

template<int D>
std::vector<Vec<D, double>> placed(
    const PicConfig& c, const std::vector<double>& vertices, const WallPose& pose)
{
    std::vector<Vec<D, double>> at(vertices.size()/3);
    for (std::size_t i = 0; i < at.size(); ++i)
        for (int d = 0; d < D; ++d)
        {
            const int row = c.axes[d];
            at[i][d] = pose.translation[row];
            for (int k = 0; k < 3; ++k) at[i][d] += pose.rotation[3*row + k]*vertices[3*i + k];
        }
    return at;
}

template<int D>
Obstacle<D> obstacleOf(
    const PicConfig& c, const PicObstacle& in, const WallMotion& motion, double t, double dt)
{
    if (in.elements.size() % D || in.elements.empty())
        throw std::invalid_argument("obstacle " + in.name + ": incomplete elements");
    Obstacle<D> o;
    o.closed = in.closed;
    o.solidOutside = in.solidOutside;
    const bool moves = in.body >= 0 && motion;
    o.vertices = placed<D>(c, in.vertices, moves ? motion(in.body, t) : WallPose{});
    if (moves) o.next = placed<D>(c, in.vertices, motion(in.body, t + dt));
    for (std::size_t e = 0; e < in.elements.size()/D; ++e)
    {
        Vec<D, int> v;
        double size = 0;
        for (int k = 0; k < D; ++k) v[k] = in.elements[D*e + k];
        for (int k = 1; k < D; ++k) size += squaredNorm(o.vertices[v[k]] - o.vertices[v[0]]);
        if (size > 0) o.elements.push_back(v);
    }
    return o;
}

//- What is open of faces without obstacles
template<int D>
std::vector<double> openOfSides(const UniformGrid<D>& grid, const PicWalls& sides, int d)
{
    std::vector<double> open = sides.aperture[d];
    if (!open.empty()) return open;
    open.assign(grid.faces(d), 1);
    for (int f = 0; f < grid.faces(d) && !grid.periodic[d]; ++f)
    {
        const int layer = grid.faceIndex(d, f).c[d];
        if (layer == 0 || layer == grid.n[d]) open[f] = 0;
    }
    return open;
}

template<int D>
PicCut cutIn(const PicConfig& c, const PicWalls& sides, const std::vector<PicObstacle>& obstacles,
    const WallMotion& motion, double t, double dt)
{
    const UniformGrid<D> grid = gridOf<D>(c);
    CutGrid<D> cut;
    for (int d = 0; d < D; ++d)
    {
        cut.aperture[d] = openOfSides(grid, sides, d);
        cut.wallVelocity[d] = sides.wallVelocity[d];
    }
    std::vector<Obstacle<D>> in;
    in.reserve(obstacles.size());
    for (const PicObstacle& o : obstacles) in.push_back(obstacleOf<D>(c, o, motion, t, dt));
    cutObstacles(grid, in, dt, cut);
    PicCut out;
    for (int d = 0; d < D; ++d)
    {
        out.walls.aperture[d] = std::move(cut.aperture[d]);
        if (cut.moves) out.walls.wallVelocity[d] = std::move(cut.wallVelocity[d]);
    }
    out.nodeDistance = std::move(cut.distance);
    for (int d = 0; d < D; ++d) out.sealed[d] = std::move(cut.sealed[d]);
    out.moves = cut.moves;
    return out;
}

} // namespace

PicCut cutWalls(const PicConfig& c, const PicWalls& sides,
    const std::vector<PicObstacle>& obstacles, const WallMotion& motion, double t, double dt)
{
    return c.dimensions == 2 ? cutIn<2>(c, sides, obstacles, motion, t, dt)
                             : cutIn<3>(c, sides, obstacles, motion, t, dt);
}

template<int D>
WallParts<D> partsOfWalls(const PicConfig& c, const PicWalls& sides,
    const std::vector<PicObstacle>& obstacles, const WallMotion& motion, double t)
{
    const UniformGrid<D> grid = gridOf<D>(c);
    WallParts<D> parts;
    PicCut cut = cutIn<D>(c, sides, obstacles, motion, t, 1);
    std::vector<double> open[D];
    for (int d = 0; d < D; ++d)
    {
        parts.aperture[d] = std::move(cut.walls.aperture[d]);
        open[d] = openOfSides(grid, sides, d);
    }
    parts.distance = std::move(cut.nodeDistance);
    std::vector<Obstacle<D>> in;
    for (const PicObstacle& o : obstacles)
    {
        in.push_back(obstacleOf<D>(c, o, motion, t, 1));
        addObstacle(grid, in.back(), o.part, parts);
    }
    dropCovered(grid, in, parts);
    addSides(grid, open, sides.part, parts);
    return parts;
}

template WallParts<2> partsOfWalls<2>(
    const PicConfig&, const PicWalls&, const std::vector<PicObstacle>&, const WallMotion&, double);
template WallParts<3> partsOfWalls<3>(
    const PicConfig&, const PicWalls&, const std::vector<PicObstacle>&, const WallMotion&, double);

} // namespace riprap

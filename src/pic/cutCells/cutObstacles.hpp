/*  What obstacles leave open of the faces of a grid, and how fast they close the rest.

    Solids that are thick against a cell cut faces by their signed distances. Thin ones (sheets;
    bodies in which no node or centre of a cell lies deeper than thinDepth cells) also close every
    face between two cells whose centres they part, whole: a path of water leads from centre to
    centre through faces, so that none leads through a thin wall, however it lies.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <optional>
#include "pic/cutCells/obstacleDistance.hpp"

namespace riprap
{

static constexpr double thinDepth = 1;

//- What is open, what moves: faces in the order of UniformGrid, nodes in that of NodeGrid
template<int D>
struct CutGrid
{
    std::vector<double> aperture[D], wallVelocity[D];   // in: of the sides of the domain
    std::vector<double> distance;                       // of the nearest solid, at the nodes
    std::vector<char> sealed[D];                        // faces that a thin wall closes
    bool moves = false;                                 // is there a wall velocity anywhere?
};

//- Is it nowhere deeper than a cell?
template<int D>
bool isThin(const UniformGrid<D>& grid, const Obstacle<D>& o, const std::vector<double>& distance)
{
    if (!o.closed) return true;
    const double deepest = *std::min_element(distance.begin(), distance.end());
    return deepest > -thinDepth*grid.h*(1 - 1e-9);
}

//- Faces that part the centres of two cells: closed[d], 1 a face, and the element that does it
template<int D>
void partedFaces(const UniformGrid<D>& grid, const Obstacle<D>& o, std::vector<char>* closed)
{
    Lattice<D> l = Lattice<D>::centres(grid);
    // a surface through a centre has it on one side for lines of any direction: centres are moved
    // by a hair, along no surface that a user would draw
    constexpr double hair[3] = {1.3e-7, 3.7e-7, 6.1e-7};
    for (int d = 0; d < D; ++d) l.origin[d] += hair[d]*grid.h;
    for (int e = 0; e < int(o.elements.size()); ++e)
        for (int d = 0; d < D; ++d)
        {
            Lattice<D> lines = l;
            lines.n[d] = 1;
            lines.origin[d] = o.vertices[o.elements[e][0]][d];
            eachNear(lines, o, e, 1e-9*grid.h, [&](const int* x)
            {
                eachCrossing(o, e, d, l.position(x), [&](double at)
                {
                    // between centres c - 1 and c: face c. The first and the last half cell end at
                    // the sides of the domain
                    const int c = int(std::floor((at - l.origin[d])/l.h)) + 1;
                    if (c < 0 || c > grid.n[d]) return;
                    typename UniformGrid<D>::Index f{{x[0], x[1], x[2]}};
                    f.c[d] = c;
                    closed[d][grid.face(d, f)] = 1;
                    if (grid.periodic[d] && (c == 0 || c == grid.n[d]))
                    {
                        f.c[d] = grid.n[d] - c;
                        closed[d][grid.face(d, f)] = 1;
                    }
                });
            });
        }
}

//- Velocity of an obstacle at a point: the rigid motion that takes its vertices from one pose to
//  the other
template<int D>
struct RigidVelocity
{
    Vec<D, double> at, velocity;
    double spin[3] = {0, 0, 0};         // about the axes; 2D: the last

    RigidVelocity(const Obstacle<D>& o, double dt)
    {
        // least squares over all vertices: exact for a rigid motion, to the order of the step
        const int n = int(o.vertices.size());
        Vec<D, double> from = filled<D>(0.0), to = filled<D>(0.0);
        for (int i = 0; i < n; ++i)
        {
            from = from + (1.0/n)*o.vertices[i];
            to = to + (1.0/n)*o.next[i];
        }
        at = 0.5*(from + to);
        velocity = (1/dt)*(to - from);
        double inertia[3][3] = {}, moment[3] = {};
        for (int i = 0; i < n; ++i)
        {
            double r[3] = {0, 0, 0}, v[3] = {0, 0, 0};
            for (int d = 0; d < D; ++d)
            {
                r[d] = 0.5*(o.vertices[i][d] + o.next[i][d]) - at[d];
                v[d] = (o.next[i][d] - o.vertices[i][d])/dt - velocity[d];
            }
            const double r2 = r[0]*r[0] + r[1]*r[1] + r[2]*r[2];
            for (int a = 0; a < 3; ++a)
            {
                moment[a] += r[(a + 1) % 3]*v[(a + 2) % 3] - r[(a + 2) % 3]*v[(a + 1) % 3];
                for (int b = 0; b < 3; ++b) inertia[a][b] += (a == b ? r2 : 0) - r[a]*r[b];
            }
        }
        if (D == 2) spin[2] = inertia[2][2] > 0 ? moment[2]/inertia[2][2] : 0;
        else solve3(inertia, moment, spin);
    }

    double along(int d, const Vec<D, double>& x) const
    {
        double r[3] = {0, 0, 0};
        for (int e = 0; e < D; ++e) r[e] = x[e] - at[e];
        const int a = (d + 1) % 3, b = (d + 2) % 3;
        return velocity[d] + spin[a]*r[b] - spin[b]*r[a];
    }

private:

    //- By Cramer's rule; vertices on a line leave the spin about it, which moves nothing, zero
    static void solve3(const double m[3][3], const double* rhs, double* x)
    {
        double c[3][3];
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                c[i][j] = m[(i + 1) % 3][(j + 1) % 3]*m[(i + 2) % 3][(j + 2) % 3]
                    - m[(i + 1) % 3][(j + 2) % 3]*m[(i + 2) % 3][(j + 1) % 3];
        const double det = m[0][0]*c[0][0] + m[0][1]*c[0][1] + m[0][2]*c[0][2],
                     trace = m[0][0] + m[1][1] + m[2][2];
        if (!(det > 1e-12*trace*trace*trace)) return;
        for (int i = 0; i < 3; ++i) x[i] = (c[0][i]*rhs[0] + c[1][i]*rhs[1] + c[2][i]*rhs[2])/det;
    }
};

//- Middle of the solid part of a face, else of the face
template<int D>
Vec<D, double> solidMiddle(const NodeGrid<D>& nodes, int d,
    const typename UniformGrid<D>::Index& face, const SolidPart<D>& part)
{
    Vec<D, double> x;
    int m = 0;
    for (int e = 0; e < D; ++e)
        x[e] = nodes.grid.origin[e]
            + nodes.grid.h
                *(face.c[e]
                    + (e == d ? 0
                            : part.share > 0 ? part.moment[m++]/part.share
                                             : 0.5));
    return x;
}

//- What obstacles leave of faces: of each closed ones, the part of those that move, and that times
//  their velocity
template<int D>
void closeFaces(const NodeGrid<D>& nodes, const std::vector<char>* closed,
    const std::vector<double>* share, const std::vector<double>* flux, CutGrid<D>& out)
{
    const UniformGrid<D>& grid = nodes.grid;
    for (int d = 0; d < D; ++d)
        for (int f = 0; f < grid.faces(d); ++f)
        {
            const double before = out.aperture[d][f];
            double open = closed[d][f] ? 0
                                       : before
                    *(1 - solidOfFace(nodes, d, grid.faceIndex(d, f), out.distance.data()).share);
            if (open < smallestAperture) open = 0;
            const double velocity = share[d][f] > 0 ? flux[d][f]/share[d][f] : 0;
            if (open < 1)
                out.wallVelocity[d][f] = ((1 - before)*out.wallVelocity[d][f]
                                             + (before - open)*velocity)
                    /(1 - open);
            out.aperture[d][f] = open;
        }
}

//- Cuts a grid by obstacles; dt: of the step that moves those that move
template<int D>
void cutObstacles(const UniformGrid<D>& grid, const std::vector<Obstacle<D>>& obstacles, double dt,
    CutGrid<D>& out)
{
    const NodeGrid<D> nodes{grid};
    out.distance.assign(nodes.count(), bandNodes*grid.h);
    std::vector<char> closed[D];
    // of moving solids: part of the face, and times their velocity
    std::vector<double> share[D], flux[D];
    out.moves = false;
    for (int d = 0; d < D; ++d)
    {
        closed[d].assign(grid.faces(d), 0);
        share[d].assign(grid.faces(d), 0);
        flux[d].assign(grid.faces(d), 0);
        out.wallVelocity[d].resize(grid.faces(d), 0);
        for (const double w : out.wallVelocity[d]) out.moves = out.moves || w != 0;
    }
    for (const Obstacle<D>& o : obstacles)
    {
        const std::vector<double> distance = obstacleDistance(grid, o);
        if (o.closed)
            for (std::size_t i = 0; i < distance.size(); ++i)
                out.distance[i] = std::min(out.distance[i], distance[i]);
        std::vector<char> parted[D];
        const bool thin = isThin(grid, o, distance);
        for (int d = 0; d < D; ++d) parted[d].assign(grid.faces(d), 0);
        if (thin) partedFaces(grid, o, parted);
        for (int d = 0; d < D; ++d)
            for (int f = 0; f < grid.faces(d); ++f) closed[d][f] = closed[d][f] || parted[d][f];
        out.moves = out.moves || o.moves();
        std::optional<RigidVelocity<D>> motion;
        if (o.moves()) motion.emplace(o, dt);
        for (int d = 0; d < D; ++d)
            for (int f = 0; f < grid.faces(d); ++f)
            {
                const auto x = grid.faceIndex(d, f);
                SolidPart<D> part{};
                if (o.closed) part = solidOfFace(nodes, d, x, distance.data());
                const double own = parted[d][f] ? 1 : part.share;
                share[d][f] += own;
                if (motion && own > 0)
                    flux[d][f] += own*motion->along(d, solidMiddle(nodes, d, x, part));
            }
    }
    closeFaces(nodes, closed, share, flux, out);
    for (int d = 0; d < D; ++d) out.sealed[d].swap(closed[d]);
}

} // namespace riprap

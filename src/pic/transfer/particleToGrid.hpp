/*  Particles to grid: mass and momentum at the faces of one direction.

        m_f = sum_p W(x_f - x_p),       m_f u_f = sum_p W(x_f - x_p) (v_p + C_p.(x_f - x_p))

    in units of a particle's mass; C_p only with APIC (Jiang et al. 2015, Eqs. 8-10). W, a product of B-splines, sums to one over the faces: mass and momentum
    are conserved to round-off, and with APIC angular momentum about the nodes. At the sides of the block images of the particles count as well (mirror.hpp):
    the mass stays, the wall takes momentum. What runs along a side that water sticks to has no image: the particles' gradients tell what it is there.

    In two passes, so that the weights of a particle are found once: each cell sums its own particles over the faces that they can see; each face
    adds what the cells about it have for it, in their order: the same input gives the same bits.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include "core/cellSort.hpp"
#include "pic/particles.hpp"
#include "pic/shapes/bSpline.hpp"
#include "pic/transfer/near.hpp"

namespace riprap
{

//- Faces that particles of a cell can see: along the faces' own direction from cell + low on, count of them; across it likewise
template<int Order>
struct SeenFaces
{
    static constexpr int low = Order == 1 ? 0 : -1, count = Order == 1 ? 2 : 4;
    static constexpr int lowAcross = Order == 3 ? -2 : -1, countAcross = Order == 3 ? 5 : 3;

    template<int D> static constexpr int all() { return count*countAcross*(D == 3 ? countAcross : 1); }
};

//- 1 for each cell that has particles
struct HasParticles
{
    static constexpr const char* name = "hasParticles";
    const int* start;
    int cells;
    int* slot;                  // cells + 1
    HD void operator()(int c) const { slot[c] = c < cells && start[c + 1] > start[c]; }
};

//- Sums of a cell's particles; those for one of its faces stand `stride` apart from those for the next
template<int Order, int D, class R>
struct SumCells
{
    static constexpr const char* name = "particleToGrid";
    using Seen = SeenFaces<Order>;
    UniformGrid<D> grid;
    PicParticles<D, R> particles;
    int component;
    bool affine;
    const int* slot;            // of a cell that has particles
    int stride;
    R* mass;
    R* momentum;

    //- The directions across the faces' own
    HD int across(int k) const { return component <= k ? k + 1 : k; }

    HD void operator()(int cell) const
    {
        const int from = particles.start[cell], to = particles.start[cell + 1];
        if (from == to) return;
        R m[Seen::template all<D>()] = {}, mv[Seen::template all<D>()] = {};
        const typename UniformGrid<D>::Index at = grid.cellIndex(cell);
        for (int p = from; p < to; ++p) affine ? add<true>(at, p, m, mv) : add<false>(at, p, m, mv);
        for (int k = 0; k < Seen::template all<D>(); ++k)
        {
            mass[std::size_t(k)*stride + slot[cell]] = m[k];
            momentum[std::size_t(k)*stride + slot[cell]] = mv[k];
        }
    }

private:

    //- Weights of `Count` faces along an axis, the first of which lies at s0 (in cells), and how the affine part changes along it
    template<bool Affine, int Count>
    HD void along(int axis, double s0, int p, R* w, R* change) const
    {
        const R s = R(s0 - particles.x[axis][p]/grid.h);
        const R slope = Affine ? particles.affine[component*D + axis][p]*R(grid.h) : R(0);
        for (int i = 0; i < Count; ++i)
        {
            w[i] = BSpline<Order>::value(s + i);
            change[i] = slope*(s + i);
        }
    }

    template<bool Affine>
    HD void add(const typename UniformGrid<D>::Index& at, int p, R* m, R* mv) const
    {
        constexpr int n = Seen::count, b = Seen::countAcross, c = D == 3 ? Seen::countAcross : 1;
        R wn[n], wb[b], wc[b] = {R(1)}, cn[n], cb[b], cc[b] = {R(0)};
        along<Affine, n>(component, at.c[component] + Seen::low, p, wn, cn);
        along<Affine, b>(across(0), at.c[across(0)] + Seen::lowAcross + 0.5, p, wb, cb);
        if constexpr (D == 3) along<Affine, b>(across(1), at.c[across(1)] + Seen::lowAcross + 0.5, p, wc, cc);
        const R v = particles.v[component][p];
        for (int k = 0; k < c; ++k)
            for (int j = 0; j < b; ++j)
            {
                const R row = wb[j]*wc[k], speed = v + cb[j] + cc[k];
                for (int i = 0; i < n; ++i)
                {
                    const R w = row*wn[i];
                    m[i + n*(j + b*k)] += w;
                    mv[i + n*(j + b*k)] += w*(Affine ? speed + cn[i] : v);
                }
            }
    }
};

//- A face adds what the cells about it, and about its images beyond the sides, have for it
template<int Order, int D, class R>
struct GatherCells
{
    static constexpr const char* name = "gatherCells";
    using Seen = SeenFaces<Order>;
    UniformGrid<D> grid;
    const int* start;           // of the cells' particles
    int component;
    const int* slot;
    int stride;
    const R* cellMass;
    const R* cellMomentum;
    R* u;                       // velocity [m/s], 0 where no particle is near
    R* mass;                    // in particles

    HD void operator()(int face) const
    {
        const typename UniformGrid<D>::Index at = grid.faceIndex(component, face);
        int place[3][3] = {};
        R sign[3][3];
        int images[3] = {1, 1, 1};
        for (auto& axis : sign) for (R& one : axis) one = 1;
        for (int a = 0; a < D; ++a) images[a] = imagesOf(a, at.c[a], place[a], sign[a]);
        R m = 0, mv = 0;
        for (int k = 0; k < images[2]; ++k)
            for (int j = 0; j < images[1]; ++j)
                for (int i = 0; i < images[0]; ++i)
                    addCells(typename UniformGrid<D>::Index{{place[0][i], place[1][j], place[2][k]}},
                        sign[0][i]*sign[1][j]*sign[2][k], m, mv);
        mass[face] = m;
        u[face] = m > 0 ? mv/m : R(0);
    }

private:

    HD int low(int a) const { return a == component ? Seen::low : Seen::lowAcross; }
    HD int count(int a) const { return a >= D ? 1 : (a == component ? Seen::count : Seen::countAcross); }

    //- The face's place along an axis, and those of its images that a particle in the block can see
    HD int imagesOf(int a, int i, int* place, R* sign) const
    {
        const int n = grid.n[a];
        const bool own = a == component;
        int found = 0;
        place[found++] = i;
        const auto add = [&](int j, R s)
        {
            if (j == i || j < low(a) || j >= n + low(a) + count(a) - 1) return;
            place[found] = j;
            sign[found++] = s;
        };
        if (grid.periodic[a])
        {
            add(i + n, R(1));
            add(i - n, R(1));
        }
        else
        {
            const R odd = own ? R(-1) : R(1);
            if (own || !grid.sticks[a][0]) add(own ? -i : -1 - i, odd);
            if (own || !grid.sticks[a][1]) add(own ? 2*n - i : 2*n - 1 - i, odd);
        }
        return found;
    }

    HD void addCells(const typename UniformGrid<D>::Index& at, R sign, R& m, R& mv) const
    {
        int from[3] = {0, 0, 0}, to[3] = {0, 0, 0};         // cells that see the face
        for (int a = 0; a < D; ++a)
        {
            from[a] = at.c[a] - low(a) - count(a) + 1;
            to[a] = at.c[a] - low(a);
            from[a] = from[a] < 0 ? 0 : from[a];
            to[a] = to[a] >= grid.n[a] ? grid.n[a] - 1 : to[a];
        }
        const int step[3] = {stepOf(0), stepOf(1), stepOf(2)};
        for (int k = from[2]; k <= to[2]; ++k)
            for (int j = from[1]; j <= to[1]; ++j)
            {
                const int row = grid.n[0]*(j + grid.n[1]*k);
                if (from[0] > to[0] || start[row + to[0] + 1] == start[row + from[0]]) continue;
                const int fixed = step[1]*(at.c[1] - j - low(1)) + (D == 3 ? step[2]*(at.c[2] - k - low(2)) : 0);
                for (int i = from[0]; i <= to[0]; ++i)
                {
                    if (start[row + i + 1] == start[row + i]) continue;
                    const std::size_t number = std::size_t(fixed + step[0]*(at.c[0] - i - low(0)))*stride + slot[row + i];
                    const R seen = cellMass[number];
                    m += seen;
                    mv += sign*cellMomentum[number];
                }
            }
    }

    //- By how much the number of a face within a cell's sums grows along an axis
    HD int stepOf(int a) const { return a == component ? 1 : (a == (component == 0 ? 1 : 0) ? Seen::count : Seen::count*Seen::countAcross); }
};

//- The sums of cells, and the map to the faces
template<class Backend, int D, class R>
class ParticleToGrid
{
public:

    //- After the particles were sorted: which cells have any. sort: theirs
    void prepare(Context<Backend>& context, const UniformGrid<D>& grid, CellSort<Backend>& sort)
    {
        const int cells = grid.cells();
        slot_.allocate(context, std::size_t(cells) + 1);
        forEach(context, cells + 1, HasParticles{sort.start(), cells, slot_.data()});
        sort.scan(context, slot_.data(), cells + 1);
        context.toHost(&occupied_, slot_.data() + cells, sizeof(int));
    }

    //- Velocity u and mass of all faces of one direction
    template<int Order>
    void map(Context<Backend>& context, const UniformGrid<D>& grid, const PicParticles<D, R>& particles, int component, bool affine, R* u, R* mass)
    {
        const int stride = std::max(occupied_, 1);
        const std::size_t all = std::size_t(stride)*SeenFaces<Order>::template all<D>();
        for (auto& a : sums_) if (a.size() < all) a.allocate(context, all + all/8);
        forEach(context, grid.cells(), SumCells<Order, D, R>{grid, particles, component, affine, slot_.data(), stride, sums_[0].data(), sums_[1].data()});
        forEach(context, grid.faces(component), GatherCells<Order, D, R>
            {grid, particles.start, component, slot_.data(), stride, sums_[0].data(), sums_[1].data(), u, mass});
    }

    std::size_t bytes() const { return slot_.bytes() + sums_[0].bytes() + sums_[1].bytes(); }

private:
    Array<Backend, int> slot_;          // of a cell among those with particles
    Array<Backend, R> sums_[2];         // mass, momentum
    int occupied_ = 0;
};

} // namespace riprap

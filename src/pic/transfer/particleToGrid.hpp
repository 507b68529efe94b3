/*  Particles to grid: mass and momentum at the faces of one direction.

        m_f = sum_p W(x_f - x_p),       m_f u_f = sum_p W(x_f - x_p) (v_p + C_p.(x_f - x_p))

    in units of a particle's mass; C_p only with APIC (Jiang et al. 2015, Eqs. 8-10). W, a product
    of B-splines, sums to one over the faces: mass and momentum are conserved to round-off, and with
    APIC angular momentum about the nodes. At the sides of the block images of the particles count
    as well (mirror.hpp): the mass stays, the wall takes momentum; where water comes in by a side
    that moves with w, images have 2 w - v. What runs along a side that water sticks to has no
    image: the particles' gradients tell what it is there.

    In two passes, so that the weights of a particle are found once: a block of threads takes a tile
    of 64 cells, each of which sums its own particles over the faces that they can see; then cell by
    cell of that neighbourhood all of them add theirs to the tile's sums, different cells to
    different faces. Each face adds what the tiles about it have for it, in their order: the same
    input gives the same bits.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include "core/backend/blocks.hpp"
#include "pic/grid/activeRows.hpp"
#include "pic/grid/particles.hpp"
#include "pic/transfer/bSpline.hpp"
#include "pic/grid/mirror.hpp"

namespace riprap
{

//- Faces that particles of a cell can see: along the faces' own direction from cell + low on, count
//  of them; across it likewise
template<int Order>
struct SeenFaces
{
    static constexpr int low = Order == 1 ? 0 : -1, count = Order == 1 ? 2 : 4;
    static constexpr int lowAcross = Order == 3 ? -2 : -1, countAcross = Order == 3 ? 5 : 3;

    template<int D> static constexpr int all()
    {
        return count*countAcross*(D == 3 ? countAcross : 1);
    }

    //- Along an axis, of all cells of a tile
    template<int D> HD static constexpr int ofTile(bool own)
    {
        return CellTiles<D>::side - 1 + (own ? count : countAcross);
    }
    template<int D> HD static constexpr int allOfTile()
    {
        return ofTile<D>(true)*ofTile<D>(false)*(D == 3 ? ofTile<D>(false) : 1);
    }
};

template<class R>
struct alignas(2*sizeof(R)) FaceSum { R mass, momentum; };

//- Of a direction, where particles of slow tiles stay as they are for several steps
//  (pic/multirate): their sums are kept; what the grid has changed since is added to them
template<int D, class R>
struct SlowSums
{
    TileList<D> current, summed;    // tiles of other particles; slow ones that are to be summed
    const int* slot;                // where the sums of `summed` go
    const int* place;               // of all tiles, as GatherTiles has it
    FaceSum<R>* sums;
    const R* change;                // of the faces' velocities [m/s]
};

//- Sums of the tiles that have particles
template<int Order, int D, class R, int Component, bool Affine>
struct SumTiles
{
    static constexpr const char* name = "particleToGrid";
    static constexpr int threads = CellTiles<D>::cells;
    // measured to be fastest
    static constexpr int residentBlocks = D == 3 && Order == 2 && sizeof(R) == 4 ? (Affine ? 8 : 10)
                                                                                 : 0;
    using Seen = SeenFaces<Order>;
    using Index = typename UniformGrid<D>::Index;
    static constexpr int all = Seen::template all<D>(), allOfTile = Seen::template allOfTile<D>();
    struct Shared { FaceSum<R> sum[allOfTile]; };

    UniformGrid<D> grid;
    CellTiles<D> tiles;
    const int* list;
    PicParticles<D, R> particles;
    FaceSum<R>* sums;           // tile after tile
    const int* slot;            // where those of a tile go; nullptr: in the order of the list

    HD void operator()(const Team& team, Shared& shared, int block) const
    {
        const Index first = tiles.first(list[block]);
        team.each(allOfTile, [&](int k) { shared.sum[k] = FaceSum<R>{R(0), R(0)}; });
        for (int k = team.index; k < threads; k += team.size) addCell(team, shared, first, k);
        const std::size_t to = std::size_t(slot ? slot[block] : block)*allOfTile;
        team.each(allOfTile, [&](int k) { sums[to + k] = shared.sum[k]; });
    }

private:

    //- The directions across the faces' own
    static constexpr int acrossOne = Component == 0 ? 1 : 0, acrossTwo = Component == 2 ? 1 : 2;

    HD static constexpr int ofTile(int a) { return Seen::template ofTile<D>(a == Component); }

    //- What a particle brings
    struct Brought
    {
        R t[D], v, slope[Affine ? D : 1];

        template<int Axis>
        HD R along() const
        {
            if constexpr (Affine) return slope[Axis];
            else return R(0);
        }
    };

    HD Brought read(int p) const
    {
        Brought b;
        const PlaceInCell<R> in = particles.place[p];
        UNROLL
        for (int a = 0; a < D; ++a) b.t[a] = in.t[a];
        b.v = particles.v[Component][p];
        if constexpr (Affine)
        {
            UNROLL
            for (int a = 0; a < D; ++a) b.slope[a] = particles.affine[Component*D + a][p]*R(grid.h);
        }
        return b;
    }

    HD void addCell(const Team& team, Shared& shared, const Index& corner, int number) const
    {
        constexpr int side = CellTiles<D>::side, n = Seen::count, b = Seen::countAcross,
                      c = D == 3 ? b : 1;
        constexpr int stride[3] = {1, ofTile(0), ofTile(0)*ofTile(1)};
        const int local[3] = {number % side, number/side % side, D == 3 ? number/(side*side) : 0};
        Index at = corner;
        bool exists = true;
        int place = 0;
        for (int a = 0; a < D; ++a)
        {
            at.c[a] += local[a];
            exists = exists && at.c[a] < grid.n[a];
            place += local[a]*stride[a];
        }
        R m[all] = {}, mv[all] = {};
        int from = 0, to = 0;
        if (exists)
        {
            const int cell = grid.cell(at);
            from = particles.start[cell];
            to = particles.start[cell + 1];
        }
        if (from < to) addParticles(from, to, m, mv);
        UNROLL
        for (int k = 0; k < c; ++k)
            UNROLL
            for (int j = 0; j < b; ++j)
                UNROLL
                for (int i = 0; i < n; ++i)
                {
                    if (from < to)
                    {
                        FaceSum<R>& sum = shared.sum[place + i*stride[Component]
                            + j*stride[acrossOne] + (D == 3 ? k*stride[acrossTwo] : 0)];
                        sum.mass += m[i + n*(j + b*k)];
                        sum.momentum += mv[i + n*(j + b*k)];
                    }
                    team.wait();
                }
    }

    //- The next particle is read while one is added
    HD void addParticles(int from, int to, R* m, R* mv) const
    {
        Brought next = read(from);
        for (int p = from; p < to; ++p)
        {
            const Brought now = next;
            if (p + 1 < to) next = read(p + 1);
            add(now, m, mv);
        }
    }

    //- Weights of the faces along an axis that particles of a cell see, and how the affine part
    //  changes along it; t: where in the cell, 0 .. 1
    template<bool Own>
    HD void along(R t, R slope, R* w, R* change) const
    {
        constexpr int seen = Own ? Seen::count : Seen::countAcross, nodes = Order + 1;
        constexpr R first = Own ? R(Seen::low) : R(Seen::lowAcross) + R(0.5);
        // which of them have a weight depends on the half of the cell
        const bool upper = seen > nodes && t >= R(0.5);
        R weight[nodes];
        BSpline<Order>::weights(t - first - (upper ? R(1) : R(0)), weight);
        UNROLL
        for (int i = 0; i < seen; ++i)
        {
            const R inLower = i < nodes ? weight[i < nodes ? i : 0] : R(0),
                    inUpper = i > 0 ? weight[i > 0 ? i - 1 : 0] : R(0);
            w[i] = upper ? inUpper : inLower;
            change[i] = Affine ? slope*(first + i - t) : R(0);
        }
    }

    HD void add(const Brought& p, R* m, R* mv) const
    {
        constexpr int n = Seen::count, b = Seen::countAcross, c = D == 3 ? b : 1;
        R wn[n], wb[b], wc[b] = {R(1)}, cn[n], cb[b], cc[b] = {R(0)};
        along<true>(p.t[Component], p.template along<Component>(), wn, cn);
        along<false>(p.t[acrossOne], p.template along<acrossOne>(), wb, cb);
        if constexpr (D == 3) along<false>(p.t[acrossTwo], p.template along<acrossTwo>(), wc, cc);
        UNROLL
        for (int i = 0; i < n; ++i) cn[i] *= wn[i];
        UNROLL
        for (int k = 0; k < c; ++k)
            UNROLL
            for (int j = 0; j < b; ++j)
            {
                const R row = wb[j]*wc[k], moving = row*(Affine ? p.v + cb[j] + cc[k] : p.v);
                UNROLL
                for (int i = 0; i < n; ++i)
                {
                    m[i + n*(j + b*k)] += row*wn[i];
                    mv[i + n*(j + b*k)] += moving*wn[i];
                    if constexpr (Affine) mv[i + n*(j + b*k)] += row*cn[i];
                }
            }
    }
};

//- A face adds what the tiles about it, and about its images beyond the sides, have for it.
//  Slow: places of slow tiles are below -1, -2 - slot; the mass m_s of their particles has m_s du
//  more momentum than their sums say
template<int Order, int D, class R, bool Slow = false>
struct GatherTiles
{
    static constexpr const char* name = "gatherTiles";
    using Seen = SeenFaces<Order>;
    UniformGrid<D> grid;
    CellTiles<D> tiles;
    const int* placeOf;         // of a tile among those that have particles; -1: it has none
    int component;
    const FaceSum<R>* sums;
    // velocities of the step before, which sides have; nullptr: sides rest
    const R* last;
    R* u;                       // velocity [m/s], 0 where no particle is near
    R* mass;                    // in particles
    const FaceSum<R>* slow;     // of slow tiles
    const R* change;            // du of the faces

    HD void operator()(int face, const typename UniformGrid<D>::Index& at) const
    {
        R m = 0, mv = 0, ofSlow = 0;
        // farther from the sides than a particle sees
        if (inner(grid, at, 3)) addTiles(at, R(1), m, mv, ofSlow);
        else addWithImages(at, m, mv, ofSlow);
        if constexpr (Slow) mv += ofSlow*change[face];
        mass[face] = m;
        u[face] = m > 0 ? mv/m : R(0);
    }

private:

    HD void addWithImages(
        const typename UniformGrid<D>::Index& at, R& m, R& mv, R& ofSlow) const
    {
        int place[3][3] = {};
        R sign[3][3];
        int images[3] = {1, 1, 1};
        for (auto& axis : sign) for (R& one : axis) one = 1;
        for (int a = 0; a < D; ++a) images[a] = imagesOf(a, at.c[a], place[a], sign[a]);
        const int own = component;
        for (int k = 0; k < images[2]; ++k)
            for (int j = 0; j < images[1]; ++j)
                for (int i = 0; i < images[0]; ++i)
                {
                    const R before = m, odd = sign[0][i]*sign[1][j]*sign[2][k];
                    const typename UniformGrid<D>::Index image{
                        {place[0][i], place[1][j], place[2][k]}};
                    addTiles(image, odd, m, mv, ofSlow);
                    if (!last || !(odd < 0)) continue;
                    typename UniformGrid<D>::Index side = at;
                    side.c[own] = image.c[own] < at.c[own] ? 0 : grid.n[own];
                    mv += 2*last[grid.face(own, side)]*(m - before);
                }
    }

    HD int low(int a) const { return a == component ? Seen::low : Seen::lowAcross; }
    HD int count(int a) const
    {
        return a >= D ? 1 : (a == component ? Seen::count : Seen::countAcross);
    }

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

    //- What a tile that has this place has for one of the faces that it sees
    HD FaceSum<R> sumOf(int tile, int number) const
    {
        constexpr int each = Seen::template allOfTile<D>();
        return Slow && tile < 0 ? slow[std::size_t(-2 - tile)*each + number]
                                : sums[std::size_t(tile)*each + number];
    }

    //- All places are read before any sum, so that a thread waits twice
    HD void addTiles(const typename UniformGrid<D>::Index& at, R sign, R& m, R& mv,
        [[maybe_unused]] R& ofSlow) const
    {
        // tiles along an axis that have a face
        constexpr int side = CellTiles<D>::side, most = 2;
        // within: place in the first tile of all
        int from[3] = {0, 0, 0}, count[3] = {1, 1, 1}, within[3] = {0, 0, 0}, stride[3] = {1, 1, 1};
        UNROLL
        for (int a = 0; a < D; ++a)
        {
            constexpr int shortest = Seen::template ofTile<D>(false)
                    < Seen::template ofTile<D>(true)
                ? Seen::template ofTile<D>(false)
                : Seen::template ofTile<D>(true);
            static_assert(shortest >= side && Seen::template ofTile<D>(true) <= most*side
                    && Seen::template ofTile<D>(false) <= most*side,
                "a face is seen by one tile or two along an axis");
            const int faces = Seen::template ofTile<D>(a == component);
            within[a] = at.c[a] - low(a);
            from[a] = within[a] < faces ? 0 : (within[a] - faces + side)/side;
            const int to = within[a]/side;
            count[a] = (to < tiles.n[a] ? to : tiles.n[a] - 1) - from[a] + 1;
            if (a < 2) stride[a + 1] = stride[a]*faces;
        }
        constexpr int along = D == 3 ? most : 1;
        int place[along][most][most];
        UNROLL
        for (int k = 0; k < along; ++k)
            UNROLL
            for (int j = 0; j < most; ++j)
                UNROLL
                for (int i = 0; i < most; ++i)
                {
                    const bool is = i < count[0] && j < count[1] && (D < 3 || k < count[2]);
                    place[k][j][i] = is ? placeOf[from[0] + i
                                         + tiles.n[0]*(from[1] + j + tiles.n[1]*(from[2] + k))]
                                        : -1;
                }
        UNROLL
        for (int k = 0; k < along; ++k)
            UNROLL
            for (int j = 0; j < most; ++j)
                UNROLL
                for (int i = 0; i < most; ++i)
                {
                    const int own = place[k][j][i];
                    if (Slow ? own == -1 : own < 0) continue;
                    int number = within[0] - side*(from[0] + i)
                        + stride[1]*(within[1] - side*(from[1] + j));
                    if constexpr (D == 3) number += stride[2]*(within[2] - side*(from[2] + k));
                    const FaceSum<R> sum = sumOf(own, number);
                    if (Slow && own < 0) ofSlow += sum.mass;
                    m += sum.mass;
                    mv += sign*sum.momentum;
                }
    }
};

//- The sums of tiles, and the map to the faces
template<class Backend, int D, class R>
class ParticleToGrid
{
public:

    //- After the particles were sorted: which tiles have any. sort: theirs
    void prepare(Context<Backend>& context, const UniformGrid<D>& grid, CellSort<Backend>& sort)
    {
        occupied_.find(context, grid, sort);
    }

    //- Velocity u and mass of the faces of one direction that rows have. last: what sides have that
    //  move, nullptr: they rest. slow: nullptr, no tiles are
    template<int Order>
    void map(Context<Backend>& context, const UniformGrid<D>& grid,
        const ActiveRows<Backend, D>& rows, const PicParticles<D, R>& particles, int component,
        bool affine, const R* last, R* u, R* mass, const SlowSums<D, R>* slow = nullptr)
    {
        const TileList<D> current = slow ? slow->current : TileList<D>(occupied_);
        const std::size_t all = std::size_t(std::max(current.count, 1))
            *SeenFaces<Order>::template allOfTile<D>();
        if (sums_.size() < all) sums_.allocate(context, all + all/8);
        sumTiles<Order>(
            context, grid, particles, component, affine, current, nullptr, sums_.data());
        if (!slow)
        {
            rows.eachFaceOfBoth(context, component,
                GatherTiles<Order, D, R>{grid, current.tiles, occupied_.place(), component,
                    sums_.data(), last, u, mass, nullptr, nullptr});
            return;
        }
        sumTiles<Order>(context, grid, particles, component, affine, slow->summed, slow->slot,
            slow->sums);
        rows.eachFaceOfBoth(context, component,
            GatherTiles<Order, D, R, true>{grid, current.tiles, slow->place, component,
                sums_.data(), last, u, mass, slow->sums, slow->change});
    }

    const OccupiedTiles<Backend, D>& occupied() const { return occupied_; }
    std::size_t bytes() const { return occupied_.bytes() + sums_.bytes(); }

private:

    template<int Order>
    static void sumTiles(Context<Backend>& context, const UniformGrid<D>& grid,
        const PicParticles<D, R>& particles, int component, bool affine, const TileList<D>& of,
        const int* slot, FaceSum<R>* sums)
    {
        const auto sum = [&](auto direction, auto withGradient)
        {
            forEachBlock(context, of.count,
                SumTiles<Order, D, R, decltype(direction)::value, decltype(withGradient)::value>{
                    grid, of.tiles, of.list, particles, sums, slot});
        };
        const auto sumAlong = [&](auto direction)
        { affine ? sum(direction, std::true_type()) : sum(direction, std::false_type()); };
        if (component == 0) sumAlong(std::integral_constant<int, 0>());
        else if (component == 1) sumAlong(std::integral_constant<int, 1>());
        else if constexpr (D == 3) sumAlong(std::integral_constant<int, 2>());
    }

    OccupiedTiles<Backend, D> occupied_;
    Array<Backend, FaceSum<R>> sums_;
};

} // namespace riprap

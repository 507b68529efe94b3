/*  Where there is something to do about the water: rows of 32 cells that have water or particles
    within `reach` cells.

    Passes over these alone cost what the water costs, whatever the box around it. Found by tiles,
    hence somewhat generous. Rows that the water has left since they were last found are listed
    after them: passes that must leave no trace there visit those, too.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <type_traits>
#include "core/loops/rows.hpp"
#include "pic/grid/tiles.hpp"

namespace riprap
{

//- 1 for each tile that has particles or a cell in the water
template<int D, class R>
struct HasWater
{
    static constexpr const char* name = "hasWater";
    UniformGrid<D> grid;
    CellTiles<D> tiles;
    const int* place;           // of tiles that have particles; -1: none
    const R* phi;
    unsigned char* has;

    HD void operator()(int t) const
    {
        bool found = place[t] >= 0;
        const typename UniformGrid<D>::Index first = tiles.first(t);
        for (int k = 0; k < tiles.cells && !found; ++k)
        {
            typename UniformGrid<D>::Index c = first;
            c.c[0] += k % tiles.side;
            c.c[1] += k/tiles.side % tiles.side;
            if constexpr (D == 3) c.c[2] += k/(tiles.side*tiles.side);
            bool in = true;
            for (int d = 0; d < D; ++d) in = in && c.c[d] < grid.n[d];
            found = in && phi[grid.cell(c)] < R(0);
        }
        has[t] = found;
    }
};

//- 1 for each tile that has one of those about it
template<int D>
struct IsNearWater
{
    static constexpr const char* name = "isNearWater";
    CellTiles<D> tiles;
    bool periodic[D];
    const unsigned char* has;
    unsigned char* near;
    int reach;                  // in tiles

    HD void operator()(int t) const
    {
        const int at[3] = {t % tiles.n[0], t/tiles.n[0] % tiles.n[1], t/(tiles.n[0]*tiles.n[1])};
        bool found = false;
        for (int k = (D == 3 ? -reach : 0); k <= (D == 3 ? reach : 0) && !found; ++k)
            for (int j = -reach; j <= reach && !found; ++j)
                for (int i = -reach; i <= reach; ++i)
                {
                    int c[3] = {at[0] + i, at[1] + j, at[2] + k};
                    bool exists = true;
                    for (int d = 0; d < D; ++d)
                    {
                        const int n = tiles.n[d];
                        if (periodic[d]) c[d] = (c[d] + reach*n) % n;
                        exists = exists && c[d] >= 0 && c[d] < n;
                    }
                    found = found || (exists && has[c[0] + tiles.n[0]*(c[1] + tiles.n[1]*c[2])]);
                }
        near[t] = found;
    }
};

//- Cell rows of 32, one after the other along the first axis
template<int D>
struct CellRows
{
    static constexpr int length = 32;
    int n[3] = {1, 1, 1};       // rows along each axis

    CellRows() = default;
    explicit CellRows(const UniformGrid<D>& g)
    {
        for (int d = 0; d < D; ++d) n[d] = g.n[d];
        n[0] = (g.n[0] + length - 1)/length;
    }

    HD int count() const { return n[0]*n[1]*n[2]; }

    HD typename UniformGrid<D>::Index first(int r) const
    { return {{r % n[0]*length, r/n[0] % n[1], r/(n[0]*n[1])}}; }
};

template<int D>
struct FlagRows
{
    static constexpr const char* name = "flagRows";
    CellTiles<D> tiles;
    CellRows<D> rows;
    const unsigned char* near;  // tiles
    const unsigned char* before;    // rows: were they listed the last time?
    int* flag;                  // rows that are, rows that no longer are, and one

    HD void operator()(int r) const
    {
        const int n = rows.count();
        if (r == n) { flag[2*n] = 0; return; }
        flag[r] = 0;
        const typename UniformGrid<D>::Index c = rows.first(r);
        const int row = tiles.n[0]
            *(c.c[1]/tiles.side + (D == 3 ? tiles.n[1]*(c.c[2]/tiles.side) : 0)),
                  from = c.c[0]/tiles.side;
        for (int i = from; i < from + rows.length/tiles.side && i < tiles.n[0]; ++i)
            if (near[row + i]) flag[r] = 1;
        flag[n + r] = before[r] && !flag[r];
    }
};

template<int D>
struct ListRows
{
    static constexpr const char* name = "listRows";
    CellRows<D> rows;
    const int* before;          // flags, summed up
    unsigned char* active;
    Vec<3, int>* list;          // first cells
    int* counts;                // of rows that are, of all that are listed

    HD void operator()(int r) const
    {
        const int n = rows.count();
        active[r] = before[r + 1] > before[r];
        for (const int k : {r, n + r})
            if (before[k + 1] > before[k]) list[before[k]] = rows.first(r);
        if (r > 0) return;
        counts[0] = before[n];
        counts[1] = before[2*n];
    }
};

//- f(number), or f(number, indices) if it takes them, which here are known
template<class F, class Index>
HD void callAt(const F& f, int i, const Index& at)
{
    if constexpr (std::is_invocable_v<const F&, int, const Index&>) f(i, at);
    else f(i);
}

//- Does f add with the indices of a cell?
template<class F, class Index, class = void> struct AddsAt : std::false_type {};
template<class F, class Index>
struct AddsAt<F, Index,
    std::void_t<decltype(std::declval<const F&>().add(
        0, std::declval<const Index&>(), static_cast<double*>(nullptr)))>> : std::true_type
{};

//- Has f a way of its own to deal with a row of cells, from one to before an index along the first
//  axis?
template<class F, class Index, class = void> struct HasRow : std::false_type {};
template<class F, class Index>
struct HasRow<F, Index,
    std::void_t<decltype(std::declval<const F&>().row(std::declval<const Index&>(), 0))>>
    : std::true_type
{};

//- The same of cells whose numbers f is told too?
template<class F, class Index, class = void> struct HasCellRow : std::false_type {};
template<class F, class Index>
struct HasCellRow<F, Index,
    std::void_t<decltype(std::declval<const F&>().row(0, std::declval<const Index&>(), 0))>>
    : std::true_type
{};

//- f(cell's indices) for the cells of listed rows
template<int D, class F>
struct OverRows
{
    static constexpr const char* name = F::name;
    const Vec<3, int>* list;
    int n;                      // cells along the first axis
    F f;

    HD void operator()(int i) const
    {
        typename UniformGrid<D>::Index c = list[i/CellRows<D>::length];
        c.c[0] += i % CellRows<D>::length;
        if (c.c[0] < n) f(c);
    }
};

//- The same row by row, on the CPU
template<int D, class F>
struct WholeRows
{
    static constexpr const char* name = F::name;
    const Vec<3, int>* list;
    int n;
    F f;

    HD void operator()(int r) const
    {
        typename UniformGrid<D>::Index c = list[r];
        const int end = c.c[0] + CellRows<D>::length < n ? c.c[0] + CellRows<D>::length : n;
        if constexpr (HasRow<F, typename UniformGrid<D>::Index>::value) f.row(c, end);
        else for (; c.c[0] < end; ++c.c[0]) f(c);
    }
};

//- Sums over the cells of listed rows
template<int D, class F>
struct SumRows
{
    static constexpr const char* name = F::name;
    UniformGrid<D> grid;
    const Vec<3, int>* list;
    F f;

    HD void add(int i, double* sums) const
    {
        typename UniformGrid<D>::Index c = list[i/CellRows<D>::length];
        c.c[0] += i % CellRows<D>::length;
        if (c.c[0] >= grid.n[0]) return;
        if constexpr (AddsAt<F, typename UniformGrid<D>::Index>::value)
            f.add(grid.cell(c), c, sums);
        else f.add(grid.cell(c), sums);
    }
};

//- f(number of the cell)
template<int D, class F>
struct OverCells
{
    static constexpr const char* name = F::name;
    UniformGrid<D> grid;
    F f;

    HD void operator()(const typename UniformGrid<D>::Index& c) const
    {
        callAt(f, grid.cell(c), c);
    }
    HD void row(typename UniformGrid<D>::Index c, int end) const
    {
        if constexpr (HasCellRow<F, typename UniformGrid<D>::Index>::value)
            f.row(grid.cell(c), c, end);
        else
        {
            const int first = grid.cell(c) - c.c[0];
            INDEPENDENT
            for (; c.c[0] < end; ++c.c[0]) callAt(f, first + c.c[0], c);
        }
    }
};

//- The faces of direction d below the cells of a row, and at the end of the block those above them
template<int D, class F>
HD void rowOfFaces(
    const UniformGrid<D>& grid, int d, const typename UniformGrid<D>::Index& c, int end, const F& f)
{
    for (int side = 0; side < (d > 0 && c.c[d] == grid.n[d] - 1 ? 2 : 1); ++side)
    {
        typename UniformGrid<D>::Index at = c;
        at.c[d] += side;
        const int first = grid.face(d, at) - at.c[0],
                  last = d == 0 && end == grid.n[0] ? end + 1 : end;
        if constexpr (HasCellRow<F, typename UniformGrid<D>::Index>::value)
            f.row(first + at.c[0], at, last);
        else
        {
            INDEPENDENT
            for (; at.c[0] < last; ++at.c[0]) callAt(f, first + at.c[0], at);
        }
    }
}

//- f(number of the face), or f(number, its indices), for the faces of direction d
template<int D, class F>
struct OverFacesOf
{
    static constexpr const char* name = F::name;
    UniformGrid<D> grid;
    int d;
    F f;

    HD void operator()(const typename UniformGrid<D>::Index& c) const
    {
        at(c);
        if (c.c[d] < grid.n[d] - 1) return;
        typename UniformGrid<D>::Index last = c;
        last.c[d] += 1;
        at(last);
    }

    HD void row(const typename UniformGrid<D>::Index& c, int end) const
    {
        rowOfFaces(grid, d, c, end, f);
    }

private:
    HD void at(const typename UniformGrid<D>::Index& face) const
    {
        callAt(f, grid.face(d, face), face);
    }
};

//- f[d](number of the face) for the faces below a cell along each axis d; at the end of the block
//  those above it, too
template<int D, class F>
struct OverFaces
{
    static constexpr const char* name = F::name;
    UniformGrid<D> grid;
    F f[D];

    HD void operator()(const typename UniformGrid<D>::Index& c) const
    {
        for (int d = 0; d < D; ++d)
        {
            callAt(f[d], grid.faceOf(d, c, 0), c);
            if (c.c[d] < grid.n[d] - 1) continue;
            typename UniformGrid<D>::Index last = c;
            last.c[d] += 1;
            callAt(f[d], grid.face(d, last), last);
        }
    }

    HD void row(const typename UniformGrid<D>::Index& c, int end) const
    {
        for (int d = 0; d < D; ++d) rowOfFaces(grid, d, c, end, f[d]);
    }
};

template<class Backend, int D>
class ActiveRows
{
public:
    static constexpr int reach = 8;             // cells

    //- All rows count as listed so far: the first time the arrays' contents are swept away
    //  everywhere
    void forget() { active_ = Array<Backend, unsigned char>(); count_ = all_ = 0; }

    //- Have they been found?
    bool found() const { return active_.size() > 0; }

    //- particles: tiles that have any. sort: whose scratch is used
    template<class R>
    void find(Context<Backend>& context, const UniformGrid<D>& grid,
        const OccupiedTiles<Backend, D>& particles, const R* phi, CellSort<Backend>& sort)
    {
        const CellTiles<D>& tiles = particles.tiles();
        const CellRows<D> rows(grid);
        const int n = rows.count();
        for (auto* a : {&has_, &near_}) a->allocate(context, tiles.count());
        if (!found()) active_.upload(context, std::vector<unsigned char>(n, 1));
        flag_.allocate(context, 2*std::size_t(n) + 1);
        list_.allocate(context, n);
        counts_.allocate(context, 2);
        forEach(context, tiles.count(),
            HasWater<D, R>{grid, tiles, particles.place(), phi, has_.data()});
        IsNearWater<D> near{tiles, {}, has_.data(), near_.data(), reach/tiles.side};
        for (int d = 0; d < D; ++d) near.periodic[d] = grid.periodic[d];
        // the last tile of a ring may be a short one
        for (int d = 0; d < D; ++d) if (grid.periodic[d]) near.reach = reach/tiles.side + 1;
        forEach(context, tiles.count(), near);
        forEach(
            context, n + 1, FlagRows<D>{tiles, rows, near_.data(), active_.data(), flag_.data()});
        sort.scan(context, flag_.data(), 2*n + 1);
        forEach(context, n,
            ListRows<D>{rows, flag_.data(), active_.data(), list_.data(), counts_.data()});
        int counts[2];
        context.toHost(counts, counts_.data(), sizeof(counts));
        count_ = counts[0];
        all_ = counts[1];
        grid_ = grid;
    }

    //- Their first cells
    const Vec<3, int>* list() const { return list_.data(); }
    int count() const { return count_; }

    //- f(indices) for each cell of theirs
    template<class F>
    void each(Context<Backend>& context, const F& f) const { over(context, count_, f); }

    //- f(number of the cell)
    template<class F> void eachCell(Context<Backend>& context, const F& f) const
    {
        over(context, count_, OverCells<D, F>{grid_, f});
    }

    //- The same also where there was water
    template<class F> void eachCellOfBoth(Context<Backend>& context, const F& f) const
    {
        over(context, all_, OverCells<D, F>{grid_, f});
    }

    //- make(d): what is done with the number of each face of direction d that belongs to them
    template<class Make>
    void eachFace(Context<Backend>& context, const Make& make) const
    {
        using F = decltype(make(0));
        if constexpr (D == 2) over(context, count_, OverFaces<D, F>{grid_, {make(0), make(1)}});
        else over(context, count_, OverFaces<D, F>{grid_, {make(0), make(1), make(2)}});
    }

    //- f(number of the face) of direction d, also where there was water
    template<class F> void eachFaceOfBoth(Context<Backend>& context, int d, const F& f) const
    {
        over(context, all_, OverFacesOf<D, F>{grid_, d, f});
    }

    template<int N, class F>
    std::array<double, N> sum(Context<Backend>& context, const F& f) const
    {
        return sumOver<N>(
            context, count_*CellRows<D>::length, SumRows<D, F>{grid_, list_.data(), f});
    }

    std::size_t bytes() const
    {
        return has_.bytes() + near_.bytes() + active_.bytes() + flag_.bytes() + list_.bytes();
    }

private:

    template<class F>
    void over(Context<Backend>& context, int rows, const F& f) const
    {
        if constexpr (Backend::gpu)
            forEach(
                context, rows*CellRows<D>::length, OverRows<D, F>{list_.data(), grid_.n[0], f});
        else forEachRow(context, rows, WholeRows<D, F>{list_.data(), grid_.n[0], f});
    }

    Array<Backend, unsigned char> has_, near_;  // tiles
    Array<Backend, unsigned char> active_;      // rows
    Array<Backend, int> flag_, counts_;
    Array<Backend, Vec<3, int>> list_;
    UniformGrid<D> grid_;
    int count_ = 0, all_ = 0;
};

} // namespace riprap

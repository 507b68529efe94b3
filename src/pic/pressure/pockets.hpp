/*  Water without a surface: connected unknowns of which none is tied to p = 0. Their equations have
    a solution only if the right-hand side sums to zero over the pocket, and then up to a constant.

    Pockets are found by joining cells across open faces to trees whose root is the smallest cell
    number (K. Komura, Comput. Phys. Commun. 194 (2015) 54; each cell begins under a neighbour, and
    ways up are shortened before the joins): the outcome does not depend on the order of the joins.
    What does not sum to zero (round-off, or walls that squeeze a closed volume) is spread over the
    pocket's cells by their diagonals, and p gets a mean of zero in it. Sums over pockets are of
    integers, so that their order does not matter either.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/loops/deviceReduce.hpp"
#include "core/loops/deterministicAtomics.hpp"
#include "pic/pressure/conjugateGradient.hpp"

namespace riprap
{

HD int rootOf(const int* parent, int c)
{
    for (int up = sharedRead(parent + c); up != c; up = sharedRead(parent + c)) c = up;
    return c;
}

//- Joins the trees of two cells under the smaller root
HD void join(int* parent, int a, int b)
{
    a = rootOf(parent, a);
    b = rootOf(parent, b);
    while (a != b)
    {
        if (a < b) { const int c = a; a = b; b = c; }
        const int old = atomicMinimum(parent + a, b);
        if (old == a) return;
        a = rootOf(parent, old);        // another has joined a meanwhile: join that one's root
        b = rootOf(parent, b);
    }
}

//- The neighbour of the smallest number that a cell is joined to, if smaller than its own: its
//  first parent, set without a join
template<int D>
HD int firstParent(const FineData<D>& f, const Place<D>& c)
{
    if (!(f.inverse[c.c] > 0)) return c.c;
    for (int d = D - 1; d >= 0; --d)
        if (f.a[d][c.c] > 0 && f.shape.below(c, d) < c.c) return f.shape.below(c, d);
    return c.c;
}

template<int D>
struct StartPockets
{
    static constexpr const char* name = "pressurePocketStart";
    FineData<D> f;
    TiledCells<D> cells;
    int* parent;
    std::int64_t* sums;     // of a root: three integers

    HD void operator()(int i) const
    {
        Place<D> c;
        if (!cells.at(i, c)) return;
        parent[c.c] = firstParent(f, c);
        for (int k = 0; k < 3; ++k) sums[3*c.c + k] = 0;
    }
};

//- Shorter ways to the root: a cell's parent becomes one a few parents up. Ways grow shorter by
//  that factor each time, whatever the order
template<int D>
struct ShortenPockets
{
    static constexpr const char* name = "pressurePocketShorten";
    static constexpr int parentsUp = 4;
    FineData<D> f;
    TiledCells<D> cells;
    int* parent;

    HD void operator()(int i) const
    {
        Place<D> c;
        if (!cells.at(i, c)) return;
        int up = sharedRead(parent + c.c);
        if (up == c.c) return;
        const int before = up;
        for (int k = 0; k < parentsUp; ++k)
        {
            const int next = sharedRead(parent + up);
            if (next == up) break;
            up = next;
        }
        if (up != before) sharedWrite(parent + c.c, up);
    }
};

template<int D>
struct JoinPockets
{
    static constexpr const char* name = "pressurePocketJoin";
    FineData<D> f;
    TiledCells<D> cells;
    int* parent;

    HD void operator()(int i) const
    {
        Place<D> c;
        if (!cells.at(i, c) || !(f.inverse[c.c] > 0)) return;
        const int joined = firstParent(f, c);
        for (int d = 0; d < D; ++d)
            if (f.a[d][c.c] > 0 && f.shape.below(c, d) != joined)
                join(parent, c.c, f.shape.below(c, d));
    }
};

//- Every cell under its root, which learns whether it is tied
template<int D>
struct CountTies
{
    static constexpr const char* name = "pressurePocketTies";
    FineData<D> f;
    TiledCells<D> cells;
    int* parent;
    std::int64_t* sums;

    HD void operator()(int i) const
    {
        Place<D> c;
        if (!cells.at(i, c) || !(f.inverse[c.c] > 0)) return;
        const int root = rootOf(parent, c.c);
        sharedWrite(parent + c.c, root);
        if (f.s[c.c] > 0) raise(sums + 3*root);
    }
};

//- How large the numbers are that will be summed, and how many cells are in pockets
template<int D>
struct PocketSize
{
    static constexpr const char* name = "pressurePocketSize";
    FineData<D> f;
    TiledCells<D> cells;
    const int* parent;
    const std::int64_t* sums;
    const double* value;

    HD void add(int i, double* total) const
    {
        Place<D> c;
        if (!cells.at(i, c) || !(f.inverse[c.c] > 0) || sums[3*parent[c.c]]) return;
        total[0] += std::fabs(value[c.c]);
        total[1] += 1;
    }
};

//- Of numbers that are summed as integers, whose sizes add up to `total`
HD double pocketScale(double total)
{
    return total > 0 ? 4e18/total : 0;                      // 2^63 is 9.2e18
}

struct KeepScale
{
    static constexpr const char* name = "pressureScalars";
    double* scale;      // and the number of cells

    HD void operator()(const double* total) const
    {
        scale[0] = pocketScale(total[0]);
        scale[1] = total[1];
    }
};

//- A cell's share of what is spread: its diagonal, in 1/1024 of an open face
HD std::int64_t pocketWeight(float inverse)
{
    return std::int64_t(1024.0/double(inverse)) + 1;
}

template<int D>
struct SumPockets
{
    static constexpr const char* name = "pressurePocketSum";
    FineData<D> f;
    TiledCells<D> cells;
    const int* parent;
    std::int64_t* sums;
    const double* value;
    const double* scale;
    bool byDiagonal;

    HD void operator()(int i) const
    {
        Place<D> c;
        if (!cells.at(i, c) || !(f.inverse[c.c] > 0)) return;
        std::int64_t* s = sums + 3*parent[c.c];
        if (s[0]) return;
        addSharedTogether(s + 1, std::int64_t(value[c.c]*scale[0]));
        addSharedTogether(s + 2, byDiagonal ? pocketWeight(f.inverse[c.c]) : 1);
    }
};

//- Takes a pocket's sum from its cells
template<int D>
struct SpreadSum
{
    static constexpr const char* name = "pressurePocketSpread";
    FineData<D> f;
    TiledCells<D> cells;
    const int* parent;
    const std::int64_t* sums;
    double* value;
    const double* scale;
    bool byDiagonal;

    HD void operator()(int i) const
    {
        Place<D> c;
        if (!cells.at(i, c) || !(f.inverse[c.c] > 0)) return;
        const std::int64_t* s = sums + 3*parent[c.c];
        if (s[0] || !(scale[0] > 0)) return;
        const double share = (byDiagonal ? double(pocketWeight(f.inverse[c.c])) : 1.0)/double(s[2]);
        value[c.c] -= double(s[1])/scale[0]*share;
    }
};

template<int D>
struct ClearPocketSums
{
    static constexpr const char* name = "pressurePocketClear";
    TiledCells<D> cells;
    std::int64_t* sums;

    HD void operator()(int i) const
    {
        Place<D> c;
        if (cells.at(i, c)) sums[3*c.c + 1] = sums[3*c.c + 2] = 0;
    }
};

template<class Backend, int D>
class Pockets
{
public:

    void allocate(Context<Backend>& context, const GridShape<D>& shape)
    {
        // zero: what no pass visits is no root but cell 0, which has no row then
        parent_.allocate(context, shape.cells);
        sums_.allocate(context, 3*std::size_t(shape.cells));
        scale_.allocate(context, 2);
        partial_.allocate(context, deviceReduceRoom(2));
    }

    //- Finds them; returns how many cells they have
    int find(Context<Backend>& context, const FineData<D>& f, const TiledCells<D>& cells)
    {
        forEach(context, cells.all(), StartPockets<D>{f, cells, parent_.data(), sums_.data()});
        // cells in a row, one after the other, need but one
        constexpr int times = Backend::gpu ? 5 : 1;
        for (int k = 0; k < times; ++k)
            forEach(context, cells.all(), ShortenPockets<D>{f, cells, parent_.data()});
        forEach(context, cells.all(), JoinPockets<D>{f, cells, parent_.data()});
        forEach(context, cells.all(), CountTies<D>{f, cells, parent_.data(), sums_.data()});
        measure(context, f, cells, f.rhs);
        double scale[2];
        context.toHost(scale, scale_.data(), sizeof(scale));
        return int(scale[1]);
    }

    //- After find(): the right-hand side sums to zero
    void balance(Context<Backend>& context, const FineData<D>& f, const TiledCells<D>& cells)
    {
        takeMean(context, f, cells, f.rhs, true);
    }

    //- p has a mean of zero in each
    void level(Context<Backend>& context, const FineData<D>& f, const TiledCells<D>& cells)
    {
        takeMean(context, f, cells, f.x, false);
    }

    //- After find(): one cell of each, its first in memory
    std::vector<int> roots() const
    {
        const std::vector<int> parent = parent_.download();
        const std::vector<std::int64_t> sums = sums_.download();
        std::vector<int> r;
        for (int c = 0; c < int(parent.size()); ++c)
            if (parent[c] == c && sums[3*std::size_t(c)] == 0) r.push_back(c);
        return r;
    }

    //- After find(): of cells their roots; of roots three integers, of which the first is 0 in a
    //  pocket
    const int* parents() const { return parent_.data(); }
    const std::int64_t* sums() const { return sums_.data(); }

private:
    void measure(Context<Backend>& context, const FineData<D>& f, const TiledCells<D>& cells,
        const double* value)
    {
        const PocketSize<D> size{f, cells, parent_.data(), sums_.data(), value};
        sumThen<2>(context, cells.all(), size, partial_.data(), KeepScale{scale_.data()});
    }

    void takeMean(Context<Backend>& context, const FineData<D>& f, const TiledCells<D>& cells,
        double* value, bool byDiagonal)
    {
        measure(context, f, cells, value);
        forEach(context, cells.all(), ClearPocketSums<D>{cells, sums_.data()});
        forEach(context, cells.all(),
            SumPockets<D>{
                f, cells, parent_.data(), sums_.data(), value, scale_.data(), byDiagonal});
        forEach(context, cells.all(),
            SpreadSum<D>{f, cells, parent_.data(), sums_.data(), value, scale_.data(), byDiagonal});
    }

    Array<Backend, int> parent_;
    Array<Backend, std::int64_t> sums_;
    Array<Backend, double> scale_, partial_;
};

} // namespace riprap

/*  Free bodies in conjugate gradients where the grid is: U U^T of the rows of wet cells, U = J L with M^-1 = L L^T (pic/bodies/bodyTerm.hpp), in the units of the equation.

    Entries stand by the rows of the bodies' blocks, so that U^T p is summed as J^T p is; sorted by cells, each cell that bodies touch adds its own part of U (U^T p). Numbers are read where
    the grid is, and launches cover what there is room for: a recorded loop stays good from step to step.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/bodies/bodyCut.hpp"
#include "pic/pressure/conjugateGradient.hpp"

namespace riprap
{

//- counts[..]
enum CoupledCount { coupledRowCount, coupledSumCount, coupledEntryCount, coupledCounts };

//- As kernels see them
template<int D>
struct CoupledView
{
    static constexpr int modes = bodyModes<D>;
    const int* counts;
    const int* firstRow;            // of bodies
    const int* first;               // of rows
    const int* place;               // of an entry, on the finest level
    const int* body;
    const double* u;                // modes an entry
    const std::uint32_t* key;       // places of entries in ascending order,
    const std::uint32_t* number;    // and whose they are
    double* ofRow;
    double* ofBody;                 // U^T p
    int rowRoom, sumRoom, entryRoom;

    bool operator==(const CoupledView& o) const
    {
        return counts == o.counts && firstRow == o.firstRow && first == o.first && place == o.place && body == o.body && u == o.u && key == o.key && number == o.number
            && ofRow == o.ofRow && ofBody == o.ofBody && rowRoom == o.rowRoom && sumRoom == o.sumRoom && entryRoom == o.entryRoom;
    }
};

template<int D>
struct SumCoupledRows
{
    static constexpr const char* name = "coupledRows";
    CoupledView<D> bodies;
    const double* field;            // nullptr: ones

    HD void operator()(int r) const
    {
        if (r < bodies.counts[coupledRowCount]) SumRowsOfBodies<bodyModes<D>>{bodies.first, bodies.place, bodies.u, field, bodies.ofRow}(r);
    }
};

template<int D>
struct SumCoupledBodies
{
    static constexpr const char* name = "coupledBodies";
    CoupledView<D> bodies;

    HD void operator()(int i) const
    {
        if (i < bodies.counts[coupledSumCount]) SumBodies{bodyModes<D>, bodies.firstRow, bodies.ofRow, bodies.ofBody}(i);
    }
};

//- to += U (U^T p), cell by cell
template<int D>
struct AddCoupled
{
    static constexpr const char* name = "coupledAdd";
    CoupledView<D> bodies;
    double* to;

    HD void operator()(int q) const
    {
        const int count = bodies.counts[coupledEntryCount];
        if (q >= count) return;
        const std::uint32_t place = bodies.key[q];
        if (q > 0 && bodies.key[q - 1] == place) return;
        double sum = 0;
        for (int k = q; k < count && bodies.key[k] == place; ++k)
        {
            const int e = int(bodies.number[k]);
            const double* t = bodies.ofBody + bodies.body[e]*bodyModes<D>;
            for (int m = 0; m < bodyModes<D>; ++m) sum += bodies.u[e*bodyModes<D> + m]*t[m];
        }
        to[place] += sum;
    }
};

//- The product with the whole matrix, p.q = p.A p + |U^T p|^2: the sums stand after the cells
template<int D>
struct ApplyCoupled
{
    static constexpr const char* name = "pressureApply";
    ApplyDirection<D> cells;
    CoupledView<D> bodies;

    HD void add(int i, double* sums) const
    {
        if (i < cells.cells.all()) { cells.add(i, sums); return; }
        i -= cells.cells.all();
        if (i < bodies.counts[coupledSumCount]) sums[0] += bodies.ofBody[i]*bodies.ofBody[i];
    }
};

//- The same by rows of cells
template<int D>
struct ApplyCoupledRows
{
    static constexpr const char* name = "pressureApply";
    SumsOfRows<D, ApplyDirection<D>> rows;
    CoupledView<D> bodies;

    HD void add(int i, double* sums) const
    {
        const int all = rows.f.cells.rows();
        if (i < all) { rows.add(i, sums); return; }
        i -= all;
        if (i < bodies.counts[coupledSumCount]) sums[0] += bodies.ofBody[i]*bodies.ofBody[i];
    }
};

//- Entries of a row of a block that have an equation
template<int D>
struct CountCoupled
{
    static constexpr const char* name = "countCoupled";
    UniformGrid<D> grid;
    FineData<D> fine;
    int rows;
    const int* first;
    const int* cell;
    const double* j;
    int* count;

    HD int place(int at) const
    {
        const typename UniformGrid<D>::Index x = grid.cellIndex(cell[at]);
        int c = 0;
        for (int d = 0; d < D; ++d) c += x.c[d]*fine.shape.stride[d];
        if (!(fine.inverse[c] > 0)) return -1;
        for (int m = 0; m < bodyModes<D>; ++m) if (j[at*bodyModes<D> + m] != 0) return c;
        return -1;
    }

    HD void operator()(int r) const
    {
        int n = 0;
        if (r < rows) for (int at = first[r]; at < first[r + 1]; ++at) n += place(at) >= 0;
        count[r] = n;
    }
};

template<int D>
struct FillCoupled
{
    static constexpr const char* name = "fillCoupled";
    CountCoupled<D> of;
    BodyBlocks<D> blocks;
    const double* root;             // L of each body times the equation's units, modes x modes
    const int* first;
    int* place;
    int* body;
    double* u;
    std::uint32_t* key;
    std::uint32_t* number;

    HD void operator()(int r) const
    {
        constexpr int modes = bodyModes<D>;
        int e = first[r];
        if (e == first[r + 1]) return;
        const int b = blocks.row(r).body;
        const double* l = root + b*modes*modes;
        for (int at = of.first[r]; at < of.first[r + 1]; ++at)
        {
            const int c = of.place(at);
            if (c < 0) continue;
            for (int m = 0; m < modes; ++m)
            {
                double sum = 0;
                for (int k = m; k < modes; ++k) sum += of.j[at*modes + k]*l[k*modes + m];
                u[e*modes + m] = sum;
            }
            place[e] = c;
            body[e] = b;
            key[e] = std::uint32_t(c);
            number[e] = std::uint32_t(e);
            ++e;
        }
    }
};

//- A sort's result, where a recorded loop finds it
struct KeepSorted
{
    static constexpr const char* name = "keepSorted";
    const std::uint32_t* key;
    const std::uint32_t* number;
    std::uint32_t* toKey;
    std::uint32_t* toNumber;

    HD void operator()(int i) const
    {
        toKey[i] = key[i];
        toNumber[i] = number[i];
    }
};

template<class Backend, int D>
class CoupledRows
{
public:

    //- Of the bodies of a cut and their L, for an equation that is assembled and set up
    void set(Context<Backend>& context, const BodyCut<Backend, D>& cut, const std::vector<double>& root, const FineData<D>& fine)
    {
        constexpr int modes = bodyModes<D>;
        const int rows = cut.rows(), sums = cut.bodies()*modes;
        makeRoom(rowRoom_, rows);
        makeRoom(sumRoom_, sums);
        root_.upload(context, root);
        first_.allocate(context, std::size_t(rowRoom_) + 1);
        const CountCoupled<D> count{cut.blocks().grid, fine, rows, cut.first(), cut.cell(), cut.j(), first_.data()};
        forEach(context, rows + 1, count);
        exclusiveScan(context, scratch_, first_.data(), rows + 1);
        int entries = 0;
        context.toHost(&entries, first_.data() + rows, sizeof(int));
        makeRoom(entryRoom_, entries);
        for (auto* a : {&place_, &body_}) a->allocate(context, entryRoom_);
        u_.allocate(context, std::size_t(entryRoom_)*modes);
        ofRow_.allocate(context, std::size_t(rowRoom_)*modes);
        ofBody_.allocate(context, sumRoom_);
        for (int k = 0; k < 2; ++k)
        {
            scratch_.keys[k].allocate(context, entryRoom_);
            scratch_.values[k].allocate(context, entryRoom_);
        }
        forEach(context, rows, FillCoupled<D>{count, cut.blocks(), root_.data(), first_.data(), place_.data(), body_.data(), u_.data(),
            scratch_.keys[0].data(), scratch_.values[0].data()});
        int bits = 1;
        while ((1ll << bits) < fine.shape.cells) ++bits;
        if (entries) sortPairs(context, scratch_, entries, bits);
        key_.allocate(context, entryRoom_);
        number_.allocate(context, entryRoom_);
        forEach(context, entries, KeepSorted{scratch_.keys[1].data(), scratch_.values[1].data(), key_.data(), number_.data()});
        std::vector<int> counts(coupledCounts);
        counts[coupledRowCount] = rows;
        counts[coupledSumCount] = sums;
        counts[coupledEntryCount] = entries;
        counts_.upload(context, counts);
        firstRow_ = cut.firstRow();
    }

    CoupledView<D> view()
    {
        return {counts_.data(), firstRow_, first_.data(), place_.data(), body_.data(), u_.data(), key_.data(), number_.data(), ofRow_.data(), ofBody_.data(),
            rowRoom_, sumRoom_, entryRoom_};
    }

private:

    static void makeRoom(int& room, int wanted)
    {
        constexpr int share = 8;        // to spare
        if (wanted > room) room = wanted + wanted/share + 1;
    }

    int rowRoom_ = 0, sumRoom_ = 0, entryRoom_ = 0;
    const int* firstRow_ = nullptr;
    Array<Backend, int> counts_, first_, place_, body_;
    Array<Backend, double> root_, u_, ofRow_, ofBody_;
    Array<Backend, std::uint32_t> key_, number_;
    SortScratch<Backend> scratch_;
};

//- to += (U U^T) v; v nullptr: of ones
template<class Backend, int D>
void addCoupled(Context<Backend>& context, const CoupledView<D>& bodies, const double* v, double* to)
{
    forEach(context, bodies.rowRoom, SumCoupledRows<D>{bodies, v});
    forEach(context, bodies.sumRoom, SumCoupledBodies<D>{bodies});
    forEach(context, bodies.entryRoom, AddCoupled<D>{bodies, to});
}

} // namespace riprap

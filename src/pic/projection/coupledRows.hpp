/*  Free bodies in conjugate gradients where the grid is: U U^T of the rows of wet cells, U = J L
    with M^-1 = L L^T (pic/bodies/bodyTerm.hpp), in the units of the equation.

    Entries stand body by body, row by row of its block, so that a block of threads sums its U^T p;
    sorted by cells, each cell that bodies touch adds its own part of U (U^T p): it knows where its
    entries begin. Numbers are read where the grid is, and launches cover what there is room for: a
    recorded loop stays good from step to step.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/blocks.hpp"
#include "pic/bodies/bodyCut.hpp"
#include "pic/pressure/conjugateGradient.hpp"

namespace riprap
{

//- counts[..]
enum CoupledCount { coupledBodyCount, coupledEntryCount, coupledCounts };

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
    // of cells: one more than the number of their first entry in that order, 0: none
    const int* at;
    double* ofBody;                 // U^T p
    int bodyRoom, entryRoom;

    bool operator==(const CoupledView& o) const
    {
        return counts == o.counts && firstRow == o.firstRow && first == o.first && place == o.place
            && body == o.body && u == o.u && key == o.key && number == o.number && at == o.at
            && ofBody == o.ofBody && bodyRoom == o.bodyRoom && entryRoom == o.entryRoom;
    }

    //- A cell's part of U (U^T p), whose entries in order begin at q
    HD double sum(int q) const
    {
        const int count = counts[coupledEntryCount];
        const std::uint32_t cell = key[q];
        double sum = 0;
        for (int k = q; k < count && key[k] == cell; ++k)
        {
            const int e = int(number[k]);
            const double* t = ofBody + body[e]*modes;
            for (int m = 0; m < modes; ++m) sum += u[e*modes + m]*t[m];
        }
        return sum;
    }
};

//- U^T p, a block of threads for each body; field nullptr: of ones
template<int D, class V>
struct SumCoupled
{
    static constexpr const char* name = "coupledBodies";
    static constexpr int threads = 128, modes = bodyModes<D>;
    struct Shared { double part[threads][modes]; };
    CoupledView<D> bodies;
    const V* field;

    HD void operator()(const Team& team, Shared& shared, int b) const
    {
        if (b >= bodies.counts[coupledBodyCount]) return;
        double sum[modes] = {};
        const int end = bodies.first[bodies.firstRow[b + 1]];
        for (int e = bodies.first[bodies.firstRow[b]] + team.index; e < end; e += team.size)
        {
            const double p = field ? double(field[bodies.place[e]]) : 1;
            for (int m = 0; m < modes; ++m) sum[m] += bodies.u[e*modes + m]*p;
        }
        double (&part)[threads][modes] = shared.part;
        for (int m = 0; m < modes; ++m) part[team.index][m] = sum[m];
        for (int o = team.size/2; o > 0; o /= 2)
        {
            team.wait();
            if (team.index < o)
                for (int m = 0; m < modes; ++m) part[team.index][m] += part[team.index + o][m];
        }
        if (team.index == 0)
            for (int m = 0; m < modes; ++m) bodies.ofBody[b*modes + m] = part[0][m];
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
        if (q >= bodies.counts[coupledEntryCount]) return;
        const std::uint32_t place = bodies.key[q];
        if (q == 0 || bodies.key[q - 1] != place) to[place] += bodies.sum(q);
    }
};

//- The product with the whole matrix
template<int D>
struct ApplyCoupled
{
    static constexpr const char* name = "pressureApply";
    FineData<D> f;
    TiledCells<D> cells;
    CoupledView<D> bodies;

    HD void add(int i, double* sums) const
    {
        Place<D> c;
        if (!cells.at(i, c)) return;
        double w = 0;
        if (f.inverse[c.c] > 0)
        {
            const int q = bodies.at[c.c];
            w = f.apply(c, f.z);
            if (q > 0) w += bodies.sum(q - 1);
        }
        ApplyPreconditioned<D>{f, cells}.add(c, w, sums);
    }

    HD void addRow(const Place<D>& first, double* sums) const
    {
        RowSum w;
        f.applyRow(first, f.z, w.part);
        for (int k = 0; k < rowCells; ++k)
        {
            const int q = bodies.at[first.c + k];       // entries are of cells with an equation
            if (q > 0) w.part[k] += bodies.sum(q - 1);
        }
        ApplyPreconditioned<D>{f, cells}.addRow(first, w, sums);
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
    int* at;

    HD void operator()(int i) const
    {
        toKey[i] = key[i];
        toNumber[i] = number[i];
        if (i == 0 || key[i - 1] != key[i]) at[key[i]] = i + 1;
    }
};

//- Of the step before
struct ForgetEntries
{
    static constexpr const char* name = "keepSorted";
    const std::uint32_t* key;
    int* at;

    HD void operator()(int i) const { if (i == 0 || key[i - 1] != key[i]) at[key[i]] = 0; }
};

template<class Backend, int D>
class CoupledRows
{
public:

    //- Of the bodies of a cut and their L, for an equation that is assembled and set up
    void set(Context<Backend>& context, const BodyCut<Backend, D>& cut,
        const std::vector<double>& root, const FineData<D>& fine)
    {
        constexpr int modes = bodyModes<D>;
        const int rows = cut.rows();
        makeRoom(rowRoom_, rows);
        makeRoom(bodyRoom_, cut.bodies());
        forEach(context, kept_, ForgetEntries{key_.data(), at_.data()});
        at_.allocate(context, fine.shape.cells);
        root_.upload(context, root);
        first_.allocate(context, std::size_t(rowRoom_) + 1);
        const CountCoupled<D> count{
            cut.blocks().grid, fine, rows, cut.first(), cut.cell(), cut.j(), first_.data()};
        forEach(context, rows + 1, count);
        exclusiveScan(context, scratch_, first_.data(), rows + 1);
        int entries = 0;
        context.toHost(&entries, first_.data() + rows, sizeof(int));
        makeRoom(entryRoom_, entries);
        for (auto* a : {&place_, &body_}) a->allocate(context, entryRoom_);
        u_.allocate(context, std::size_t(entryRoom_)*modes);
        ofBody_.allocate(context, std::size_t(bodyRoom_)*modes);
        for (int k = 0; k < 2; ++k)
        {
            scratch_.keys[k].allocate(context, entryRoom_);
            scratch_.values[k].allocate(context, entryRoom_);
        }
        forEach(context, rows,
            FillCoupled<D>{count, cut.blocks(), root_.data(), first_.data(), place_.data(),
                body_.data(), u_.data(), scratch_.keys[0].data(), scratch_.values[0].data()});
        int bits = 1;
        while ((1ll << bits) < fine.shape.cells) ++bits;
        if (entries) sortPairs(context, scratch_, entries, bits);
        key_.allocate(context, entryRoom_);
        number_.allocate(context, entryRoom_);
        forEach(context, entries,
            KeepSorted{scratch_.keys[1].data(), scratch_.values[1].data(), key_.data(),
                number_.data(), at_.data()});
        kept_ = entries;
        std::vector<int> counts(coupledCounts);
        counts[coupledBodyCount] = cut.bodies();
        counts[coupledEntryCount] = entries;
        counts_.upload(context, counts);
        firstRow_ = cut.firstRow();
    }

    CoupledView<D> view()
    {
        return {counts_.data(), firstRow_, first_.data(), place_.data(), body_.data(), u_.data(),
            key_.data(), number_.data(), at_.data(), ofBody_.data(), bodyRoom_, entryRoom_};
    }

private:

    static void makeRoom(int& room, int wanted)
    {
        constexpr int share = 8;        // to spare
        if (wanted > room) room = wanted + wanted/share + 1;
    }

    int rowRoom_ = 0, bodyRoom_ = 0, entryRoom_ = 0, kept_ = 0;
    const int* firstRow_ = nullptr;
    Array<Backend, int> counts_, first_, place_, body_, at_;
    Array<Backend, double> root_, u_, ofBody_;
    Array<Backend, std::uint32_t> key_, number_;
    SortScratch<Backend> scratch_;
};

//- to += (U U^T) v; v nullptr: of ones
template<class Backend, int D>
void addCoupled(
    Context<Backend>& context, const CoupledView<D>& bodies, const double* v, double* to)
{
    forEachBlock(context, bodies.bodyRoom, SumCoupled<D, double>{bodies, v});
    forEach(context, bodies.entryRoom, AddCoupled<D>{bodies, to});
}

} // namespace riprap

/*  V-cycle: `sweeps` two-colour sweeps before and after the correction from the next coarser level.

    Before: red, black, red, black ...; after: black, red, ...: the mirror image, so that the cycle
    is a symmetric operator, as conjugate gradients need it. The coarsest level gets bottomSweeps of
    either order. Small levels are done by one block of the GPU, in one launch: their cost is
    latency alone.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <vector>
#include "core/backend/singleBlock.hpp"
#include "pic/pressure/relaxTile.hpp"

namespace riprap
{

static constexpr int maxTailLevels = 14;
static constexpr int bottomSweeps = 2;
static constexpr int tailCells = 3000;
static_assert(2*tailCells <= DenseCells<2>::most,
    "padded levels of the tail must be small enough for its quotients");

//- Each pass over n items: a launch of its own
template<class Backend>
struct Launches
{
    Context<Backend>& context;
    template<class F> void each(int n, const F& f) const { forEach(context, n, f); }
    template<class F> void eachRow(int n, const F& f) const { forEachRow(context, n, f); }
};

EITHER_SIDE template<int D, class Cells, class Executor>
HD void relaxDown(const Executor& run, const LevelData<D>& level, const Cells& cells, int sweeps)
{
    run.each(cells.halves(), FirstSweep<D, Cells>{level, cells});
    for (int k = 1; k < 2*sweeps; ++k)
        run.each(cells.halves(), Sweep<D, Cells>{level, cells, k & 1});
}

//- The sweeps after the first black one
EITHER_SIDE template<int D, class Cells, class Executor>
HD void relaxUp(const Executor& run, const LevelData<D>& level, const Cells& cells, int sweeps)
{
    for (int k = 1; k < 2*sweeps; ++k)
        run.each(cells.halves(), Sweep<D, Cells>{level, cells, (k + 1) & 1});
}

//- The same row by row, for the CPU
template<int D, class Cells, class Executor>
void relaxDownRows(const Executor& run, const LevelData<D>& level, const Cells& cells, int sweeps)
{
    run.eachRow(cells.rows(), FirstSweeps<D, Cells>{level, cells});
    for (int k = 2; k < 2*sweeps; ++k)
        run.eachRow(cells.rows(), RowSweep<D, Cells>{level, cells, k & 1});
}

template<int D, class Cells, class Executor>
void relaxUpRows(const Executor& run, const LevelData<D>& level, const Cells& cells, int sweeps)
{
    for (int k = 1; k < 2*sweeps; ++k)
        run.eachRow(cells.rows(), RowSweep<D, Cells>{level, cells, (k + 1) & 1});
}

//- The small levels, finest first
template<int D>
struct TailCycle
{
    static constexpr const char* name = "pressureTail";
    LevelData<D> level[maxTailLevels];
    int levels = 0, sweeps = 2;

    HD void operator()(const Team& team) const { cycle(team, [&](int l) { return level[l]; }); }

    //- of(l): where a level is. Those of few cells, the last at least, are done by few
    template<class Of>
    HD void cycle(const Team& team, const Of& of) const
    {
        int few = 0;
        while (few < levels - 1 && level[few].shape.cells > fewCells) ++few;
        around(team, 0, few, of,
            [&]
            {
                team.byOneWarp([&](const Team& part)
                    { around(part, few, levels - 1, of, [&] { bottom(part, of(levels - 1)); }); });
            });
    }

private:

    static constexpr int fewCells = 128;
    using Dense = DenseCells<D>;

    //- Down from level `from` to `to`, and up again
    template<class Of, class Middle>
    HD void around(const Team& team, int from, int to, const Of& of, const Middle& middle) const
    {
        for (int l = from; l < to; ++l) down(team, of(l), of(l + 1));
        middle();
        for (int l = to - 1; l >= from; --l) up(team, of(l), of(l + 1));
    }

    HD void down(const Team& team, const LevelData<D>& fine, const LevelData<D>& coarse) const
    {
        const Dense cells(coarse.shape);
        relaxDown(team, fine, Dense(fine.shape), sweeps);
        team.each(cells.all(), RestrictResidual<D, Dense>{fine, coarse, cells});
    }

    HD void bottom(const Team& team, const LevelData<D>& last) const
    {
        const Dense cells(last.shape);
        relaxDown(team, last, cells, bottomSweeps);
        team.each(cells.halves(), Sweep<D, Dense>{last, cells, 1});
        relaxUp(team, last, cells, bottomSweeps);
    }

    HD void up(const Team& team, const LevelData<D>& fine, const LevelData<D>& coarse) const
    {
        const Dense cells(fine.shape);
        team.each(cells.halves(), ProlongSweep<D, Dense>{fine, coarse, cells});
        relaxUp(team, fine, cells, sweeps);
    }
};

//- The same on a copy in memory that is near: latency is what the small levels cost. Cells that
//  others write meanwhile are nowhere read, not even for nothing (GridShape::spaced)
template<int D>
struct NearTail
{
    static constexpr const char* name = "pressureTail";
    static constexpr int vectors = D + 4;       // of a level
    TailCycle<D> tail;
    int first[maxTailLevels + 1];               // of each level, floats

    explicit NearTail(const TailCycle<D>& t) : tail(t)
    {
        first[0] = 0;
        for (int l = 0; l < tail.levels; ++l)
            first[l + 1] = first[l] + vectors*size(tail.level[l].shape.spaced());
    }

    int floats() const { return first[tail.levels]; }

    HD void operator()(const Team& team, float* memory) const
    {
        team.each(first[tail.levels], [&](int i) { memory[i] = 0; });
        int next = team.index;                  // levels are dealt out one after the other
        for (int l = 0; l < tail.levels; ++l)
        {
            const LevelData<D> far = tail.level[l], near = at(l, memory);
            const DenseCells<D> cells(near.shape);
            for (; next < cells.all(); next += team.size)
            {
                Place<D> p;
                cells.at(next, p);
                for (int d = 0; d < D; ++d) near.a[d][p.c] = far.a[d][next];
                near.s[p.c] = far.s[next];
                near.inverse[p.c] = far.inverse[next];
                if (l == 0) near.b[p.c] = far.b[next];
            }
            next -= cells.all();
        }
        team.wait();
        tail.cycle(team, [&](int l) { return at(l, memory); });
        const LevelData<D> near = at(0, memory);
        const DenseCells<D> cells(near.shape);
        team.each(cells.all(), [&](int i)
        {
            Place<D> p;
            cells.at(i, p);
            tail.level[0].x[i] = near.x[p.c];
        });
    }

private:

    HD static int size(const GridShape<D>& spaced) { return spaced.cells + 2*spaced.margin; }

    HD LevelData<D> at(int l, float* memory) const
    {
        LevelData<D> v;
        v.shape = tail.level[l].shape.spaced();
        float* next = memory + first[l] + v.shape.margin;
        const int n = size(v.shape);
        for (int d = 0; d < D; ++d, next += n) v.a[d] = next;
        v.s = next;
        v.inverse = next + n;
        v.x = next + 2*n;
        v.b = next + 3*n;
        return v;
    }
};

//- The levels that are not in the tail: sweeps of each in one launch where together (2D), else each
//  in a launch of its own, row by row on the CPU
template<int D, class Backend>
struct TiledCycle
{
    using Tiled = TiledCells<D>;

    Context<Backend>& context;
    const std::vector<LevelData<D>>& level;
    const std::vector<Tiled>& cells;
    const std::vector<float*>& second;
    int sweeps;
    bool together;

    //- Level l, and what the next coarser one gets
    void down(int l) const
    {
        if (together)
        {
            if constexpr (D == 2)
                forEachBlock(context, cells[l].capacity,
                    RelaxTile<false>{level[l], cells[l], second[l], nullptr, level[l + 1]});
            return;
        }
        const Launches<Backend> launch{context};
        const bool last = l + 1 == int(cells.size());
        const DenseCells<D> dense(level[l + 1].shape);
        if constexpr (!Backend::gpu)
            if (!level[l].shape.ringRows())
            {
                relaxDownRows(launch, level[l], cells[l], sweeps);
                if (!last)
                    launch.eachRow(cells[l + 1].rows(),
                        RestrictRow<D, Tiled>{level[l], level[l + 1], cells[l + 1]});
                else
                    launch.eachRow(
                        dense.rows(), RestrictRow<D, DenseCells<D>>{level[l], level[l + 1], dense});
                return;
            }
        relaxDown(launch, level[l], cells[l], sweeps);
        if (!last)
            launch.each(cells[l + 1].all(),
                RestrictResidual<D, Tiled>{level[l], level[l + 1], cells[l + 1]});
        else
            launch.each(
                dense.all(), RestrictResidual<D, DenseCells<D>>{level[l], level[l + 1], dense});
    }

    //- Level l from the next coarser one
    void up(int l) const
    {
        const Launches<Backend> launch{context};
        if constexpr (!Backend::gpu)
            if (!together && !level[l].shape.ringRows())
            {
                launch.eachRow(
                    cells[l].rows(), ProlongRow<D, Tiled>{level[l], level[l + 1], cells[l]});
                relaxUpRows(launch, level[l], cells[l], sweeps);
                return;
            }
        if (!together)
        {
            launch.each(
                cells[l].halves(), ProlongSweep<D, Tiled>{level[l], level[l + 1], cells[l]});
            relaxUp(launch, level[l], cells[l], sweeps);
        }
        else if constexpr (D == 2)
            forEachBlock(context, cells[l].capacity,
                RelaxTile<true>{level[l], cells[l], level[l].x, second[l], level[l + 1]});
    }
};

//- x of the finest level from its b. second: another x of each tiled level; with it the sweeps of a
//  level take one launch, as far as there is one for them (2D). nearTail: the small levels are
//  copied to memory that is near
template<int D, class Backend>
void vCycle(Context<Backend>& context, const std::vector<LevelData<D>>& level,
    const std::vector<TiledCells<D>>& cells, const TailCycle<D>& tail, int sweeps,
    const std::vector<float*>& second = std::vector<float*>(), bool nearTail = false)
{
    const bool together = D == 2 && !second.empty() && sweeps == tileSweeps;
    const TiledCycle<D, Backend> tiled{context, level, cells, second, sweeps, together};
    const int levels = int(cells.size());
    for (int l = 0; l < levels; ++l) tiled.down(l);
    if (nearTail)
    {
        const NearTail<D> near(tail);
        singleBlock(context, near, near.floats());
    }
    else singleBlock(context, tail);
    for (int l = levels - 1; l >= 0; --l) tiled.up(l);
}

} // namespace riprap

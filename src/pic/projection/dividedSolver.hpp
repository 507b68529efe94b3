/*  The pressure equation of a grid that is divided over ranks: conjugate gradients and the V-cycle
    of MultigridSolver, each rank with the cells of its brick.

    On the finest levels ranks exchange the values beside their bricks after each half sweep, so
    that cells become what they become on one process. The level after these is on each rank as a
    whole, and those below it: 1/512 of the grid's cells in 3D, 1/64 in 2D. Sums are added up by
    rank, and differ by round-off from those of one process.

    Cells around a brick are no unknowns: their inverse is 0, so that passes leave them and sums do
    not count them.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <memory>
#include "pic/projection/dividedPockets.hpp"
#include "pic/projection/multigridSolver.hpp"

namespace riprap
{

//- Only the cells of a brick are unknowns
template<int D>
struct MaskBrick
{
    static constexpr const char* name = "pressureMask";
    LevelData<D> level;
    CellBox brick;              // in the level's arrays

    HD void operator()(int i) const
    {
        const Place<D> p = level.shape.place(i);
        int c[3] = {0, 0, 0};
        for (int d = 0; d < D; ++d) c[d] = p.x[d];
        if (!brick.has(c)) level.inverse[i] = 0;
    }
};

template<int N>
struct KeepTotals
{
    double* totals;
    HD void operator()(const double* sums) const
    {
        for (int k = 0; k < N; ++k) totals[k] = sums[k];
    }
};

template<class Backend, int D>
class DividedSolver
{
public:

    //- part: of this rank's part of the grid, allocated
    DividedSolver(Context<Backend>& context, const GridBricks<D>& bricks,
        MultigridSolver<Backend, D>& part);

    //- After part's; pockets: memory of part
    void setUp(Context<Backend>& context, Pockets<Backend, D>& pockets);
    //- bodies: as MultigridSolver::solve has them, with the entries of this rank's cells
    PressureReport solve(Context<Backend>& context, const MultigridControls& controls,
        const CoupledView<D>* bodies = nullptr);

    std::size_t bytes() const { return coarse_.bytes(); }

private:

    //- Levels that are divided: bricks begin at multiples of eight cells, and colours must agree
    static constexpr int levels = 3;

    const LevelData<D>& level(int l) const { return part_.levels()[l]; }
    //- f(cells) with those that passes over a level visit
    template<class F> void withCells(int l, const F& f) const
    {
        if (l < int(part_.tiledCells().size())) f(part_.tiledCells()[l]);
        else f(DenseCells<D>(level(l).shape));
    }
    void share(int l) { halo_[l]->exchange(context_, level(l).x); }
    void half(int l, int colour, bool first);
    void down(int l, int sweeps);
    void up(int l, int sweeps);
    void solveCoarse(int sweeps);
    void cycle(int sweeps);
    std::vector<float> gathered(const float* values) const;
    template<int N, class F> std::vector<double> total(const F& f);
    template<class V> void sumCoupled(const CoupledView<D>& bodies, const V* field);
    void startCoupled(const CoupledView<D>& bodies);

    Context<Backend>& context_;
    const GridBricks<D>& bricks_;
    MultigridSolver<Backend, D>& part_;
    std::vector<std::unique_ptr<LevelHalo<Backend, D>>> halo_;      // of levels, the coarse one too
    std::unique_ptr<DividedPockets<Backend, D>> pockets_;
    bool hasPockets_ = false;
    MultigridSolver<Backend, D> coarse_;
    Array<Backend, double> partial_, totals_;
    Array<Backend, CgState> state_;
};

template<class Backend, int D>
DividedSolver<Backend, D>::DividedSolver(Context<Backend>& context, const GridBricks<D>& bricks,
    MultigridSolver<Backend, D>& part)
:
    context_(context), bricks_(bricks), part_(part)
{
    for (int l = 0; l <= levels; ++l)
        halo_.push_back(
            std::make_unique<LevelHalo<Backend, D>>(bricks, l, level(l).shape.stride));
    pockets_ = std::make_unique<DividedPockets<Backend, D>>(bricks, *halo_[0]);
    int n[D];
    for (int d = 0; d < D; ++d)
        n[d] = (bricks.whole().n[d] + (1 << levels) - 1) >> levels;
    coarse_.allocate(context, n, bricks.whole().periodic);
    partial_.allocate(context, deviceReduceRoom(3));
    totals_.allocate(context, 3);
    state_.allocate(context, 1);
}

//- The coarse level's values of all ranks, x first
template<class Backend, int D>
std::vector<float> DividedSolver<Backend, D>::gathered(const float* values) const
{
    const LevelHalo<Backend, D>& halo = *halo_[levels];
    const GridShape<D>& from = level(levels).shape;
    const GridShape<D>& to = coarse_.fine().shape;
    std::vector<float> here(from.cells), whole(to.cells, 0.0f);
    context_.toHost(here.data(), values, here.size()*sizeof(float));
    const CellBox own = halo.brick(bricks_.rank());
    const BoxInArray box = halo.inArray(own);
    std::vector<float> mine(own.count());
    for (int i = 0; i < int(mine.size()); ++i) mine[i] = here[box.at(i)];
    RankBytes bytes;
    putValues(bytes, mine.data(), mine.size());
    const std::vector<RankBytes> came = toAll(bricks_.ranks(), bytes);
    for (int r = 0; r < bricks_.size(); ++r)
    {
        const CellBox brick = halo.brick(r);
        const unsigned char* next = came[r].data();
        int c[3];
        for (c[2] = brick.low[2]; c[2] < brick.high[2]; ++c[2])
            for (c[1] = brick.low[1]; c[1] < brick.high[1]; ++c[1])
                for (c[0] = brick.low[0]; c[0] < brick.high[0]; ++c[0])
                {
                    int at = 0;
                    for (int d = 0; d < D; ++d) at += c[d]*to.stride[d];
                    takeValues(next, &whole[at]);
                }
    }
    return whole;
}

template<class Backend, int D>
void DividedSolver<Backend, D>::setUp(Context<Backend>& context, Pockets<Backend, D>& pockets)
{
    for (int l = 0; l < levels; ++l)
        forEach(context, level(l).shape.cells, MaskBrick<D>{level(l), halo_[l]->brickInPart()});
    const FineData<D>& coarse = coarse_.fine();
    const auto set = [&](double* to, const float* from)
    {
        const std::vector<float> values = gathered(from);
        const std::vector<double> wide(values.begin(), values.end());
        context.toDevice(to, wide.data(), wide.size()*sizeof(double));
    };
    for (int d = 0; d < D; ++d) set(coarse.a[d], level(levels).a[d]);
    set(coarse.s, level(levels).s);
    coarse_.setUp(context);
    hasPockets_ = pockets_->find(context, pockets, part_.fine(), part_.fineCells());
}

//- A half sweep of a level, and what others made of theirs
template<class Backend, int D>
void DividedSolver<Backend, D>::half(int l, int colour, bool first)
{
    const Launches<Backend> launch{context_};
    withCells(l, [&](const auto& cells)
    {
        using Cells = std::decay_t<decltype(cells)>;
        if (first)
        {
            launch.each(cells.halves(), FirstSweep<D, Cells>{level(l), cells});
            return;
        }
        if constexpr (!Backend::gpu && std::is_same<Cells, TiledCells<D>>::value)
            if (!level(l).shape.ringRows())
            {
                launch.eachRow(cells.rows(), RowSweep<D, Cells>{level(l), cells, colour});
                return;
            }
        launch.each(cells.halves(), Sweep<D, Cells>{level(l), cells, colour});
    });
    share(l);
}

template<class Backend, int D>
void DividedSolver<Backend, D>::down(int l, int sweeps)
{
    for (int k = 0; k < 2*sweeps; ++k) half(l, k & 1, k == 0);
    const Launches<Backend> launch{context_};
    withCells(l + 1, [&](const auto& cells)
    {
        using Cells = std::decay_t<decltype(cells)>;
        launch.each(cells.all(), RestrictResidual<D, Cells>{level(l), level(l + 1), cells});
    });
}

//- The first half sweep sees neighbours of the other colour corrected
template<class Backend, int D>
void DividedSolver<Backend, D>::up(int l, int sweeps)
{
    const Launches<Backend> launch{context_};
    withCells(l, [&](const auto& cells)
    {
        using Cells = std::decay_t<decltype(cells)>;
        launch.each(cells.halves(), ProlongSweep<D, Cells>{level(l), level(l + 1), cells});
    });
    share(l);
    for (int k = 1; k < 2*sweeps; ++k) half(l, (k + 1) & 1, false);
}

//- The coarse level, on each rank
template<class Backend, int D>
void DividedSolver<Backend, D>::solveCoarse(int sweeps)
{
    const LevelData<D>& own = level(levels);
    const FineData<D>& coarse = coarse_.fine();
    const std::vector<float> b = gathered(own.b);
    context_.toDevice(coarse.b, b.data(), b.size()*sizeof(float));
    coarse_.precondition(context_, sweeps);
    std::vector<float> x(coarse.shape.cells), here(own.shape.cells, 0.0f);
    context_.toHost(x.data(), coarse.z, x.size()*sizeof(float));
    const CellBox part = bricks_.part(bricks_.rank());
    for (int i = 0; i < own.shape.cells; ++i)
    {
        const Place<D> p = own.shape.place(i);
        if (!own.shape.inside(p)) continue;
        int at = 0;
        for (int d = 0; d < D; ++d) at += (p.x[d] + (part.low[d] >> levels))*coarse.shape.stride[d];
        here[i] = x[at];
    }
    context_.toDevice(own.x, here.data(), here.size()*sizeof(float));
}

template<class Backend, int D>
void DividedSolver<Backend, D>::cycle(int sweeps)
{
    for (int l = 0; l < levels; ++l) down(l, sweeps);
    solveCoarse(sweeps);
    for (int l = levels - 1; l >= 0; --l) up(l, sweeps);
}

//- Sums over the unknowns of all ranks
template<class Backend, int D>
template<int N, class F>
std::vector<double> DividedSolver<Backend, D>::total(const F& f)
{
    sumOfTiles<N, Backend, D>(context_, part_.byRows(), f, partial_.data(),
        KeepTotals<N>{totals_.data()});
    std::vector<double> sums(N);
    context_.toHost(sums.data(), totals_.data(), N*sizeof(double));
    addByRank(bricks_.ranks(), sums);
    return sums;
}

//- U^T of a field, over the cells of all ranks: a body may lie on several
template<class Backend, int D>
template<class V>
void DividedSolver<Backend, D>::sumCoupled(const CoupledView<D>& bodies, const V* field)
{
    forEachBlock(context_, bodies.bodyRoom, SumCoupled<D, V>{bodies, field});
    int count = 0;
    context_.toHost(&count, bodies.counts + coupledBodyCount, sizeof(int));
    std::vector<double> sums(std::size_t(count)*bodyModes<D>);
    context_.toHost(sums.data(), bodies.ofBody, sums.size()*sizeof(double));
    addByRank(bricks_.ranks(), sums);
    context_.toDevice(bodies.ofBody, sums.data(), sums.size()*sizeof(double));
}

//- What bodies add to the first residual, and to the measure of residuals
template<class Backend, int D>
void DividedSolver<Backend, D>::startCoupled(const CoupledView<D>& bodies)
{
    const FineData<D>& fine = part_.fine();
    eachOfTiles<Backend, D>(context_, part_.byRows(), ClearDirections<D>{fine, part_.fineCells()});
    sumCoupled(bodies, fine.x);
    forEach(context_, bodies.entryRoom, AddCoupled<D>{bodies, fine.q});
    sumCoupled(bodies, static_cast<const double*>(nullptr));
    forEach(context_, bodies.entryRoom, AddCoupled<D>{bodies, fine.p});
}

template<class Backend, int D>
PressureReport DividedSolver<Backend, D>::solve(
    Context<Backend>& context, const MultigridControls& controls, const CoupledView<D>* bodies)
{
    const FineData<D>& fine = part_.fine();
    const TiledCells<D>& cells = part_.fineCells();
    CgState s{};
    s.tolerance = controls.tolerance;
    s.relTol = controls.relTol;
    s.maxIter = controls.maxIter;
    s.minIter = controls.minIter;
    const auto give = [&] { context.toDevice(state_.data(), &s, sizeof(s)); };
    if (hasPockets_) pockets_->balance(context, fine);
    halo_[0]->exchange(context, fine.x);
    SetReference{&s}(total<2>(AverageGuess<D>{fine, cells}).data());
    give();
    if (bodies) startCoupled(*bodies);
    StartIterations{&s}(
        total<2>(FirstResidual<D>{fine, cells, state_.data(), bodies != nullptr}).data());
    while (s.again)
    {
        cycle(controls.sweeps);
        if (bodies)
        {
            sumCoupled(*bodies, static_cast<const float*>(fine.z));
            SetDirection{&s}(total<3>(ApplyCoupled<D>{fine, cells, *bodies}).data());
        }
        else SetDirection{&s}(total<3>(ApplyPreconditioned<D>{fine, cells}).data());
        give();
        s.residual = total<1>(Advance<D>{fine, cells, state_.data()})[0]/s.normFactor;
        ++s.iterations;
        s.decide();
    }
    if (hasPockets_) pockets_->level(context, fine);
    halo_[0]->exchange(context, fine.x);
    return reportOf(s);
}

} // namespace riprap

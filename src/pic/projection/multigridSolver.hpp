/*  Conjugate gradients with a geometric multigrid as preconditioner, on one uniform grid: memory,
    levels and the loop.

    Whoever assembles a system fills a, s, rhs and x of fine() (all stored cells, zero where there
    is nothing) and calls setUp(), which makes all that follows from them; then solve(), which
    spends rhs.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/loops/deviceReduce.hpp"
#include "core/loops/sort.hpp"
#include "pic/pressure/conjugateGradient.hpp"
#include "pic/projection/coupledRows.hpp"
#include "api/linearSolver.hpp"
#include "pic/pressure/vCycle.hpp"

namespace riprap
{

//- The finest level in single precision from its double form
template<int D>
struct Mirror
{
    static constexpr const char* name = "pressureMirror";
    FineData<D> fine;
    LevelData<D> level;
    bool oddPeriodic[D];
    int* tileFlag;

    HD void operator()(int i) const { cell(fine.shape.place(i)); }

    HD void cell(const Place<D>& c) const
    {
        const int i = c.c;
        double sum = 0, kept = 0;
        if (fine.shape.inside(c))
        {
            sum = kept = fine.s[i];
            for (int d = 0; d < D; ++d)
            {
                const double lower = fine.a[d][i], upper = fine.a[d][fine.shape.above(c, d)];
                sum += lower + upper;
                kept += (cut(c, d, 0) ? 0 : lower) + (cut(c, d, fine.shape.n[d] - 1) ? 0 : upper);
            }
        }
        for (int d = 0; d < D; ++d) level.a[d][i] = cut(c, d, 0) ? 0.0f : float(fine.a[d][i]);
        level.s[i] = float(fine.s[i]);
        // an unknown that has nothing but the cut ring still needs a diagonal
        level.inverse[i] = sum > 0 ? float(1/(kept > 0 ? kept : sum)) : 0.0f;
        level.x[i] = 0;
        if (!(sum > 0)) fine.x[i] = 0;
        if (sum > 0) raise(tileFlag + fine.shape.tileOf(c));
    }

    HD bool cut(const Place<D>& c, int d, int at) const { return oddPeriodic[d] && c.x[d] == at; }
};

//- Active tiles of a level in order; before: scanned flags of all levels, first: where this level's
//  begin
template<int D>
struct ListTiles
{
    static constexpr const char* name = "pressureTiles";
    GridShape<D> shape;
    const int* before;
    int first;
    TileOrigin<D>* list;
    int* count;

    HD void operator()(int t) const
    {
        const int at = before[first + t] - before[first];
        const bool active = before[first + t + 1] > before[first + t];
        if (t == shape.tileCount - 1) *count = at + active;
        if (!active) return;
        TileOrigin<D> o;
        o.c = 0;
        for (int d = 0; d < D; ++d)
        {
            o.x[d] = (t % shape.tiles[d]) << tileLog<D>(d);
            t /= shape.tiles[d];
            o.c += o.x[d]*shape.stride[d];
        }
        list[at] = o;
    }
};

//- Tiles of the next coarser level that hold some of the cells of tiles
template<int D>
std::vector<int> tilesOver(
    const GridShape<D>& fine, const GridShape<D>& coarse, const std::vector<int>& tiles)
{
    std::vector<char> over(coarse.tileCount, 0);
    for (const int t : tiles)
    {
        Place<D> p = rowOfTile(fine, t, 0);
        for (int d = 0; d < D; ++d) p.x[d] /= 2;
        over[coarse.tileOf(p)] = 1;
    }
    std::vector<int> list;
    for (int t = 0; t < coarse.tileCount; ++t) if (over[t]) list.push_back(t);
    return list;
}

//- Of a solution that has ended
inline PressureReport reportOf(const CgState& s)
{
    PressureReport report;
    report.solver = ownSolver;
    report.initialResidual = s.initial;
    report.finalResidual = s.residual;
    report.iterations = s.iterations;
    report.wetCells = s.cells;
    report.converged = s.residual < s.tolerance
        || (s.relTol > 0 && s.residual < s.relTol*s.initial);
    return report;
}

template<class Backend, int D>
class MultigridSolver
{
public:

    void allocate(Context<Backend>& context, const int* cells, const bool* periodic);

    const FineData<D>& fine() const { return fine_; }
    const TiledCells<D>& fineCells() const { return cells_[0]; }
    const std::vector<LevelData<D>>& levels() const { return levels_; }
    //- Of the finest levels; others are small
    const std::vector<TiledCells<D>>& tiledCells() const { return cells_; }
    //- Are passes over the finest level done row by row?
    bool byRows() const { return !Backend::gpu && !fine_.shape.ringRows(); }
    int fineTiles() const { return active_.empty() ? 0 : active_[0]; }

    //- After coefficients have changed. touched: tiles of the finest level; in others all
    //  coefficients are zero, and were so at the last call. On the CPU; nullptr: all
    void setUp(Context<Backend>& context, const std::vector<int>* touched = nullptr);

    //- bodies: what free ones add to the matrix, whose slow modes nothing takes away: for those
    //  that are heavier than the water
    PressureReport solve(Context<Backend>& context, const MultigridControls& controls,
        const CoupledView<D>* bodies = nullptr);

    //- One V-cycle, from fine().b to fine().z, for a loop that is not ours; after setUp()
    void precondition(Context<Backend>& context, int sweeps)
    {
        vCycle<D>(context, levels_, cells_, tail_, sweeps, second_, near_);
    }

    //- The sweeps of a level in one launch where there is one for them, or each in its own; before
    //  allocate()
    void sweepTogether(bool on) { together_ = on; }

    //- The small levels in near memory, if it holds them, or not; before allocate()
    void bringNear(bool on) { wantsNear_ = on; }

    std::size_t bytes() const { return floats_.bytes() + doubles_.bytes() + origins_.bytes(); }

private:

    //- Of an array of a level: its cells, with a margin on either side
    template<class T> static T* take(T*& next, const GridShape<D>& shape)
    {
        T* p = next + shape.margin;
        next += shape.cells + 2*shape.margin;
        return p;
    }

    int setLevels(const int* cells);
    void placeLevels(Context<Backend>& context);
    void chooseCapacities(const std::vector<int>& count);
    void start(Context<Backend>& context, const CoupledView<D>* bodies);
    void iterate(
        Context<Backend>& context, const CoupledView<D>* bodies, const LoopCondition& condition);
    void forgetLoops() { loop_.forget(); coupledLoop_.forget(); }

    bool periodic_[D] = {};
    int sweeps_ = 2;
    bool together_ = Backend::gpu && D == 2;    // launches bind there
    FineData<D> fine_{};
    std::vector<LevelData<D>> levels_;
    std::vector<TiledCells<D>> cells_;      // of the levels that are not in the tail
    bool wantsNear_ = Backend::gpu, near_ = false;
    // of tiled levels: another x, where sweeps are done together
    std::vector<float*> second_;
    std::vector<int> firstTile_, active_;
    TailCycle<D> tail_;
    Array<Backend, float> floats_;
    Array<Backend, double> doubles_, partial_;
    Array<Backend, int> flags_, counts_;
    Array<Backend, TileOrigin<D>> origins_;
    Array<Backend, CgState> state_;
    SortScratch<Backend> scan_;
    DeviceLoop<Backend> loop_, coupledLoop_;
    CoupledView<D> recorded_{};             // of coupledLoop_
};

//- Their shapes. \return tiles of those that are not in the tail
template<class Backend, int D>
int MultigridSolver<Backend, D>::setLevels(const int* cells)
{
    int n[D], tiles = 0;
    for (int d = 0; d < D; ++d) n[d] = cells[d];
    for (bool last = false; !last; )
    {
        long long total = 1;
        bool small = true;
        for (int d = 0; d < D; ++d) { total *= n[d]; small = small && n[d] <= 2; }
        const bool tiled = levels_.empty() || total > tailCells;
        LevelData<D> level{};
        level.shape.set(n, periodic_, tiled);
        levels_.push_back(level);
        if (tiled) { firstTile_.push_back(tiles); tiles += level.shape.tileCount; }
        last = small && levels_.size() > 1;
        for (int d = 0; d < D; ++d) n[d] = (n[d] + 1)/2;
    }
    return tiles;
}

template<class Backend, int D>
void MultigridSolver<Backend, D>::placeLevels(Context<Backend>& context)
{
    std::size_t floats = 0;
    for (std::size_t l = 0; l < levels_.size(); ++l)
    {
        const GridShape<D>& shape = levels_[l].shape;
        floats += std::size_t(D + 4 + (l < firstTile_.size() && together_))
            *(shape.cells + 2*shape.margin);
    }
    // a tile's rows read beyond a coarser level that is smaller: what they find must be finite
    floats_.allocate(context, floats + (1 << tileCellsLog));
    float* f = floats_.data();
    for (LevelData<D>& l : levels_)
    {
        for (int d = 0; d < D; ++d) l.a[d] = take(f, l.shape);
        for (float** v : {&l.s, &l.inverse, &l.x, &l.b}) *v = take(f, l.shape);
        if (together_ && second_.size() < firstTile_.size()) second_.push_back(take(f, l.shape));
    }
    const GridShape<D>& shape = levels_[0].shape;
    doubles_.allocate(context, std::size_t(D + 6)*(shape.cells + 2*shape.margin));
    double* g = doubles_.data();
    fine_.shape = shape;
    for (int d = 0; d < D; ++d) fine_.a[d] = take(g, shape);
    for (double** v : {&fine_.s, &fine_.rhs, &fine_.x, &fine_.r, &fine_.p, &fine_.q})
        *v = take(g, shape);
    fine_.inverse = levels_[0].inverse;
    fine_.b = levels_[0].b;
    fine_.z = levels_[0].x;
}

template<class Backend, int D>
void MultigridSolver<Backend, D>::allocate(
    Context<Backend>& context, const int* cells, const bool* periodic)
{
    levels_.clear(); cells_.clear(); second_.clear(); firstTile_.clear(); active_.clear();
    forgetLoops();
    for (int d = 0; d < D; ++d) periodic_[d] = periodic[d];
    const int tiles = setLevels(cells);
    placeLevels(context);

    const int tiledLevels = int(firstTile_.size());
    tail_.levels = int(levels_.size()) - tiledLevels;
    for (int l = 0; l < tail_.levels; ++l) tail_.level[l] = levels_[tiledLevels + l];
    near_ = wantsNear_ && NearTail<D>(tail_).floats() <= nearRoom(context);
    flags_.allocate(context, tiles + 1);
    origins_.allocate(context, tiles);
    counts_.allocate(context, tiledLevels);
    partial_.allocate(context, deviceReduceRoom(3));
    state_.allocate(context, 1);
    for (int l = 0; l < tiledLevels; ++l)
    {
        TiledCells<D> c{};
        c.list = origins_.data() + firstTile_[l];
        c.count = counts_.data() + l;
        for (int d = 0; d < D; ++d) c.stride[d] = levels_[l].shape.stride[d];
        cells_.push_back(c);
    }
}

template<class Backend, int D>
void MultigridSolver<Backend, D>::setUp(Context<Backend>& context, const std::vector<int>* touched)
{
    const auto odd = [&](const GridShape<D>& s, int d) { return periodic_[d] && s.n[d] % 2 == 1; };
    context.zero(flags_.data(), flags_.size()*sizeof(int));
    Mirror<D> mirror{fine_, levels_[0], {}, flags_.data()};
    for (int d = 0; d < D; ++d) mirror.oddPeriodic[d] = odd(fine_.shape, d);
    std::vector<int> some;
    const auto each = [&](const GridShape<D>& shape, bool tiled, const auto& f)
    {
        if constexpr (!Backend::gpu)
            if (touched && tiled)
            {
                forEachRow(context, int(some.size()) << InTiles<D, Mirror<D>>::rowsLog,
                    InTiles<D, std::decay_t<decltype(f)>>{shape, some.data(), f});
                return;
            }
        forEach(context, shape.cells, f);
    };
    if (touched) some = *touched;
    each(fine_.shape, true, mirror);
    for (std::size_t l = 1; l < levels_.size(); ++l)
    {
        const bool tiled = l < cells_.size();
        Coarsen<D> coarsen{
            levels_[l - 1], levels_[l], {}, tiled ? flags_.data() + firstTile_[l] : nullptr};
        for (int d = 0; d < D; ++d) coarsen.oddPeriodic[d] = odd(levels_[l].shape, d);
        if (touched && tiled) some = tilesOver(levels_[l - 1].shape, levels_[l].shape, some);
        each(levels_[l].shape, tiled, coarsen);
    }
    exclusiveScan(context, scan_, flags_.data(), int(flags_.size()));
    for (std::size_t l = 0; l < cells_.size(); ++l)
    {
        const GridShape<D>& shape = levels_[l].shape;
        TileOrigin<D>* list = origins_.data() + firstTile_[l];
        forEach(context, shape.tileCount,
            ListTiles<D>{shape, flags_.data(), firstTile_[l], list, counts_.data() + l});
    }
    chooseCapacities(counts_.download());
}

//- A recorded loop stays good while the active tiles fit what it launches and fill most of it
template<class Backend, int D>
void MultigridSolver<Backend, D>::chooseCapacities(const std::vector<int>& count)
{
    active_ = count;
    for (std::size_t l = 0; l < cells_.size(); ++l)
    {
        const int spare = Backend::gpu ? count[l]/8 + 1 : 0;
        const int wanted = count[l] + spare < levels_[l].shape.tileCount
            ? count[l] + spare
            : levels_[l].shape.tileCount;
        int& capacity = cells_[l].capacity;
        if (count[l] <= capacity && capacity <= wanted + 2*spare) continue;
        capacity = wanted;
        forgetLoops();
    }
}

template<class Backend, int D>
void MultigridSolver<Backend, D>::start(Context<Backend>& context, const CoupledView<D>* bodies)
{
    CgState* state = state_.data();
    const bool rows = byRows();
    sumOfTiles<2, Backend, D>(
        context, rows, AverageGuess<D>{fine_, cells_[0]}, partial_.data(), SetReference{state});
    if (bodies)
    {
        eachOfTiles<Backend, D>(context, rows, ClearDirections<D>{fine_, cells_[0]});
        addCoupled(context, *bodies, fine_.x, fine_.q);
        addCoupled(context, *bodies, static_cast<const double*>(nullptr), fine_.p);
    }
    sumOfTiles<2, Backend, D>(context, rows,
        FirstResidual<D>{fine_, cells_[0], state, bodies != nullptr}, partial_.data(),
        StartIterations{state});
}

template<class Backend, int D>
void MultigridSolver<Backend, D>::iterate(
    Context<Backend>& context, const CoupledView<D>* bodies, const LoopCondition& condition)
{
    CgState* state = state_.data();
    double* partial = partial_.data();
    const bool rows = byRows();
    const ApplyPreconditioned<D> apply{fine_, cells_[0]};
    vCycle<D>(context, levels_, cells_, tail_, sweeps_, second_, near_);
    if (bodies)
    {
        forEachBlock(context, bodies->bodyRoom, SumCoupled<D, float>{*bodies, fine_.z});
        sumOfTiles<3, Backend, D>(context, rows, ApplyCoupled<D>{fine_, cells_[0], *bodies},
            partial, SetDirection{state});
    }
    else sumOfTiles<3, Backend, D>(context, rows, apply, partial, SetDirection{state});
    sumOfTiles<1, Backend, D>(context, rows, Advance<D>{fine_, cells_[0], state}, partial,
        EndIteration{state, condition});
}

template<class Backend, int D>
PressureReport MultigridSolver<Backend, D>::solve(
    Context<Backend>& context, const MultigridControls& controls, const CoupledView<D>* bodies)
{
    if (sweeps_ != controls.sweeps) forgetLoops();
    sweeps_ = controls.sweeps;
    if (bodies && !(*bodies == recorded_))
    {
        coupledLoop_.forget();
        recorded_ = *bodies;
    }
    CgState s{};
    s.tolerance = controls.tolerance;
    s.relTol = controls.relTol;
    s.maxIter = controls.maxIter;
    s.minIter = controls.minIter;
    context.toDevice(state_.data(), &s, sizeof(s));
    start(context, bodies);
    context.toHost(&s, state_.data(), sizeof(s));
    if (s.again)
        (bodies ? coupledLoop_ : loop_)
            .run(context, &state_.data()->again,
                [&](const LoopCondition& c) { iterate(context, bodies, c); });
    context.toHost(&s, state_.data(), sizeof(s));
    return reportOf(s);
}

} // namespace riprap

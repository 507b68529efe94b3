/*  The pressure step: assembles the equation of the wet cells, has it solved, and projects the
    velocities.

    The solver is ours, where the grid is (LinearSolver::onDevice), or the caller's, on the host:
    then the coefficients, the right-hand side and p of the wet cells cross once each way. With free
    bodies our solver is conjugate gradients on the host with the multigrid, where the grid is, as
    preconditioner: residuals and corrections of the wet cells cross each iteration.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cmath>
#include <stdexcept>
#include "pic/grid/activeRows.hpp"
#include "pic/bodies/bodyTerm.hpp"
#include "pic/bodies/coupledGradient.hpp"
#include "pic/projection/hostSystem.hpp"
#include "pic/projection/dividedSolver.hpp"
#include "pic/pressure/pockets.hpp"
#include "pic/projection/project.hpp"

namespace riprap
{

//- Bodies so many times as heavy as water need no deflation: iterations are those of a wall. In 2D
//  water has no way around but between them, and crowds move more of it
template<int D> inline constexpr double heavyRatio = D == 2 ? 10 : 2;

//- On a GPU so many are enough: three times as many iterations in a crowd of half of water's
//  density, ten times at this one, take less than a loop on the host
inline constexpr double heavyRatioOnDevice = 0.05;

//- On a CPU with so few bodies, under a surface, so many: they are no crowd that matters, and what
//  deflation costs an iteration is a third of a step
inline constexpr int fewBodies = 128;
inline constexpr double heavyRatioOfFew = 2;

//- Bodies where the grid is, with L of each: M^-1 = L L^T
template<class Backend, int D>
struct BodiesOnGrid
{
    const BodyCut<Backend, D>& cut;
    const std::vector<double>& root;
};

template<class Backend, int D, class R>
class PressureStep
{
public:

    void allocate(Context<Backend>& context, const UniformGrid<D>& grid)
    {
        multigrid_.allocate(context, grid.n, grid.periodic);
        pockets_.allocate(context, multigrid_.fine().shape);
        wet_.allocate(context, grid.cells());
        assembled_.clear();
    }

    //- For correct() alone: the equation is solved elsewhere
    void allocateWet(Context<Backend>& context, const UniformGrid<D>& grid)
    {
        wet_.allocate(context, grid.cells());
    }

    //- The grid is a rank's part, and the equation that of all ranks; after allocate()
    void divide(Context<Backend>& context, const GridBricks<D>& bricks)
    {
        divided_ = std::make_unique<DividedSolver<Backend, D>>(context, bricks, multigrid_);
    }

    //- Of a rank's part, whose own solver the controls are for
    PressureReport solveDivided(Context<Backend>& context, const PressureFields<D, R>& f,
        bool sameWater, const MultigridControls& controls,
        const BodiesOnGrid<Backend, D>* onGrid = nullptr)
    {
        assemble(context, f, sameWater);
        if (onGrid)
            coupled_.set(context, onGrid->cut, scaled(onGrid->root, f), multigrid_.fine());
        const CoupledView<D> view = coupled_.view();
        const PressureReport report = divided_->solve(context, controls, onGrid ? &view : nullptr);
        store(context, f);
        return report;
    }

    //- bodies: those that the water moves, whose V* is in f's wall velocities; solved for with the
    //  pressure, on the host (those without modes are walls, which a solver may want to know of).
    //  Their V becomes that at the end of the step. onGrid: bodies that our solver takes as they
    //  are in the grid, none of them light; what becomes of their V is the caller's. sameWater:
    //  surface and open parts are those of the last projection. rows: those about the water, where
    //  alone faces may need a correction; nullptr: all. tolerance: of our solver, in place of its
    //  own; 0: that
    PressureReport project(Context<Backend>& context, const PressureFields<D, R>& f,
        LinearSolver& solver, std::vector<BodyTerm>* bodies = nullptr, bool sameWater = false,
        const ActiveRows<Backend, D>* rows = nullptr,
        const BodiesOnGrid<Backend, D>* onGrid = nullptr, double tolerance = 0)
    {
        const PressureReport report = solve(
            context, f, solver, bodies, sameWater, onGrid, tolerance);
        correct(context, f, rows);
        if (bodies && !bodies->empty()) moveBodies(context, f, *bodies);
        return report;
    }

    //- The pressure alone
    PressureReport solve(Context<Backend>& context, const PressureFields<D, R>& f,
        LinearSolver& solver, std::vector<BodyTerm>* bodies, bool sameWater,
        const BodiesOnGrid<Backend, D>* onGrid, double tolerance)
    {
        assemble(context, f, sameWater);
        const FineData<D>& fine = multigrid_.fine();
        const TiledCells<D> cells = multigrid_.fineCells();
        if (pocketCells_) pockets_.balance(context, fine, cells);

        const MultigridControls* controls = solver.onDevice();
        MultigridControls own;
        if (controls && tolerance > 0)
        {
            own = *controls;
            own.tolerance = tolerance;
            controls = &own;
        }
        const bool free = bodies && !bodies->empty();
        PressureReport report;
        if (controls && onGrid)
        {
            coupled_.set(context, onGrid->cut, scaled(onGrid->root, f), fine);
            const CoupledView<D> view = coupled_.view();
            report = multigrid_.solve(context, *controls, &view);
        }
        else
            report = controls && !free ? multigrid_.solve(context, *controls)
                                       : solveOnHost(context, f, solver, controls,
                                           free ? *bodies : std::vector<BodyTerm>());
        solver.report(report);

        if (pocketCells_) pockets_.level(context, fine, cells);
        store(context, f);
        return report;
    }

    //- What f's pressure does to velocities; wet cells are known
    void correct(Context<Backend>& context, const PressureFields<D, R>& f,
        const ActiveRows<Backend, D>* rows)
    {
        if (rows)
            rows->eachFace(context,
                [&](int d) {
                    return CorrectVelocity<D, R>{f, wet_.data(), d};
                });
        else
            for (int d = 0; d < D; ++d)
                forEach(context, f.grid.faces(d), CorrectVelocity<D, R>{f, wet_.data(), d});
    }

    //- Which cells are wet, for wet() before a projection
    void markWet(Context<Backend>& context, const PressureFields<D, R>& f)
    {
        forEach(context, f.grid.cells(), MarkWet<D, R>{f, wet_.data()});
    }

    //- How heavy bodies must be to be solved for where the grid is. sameWater: as of project()
    double heavyFrom(std::size_t bodies, bool sameWater) const
    {
        // closed water has no pressure to begin from, and needs the hats
        const bool open = sameWater && !pocketCells_;
        if (Backend::gpu) return heavyRatioOnDevice;
        return open && bodies <= std::size_t(fewBodies) ? heavyRatioOfFew : heavyRatio<D>;
    }

    //- Cells in pockets without a surface, at the last projection
    int pocketCells() const { return pocketCells_; }
    const int* wet() const { return wet_.data(); }
    std::size_t bytes() const { return multigrid_.bytes(); }

private:
    PressureReport solveOnHost(Context<Backend>& context, const PressureFields<D, R>& f,
        LinearSolver& solver, const MultigridControls* controls,
        const std::vector<BodyTerm>& bodies);
    PressureReport solveCoupled(Context<Backend>& context, ReducedSystem& r,
        const std::vector<int>& stored, const MultigridControls& controls);
    static void moveBodies(
        Context<Backend>& context, const PressureFields<D, R>& f, std::vector<BodyTerm>& bodies);

    static constexpr int tileRowsLog = tileCellsLog - tileLog<D>(0);

    //- On the CPU: only tiles in which there is water, or was the last time, are written
    void assembleTiles(Context<Backend>& context, const PressureFields<D, R>& f)
    {
        const FineData<D>& fine = multigrid_.fine();
        const int tiles = fine.shape.tileCount;
        wetTiles_.allocate(context, tiles);
        context.zero(wetTiles_.data(), tiles*sizeof(int));
        forEachRow(context, tiles << tileRowsLog,
            MarkWetRows<D, R>{f, fine.shape, wet_.data(), wetTiles_.data()});
        const bool known = !assembled_.empty();
        if (!known) assembled_.assign(tiles, 1);
        std::vector<int> touched;
        for (int t = 0; t < tiles; ++t)
        {
            const bool wet = wetTiles_.data()[t];
            if (wet || assembled_[t]) touched.push_back(t);
            assembled_[t] = wet;
        }
        forEachRow(context, int(touched.size()) << tileRowsLog,
            InTiles<D, Assemble<D, R>>{fine.shape, touched.data(), {f, wet_.data(), fine}});
        multigrid_.setUp(context, known ? &touched : nullptr);
    }

    //- p in the order of the grid
    void store(Context<Backend>& context, const PressureFields<D, R>& f)
    {
        const FineData<D>& fine = multigrid_.fine();
        if constexpr (Backend::gpu)
            forEach(context, f.grid.cells(), StorePressure<D, R>{f.grid, wet_.data(), fine, f.p});
        else
            forEachRow(context, fine.shape.tileCount << tileRowsLog,
                StorePressureRows<D, R>{f.grid, wet_.data(), wetTiles_.data(), fine, f.p});
    }

    //- The matrix, if the water is another, and the source
    void assemble(Context<Backend>& context, const PressureFields<D, R>& f, bool sameWater)
    {
        const FineData<D>& fine = multigrid_.fine();
        if (sameWater)
            eachOfTiles<Backend, D>(context, !fine.shape.ringRows(),
                AssembleSource<D, R>{f, wet_.data(), fine, multigrid_.fineCells()});
        else
        {
            if constexpr (Backend::gpu)
            {
                markWet(context, f);
                forEach(context, fine.shape.cells, Assemble<D, R>{f, wet_.data(), fine});
                multigrid_.setUp(context);
            }
            else assembleTiles(context, f);
            if (divided_) divided_->setUp(context, pockets_);
            else pocketCells_ = pockets_.find(context, fine, multigrid_.fineCells());
        }
    }

    //- U = J L in the units of the equation
    static double bodyScale(const PressureFields<D, R>& f)
    {
        return std::sqrt(f.density*f.grid.h/f.grid.area());
    }
    static std::vector<double> scaled(std::vector<double> root, const PressureFields<D, R>& f)
    {
        for (double& l : root) l *= bodyScale(f);
        return root;
    }

    CoupledRows<Backend, D> coupled_;
    MultigridSolver<Backend, D> multigrid_;
    Pockets<Backend, D> pockets_;
    Array<Backend, int> wet_;
    Array<Backend, int> wetTiles_;          // on the CPU: has a tile a wet cell?
    std::vector<char> assembled_;           // had it at the last assembly? Empty: there was none
    int pocketCells_ = 0;
    std::unique_ptr<DividedSolver<Backend, D>> divided_;    // null: the grid is no part
};

template<class Backend, int D, class R>
PressureReport PressureStep<Backend, D, R>::solveOnHost(Context<Backend>& context,
    const PressureFields<D, R>& f, LinearSolver& solver, const MultigridControls* controls,
    const std::vector<BodyTerm>& bodies)
{
    const UniformGrid<D>& grid = f.grid;
    const FineData<D>& fine = multigrid_.fine();
    HostLevel<D> level(context, fine);

    ReducedSystem r;
    r.dimensions = D;
    for (int d = 0; d < 3; ++d) { r.n[d] = grid.n[d]; r.periodic[d] = grid.periodic[d]; }
    const HostRows rows = numberRows(grid, fine.shape, bodies, level, r);
    // p = 0 in one cell of each pocket: exact, since the right-hand sides of a pocket sum to zero,
    // and solvers that factorise meet no singular matrix
    if (pocketCells_ && !controls)
        for (const int c : pockets_.roots()) if (rows.row[c] >= 0) r.diagonal[rows.row[c]] *= 2;
    joinRows(fine.shape, level, rows, r);
    for (const BodyTerm& b : bodies)
        r.bodies.push_back(
            rowsOfBody(grid, fine.shape, rows, b, bodyScale(f), heavyRatio<D>*f.density));

    PressureReport report = controls ? solveCoupled(context, r, rows.stored, *controls)
                                     : solver.solve(r);
    report.wetCells = r.rows() + rows.lone;
    for (int i = 0; i < r.rows(); ++i) level.x(rows.stored[i]) = r.x[i];
    level.storeX(context, fine);
    return report;
}

//- stored: where each row lies on the finest level
template<class Backend, int D, class R>
PressureReport PressureStep<Backend, D, R>::solveCoupled(Context<Backend>& context,
    ReducedSystem& r, const std::vector<int>& stored, const MultigridControls& controls)
{
    const FineData<D>& fine = multigrid_.fine();
    std::vector<float> staged(Backend::gpu ? fine.shape.cells : 0, 0.0f);
    if (!Backend::gpu) context.zero(fine.b, fine.shape.cells*sizeof(float));
    PressureReport report = coupledGradient(r, BodyDeflation(r, DeflationControls()), controls,
        [&](const double* from, double* to)
        {
            float* b = Backend::gpu ? staged.data() : fine.b;
            for (int i = 0; i < r.rows(); ++i) b[stored[i]] = float(from[i]);
            if (Backend::gpu)
                context.toDevice(fine.b, staged.data(), staged.size()*sizeof(float));
            multigrid_.precondition(context, controls.sweeps);
            if (Backend::gpu) context.toHost(staged.data(), fine.z, staged.size()*sizeof(float));
            const float* z = Backend::gpu ? staged.data() : fine.z;
            for (int i = 0; i < r.rows(); ++i) to[i] = z[stored[i]];
        });
    report.solver = ownSolver;
    return report;
}

template<class Backend, int D, class R>
void PressureStep<Backend, D, R>::moveBodies(
    Context<Backend>& context, const PressureFields<D, R>& f, std::vector<BodyTerm>& bodies)
{
    std::vector<double> p(f.grid.cells());
    context.toHost(p.data(), f.p, p.size()*sizeof(double));
    for (BodyTerm& b : bodies) b.advance(p.data(), f.timeStep);
}

//- Ours, without fvSolution
class MultigridLinear : public LinearSolver
{
public:
    MultigridControls controls;
    PressureReport last;

    const MultigridControls* onDevice() const override { return &controls; }
    PressureReport solve(ReducedSystem&) override
    {
        throw std::logic_error("MultigridLinear solves where the grid is");
    }
    void report(const PressureReport& r) override { last = r; }
};

} // namespace riprap

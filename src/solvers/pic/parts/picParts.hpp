/*  What a scene of water in cells consists of. Its parts know what they are made from; what the
    solver does with them is in solvers/pic/driver.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <atomic>
#include "coupling/solidView.hpp"
#include "pic/bodies/bodyCut.hpp"
#include "pic/cutCells/obstacleDistance.hpp"
#include "pic/cutCells/solidField.hpp"
#include "pic/grid/activeRows.hpp"
#include "pic/grid/extrapolate.hpp"
#include "pic/grid/pressureFields.hpp"
#include "pic/multirate/slowTiles.hpp"
#include "pic/transfer/particleToGrid.hpp"
#include "solvers/pic/parts/cutCells.hpp"
#include "solvers/pic/parts/gatheredPressure.hpp"
#include "solvers/pic/parts/gridFields.hpp"
#include "solvers/pic/parts/gridWalls.hpp"
#include "solvers/pic/parts/openSides.hpp"
#include "solvers/pic/parts/picParticleFields.hpp"
#include "solvers/pic/bodies/picBodies.hpp"

namespace riprap
{

//- Solids that move with the water
template<class Backend, int D, class P>
struct SolidsInWater
{
    SolidSide<D, P>* side = nullptr;
    std::unique_ptr<PicBodies<D>> bodies;       // null: there are none
    BodyCut<Backend, D> cut;
    int subcycles = 0;
    // are they where a loaded state has them, and the grid cut elsewhere?
    bool loaded = false;
    // have faces that bodies close no velocity, to the bit?
    bool rest = false;
};

template<class Backend, int D, class P>
struct PicParts
{
    using real = typename P::real;

    PicSetting<Backend, D, P> set;
    PicParticleFields<Backend, D, P> particles{set};
    ParticleToGrid<Backend, D, real> toFaces;
    SlowTiles<Backend, D, real> slow;           // of multirate
    ActiveRows<Backend, D> rows;                // of the step
    SurfaceFields<Backend, D, P> surface{set};
    FaceVelocities<Backend, D, P> faces{set};
    GridWalls<Backend, D, P> walls{set};
    OpenSides<Backend, D, P> openings{set};
    PicInside inside;
    SolidsInWater<Backend, D, P> solids;
    CutCells<Backend, D, P> cut{set};
    PressureOfWater<Backend, D, P> pressure;
    double wallWork = 0;                        // of obstacles that move, since the scene began
    std::atomic<bool> interrupted{false};

    // of several ranks; null: there is one
    std::unique_ptr<HaloExchange<Backend, D>> halo;
    std::unique_ptr<GatheredPressure<Backend, D, P>> gathered;      // null: they divide it

    PicParts(const PicConfig& config, const FluidInput& water, LinearSolver* solver, PicInside&& in)
        : set(ofRanks(config, bool(in.solids)), water), inside(std::move(in)), pressure(set, solver)
    {
        if (!set.bricks) return;
        halo = std::make_unique<HaloExchange<Backend, D>>(set.context, *set.bricks);
        if (set.gathersPressure())
            gathered = std::make_unique<GatheredPressure<Backend, D, P>>(set, *halo);
    }

    PicParts(const PicParts&) = delete;

    //- Bodies are solved for where the equation is divided
    static PicConfig ofRanks(PicConfig config, bool solids)
    {
        if (solids) config.gatheredCells = 0;
        return config;
    }

    //- On any rank
    bool isInterrupted() const { return set.largest(interrupted ? 1 : 0) > 0; }
    bool opens() const { return !openings.faces.empty(); }
    bool multirate() const { return set.config.slowInterval > 1; }
    bool cuts() const { return !inside.empty(); }
    bool sticksInside() const { return cuts() && set.config.noSlip && set.config.viscosity > 0; }

    PressureFields<D, real> pressureFields(double dt, bool useReflected = false);
    //- As PressureStep::project
    PressureReport projectOnRanks(const PressureFields<D, real>&, bool sameWater,
        double tolerance = 0, const BodiesOnGrid<Backend, D>* onGrid = nullptr);

    //- Of cells (direction -1) or faces of the whole block, on the host
    template<class A> auto whole(A& array, int direction) const
    {
        return halo ? halo->gather(array, direction) : array.download();
    }
    //- Of the whole block's nodes to solids
    std::vector<double> nodeDistances() const
    {
        if (!halo) return cut.nodeDistance.download();
        return solids.bodies ? halo->gather(cut.nodeDistance, GridField::nodes)
                             : cut.base.nodeDistance;
    }

    GridVelocities<D, real> gridVelocities(double dt);
    SolidField<D, real> solidField();
    CutFields<D, real> cutFields();

    //- Which faces of a direction have a velocity of their own
    MarkByWetCells<D, real> markFaces(int d)
    {
        return {set.grid, surface.wet.data(), walls.aperture[d].data(),
            sticksInside() ? cut.faceDistance[d].data() : nullptr, d, faces.layer[d].data()};
    }
};

template<class Backend, int D, class P>
PressureFields<D, typename P::real> PicParts<Backend, D, P>::pressureFields(
    double dt, bool useReflected)
{
    PressureFields<D, real> f{};
    f.grid = set.grid;
    f.phi = surface.phi.data();
    for (int d = 0; d < D; ++d)
    {
        f.aperture[d] = walls.aperture[d].data();
        f.wallVelocity[d] = walls.move ? walls.velocity[d].data() : nullptr;
        f.u[d] = faces.u[d].data();
    }
    f.p = (useReflected ? pressure.reflected : pressure.p).data();
    f.timeStep = dt;
    f.density = set.config.density;
    return f;
}

template<class Backend, int D, class P>
PressureReport PicParts<Backend, D, P>::projectOnRanks(const PressureFields<D, real>& f,
    bool sameWater, double tolerance, const BodiesOnGrid<Backend, D>* onGrid)
{
    PressureReport report;
    if (!pressure.solver.onDevice())
        throw std::invalid_argument(
            std::string("several processes need p solved by ") + ownSolver);
    MultigridControls controls = *pressure.solver.onDevice();
    if (tolerance > 0) controls.tolerance = tolerance;
    if (gathered)
    {
        report = gathered->solve(f, pressure.solver, sameWater, tolerance);
        if (!sameWater) pressure.step.markWet(set.context, f);
    }
    else
    {
        report = pressure.step.solveDivided(set.context, f, sameWater, controls, onGrid);
        pressure.solver.report(report);
    }
    pressure.step.correct(set.context, f, &rows);
    return report;
}

template<class Backend, int D, class P>
GridVelocities<D, typename P::real> PicParts<Backend, D, P>::gridVelocities(double dt)
{
    GridVelocities<D, real> v{};
    v.grid = set.grid;
    v.particles = particles.view();
    for (int d = 0; d < D; ++d)
    {
        v.u[d] = (set.config.reflection > 0 ? faces.after : faces.u)[d].data();
        v.du[d] = faces.change[d].data();
        v.fall[d] = real(set.gravity[d]*dt);
    }
    v.nearWater = surface.near.data();
    return v;
}

template<class Backend, int D, class P>
SolidField<D, typename P::real> PicParts<Backend, D, P>::solidField()
{
    SolidField<D, real> f{};
    f.grid = set.grid;
    f.distance = cut.nodeDistance.data();
    for (int d = 0; d < D; ++d)
    {
        f.aperture[d] = walls.aperture[d].data();
        f.wallVelocity[d] = walls.move ? walls.velocity[d].data() : nullptr;
        f.sealed[d] = cut.sealed[d].data();
    }
    return f;
}

//- The grid for bodies to cut
template<class Backend, int D, class P>
CutFields<D, typename P::real> PicParts<Backend, D, P>::cutFields()
{
    CutFields<D, real> f{};
    for (int d = 0; d < D; ++d)
    {
        f.aperture[d] = walls.aperture[d].data();
        f.wallVelocity[d] = walls.velocity[d].data();
        f.baseAperture[d] = cut.baseAperture[d].data();
        f.baseVelocity[d] = cut.base.walls.wallVelocity[d].empty() ? nullptr
                                                                   : cut.baseVelocity[d].data();
    }
    f.distance = cut.nodeDistance.data();
    f.baseDistance = cut.baseDistance.data();
    f.band = bandNodes*set.grid.h;
    return f;
}

} // namespace riprap

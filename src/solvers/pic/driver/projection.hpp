/*  Forces and the pressure of a step, and what they make of the grid's velocities.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/projection/wallWork.hpp"
#include "pic/terms/forces.hpp"
#include "solvers/pic/driver/momentumBudget.hpp"
#include "solvers/pic/driver/picTransfer.hpp"
#include "solvers/pic/driver/rankSums.hpp"
#include "solvers/pic/driver/viscousStep.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class Projection
{
public:

    using real = typename P::real;

    Projection(PicParts<Backend, D, P>& parts, PicTransfer<Backend, D, P>& transfer,
        OpenBoundaries<Backend, D, P>& openings, BodyCoupling<Backend, D, P>& coupling,
        ViscousStep<Backend, D, P>& viscosity, MomentumBudget<Backend, D, P>& budget)
        : p_(parts), transfer_(transfer), openings_(openings), coupling_(coupling),
          viscosity_(viscosity), budget_(budget)
    {}

    void project(double dt, double drift);

private:

    void force(Array<Backend, real>* from, bool gravity, double dt);
    void reflect(double dt, double drift);
    void addWallWork(double dt);

    PicParts<Backend, D, P>& p_;
    PicTransfer<Backend, D, P>& transfer_;
    OpenBoundaries<Backend, D, P>& openings_;
    BodyCoupling<Backend, D, P>& coupling_;
    ViscousStep<Backend, D, P>& viscosity_;
    MomentumBudget<Backend, D, P>& budget_;
};

//- What acts beside the pressure, and gravity and zones that absorb if wanted
template<class Backend, int D, class P>
void Projection<Backend, D, P>::force(Array<Backend, real>* from, bool gravity, double dt)
{
    Context<Backend>& context = p_.set.context;
    FaceVelocities<Backend, D, P>& faces = p_.faces;
    GridWalls<Backend, D, P>& walls = p_.walls;
    p_.rows.eachFace(context,
        [&](int d)
        {
            return ApplyForces<D, real>{walls.aperture[d].data(),
                walls.move ? walls.velocity[d].data() : nullptr, from[d].data(),
                faces.u[d].data(), gravity ? real(p_.set.gravity[d]*dt) : real(0),
                gravity && faces.absorb[d].size() ? faces.absorb[d].data() : nullptr, real(dt)};
        });
}

//- The first of two projections
template<class Backend, int D, class P>
void Projection<Backend, D, P>::reflect(double dt, double drift)
{
    Context<Backend>& context = p_.set.context;
    FaceVelocities<Backend, D, P>& faces = p_.faces;
    PressureOfWater<Backend, D, P>& pressure = p_.pressure;
    // after a step that was much shorter (it ended at a target) the little that its drift did
    // says nothing of a long one
    constexpr double longest = 2;
    const real part = p_.set.clock.steps
        ? real(0.5*std::min(drift/p_.set.clock.lastStep, longest))
        : real(0);
    p_.rows.eachFace(context,
        [&](int d)
        {
            return KeepLast<real>{faces.u[d].data(), faces.before[d].data(),
                faces.after[d].data(), faces.carrier[d].data()};
        });
    if (p_.solids.bodies) coupling_.useVelocities(false);
    force(faces.after, false, dt);
    const MultigridControls* own = pressure.solver.onDevice();
    coupling_.solve(p_.pressureFields(dt, true), false, own ? own->reflectionTolerance : 0);
    p_.rows.eachCellOfBoth(context,
        HalfImpulse{pressure.reflected.data(), pressure.ahead.data(), dt*double(part)});
    p_.rows.eachFace(context,
        [&](int d)
        {
            return HalfDrift<real>{
                faces.u[d].data(), faces.after[d].data(), faces.carrier[d].data(), part};
        });
}

//- Of obstacles that move, in a kick
template<class Backend, int D, class P>
void Projection<Backend, D, P>::addWallWork(double dt)
{
    WallWork<D, real> work{
        p_.set.grid, p_.pressure.step.wet(), p_.pressure.whole().data(), {}};
    for (int d = 0; d < D; ++d)
    {
        if (!p_.cut.pushed[d].size()) return;
        work.flux[d] = p_.cut.pushed[d].data();
    }
    const double sum = p_.halo
        ? sumByRank<1>(p_, work)[0]
        : sumOver<1>(p_.set.context, p_.set.grid.cells(), work)[0];
    p_.wallWork += dt*p_.set.grid.area()*sum;
}

//- Forces, then the pressure; the velocity, its change and what carries particles, extended past
//  the surface.
//
//  Particles bring the velocity of half a step ago to where they are now. Two errors of the order
//  of dt follow, which the last drift tells how to mend.
//  Over a drift u.grad u has a part G that is the gradient of a pressure, and a rest S. Particles,
//  which move at the middle of the coming drift, must be ahead of the projected velocity by dt/2 G:
//  a plain projection (`reflection no`) takes that away and dissipates. The advection-reflection of
//  Zehnder, Narain
//  & Thomaszewski (2018, ACM Trans. Graph. 37) gives G dt and nothing by turns; here it is half of
//  what the last drift's divergence was, each step.
//  And the projected velocity lags by dt/2 S where it carries particles. Both come from one more
//  solution: that of the velocity as particles bring it, less what they were left ahead by, with
//  bodies free from the velocity that they had, less the same impulse's. What is added is then a
//  gradient about the surface and bodies as they are now, and momentum balances. Were bodies moved
//  as given there, the half that is added back would hold work which they never did.
//  The second solution's pressure then lacks what lies in `after`, half of the dynamic pressure:
//  PressureOfWater::whole() has it.
template<class Backend, int D, class P>
void Projection<Backend, D, P>::project(double dt, double drift)
{
    const PicConfig& config = p_.set.config;
    Context<Backend>& context = p_.set.context;
    FaceVelocities<Backend, D, P>& faces = p_.faces;
    SolidsInWater<Backend, D, P>& solids = p_.solids;
    PressureOfWater<Backend, D, P>& pressure = p_.pressure;
    const bool reflects = config.reflection > 0;
    if (reflects) reflect(dt, drift);
    if (config.viscosity > 0) viscosity_.diffuse(dt);
    force(config.viscosity > 0 ? faces.u : faces.before, true, dt);
    if (p_.opens()) openings_.push(dt);
    budget_.keepForced();
    if (solids.bodies) coupling_.project(dt, reflects);
    else if (p_.halo) pressure.last = p_.projectOnRanks(p_.pressureFields(dt), reflects);
    else
        pressure.last = pressure.step.project(
            context, p_.pressureFields(dt), pressure.solver, nullptr, reflects, &p_.rows);
    if (reflects)
        p_.rows.eachCellOfBoth(context,
            WholePressure{pressure.step.wet(), pressure.p.data(), pressure.ahead.data(),
                pressure.total.data(), dt});
    if (p_.cut.base.moves) addWallWork(dt);
    if (solids.bodies)
        solids.bodies->forces.act(coupling_.gather(pressure.whole().data()));
    p_.rows.eachFace(context,
        [&](int d)
        {
            return VelocityChange<real>{faces.u[d].data(), faces.before[d].data(),
                faces.change[d].data(), reflects ? faces.after[d].data() : nullptr,
                reflects ? faces.carrier[d].data() : nullptr};
        });
    budget_.weigh(dt);
    p_.rows.eachFace(context, [&](int d) { return p_.markFaces(d); });
    if (reflects)
        transfer_.extrapolate(
            {faces.u, faces.change, faces.after, faces.carrier}, p_.set.extrapolationPasses, true);
    else transfer_.extrapolate({faces.u, faces.change}, p_.set.extrapolationPasses, true);
}

} // namespace riprap

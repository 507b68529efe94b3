/*  Solids in a step of the fluid. Nothing of this is called in a scene that has none.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/sph/parts/sphParts.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class SolidCoupling
{
public:

    using real = typename P::real;

    explicit SolidCoupling(SphParts<Backend, D, P>& parts) : p_(parts) {}

    //- In a rebuild: their points into the fluid's cells
    void sort();

    //- In a rebuild: is there fluid near any? Until the next one nothing is computed if there is
    //  none
    void findFluid();

    //- Solids over the step that the clock has begun; the fluid's force of its start acts on them
    void advance();

    //- Half a step's impulse of the fluid at once, as the fluid gets it
    void push();

    //- Between two calls of advance solids are read: with the fluid's force of now
    void showForces();

    //- Points to the end of the step, or to its middle
    void move(bool half);

    //- Pressures of their points, of couplings that take them from the fluid
    void pressurePass(bool inStep);

    //- What solids do to the fluid
    template<Part part> void pass();

    //- What the fluid does to solids. pressureForce: where that of the pressure alone is put,
    //  between two steps
    void forcePass(real* pressureForce = nullptr);

    //- As SphScene has it
    CouplingState state();

private:

    template<class F> void withSolidTerms(bool viscous, const F&) const;

    SphParts<Backend, D, P>& p_;
};

//- Sorted by key within a cell: the order does not depend on how the scene came here
template<class Backend, int D, class P>
void SolidCoupling<Backend, D, P>::sort()
{
    forEach(p_.set.context, p_.solids.count,
        PointKeys<D, P>{p_.set.box, p_.set.grid, p_.solids.side->view(), p_.solids.sort.keys(),
            p_.solids.sort.indices()});
    p_.solids.sort.sort(p_.set.context, p_.solids.count);
    PlacePoints<Backend, D, P> place{p_.set.box, p_.solids.side->view(), p_.solids.points(),
        p_.solids.records.view(), {}, p_.set.model, {}};
    for (int d = 0; d < D; ++d)
        place.reference[d] = p_.solids.reference.data() + std::size_t(d)*p_.solids.count;
    if constexpr (Backend::gpu) place.frames = p_.memory.frames.view();
    forEach(p_.set.context, p_.solids.count, place);
    if (p_.solidRanks) p_.solidRanks->settle();
}

template<class Backend, int D, class P>
void SolidCoupling<Backend, D, P>::findFluid()
{
    const bool ranks = bool(p_.solidRanks);
    p_.solids.meets.upload(
        p_.set.context, std::vector<int>(ranks ? std::size_t(p_.solids.count) : 1, 0));
    forEach(p_.set.context, p_.solids.count,
        MeetFluid<D, P>{p_.set.box, p_.set.grid, p_.solids.side->view(), p_.solids.sort.order(),
            p_.solids.sort.active(), p_.fluid.sort.start(), p_.solids.meets.data(), ranks,
            p_.set.grid.radius});
    p_.solids.meetFluid = ranks ? p_.solidRanks->agreeOnMeeting()
                                : p_.solids.meets.download()[0] != 0;
    if (!p_.solids.meetFluid)
        forEach(p_.set.context, p_.solids.count*D, ClearForces<real>{p_.solids.force.data()});
    else if (Backend::gpu)
        forEach(p_.set.context, p_.fluid.n, ClearAction<D, real>{p_.solids.action()});
}

template<class Backend, int D, class P>
void SolidCoupling<Backend, D, P>::push()
{
    if (p_.solids.side->still()) return;
    forEach(p_.set.context, p_.solids.count,
        HoldForces<D, P>{p_.solids.force.data(), nullptr, p_.solids.side->external(), 1, 0});
    p_.solids.side->push(0.5*p_.clock.now.dt);
}

template<class Backend, int D, class P>
void SolidCoupling<Backend, D, P>::advance()
{
    const FluidForceCard& force = p_.solids.fluidForce();
    const double ratio = p_.clock.now.previousDt/p_.clock.now.dt;   // 0 in the first step
    const auto advance = [&](double t, double dt, int steps, const ForceShares& shares)
    {
        const double scale = dt/p_.solids.side->kickTime(dt, steps);
        forEach(p_.set.context, p_.solids.count,
            HoldForces<D, P>{p_.solids.force.data(), p_.solids.forceBefore.data(),
                p_.solids.side->external(), scale*shares.now, scale*shares.before});
        return p_.solids.side->advanceTo(t, dt, steps);
    };
    if (p_.solids.side->still())
    {
        p_.solids.side->advanceTo(p_.clock.now.time, p_.clock.now.dt, p_.solids.subcycles = 1);
        return;
    }
    if (force.blows) push();
    const int steps = p_.solids.subcycles = p_.solids.side->subcycles(p_.clock.now.dt);
    const double begin = p_.clock.now.time - p_.clock.now.dt, part = p_.clock.now.dt/steps;
    const auto end = [&](int k) { return k == steps ? p_.clock.now.time : begin + k*part; };
    bool good = true;
    if (force.eachSubstep)
    {
        for (int k = 0; k < steps && good; ++k)
            good = advance(end(k + 1), part, 1, force.shares(ratio, (k + 0.5)/steps));
        forEach(p_.set.context, p_.solids.count*D,
            KeepForces<real>{p_.solids.force.data(), p_.solids.forceBefore.data()});
    }
    else good = advance(p_.clock.now.time, p_.clock.now.dt, steps, force.shares(ratio, 0.5));
    if (good) return;
    p_.clock.now.halt = Halt::solids;
    p_.clock.now.active = 0;
    p_.clock.write();
}

template<class Backend, int D, class P>
void SolidCoupling<Backend, D, P>::showForces()
{
    if (!p_.solids.side) return;
    forEach(p_.set.context, p_.solids.count,
        HoldForces<D, P>{p_.solids.force.data(), nullptr, p_.solids.side->external(), 1, 0});
}

template<class Backend, int D, class P>
void SolidCoupling<Backend, D, P>::move(bool half)
{
    if (!p_.solids.side || (half && p_.solids.side->still())) return;
    MovePoints<Backend, D, P> move{p_.set.box, p_.solids.side->view(), p_.solids.points(),
        p_.solids.records.view(), {}, p_.set.allowedWay,
        p_.set.config.smoothingRatio*p_.set.config.spacing/p_.set.config.soundSpeed, half,
        p_.clock.data(), {}};
    for (int d = 0; d < D; ++d)
        move.reference[d] = p_.solids.reference.data() + std::size_t(d)*p_.solids.count;
    if constexpr (Backend::gpu) move.frames = p_.memory.frames.view();
    forEach(p_.set.context, p_.solids.count, move);
}

template<class Backend, int D, class P>
template<class F>
void SolidCoupling<Backend, D, P>::withSolidTerms(bool viscous, const F& f) const
{
    SolidPressure pressure{};
    pressure.gradient = couplingOf(p_.solids.coupling.kind).gradient;
    const auto antiClump = p_.set.terms.template get<AntiClump<real>>();
    const auto xsph = p_.set.terms.template get<Xsph<real>>();
    p_.set.terms.withSolidTerms(viscous && p_.solids.coupling.viscosity,
        [&](const auto& viscousTerms)
        {
            f(SolidTerms<std::decay_t<decltype(viscousTerms)>, real>{pressure, Continuity{},
                viscousTerms, Switchable<AntiClump<real>>(antiClump, p_.solids.coupling.antiClump),
                p_.solids.coupling.xsph ? real(2)*xsph.epsilon : real(0)});
        });
}

template<class Backend, int D, class P>
void SolidCoupling<Backend, D, P>::pressurePass(bool inStep)
{
    const CouplingCard& coupling = couplingOf(p_.solids.coupling.kind);
    if (!p_.solids.meetFluid || !coupling.pressed) return;
    withKernel(p_.set.config, [&](auto kernel, auto variable)
    {
        using Kernel = decltype(kernel);
        p_.runOverSolids(SolidPressurePass<Backend, D, P, Kernel, decltype(variable)::value>{
            p_.set.box, p_.set.grid, {p_.fluidAboutSolids()}, p_.solids.records.view(),
            p_.set.template kernelConstants<Kernel>(), p_.set.model, p_.solids.points(),
            coupling.extrapolates, inStep ? p_.clock.data() : nullptr, p_.solidGhosts()});
    });
    if (p_.solidRanks) p_.solidRanks->sharePressures();
}

template<class Backend, int D, class P>
template<Part part>
void SolidCoupling<Backend, D, P>::pass()
{
    if (!p_.solids.meetFluid) return;
    withKernel(p_.set.config, [&](auto kernel, auto variable)
    {
        using Kernel = decltype(kernel);
        withSolidTerms(true, [&](const auto& terms)
        {
            using SolidTerms = std::decay_t<decltype(terms)>;
            constexpr bool variableH = decltype(variable)::value;
            SolidToFluidPass<Backend, D, P, Kernel, variableH, part, SolidTerms> pass{p_.set.box,
                p_.set.grid, {p_.solidSource()}, p_.fluid.records.view(), terms,
                p_.set.template kernelConstants<Kernel>(), p_.set.model, p_.solids.action(),
                p_.solids.mass.data(), {}, p_.fluid.sort.active(), p_.clock.data(), p_.ghosts()};
            for (int d = 0; d < D; ++d) pass.own[d] = p_.solids.own[d].data();
            p_.run(pass, p_.fluid.n);
        });
    });
}

template<class Backend, int D, class P>
void SolidCoupling<Backend, D, P>::forcePass(real* pressureForce)
{
    if (!p_.solids.meetFluid) return;
    SolidPoints<D, P> points = p_.solids.points();
    if (pressureForce) points.force = pressureForce;
    if (p_.solidRanks)
        forEach(p_.set.context, p_.solids.count,
            ClearPointForces<D, P>{points, p_.set.model.mass});
    withKernel(p_.set.config, [&](auto kernel, auto variable)
    {
        using Kernel = decltype(kernel);
        withSolidTerms(!pressureForce, [&](const auto& terms)
        {
            using SolidTerms = std::decay_t<decltype(terms)>;
            constexpr bool variableH = decltype(variable)::value;
            p_.runOverSolids(FluidToSolidPass<Backend, D, P, Kernel, variableH, SolidTerms>{
                p_.set.box, p_.set.grid, {p_.fluidAboutSolids()}, p_.solids.records.view(), terms,
                p_.set.template kernelConstants<Kernel>(), p_.set.model, points,
                pressureForce ? nullptr : p_.clock.data(), p_.solidGhosts()});
        });
    });
    if (p_.solidRanks) p_.solidRanks->shareForces(points);
}

template<class Backend, int D, class P>
CouplingState SolidCoupling<Backend, D, P>::state()
{
    CouplingState s;
    if (!p_.solids.side) return s;
    p_.clock.read();
    s.subcycles = p_.solids.subcycles;
    const std::vector<real> force = p_.solids.force.download();
    const std::vector<real> before = p_.solids.forceBefore.size()
        ? p_.solids.forceBefore.download()
        : std::vector<real>(force.size(), real(0));
    const std::vector<std::int32_t> keys = p_.solids.side->order();
    s.force.assign(3*keys.size(), 0.0);
    for (std::size_t i = 0; i < keys.size(); ++i)
        for (int d = 0; d < D; ++d)
        {
            const std::size_t at = std::size_t(keys[i])*D + d;
            const double f = force[at];
            s.force[3*i + p_.set.config.axes[d]] = f;
            s.total[p_.set.config.axes[d]] += f;
            if (!p_.solids.fluidForce().blows)
                s.pending[p_.set.config.axes[d]] += 0.5*p_.clock.now.dt*(f - before[at]);
        }
    return s;
}

} // namespace riprap

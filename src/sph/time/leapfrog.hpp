/*  Leapfrog in kick-drift-kick form (paper section 3.3, ref. 45): one pass over the pairs a step.

        v_{n+1/2} = v_n + a_n dt/2;  rho likewise
        x_{n+1}   = x_n + (v_{n+1/2} + drift_n) dt
        pass at x_{n+1} with v, rho predicted to n+1 by a_n, rate_n
        v_{n+1}   = v_{n+1/2} + a_{n+1} dt/2;  rho likewise      (FluidPass::finish)

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/neighbours/localFrames.hpp"
#include "core/containers/ghostMarks.hpp"
#include "sph/boundary/faceContact.hpp"
#include "sph/state/fluidFields.hpp"
#include "sph/state/clock.hpp"
#include "sph/terms/term.hpp"
#include "sph/time/card.hpp"

namespace riprap
{

//- What moving particles share: records, the aged-neighbours check, and the domain
template<class Backend, int D, class P>
struct Mover
{
    using real = typename P::real;

    Box<D, P> box;
    FluidModel<D, P> model;
    FluidFields<D, P> fluid;
    RecordsView<Backend, D, P> records;
    typename P::position* reference[D];     // pair positions when the neighbours were found
    real allowedWay;
    LocalFrames<D, P> frames;               // GPU: what the way since then is measured against
    const int* count;
    ClockData* clock;
    FaceContact<D, P> contact;
    GhostMarks<Backend> ghosts;             // moved where they are own ones

    //- Of a scene without other ranks, faces, drift, variable h and removal of wild particles
    HD bool isPlain() const
    {
        return !ghosts.mark && !contact.faces.groups && !model.drifts && !model.variableH
            && !model.removesWild;
    }

    //- Move by u dt; returns the new position
    HD Vec<D, std::int64_t> moved(
        const Vec<D, std::int64_t>& x, const Vec<D, real>& u, double dt) const
    {
        Vec<D, std::int64_t> r;
        for (int d = 0; d < D; ++d)
            r.c[d] = x.c[d] + std::int64_t(rint(double(u.c[d])*dt*box.unitsPerMetre[d]));
        return r;
    }

    HD Vec<D, std::int64_t> position(int i) const
    {
        Vec<D, std::int64_t> x;
        for (int d = 0; d < D; ++d) x.c[d] = fluid.x[d][i];
        return x;
    }

    HD Vec<D, real> drift(int i) const
    {
        Vec<D, real> u = filled<D>(real(0));
        if (model.drifts) for (int d = 0; d < D; ++d) u.c[d] = fluid.drift[d][i];
        return u;
    }

    //- Back onto the face that it went behind
    HD void keepOut(int i, const Vec<D, real>& kick, Vec<D, std::int64_t>& x, Vec<D, real>& v) const
    {
        if (!contact.faces.groups) return;
        const Vec<D, real> before = v;
        contact.keepOut(box, model.gravity, kick, x, v, clock);
        for (int d = 0; d < D; ++d) if (v.c[d] != before.c[d]) fluid.v[d][i] = v.c[d];
    }

    //- Write what pairs see. \return h
    HD real record(
        int i, const Vec<D, std::int64_t>& x, const Vec<D, real>& v, real deviation) const
    {
        Vec<D, typename P::position> p;
        for (int d = 0; d < D; ++d) p.c[d] = box.pairPosition(d, x.c[d]);
        records.storePosition(i, p);
        const PairParticle<D, real> pair = pairParticle(model, v, deviation);
        records.store(i, pair);
        return pair.h;
    }

    //- After a step, whose h lists must hold; on the CPU, which walks rows of cells, the limit of h
    //  costs nothing
    HD void recordMoved(
        int i, const Vec<D, std::int64_t>& x, const Vec<D, real>& v, real deviation) const
    {
        [[maybe_unused]] const real h = record(i, x, v, deviation);
        if (Backend::gpu && model.variableH) clock->noticeH(float(h), float(model.hMax));
    }

    //- A particle that runs wild leaves with the next sort; until then pairs see it at rest, and
    //  beyond their reach where the box has an edge. Its state stays, to be reported
    HD bool tookOut(int i, const Vec<D, real>& v, real deviation) const
    {
        if (!model.removesWild) return false;
        real a2 = 0;
        for (int d = 0; d < D; ++d) a2 += fluid.a[d][i]*fluid.a[d][i];
        if (!model.wild(deviation, squaredNorm(v), a2)) return false;
        Vec<D, std::int64_t> x = position(i);
        for (int d = 0; d < D; ++d) if (!box.periodic[d]) x.c[d] = box.toFixed(d, box.lower[d]);
        record(i, x, filled<D>(real(0)), real(0));
        if (fluid.id[i] >= 0) fluid.id[i] = -1 - fluid.id[i];
        clock->needRebuild = 1;
        return true;
    }

    //- Ask for new neighbours before the next step could carry the particle past half the skin. The
    //  margin covers a growing step and one step's acceleration.
    HD void checkSkin(int i, const Vec<D, std::int64_t>& x, const Vec<D, real>& u) const
    {
        if constexpr (Backend::gpu) if (frames.frame) return checkFrame(i, x, u);
        real distance2 = 0, speed2 = 0;
        for (int d = 0; d < D; ++d)
        {
            const real s = box.template separation<real>(
                d, box.pairPosition(d, x.c[d]), reference[d][i]);
            distance2 += s*s;
            speed2 += u.c[d]*u.c[d];
        }
        const real distance = squareRoot(distance2);
        const real margin = real(1.25)*squareRoot(speed2)*real(clock->fullDt);
        if (distance > allowedWay) clock->skinViolations = 1;
        if (distance + margin > allowedWay || !model.inside(box, x)) clock->needRebuild = 1;
    }

private:

    //- The same against what is around it
    HD void checkFrame(int i, const Vec<D, std::int64_t>& x, const Vec<D, real>& u) const
    {
        Vec<D, typename P::position> from, p;
        for (int d = 0; d < D; ++d)
        {
            from.c[d] = reference[d][i];
            p.c[d] = box.pairPosition(d, x.c[d]);
        }
        const real time = real(clock->time - clock->searched),
                   ahead = real(1.25)*real(clock->fullDt);
        WaySince<real> way = frames.since(box, from, p, u, time, ahead);
        // what is at rest in its frame may be on its way in a step
        real a2 = 0;
        for (int d = 0; d < D; ++d) a2 += fluid.a[d][i]*fluid.a[d][i];
        const real pushed = ahead*ahead*squareRoot(a2);
        way.relativeNext += pushed;
        way.wholeNext += pushed;
        clock->notice(way, allowedWay);
        if (!model.inside(box, x)) clock->needRebuild = 1;
    }
};

//- For the CPU: moves particles of a plain scene, and asks none of them whether it is one
template<class M>
struct PlainMover
{
    static constexpr const char* name = M::name;

    M mover;

    HD void operator()(int i) const
    {
        if (!mover.isPlain()) __builtin_unreachable();
        mover(i);
    }
};

template<class Backend, int D, class P>
struct LeapfrogDrift : Mover<Backend, D, P>
{
    using real = typename P::real;
    static constexpr const char* name = "leapfrogDrift";
    static constexpr int residentBlocks = 12;    // as of symplecticDrift

    HD void operator()(int i) const
    {
        const ClockData& c = *this->clock;
        if (!c.active || i >= *this->count || this->ghosts(i)) return;
        const FluidFields<D, P>& f = this->fluid;
        const real half = real(0.5*c.dt);
        Vec<D, real> v, a;
        for (int d = 0; d < D; ++d)
        {
            a.c[d] = f.a[d][i];
            v.c[d] = f.v[d][i] + a.c[d]*half;
            f.v[d][i] = v.c[d];
        }
        const real rate = f.rate[i];
        const real deviation = f.deviation[i] + rate*half;
        f.deviation[i] = deviation;
        if (this->tookOut(i, v, deviation + rate*half)) return;
        const Vec<D, real> u = v + this->drift(i);
        Vec<D, std::int64_t> x = this->moved(this->position(i), u, c.dt);
        this->keepOut(i, half*a, x, v);
        for (int d = 0; d < D; ++d) f.x[d][i] = x.c[d];
        this->recordMoved(i, x, v + half*a, deviation + rate*half);
        this->checkSkin(i, x, u);
    }
};

struct SphLeapfrog : IntegratorCard
{
    static constexpr const char* word = "leapfrog";
    static constexpr const char* text = "kick, drift, kick: one pass over the pairs a step";
    static constexpr int passes = 1;
    // unless density is diffused sound waves need the shorter step (docs/theory). No scene stands
    // the highest (benchmarks/README.md: 0.595)
    static constexpr double acousticCourant = 0.2, highestCourant = 0.7;

    template<class Step>
    static void run(Step& step)
    {
        step.template move<LeapfrogDrift>();
        step.moveToEnd();
        step.template pass<Part::all>();
    }
};

} // namespace riprap

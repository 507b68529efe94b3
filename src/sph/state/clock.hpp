/*  The clock: time, step and stop conditions, kept on the device so that steps follow one another
    without the host.

    Before each step `Tick` turns the maxima of the last pass into the next step (docs/theory, "What
    limits the step"):
        acoustic  dt <= Ca h/(c + |v|)max
        force     dt <= Cf sqrt(h/|a|max)
        viscous   dt <= Cv h^2/nu
    with the h of the largest density deviation where h varies: no particle has a smaller one,
    shortens it to land on the target time, and switches the steps off when the target is reached,
    the neighbour structures have aged, or a guard fires.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cmath>
#include <cstdint>
#include "core/backend/launch.hpp"
#include "core/neighbours/localFrames.hpp"

namespace riprap
{

enum class Limit : int {none, acoustic, force, viscous, fixed, target, maximum, growth};
enum class Halt : int {none, notANumber, density, speed, solids};

//- What faces of walls did since the start (sph/boundary/faceContact.hpp), in whole units: sums do
//  not depend on an order
struct FaceTally
{
    std::int64_t contacts = 0, energy = 0, impulse[3] = {0, 0, 0};
    std::int64_t atBodies = 0;          // of contacts
};

//- Without padding, so that saved states of equal runs are equal words
struct ClockData
{
    double time = 0, target = 0;
    double dt = 0;              // of the step in hand
    double previousDt = 0;      // of the one before it
    double fullDt = 0;          // before shortening to the target
    double minDt = 1e300, maxDt = 0;
    std::int64_t step = 0, lastStep = 0;    // taken; stop at
    int active = 0;
    int needRebuild = 0;
    int overflow[5] = {0, 0, 0, 0, 0};      // neighbour lists that did not fit: room needed
    int skinViolations = 0;
    float foundH = 0;           // where h varies: the largest when neighbours were sought [m]
    Limit limit = Limit::none;
    Halt halt = Halt::none;
    float maxima[maximaCount] = {};         // |a|^2, c + |v|, |deviation|, |v| of the last pass
    float speed = 0;            // largest c + |v|, and the others, seen by the last tick
    float acceleration = 0;
    float deviation = 0;
    // neighbours, by the ways of particles against those near them; by the ways alone
    int aged[2] = {0, 0};
    int missed[2] = {0, 0};     // pairs may have been, likewise
    double searched = 0;        // when neighbours were sought

    FaceTally faces;

    //- Lists reach as far as this growth of the largest h; beyond half of it they are made anew
    static constexpr float growthOfH = 0.02f;

    //- How large h may become before pairs are missed, when its limit is `most` [m]
    HD float listedH(float most) const
    {
        const float h = (1 + growthOfH)*foundH;
        return h < most ? h : most;
    }

    //- An h after a step
    HD void noticeH(float h, float most)
    {
        const float listed = listedH(most);
        if (!(h > (1 + 0.5f*growthOfH)*foundH) || listed == most) return;
        if (h > listed) skinViolations = 1;
        needRebuild = 1;
    }

    //- A particle's way: does it still hold, and after the next step? Read before written: the
    //  whole way of nearly everyone is too long for the box at rest, and a million stores to one
    //  word take longer than the step
    template<class R>
    HD void notice(const WaySince<R>& way, R halfSkin)
    {
        if ((way.relative > halfSkin || way.whole > way.limit) && !missed[0]) missed[0] = 1;
        if (way.whole > halfSkin && !missed[1]) missed[1] = 1;
        if ((way.relativeNext > halfSkin || way.wholeNext > way.limit) && !aged[0]) aged[0] = 1;
        if (way.wholeNext > halfSkin && !aged[1]) aged[1] = 1;
    }

    //- Lists hold as long as one of the two says so
    HD void settleAge()
    {
        if (aged[0] && aged[1]) needRebuild = 1;
        if (missed[0] && missed[1]) skinViolations = 1;
    }

    //- Neighbours are new
    HD void search()
    {
        settleAge();
        needRebuild = aged[0] = aged[1] = missed[0] = missed[1] = 0;
        searched = time;
    }

    HD bool overflows() const
    {
        bool any = false;
        for (const int o : overflow) any = any || o != 0;
        return any;
    }
};

static_assert(sizeof(ClockData) == 16*8 + 22*4, "ClockData has padding");

struct StepLimits
{
    bool adjust;
    double fixedDt, maxDt;
    double acoustic, force;     // Courant numbers
    double h0;                  // smoothing length at rest density [m]
    double leastH;              // where h varies: its limit [m]; else h0
    int dimensions;             // h rho^(1/dimensions) is constant
    double viscousDt;           // Cv h0^2/nu [s]
    double maxDeviation, maxSpeed;          // guards: |rho/rho0 - 1|, |v| [m/s]
    double growth;              // a step is at most this much longer than the one before

    //- Does a guard fire for the maxima of the last pass?
    HD Halt halt(const ClockData& c) const
    {
        if (!(c.maxima[0] < 1e30f) || !(c.maxima[1] < 1e30f) || !(c.maxima[2] < 1e30f))
            return Halt::notANumber;
        if (c.maxima[2] > maxDeviation) return Halt::density;
        return c.maxima[3] > maxSpeed ? Halt::speed : Halt::none;
    }
};

struct Tick
{
    static constexpr const char* name = "clock";

    ClockData* clock;
    StepLimits limits;

    //- A bound of the smallest smoothing length [m]
    HD double smallestH(double deviation) const
    {
        if (limits.leastH >= limits.h0) return limits.h0;
        const double h = limits.dimensions == 2 ? limits.h0/sqrt(1 + deviation)
                                                : limits.h0/cbrt(1 + deviation);
        return h > limits.leastH ? h : limits.leastH;
    }

    //- The longest admissible step for the maxima at hand
    HD double longest(const ClockData& c, Limit& limit) const
    {
        if (!limits.adjust) { limit = Limit::fixed; return limits.fixedDt; }
        const double h = smallestH(double(c.maxima[2])), shrinkage = h/limits.h0;
        double dt = limits.acoustic*h/double(c.maxima[1]);
        limit = Limit::acoustic;
        const double a = sqrt(double(c.maxima[0]));
        if (a > 0)
        {
            const double force = limits.force*sqrt(h/a);
            if (force < dt) { dt = force; limit = Limit::force; }
        }
        const double viscous = limits.viscousDt*shrinkage*shrinkage;
        if (viscous < dt) { dt = viscous; limit = Limit::viscous; }
        if (limits.maxDt < dt) { dt = limits.maxDt; limit = Limit::maximum; }
        return dt;
    }

    HD void operator()(int) const
    {
        ClockData& c = *clock;
        c.active = 0;
        c.settleAge();
        if (c.halt != Halt::none || c.needRebuild) return;
        if (c.overflows()) return;
        c.acceleration = sqrtf(c.maxima[0]);
        c.speed = c.maxima[1];
        c.deviation = c.maxima[2];
        c.halt = limits.halt(c);
        if (c.halt != Halt::none || c.time >= c.target || c.step >= c.lastStep) return;

        Limit limit;
        double dt = longest(c, limit);
        if (limits.adjust && c.fullDt > 0 && dt > limits.growth*c.fullDt)
        {
            dt = limits.growth*c.fullDt;
            limit = Limit::growth;
        }
        c.fullDt = dt;
        const double remaining = c.target - c.time;
        bool last = false;
        if (dt >= remaining*(1 - 1e-9))
        {
            last = true;
            if (dt > remaining*(1 + 1e-9)) limit = Limit::target;
            dt = remaining;
        }
        else if (limits.adjust && 2*dt > remaining) { dt = 0.5*remaining; limit = Limit::target; }
        c.previousDt = c.dt;
        c.dt = dt;
        c.time = last ? c.target : c.time + dt;
        c.step += 1;
        c.limit = limit;
        c.minDt = dt < c.minDt ? dt : c.minDt;
        c.maxDt = dt > c.maxDt ? dt : c.maxDt;
        for (int k = 0; k < maximaCount; ++k) c.maxima[k] = 0;
        c.active = 1;
    }
};

} // namespace riprap

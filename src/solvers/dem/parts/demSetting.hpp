/*  What all parts of a scene of solids refer to.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/launch.hpp"
#include "core/simd/precision.hpp"
#include "dem/motion/integrators.hpp"
#include "dem/state/clock.hpp"
#include "solvers/dem/demLaws.hpp"

namespace riprap
{

template<class Backend, int D, class P>
struct DemSetting
{
    DemConfig config;
    LawChoice laws;
    DemIntegrator integrator;
    DemInput input;             // without particles and bonds
    DemPlan plan;
    Context<Backend> context{};
    Box<D, P> box{};

    //- Particles and bonds go to the device: the host keeps no second copy of millions
    DemSetting(const DemConfig& c, const DemInput& in, const DemPlan& p)
    :
        config(c), laws(lawChoice(c)), integrator(demIntegratorOf(c.integrator)), plan(p)
    {
        input.materials = in.materials;
        input.pairs = in.pairs;
        input.groups = in.groups;
        input.clumps = in.clumps;
        input.bondTypes = in.bondTypes;
        input.walls = in.walls;
        input.groupMotion = in.groupMotion;
        input.wallMotion = in.wallMotion;
        if (input.groups.empty()) input.groups.emplace_back();
    }

    DemSetting(const DemSetting&) = delete;

    //- Sign of a spin about axes[2] when axes[0], axes[1] are the plane
    double spinSign() const
    {
        const int* a = config.axes;
        return (a[1] - a[0] + 3) % 3 == 1 ? 1 : -1;
    }
};

//- The clock on the device (two: that of the step, and the next one) and as the host last saw it,
//  or is about to set it
template<class Backend>
class SceneClock
{
public:

    DemClockData now;

    explicit SceneClock(Context<Backend>& context) : context_(context)
    {
        clock_.allocate(context_, 2);
    }

    DemClockData* data() { return clock_.data(); }
    void read() { context_.toHost(&now, clock_.data(), sizeof(DemClockData)); }
    void write() { forEach(context_, 2, SetDemClock{now, clock_.data()}); }

private:

    Context<Backend>& context_;
    Array<Backend, DemClockData> clock_;
};

} // namespace riprap

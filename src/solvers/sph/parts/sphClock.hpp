/*  The clock of a scene of fluid.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/launch.hpp"
#include "sph/state/clock.hpp"

namespace riprap
{

inline const char* wordOf(Limit limit)
{
    static const char* words[] = {
        "none", "acoustic", "force", "viscous", "fixed", "target", "maximum", "growth"};
    return words[int(limit)];
}

//- On the device, and as the host last saw it or is about to set it
template<class Backend>
class SphClock
{
public:

    ClockData now;

    explicit SphClock(Context<Backend>& context) : context_(context)
    {
        clock_.allocate(context_, 1);
    }

    ClockData* data() { return clock_.data(); }
    const ClockData* data() const { return clock_.data(); }
    void read() { context_.toHost(&now, clock_.data(), sizeof(ClockData)); }
    void write() { context_.toDevice(clock_.data(), &now, sizeof(ClockData)); }

    //- For the host to change between two launches, and back
    ClockData& taken()
    {
        if (!Backend::gpu) return *clock_.data();
        read();
        return now;
    }
    void give() { if (Backend::gpu) write(); }

    //- Has the device come to the target, the last step, or to a guard?
    bool over() const
    {
        return now.halt != Halt::none || now.time >= now.target || now.step >= now.lastStep;
    }

private:

    Context<Backend>& context_;
    Array<Backend, ClockData> clock_;
};

} // namespace riprap

/*  DemSolver: who falls asleep and who wakes (dem/passes/sleep.hpp).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/dem/demSolver.hpp"

namespace riprap
{

//- fused: between fused steps, when motion lies in their state
template<class Backend, int D, class P>
SleepState<D, P> DemSolver<Backend, D, P>::sleepState(bool fused)
{
    SleepState<D, P> s{};
    s.fields = fields();
    s.solids = records_.view();
    if (fused)
    {
        s.state = stepState();
        s.solids = s.state.from;
    }
    s.active = sort_.active();
    s.wakes = wakes_.data();
    s.waits = waits_.data();
    s.needed = std::int32_t(std::min(1e5, std::max(2.0, std::ceil(config_.sleepAfter/(stepsPerCheck*plan_.timeStep)))));
    return s;
}

//- Where histories are kept at both ends, before those that are marked wake
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::takeHistories(const SleepState<D, P>& s)
{
    if constexpr (Backend::gpu)
        withLaw(laws_, [&](auto law)
        {
            forEach(context_, n_, TakeHistories<Backend, D, P>{s, list_.view(), histories_, decltype(law)::template turnsFrom<D>});
        });
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::checkSleep(bool fused)
{
    const SleepState<D, P> s = sleepState(fused);
    const bool walls = nWalls_ && wallMemory_.entries;
    forEach(context_, n_, CountCalm<D, P>
    {s, real(config_.sleepSpeed), walls ? wallMemory_.entryFirst.data() : nullptr, wallMemory_.entry.data(), walls_.data()});
    forEach(context_, n_, MarkRestless<Backend, D, P>{s, list_.view(), bondTable(), slotOf_.data()});
    takeHistories(s);
    forEach(context_, n_, FallAsleep<D, P>{s, groups_.data()});
    setRanges();
}

//- A change that could set a sleeper in motion faster than v_s within the time after which it sleeps
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::wakeChanged(const std::vector<real>& before, const std::vector<real>& after)
{
    constexpr int numbers = D + S;
    const double span = std::max(config_.sleepAfter, 2.0*stepsPerCheck*plan_.timeStep);
    const auto key = field<std::int32_t>(idField_);
    const auto mass = field<real>(massField_), radius = field<real>(radiusField_);
    std::vector<std::int32_t> changed(n_, 0);
    for (int i = 0; i < activeSolids(); ++i)
    {
        double change = 0;
        for (int c = 0; c < numbers; ++c)
        {
            const std::size_t at = std::size_t(key[i])*numbers + c;
            const double difference = double(after[at]) - (before.empty() ? 0.0 : double(before[at]));
            change += std::abs(difference)/(c < D ? 1.0 : double(radius[i]));
        }
        changed[key[i]] = change*span > config_.sleepSpeed*double(mass[i]);
    }
    Array<Backend, std::int32_t> marks;
    marks.upload(context_, changed);
    const SleepState<D, P> s = sleepState(false);
    forEach(context_, n_, MarkChanged<D, P>{s, marks.data()});
    takeHistories(s);
    forEach(context_, n_, WakeMarked<D, P>{s});
    setRanges();
    context_.synchronise();
}

template<class Backend, int D, class P>
std::size_t DemSolver<Backend, D, P>::asleepNow()
{ return std::size_t(sumOver<1>(context_, n_, CountAsleep{fields().calm, sort_.active()})[0]); }

} // namespace riprap

/*  Who falls asleep and who wakes (dem/passes/sleep.hpp).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/passes/sleep.hpp"
#include "solvers/dem/driver/neighbours.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class Sleepers
{
public:

    using real = typename P::real;
    static constexpr int S = spins<D>;
    static constexpr int stepsPerCheck = 8;

    Sleepers(DemParts<Backend, D, P>& parts, ContactForces<Backend, D, P>& forces,
        Neighbours<Backend, D, P>& neighbours)
        : p_(parts), forces_(forces), neighbours_(neighbours)
    {}

    //- Memory, where solids sleep
    void allocate();

    //- fused: between fused steps, when motion lies in their state
    void check(bool fused);
    void wakeChanged(const std::vector<real>& before, const std::vector<real>& after);
    std::size_t asleep();

private:

    SleepState<D, P> state(bool fused);
    // where sleepers that nobody touches need not be asked (CPU)
    bool looksNear() const;
    template<class Kernel> void ofNear(const Kernel&, bool looking);
    void takeHistories(const SleepState<D, P>&);

    DemParts<Backend, D, P>& p_;
    ContactForces<Backend, D, P>& forces_;
    Neighbours<Backend, D, P>& neighbours_;
    Array<Backend, std::int32_t> wakes_, waits_;
};

template<class Backend, int D, class P>
SleepState<D, P> Sleepers<Backend, D, P>::state(bool fused)
{
    SleepState<D, P> s{};
    s.fields = p_.particles.view();
    s.solids = p_.order.records.view();
    if (fused)
    {
        s.state = forces_.stepState();
        s.solids = s.state.from;
    }
    s.active = p_.order.sort.active();
    s.wakes = wakes_.data();
    s.waits = waits_.data();
    s.needed = std::int32_t(std::min(1e5,
        std::max(
            2.0, std::ceil(p_.set.config.sleepAfter/(stepsPerCheck*p_.set.plan.timeStep)))));
    return s;
}

//- What wakes comes from neighbours alone
template<class Backend, int D, class P>
bool Sleepers<Backend, D, P>::looksNear() const
{
    return !Backend::gpu && !p_.bonds.count() && !p_.motion.walls();
}

//- Over all; near sleepers' neighbours alone, or those of them whose lists are looked at
template<class Backend, int D, class P>
template<class Kernel>
void Sleepers<Backend, D, P>::ofNear(const Kernel& kernel, [[maybe_unused]] bool looking)
{
#ifndef __CUDACC__
    if constexpr (!Backend::gpu)
        if (looksNear())
        {
            const AwakeLists& awake = p_.memory.deferred.awake;
            const std::vector<int>& list = looking ? awake.looking : awake.near;
            forEach(p_.set.context, int(list.size()), OverList<Kernel>{kernel, list.data()});
            return;
        }
#endif
    forEach(p_.set.context, p_.particles.n, kernel);
}

//- Where histories are kept at both ends, before those that are marked wake
template<class Backend, int D, class P>
void Sleepers<Backend, D, P>::takeHistories(const SleepState<D, P>& s)
{
    if constexpr (Backend::gpu)
        withLaw(p_.set.laws, [&](auto law)
        {
            forEach(p_.set.context, p_.particles.n, TakeHistories<Backend, D, P>
            {s, p_.order.list.view(), p_.pairs.histories(), decltype(law)::template turnsFrom<D>});
        });
}

template<class Backend, int D, class P>
void Sleepers<Backend, D, P>::check(bool fused)
{
    SleepState<D, P> s = state(fused);
    std::int32_t stirs = Backend::gpu, changed = 0;
    if constexpr (!Backend::gpu)
    {
        s.stirs = &stirs;
        s.changed = &changed;
    }
    const bool walls = p_.walls.count && p_.walls.memory.entries;
    ofNear(CountCalm<D, P>{s, real(p_.set.config.sleepSpeed),
               walls ? p_.walls.memory.entryFirst.data() : nullptr, p_.walls.memory.entry.data(),
               p_.walls.walls.data()},
        false);
    if (!stirs) return;
    // whoever falls asleep keeps its forces
    forces_.collectForces();
    ofNear(MarkRestless<Backend, D, P>{
               s, p_.order.list.view(), p_.bonds.table(), p_.order.slotOf.data()},
        true);
    takeHistories(s);
    ofNear(FallAsleep<D, P>{s, p_.groups.data()}, false);
    if (changed) neighbours_.setRanges();
}

//- A change that could set a sleeper in motion faster than v_s within the time after which it
//  sleeps
template<class Backend, int D, class P>
void Sleepers<Backend, D, P>::wakeChanged(
    const std::vector<real>& before, const std::vector<real>& after)
{
    constexpr int numbers = D + S;
    const double span = std::max(p_.set.config.sleepAfter, 2.0*stepsPerCheck*p_.set.plan.timeStep);
    const auto key = p_.particles.template field<std::int32_t>(p_.particles.at.id);
    const auto mass = p_.particles.template field<real>(p_.particles.at.mass),
               radius = p_.particles.template field<real>(p_.particles.at.radius);
    std::vector<std::int32_t> changed(p_.particles.n, 0);
    for (int i = 0, last = p_.order.active(); i < last; ++i)
    {
        double change = 0;
        for (int c = 0; c < numbers; ++c)
        {
            const std::size_t at = std::size_t(key[i])*numbers + c;
            const double difference = double(after[at])
                - (before.empty() ? 0.0 : double(before[at]));
            change += std::abs(difference)/(c < D ? 1.0 : double(radius[i]));
        }
        changed[key[i]] = change*span > p_.set.config.sleepSpeed*double(mass[i]);
    }
    Array<Backend, std::int32_t> marks;
    marks.upload(p_.set.context, changed);
    const SleepState<D, P> s = state(false);
    forEach(p_.set.context, p_.particles.n, MarkChanged<D, P>{s, marks.data()});
    takeHistories(s);
    forEach(p_.set.context, p_.particles.n, WakeMarked<D, P>{s});
    neighbours_.setRanges();
    p_.set.context.synchronise();
}

template<class Backend, int D, class P>
std::size_t Sleepers<Backend, D, P>::asleep()
{
    return std::size_t(sumOver<1>(p_.set.context, p_.particles.n,
        CountAsleep{p_.particles.view().calm, p_.order.sort.active()})[0]);
}

template<class Backend, int D, class P>
void Sleepers<Backend, D, P>::allocate()
{
    if (!p_.sleeps()) return;
    wakes_.allocate(p_.set.context, p_.particles.n);
    waits_.allocate(p_.set.context, p_.particles.n);
}

} // namespace riprap

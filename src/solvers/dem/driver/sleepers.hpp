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
    const SleepState<D, P> s = state(fused);
    const bool walls = p_.walls.count && p_.walls.memory.entries;
    forEach(p_.set.context, p_.particles.n,
        CountCalm<D, P>{s, real(p_.set.config.sleepSpeed),
            walls ? p_.walls.memory.entryFirst.data() : nullptr, p_.walls.memory.entry.data(),
            p_.walls.walls.data()});
    forEach(p_.set.context, p_.particles.n,
        MarkRestless<Backend, D, P>{
            s, p_.order.list.view(), p_.bonds.table(), p_.order.slotOf.data()});
    takeHistories(s);
    forEach(p_.set.context, p_.particles.n, FallAsleep<D, P>{s, p_.groups.data()});
    neighbours_.setRanges();
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

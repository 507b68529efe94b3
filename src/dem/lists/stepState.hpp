/*  The state of solids while steps are fused (GPU): each particle's motion lies in the records that
    contacts read, twice, since a step reads the old ones of its neighbours while it writes its own
    new ones; and beside them what the records have rounded away.

        mixed   x: 64-bit fixed point = the record's upper 32 bits and `low.x`; v: record + `low.v`,
                48 bits in all
        double  x: `low.x`, all of it;  v: the record's

    A step then moves 24 words of a particle's state where the fields' own layout would take 60.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/state/solidFields.hpp"
#include "dem/lists/solidRecords.hpp"

namespace riprap
{

template<class P> struct LowWords;
template<> struct alignas(8) LowWords<Mixed> { std::uint32_t x; float v; };
template<> struct alignas(8) LowWords<Double> { std::int64_t x; };

//- What a particle's own step reads of it, and no neighbour does
template<class R>
struct alignas(16) OwnWords
{
    R inverseInertia;
    std::int32_t group, id, flags;

    static constexpr std::int32_t nearWall = 1, bonded = 2, asleep = 4;
};

template<int D, class P>
struct StepState
{
    using real = typename P::real;
    using position = typename P::position;

    SolidRecords<D, P> from, to;    // at the step's start and at its end
    LowWords<P>* low[D];
    OwnWords<real>* own;            // null: steps are not fused

    static HD LowWords<P> lowOf(std::int64_t x, [[maybe_unused]] double v)
    {
        if constexpr (sizeof(real) == 4)
            return LowWords<P>{std::uint32_t(x), float(v - double(float(v)))};
        else return LowWords<P>{x};
    }

    static HD std::int64_t whole([[maybe_unused]] position high, const LowWords<P>& l)
    {
        if constexpr (sizeof(real) == 4)
            return std::int64_t(std::uint64_t(std::uint32_t(high)) << 32 | l.x);
        else return l.x;
    }

    static HD double wholeVelocity(real high, [[maybe_unused]] const LowWords<P>& l)
    {
        if constexpr (sizeof(real) == 4) return double(high) + double(l.v);
        else return high;
    }

    HD Vec<D, std::int64_t> place(int i) const
    {
        const Vec<D, position> high = from.position(i);
        Vec<D, std::int64_t> x;
        for (int d = 0; d < D; ++d) x.c[d] = whole(high.c[d], low[d][i]);
        return x;
    }
};

//- From the fields: the low words and a particle's own
template<int D, class P>
struct OpenSteps
{
    static constexpr const char* name = "openSteps";

    StepState<D, P> state;
    SolidFields<D, P> fields;
    const int* bondFirst;           // of an id; null: there are no bonds
    const int* wallFirst;           // entries of a particle; null: no walls
    const int* active;

    HD void operator()(int i) const
    {
        if (i >= *active) return;
        for (int d = 0; d < D; ++d)
            state.low[d][i] = StepState<D, P>::lowOf(fields.x[d][i], fields.v[d][i]);
        const std::int32_t id = fields.id[i];
        const bool wall = wallFirst && wallFirst[i + 1] > wallFirst[i],
                   bond = bondFirst && bondFirst[id + 1] > bondFirst[id];
        using Own = OwnWords<typename P::real>;
        const bool asleep = fields.asleep(i);
        state.own[i] = Own
        {
            fields.inverseInertia[i], fields.group[i], id,
            (wall ? Own::nearWall : 0) | (bond ? Own::bonded : 0) | (asleep ? Own::asleep : 0)
        };
        if (!asleep) return;
        int material;
        const auto q = state.from.body(i, material);
        state.to.store(i, state.from.position(i), q, material);
    }
};

//- Back to the fields
template<int D, class P>
struct CloseSteps
{
    static constexpr const char* name = "closeSteps";

    StepState<D, P> state;
    SolidFields<D, P> fields;
    const int* active;

    HD void operator()(int i) const
    {
        if (i >= *active) return;
        int material;
        const ContactBody<D, typename P::real> q = state.from.body(i, material);
        const Vec<D, std::int64_t> x = state.place(i);
        for (int d = 0; d < D; ++d)
        {
            fields.x[d][i] = x.c[d];
            fields.v[d][i] = StepState<D, P>::wholeVelocity(q.velocity.c[d], state.low[d][i]);
        }
        for (int c = 0; c < spins<D>; ++c) fields.w[c][i] = q.spin.c[c];
    }
};

} // namespace riprap

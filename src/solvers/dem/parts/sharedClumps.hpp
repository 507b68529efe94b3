/*  What a rank knows of rigid bodies besides their state: which of all it has, and what ranks that
    share one send each other.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <map>
#include "core/ranks/slotShares.hpp"
#include "dem/motion/clumpState.hpp"
#include "dem/state/solidFields.hpp"

namespace riprap
{

//- Members of bodies that several ranks share: own ones and copies of others', side by side in the
//  order of bodies and of their members
template<int D, class P>
class SharedMembers
{
public:

    using real = typename P::real;
    static constexpr int S = spins<D>;

    SlotShares shares;                      // of slots, and of places in this memory
    std::vector<std::pair<int, int>> own;   // a slot, and its place
    std::vector<int> place;                 // 0, 1, 2 ..

    //- For n members
    void allocate(int n)
    {
        shares.clear();
        own.clear();
        place.resize(n);
        for (int k = 0; k < n; ++k) place[k] = k;
        for (auto& x : x_) x.assign(n, 0);
        for (auto& f : f_) f.assign(n, 0);
        for (auto& m : m_) m.assign(n, 0);
    }

    //- Where they are, and forces and moments on them. \return bytes sent
    std::int64_t share(Transport& ranks, const SolidFields<D, P>& fields)
    {
        const SolidFields<D, P> here = view();
        for (const auto& one : own)
        {
            for (int d = 0; d < D; ++d)
            {
                here.x[d][one.second] = fields.x[d][one.first];
                here.f[d][one.second] = fields.f[d][one.first];
            }
            for (int c = 0; c < S; ++c) here.m[c][one.second] = fields.m[c][one.first];
        }
        const auto put = [&](int slot, unsigned char* to)
        {
            eachNumber(fields, slot, [&](const auto* number)
            {
                std::memcpy(to, number, sizeof(*number));
                to += sizeof(*number);
            });
        };
        const auto take = [&](int at, const unsigned char* from)
        {
            eachNumber(here, at, [&](auto* number)
            {
                std::memcpy(number, from, sizeof(*number));
                from += sizeof(*number);
            });
        };
        return shares.share(
            ranks, D*(sizeof(std::int64_t) + sizeof(real)) + S*sizeof(real), put, take);
    }

    SolidFields<D, P> view()
    {
        SolidFields<D, P> s{};
        for (int d = 0; d < D; ++d)
        {
            s.x[d] = x_[d].data();
            s.f[d] = f_[d].data();
        }
        for (int c = 0; c < S; ++c) s.m[c] = m_[c].data();
        return s;
    }

private:

    template<class F>
    static void eachNumber(const SolidFields<D, P>& fields, int i, const F& f)
    {
        for (int d = 0; d < D; ++d)
        {
            f(fields.x[d] + i);
            f(fields.f[d] + i);
        }
        for (int c = 0; c < S; ++c) f(fields.m[c] + i);
    }

    std::vector<std::int64_t> x_[D];
    std::vector<real> f_[D], m_[S];
};

//- Bodies of this rank, if it has some of all: those that it has all members of, those that it
//  shares, those whose members are ghosts here, each by number. It moves the first two kinds
template<int D, class P>
struct SharedClumps
{
    bool some = false;                      // else all are here, in order
    std::vector<int> first;                 // members of each body among those of all
    std::vector<std::int32_t> row;          // of each key: which of them; -1: none
    std::vector<std::int32_t> number;       // of bodies here
    std::vector<std::int32_t> place;        // of each slot: its body here; -1: none
    std::vector<char> counts;               // of all ranks that move it one reports it
    int whole = 0;
    SharedMembers<D, P> members;
    // bodies that are out of the domain: known to all ranks
    std::map<std::int32_t, ClumpData> left;
    bool leftActed = false;                 // nothing acts on them from the next forces on
    std::int64_t bytes = 0;                 // sent in steps
};

} // namespace riprap

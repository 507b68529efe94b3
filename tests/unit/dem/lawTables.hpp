/*  All contact laws there are, with numbers to try them by.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <iterator>
#include "solvers/dem/demFamilies.hpp"

namespace riprap
{
namespace
{

//- The typical numbers of chosen laws; lossless: as elastic as they can be
PairProperties typical(const std::vector<PairEntry>& entries, bool lossless)
{
    PairProperties p;
    p.youngA = p.youngB = 1e8;
    p.gravity = 9.81;
    p.largestRadius = 0.015;
    for (const PairEntry& e : entries) e.set(p, e.typical);
    for (const PairEntry& e : entries) if (lossless && e.lossless >= 0) e.set(p, e.lossless);
    return p;
}

template<class L> [[maybe_unused]] std::vector<PairEntry> entriesOf()
{
    return {std::begin(L::entries), std::end(L::entries)};
}

//- f(law, its choice) for every combination there is
template<class F>
void eachLaw(F f)
{
    for (int n = 0; n < NormalLaws::size; ++n)
        for (int t = 0; t < TangentialLaws::size; ++t)
            for (int r = 0; r < RollingLaws::size; ++r)
            {
                const LawChoice c{n, t, r};
                withLaw(c, [&](auto law) { f(law, c); });
            }
}

std::string nameOf(const LawChoice& c)
{
    std::string s;
    const auto add = [&](auto law)
    { s += std::string(s.empty() ? "" : " ") + decltype(law)::type::word; };
    NormalLaws::at(c.normal, add);
    TangentialLaws::at(c.tangential, add);
    RollingLaws::at(c.rolling, add);
    return s;
}

} // namespace
} // namespace riprap

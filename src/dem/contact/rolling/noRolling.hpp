/*  No rolling friction.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/contact/card.hpp"

namespace riprap
{

struct NoRolling : RollingCard
{
    static constexpr const char* word = "none";
    static constexpr const char* text = "no rolling friction";
    static constexpr NoEntries<PairEntry> entries{};
    static constexpr bool off = true;
    template<class Tangential> static constexpr bool goesWith = true;
    template<int D> static constexpr int history = 0;

    template<class T> struct Parameters { T unused; };

    static Parameters<double> make(const PairProperties&) { return {0}; }

    template<int D, class T>
    HD static Spin<D, T> moment(
        const Parameters<T>&, const ContactGeometry<D, T>&, const NormalForce<T>&, T*)
    { return filled<spins<D>>(T(0.0f)); }
};

} // namespace riprap

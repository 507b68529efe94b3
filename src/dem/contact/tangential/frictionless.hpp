/*  No tangential force, and no history.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/contact/card.hpp"

namespace riprap
{

struct Frictionless : TangentialCard
{
    static constexpr const char* word = "none";
    static constexpr const char* text = "no friction";
    static constexpr NoEntries<PairEntry> entries{};
    static constexpr bool off = true, spring = false;
    template<int D> static constexpr int history = 0;

    template<class T> struct Parameters { T unused; };

    static Parameters<double> make(const PairProperties&) { return {0}; }

    static double stiffnessRatio(const PairProperties&) { return 0; }

    template<int D, class T>
    HD static Tangent<D, T> force(
        const Parameters<T>&, const ContactGeometry<D, T>&, const NormalForce<T>&, T*)
    { return filled<spins<D>>(T(0.0f)); }

    template<int D, class T>
    HD static T energy(const Parameters<T>&, const NormalForce<T>&, const T*) { return T(0.0f); }
};

} // namespace riprap

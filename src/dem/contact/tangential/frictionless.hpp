/*  No tangential force, and no history.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/contact/geometry.hpp"
#include "dem/contact/pairProperties.hpp"

namespace riprap
{

struct Frictionless
{
    template<int D> static constexpr int history = 0;

    template<class T> struct Parameters { T unused; };

    static Parameters<double> make(const PairProperties&) { return {0}; }

    template<int D, class T>
    HD static Tangent<D, T> force(const Parameters<T>&, const ContactGeometry<D, T>&, const NormalForce<T>&, T*)
    { return filled<spins<D>>(T(0.0f)); }

    template<int D, class T>
    HD static T energy(const Parameters<T>&, const NormalForce<T>&, const T*) { return T(0.0f); }
};

} // namespace riprap

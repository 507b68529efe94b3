/*  The transfer schemes and splines there are, a line each family, and from a configuration to
    their types, once, outside the loops.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/transfer/bSpline.hpp"
#include "pic/transfer/schemes/apic.hpp"
#include "pic/transfer/schemes/flip.hpp"
#include "pic/transfer/schemes/flipPic.hpp"
#include "pic/transfer/schemes/pic.hpp"
#include "solvers/pic/transfer/picSplines.hpp"
#include "solvers/pic/transfer/picTransfers.hpp"

namespace riprap
{

using Transfers = Models<Flip, Pic, FlipPic, Apic>;

namespace detail
{

template<class Scheme, class F>
void withSplineOf(int order, F& f)
{
    withSpline(order, [&](auto spline)
    {
        if constexpr (Scheme::template goesWith<decltype(spline)::value>) f(Scheme(), spline);
    });
}

} // namespace detail

//- f(scheme, std::integral_constant<int, order of the splines>)
template<class F>
void withTransfer(int choice, int order, F f)
{
    Transfers::at(choice,
        [&](auto scheme) { detail::withSplineOf<typename decltype(scheme)::type>(order, f); });
}

} // namespace riprap

/*  The contact laws there are, a line each family, and from the words of a configuration to a law's
    type, once, outside the loops.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/contact/contact.hpp"
#include "dem/contact/normal/cellSpring.hpp"
#include "dem/contact/normal/hertz.hpp"
#include "dem/contact/normal/incrementalSpring.hpp"
#include "dem/contact/normal/jkr.hpp"
#include "dem/contact/normal/linearSpring.hpp"
#include "dem/contact/rolling/constantTorque.hpp"
#include "dem/contact/rolling/noRolling.hpp"
#include "dem/contact/rolling/rollingSpring.hpp"
#include "dem/contact/tangential/frictionless.hpp"
#include "dem/contact/tangential/historySpring.hpp"
#include "dem/contact/tangential/mindlin.hpp"
#include "dem/contact/tangential/oneStepSpring.hpp"
#include "solvers/dem/demLaws.hpp"

namespace riprap
{

using NormalLaws = Models<LinearSpring, IncrementalSpring, CellSpring, Hertz, Jkr>;
using TangentialLaws = Models<Frictionless, HistorySpring, Mindlin, OneStepSpring>;
using RollingLaws = Models<NoRolling, ConstantTorque, RollingSpring>;

namespace detail
{

template<class Normal, class Tangential, class F>
void withRolling(const LawChoice& c, F& f)
{
    RollingLaws::at(c.rolling, [&](auto rolling)
    {
        using Rolling = typename decltype(rolling)::type;
        if constexpr (Rolling::template goesWith<Tangential>)
            f(Contact<Normal, Tangential, Rolling>());
    });
}

template<class Normal, class F>
void withTangential(const LawChoice& c, F& f)
{
    TangentialLaws::at(c.tangential, [&](auto tangential)
    {
        using Tangential = typename decltype(tangential)::type;
        if constexpr (Tangential::template goesWith<Normal>) withRolling<Normal, Tangential>(c, f);
    });
}

} // namespace detail

//- f(law), a Contact<...>
template<class F>
void withLaw(const LawChoice& c, F f)
{
    NormalLaws::at(c.normal,
        [&](auto normal) { detail::withTangential<typename decltype(normal)::type>(c, f); });
}

} // namespace riprap

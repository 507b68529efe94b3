/*  From the words of a configuration to a contact law's type, once, outside the loops.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/contact/contact.hpp"
#include "dem/contact/normal/cellSpring.hpp"
#include "dem/contact/normal/hertz.hpp"
#include "dem/contact/normal/incrementalSpring.hpp"
#include "dem/contact/normal/linearSpring.hpp"
#include "dem/contact/rolling/constantTorque.hpp"
#include "dem/contact/rolling/noRolling.hpp"
#include "dem/contact/rolling/rollingSpring.hpp"
#include "dem/contact/tangential/frictionless.hpp"
#include "dem/contact/tangential/historySpring.hpp"
#include "dem/contact/tangential/mindlin.hpp"
#include "dem/contact/tangential/oneStepSpring.hpp"
#include "scene/demScene.hpp"

namespace riprap
{

namespace detail
{

template<class Normal, class Tangential, class F>
auto withRolling(const DemConfig& c, F f)
{
    if (c.rolling == RollingKind::constantTorque) return f(Contact<Normal, Tangential, ConstantTorque>());
    if (c.rolling == RollingKind::spring) return f(Contact<Normal, Tangential, RollingSpring>());
    return f(Contact<Normal, Tangential, NoRolling>());
}

template<class Normal, class History, class F>
auto withTangential(const DemConfig& c, F f)
{
    if (c.tangential == TangentialKind::none) return f(Contact<Normal, Frictionless, NoRolling>());
    if (c.tangential == TangentialKind::oneStep) return withRolling<Normal, OneStepSpring>(c, f);
    return withRolling<Normal, History>(c, f);
}

} // namespace detail

//- f(law). Rolling friction goes with any friction: createDemScene refuses it without
template<class F>
auto withLaw(const DemConfig& c, F f)
{
    switch (c.normal)
    {
        case NormalKind::linear: return detail::withTangential<LinearSpring, HistorySpring>(c, f);
        case NormalKind::incremental: return detail::withTangential<IncrementalSpring, HistorySpring>(c, f);
        case NormalKind::cellSpring: return detail::withTangential<CellSpring, HistorySpring>(c, f);
        case NormalKind::hertz: break;
    }
    return detail::withTangential<Hertz, Mindlin>(c, f);
}

} // namespace riprap

/*  Pair terms: what a term sees, what it adds to, and how terms are combined.

    A term is a struct of parameters with a branch-free
        template<class T, ...> HD void operator()(const PairParticle& i, const PairParticle& j,
        const PairGeometry& g, Channels<T>& c) const
    that adds to channels; the loop multiplies the common factors once for all terms:

        dv_i/dt     += m_j F (c.radial (x_i - x_j) + c.cross (v_i - v_j))
        drho_i/dt   += m_j F c.rate
        dx_i/dt     -= m_j W c.smooth (v_i - v_j)

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/containers/records.hpp"

namespace riprap
{

template<int D, class T>
struct PairGeometry
{
    Vec<D, T> dx;               // x_i - x_j [m]
    Vec<D, T> dv;               // v_i - v_j [m/s]
    T r2;                       // |dx|^2 [m2]
    T approach;                 // dv . dx [m2/s]
    T h;                        // smoothing length of the pair [m]
    T f;                        // grad_i W = f dx [1/m^(D+2)]
    T w;                        // W [1/m^D]; set only if a term needs it
    T wRatio;                   // W/W(dp): the same
};

template<class T>
struct Channels
{
    T radial, cross, rate, smooth;
};

//- Terms that are always there; needs<...> say what the loop must provide
template<class... Ts>
struct Terms : Ts...
{
    static constexpr bool needsW = (Ts::needsW || ...);
    static constexpr bool smooths = (Ts::smooths || ...);

    template<class Q, class G, class T>
    HD void operator()(const Q& i, const Q& j, const G& g, Channels<T>& c) const
    {
        (static_cast<const Ts&>(*this)(i, j, g, c), ...);
    }
};

template<class... Ts> Terms(Ts...) -> Terms<Ts...>;

//- What is summed: everything (leapfrog), or the half that a symplectic step needs
enum class Part : int {all, momentum, density};

//- What most terms are
struct TermTraits
{
    static constexpr bool needsW = false;
    static constexpr bool smooths = false;
};

//- A term that a case switches at run time (one branch, the same for all pairs): keeps the number
//  of compiled combinations bounded where exactly matching ones do not exist
template<class Term>
struct Switchable : Term
{
    bool on;

    Switchable(const Term& t, bool isOn) : Term(t), on(isOn) {}

    template<class Q, class G, class T>
    HD void operator()(const Q& i, const Q& j, const G& g, Channels<T>& c) const
    {
        if (on) Term::operator()(i, j, g, c);
    }
};

} // namespace riprap

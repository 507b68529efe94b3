/*  Linear spring by increments (paper 1, Eqs. 6, 9, 11): an overlap that was there before the
    contact was made gives no force.

        F_n <- max(F_n + k V_n dt, 0),    f_n = F_n + 2 zeta sqrt(m* k) V_n

    F_n is the contact's history [N].

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/contact/normal/linearSpring.hpp"

namespace riprap
{

//- The numbers of LinearSpring
struct IncrementalSpring : LinearSpring
{
    static constexpr const char* word = "incremental";
    static constexpr const char* text =
        "spring by increments: an overlap that was there before gives no force";
    static constexpr int history = 1;

    template<int D, class T>
    HD static NormalForce<T> force(const Parameters<T>& p, const ContactGeometry<D, T>& g, T* h)
    {
        NormalForce<T> f;
        h[0] = maximum(h[0] + p.k*g.approach*g.since, T(0.0f));
        f.stiffness = p.k;
        f.damping = dashpot(p.twoZeta, f.stiffness, g);
        f.elastic = h[0];
        f.force = maximum(f.elastic + f.damping*dashpotApproach(g), p.floor);
        f.load = f.force;
        return f;
    }

    template<int D, class T>
    HD static T energy(const Parameters<T>& p, const ContactGeometry<D, T>&, const T* h)
    { return T(0.5f)*h[0]*h[0]/p.k; }
};

} // namespace riprap

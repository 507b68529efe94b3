/*  Coulomb's limit on magnitudes (paper 1, Eq. 13 with ERRATA; paper 2, Eq. 15): |f_t| <= mu f_n.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/contact/geometry.hpp"

namespace riprap
{

//- What part of a tangential force of this square may act
template<class T>
HD T coulombShare(T square, T mu, T normal)
{
    const T limit = mu*maximum(normal, T(0.0f)), tiny(1e-36f);
    return minimum(T(1.0f), limit*inverseRoot(maximum(square, tiny)));
}

} // namespace riprap

/*  Spring and dashpot of paper 2 (Eqs. 7, 10, 11), whose stiffness is such that a solid at rest sinks in by theta dx.

        f_n = k delta + c V_n,    k = m_ij |g|/(theta dx),    c = 2 alpha sqrt(m_ij k),    m_ij = (m_i + m_j)/2

    Beside a wall m_ij = m_i. The overlap counts from the solids' imaginary boundaries (Eq. 19): PairProperties::gap. The
    dashpot does not pull unless asked to (Eq. 14 with ERRATA).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/contact/geometry.hpp"
#include "dem/contact/pairProperties.hpp"

namespace riprap
{

struct CellSpring
{
    static constexpr int history = 0;

    template<class T>
    struct Parameters { T kPerMass, twoAlpha, floor; };

    static Parameters<double> make(const PairProperties& p)
    {
        return {p.gravity/(p.theta*p.cellSize), 2*p.alpha, p.attraction ? -1e30 : 0.0};
    }

    template<int D, class T>
    HD static NormalForce<T> force(const Parameters<T>& p, const ContactGeometry<D, T>& g, T*)
    {
        NormalForce<T> f;
        f.stiffness = p.kPerMass*g.meanMass;
        f.damping = p.twoAlpha*squareRoot(g.meanMass*f.stiffness);
        f.elastic = f.stiffness*g.overlap;
        f.force = maximum(f.elastic + f.damping*g.approach, p.floor);
        return f;
    }

    template<int D, class T>
    HD static T energy(const Parameters<T>& p, const ContactGeometry<D, T>& g, const T*)
    { return T(0.5f)*p.kPerMass*g.meanMass*g.overlap*g.overlap; }
};

} // namespace riprap

/*  Spring and dashpot of paper 2 (Eqs. 7, 10, 11), whose stiffness is such that a solid at rest
    sinks in by theta dx.

        f_n = k delta + c V_n,    k = m_ij |g|/(theta dx), c = 2 alpha sqrt(m_ij k), m_ij = (m_i +
                                  m_j)/2

    Beside a wall m_ij = m_i. The overlap counts from the solids' imaginary boundaries (Eq. 19):
    PairProperties::gap. The dashpot does not pull unless asked to (Eq. 14 with ERRATA).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <sstream>
#include "dem/contact/card.hpp"

namespace riprap
{

struct CellSpring : SpringNormal
{
    static constexpr const char* word = "cellSpring";
    static constexpr const char* text =
        "spring in which a body at rest sinks in by theta of a cell";
    static constexpr PairEntry entries[] = {
        PairEntry("theta", "", "theta", &PairProperties::theta).byDefault(0.01).like(0.01),
        PairEntry("alpha", "", "alpha", &PairProperties::alpha)
            .in(Range::zeroOrPositive)
            .byDefault(0)
            .like(0.3)
            .losslessAt(0),
        PairEntry("cellSize", "m", "cellSize", &PairProperties::cellSize).like(5e-4),
        pairEntry::attraction, pairEntry::gap};
    static constexpr bool gravity = true, stiffnessByMass = true;
    static constexpr int history = 0;

    static double stiffnessOf(const PairProperties& p, double mass)
    {
        return mass*p.gravity/(p.theta*p.cellSize);
    }
    static double stiffness(const PairProperties& p, const Impact& b)
    {
        return stiffnessOf(p, b.mass);
    }
    static NormalDashpot dashpotOf(const PairProperties& p) { return {0, 2*p.alpha}; }

    //- An impact at speed v sinks in by v sqrt(m/k), and the gap is all there is
    static std::string warning(const PairProperties& p, double fall)
    {
        const double eats = p.gap*std::sqrt(stiffnessOf(p, 1));
        if (!(p.gap > 0) || fall <= eats) return "";
        std::ostringstream s;
        s.precision(4);
        s << "solids that meet at " << eats << " m/s go through the whole gap of " << p.gap
          << " m, and in this domain they can fall to " << fall << " m/s; theta = "
          << p.gap*p.gap*p.gravity/(fall*fall*p.cellSize) << " would hold";
        return s.str();
    }

    template<class T>
    struct Parameters { T kPerMass, twoAlpha, floor; };

    static Parameters<double> make(const PairProperties& p)
    {
        return {stiffnessOf(p, 1), 2*p.alpha, p.attraction ? -1e30 : 0.0};
    }

    template<int D, class T>
    HD static NormalForce<T> force(const Parameters<T>& p, const ContactGeometry<D, T>& g, T*)
    {
        NormalForce<T> f;
        f.stiffness = p.kPerMass*g.meanMass;
        f.damping = p.twoAlpha*squareRoot(g.meanMass*f.stiffness);
        f.elastic = f.stiffness*g.overlap;
        f.force = maximum(f.elastic + f.damping*g.approach, p.floor);
        f.load = f.force;
        return f;
    }

    template<int D, class T>
    HD static T energy(const Parameters<T>& p, const ContactGeometry<D, T>& g, const T*)
    { return T(0.5f)*p.kPerMass*g.meanMass*g.overlap*g.overlap; }
};

} // namespace riprap

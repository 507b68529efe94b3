/*  The linear equation of state, d = rho/rho0 - 1:

        p = c0^2 rho0 d         [Pa]

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "sph/eos/card.hpp"

namespace riprap
{

template<class R>
struct LinearEquation : EquationCard
{
    static constexpr const char* word = "linear";
    static constexpr const char* text = "pressure proportional to the change of density";

    R stiffness;                // c0^2 rho0 [Pa]
    R c0;                       // [m/s]
    R rho0;                     // [kg/m3]

    static LinearEquation make(const EquationProperties&, double c0, double rho0)
    {
        LinearEquation l;
        l.stiffness = R(c0*c0*rho0);
        l.c0 = R(c0);
        l.rho0 = R(rho0);
        return l;
    }

    double lowestPressure() const { return double(stiffness)*emptiest; }

    HD R pressure(R d) const { return stiffness*d; }
    HD R deviation(R p) const { return maximum(p/stiffness, R(emptiest)); }
    HD R soundSpeed(R) const { return c0; }

    HD double elasticEnergy(double d) const
    {
        const double s = double(stiffness)/rho0;
        return s*(log1p(d) - d/(1 + d));
    }
};

} // namespace riprap

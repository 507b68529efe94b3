/*  Equations of state of a weakly compressible fluid, in terms of d = rho/rho0 - 1 (so that single
    precision keeps small density changes):

        Tait   (paper Eq. 35): p = c0^2 rho0/gamma ((1 + d)^gamma - 1)
        linear               : p = c0^2 rho0 d

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/simd/math.hpp"

namespace riprap
{

template<class R>
struct EquationOfState
{
    bool isLinear;
    R gamma;
    R stiffness;                // c0^2 rho0 [Pa]
    R c0;                       // [m/s]
    R rho0;                     // [kg/m3]

    static EquationOfState make(bool linear, double gamma, double c0, double rho0)
    {
        return EquationOfState{linear, R(gamma), R(c0*c0*rho0), R(c0), R(rho0)};
    }

    //- Pressure [Pa] of the density deviation d
    HD R pressure(R d) const
    {
        if (isLinear) return stiffness*d;
        if (gamma == R(7))      // expanded: no cancellation for small d
            return stiffness/R(7)*d
                *(R(7) + d*(R(21) + d*(R(35) + d*(R(35) + d*(R(21) + d*(R(7) + d))))));
        return stiffness/gamma*R(expm1(gamma*log1p(d)));
    }

    //- Density deviation of the pressure p [Pa]; the fluid cannot be emptier than half its rest
    //  density here
    HD R deviation(R p) const
    {
        if (isLinear) return maximum(p/stiffness, R(-0.5));
        const R x = maximum(p*gamma/stiffness, R(-0.99));
        return maximum(R(expm1(log1p(x)/gamma)), R(-0.5));
    }

    //- Speed of sound [m/s]
    HD R soundSpeed(R d) const
    {
        if (isLinear) return c0;
        if (gamma == R(7)) { const R s = R(1) + d; return c0*s*s*s; }
        return c0*R(exp(R(0.5)*(gamma - R(1))*log1p(d)));
    }

    //- Elastic energy a unit mass [J/kg]: integral of p/rho^2 drho from rho0
    HD double elasticEnergy(double d) const
    {
        const double s = double(stiffness)/rho0, g = gamma;
        if (isLinear) return s*(log1p(d) - d/(1 + d));
        const double work = g == 1 ? log1p(d) : expm1((g - 1)*log1p(d))/(g - 1);
        return s/g*(work - d/(1 + d));
    }
};

} // namespace riprap

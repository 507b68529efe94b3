/*  Tait's equation of state (paper Eq. 35), d = rho/rho0 - 1:

        p = c0^2 rho0/gamma ((1 + d)^gamma - 1)         [Pa]

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "sph/eos/card.hpp"

namespace riprap
{

template<class R>
struct Tait : EquationCard
{
    static constexpr const char* word = "Tait";
    static constexpr const char* text = "Tait's, as of water under shock waves (paper Eq. 35)";
    static constexpr EquationEntry entries[] =
    {
        EquationEntry("gamma", "", "exponent", &EquationProperties::gamma).byDefault(7).like(1.4)
    };

    R gamma;
    R stiffness;                // c0^2 rho0 [Pa]
    R c0;                       // [m/s]
    R rho0;                     // [kg/m3]

    static Tait make(const EquationProperties& p, double c0, double rho0)
    {
        Tait t;
        t.gamma = R(p.gamma);
        t.stiffness = R(c0*c0*rho0);
        t.c0 = R(c0);
        t.rho0 = R(rho0);
        return t;
    }

    //- Of p gamma/stiffness, which is -1 where there is nothing left
    static constexpr double lowest = -0.99;
    double lowestPressure() const { return double(stiffness)*(lowest/double(gamma)); }

    HD R pressure(R d) const
    {
        if (gamma == R(7))      // expanded: no cancellation for small d
            return stiffness/R(7)*d
                *(R(7) + d*(R(21) + d*(R(35) + d*(R(35) + d*(R(21) + d*(R(7) + d))))));
        return stiffness/gamma*R(expm1(gamma*log1p(d)));
    }

    HD R deviation(R p) const
    {
        const R x = maximum(p*gamma/stiffness, R(lowest));
        return maximum(R(expm1(log1p(x)/gamma)), R(emptiest));
    }

    HD R soundSpeed(R d) const
    {
        if (gamma == R(7)) { const R s = R(1) + d; return c0*s*s*s; }
        return c0*R(exp(R(0.5)*(gamma - R(1))*log1p(d)));
    }

    HD double elasticEnergy(double d) const
    {
        const double s = double(stiffness)/rho0, g = gamma;
        const double work = g == 1 ? log1p(d) : expm1((g - 1)*log1p(d))/(g - 1);
        return s/g*(work - d/(1 + d));
    }
};

} // namespace riprap

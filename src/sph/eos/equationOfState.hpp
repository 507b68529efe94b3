/*  The equation of state of a weakly compressible fluid that a case has chosen, of those there are.

        pressure(d)         [Pa] of the density deviation d = rho/rho0 - 1
        deviation(p)        d of the pressure p [Pa], not below EquationCard::emptiest
        soundSpeed(d)       [m/s]
        elasticEnergy(d)    a unit mass [J/kg]: integral of p/rho^2 drho from rho0
        lowestPressure()    [Pa], below which deviation(p) is cut off

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "sph/eos/linearEquation.hpp"
#include "sph/eos/tait.hpp"

namespace riprap
{

template<class R> using EquationsOfState = Models<Tait<R>, LinearEquation<R>>;

//- One of these: as many questions as there are others. R: of the formulas
template<class R, class... M> struct ChosenEquation;

template<class R, class M>
struct ChosenEquation<R, M>
{
    M equation;

    static ChosenEquation make(int, const EquationProperties& p, double c0, double rho0)
    { return {M::make(p, c0, rho0)}; }

    double lowestPressure() const { return equation.lowestPressure(); }
    HD R pressure(R d) const { return equation.pressure(d); }
    HD R deviation(R p) const { return equation.deviation(p); }
    HD R soundSpeed(R d) const { return equation.soundSpeed(d); }
    HD double elasticEnergy(double d) const { return equation.elasticEnergy(d); }
};

template<class R, class M, class Next, class... Rest>
struct ChosenEquation<R, M, Next, Rest...>
{
    bool chosen;
    M equation;
    ChosenEquation<R, Next, Rest...> others;

    static ChosenEquation make(
        int choice, const EquationProperties& p, double c0, double rho0)
    {
        return {choice == 0, M::make(p, c0, rho0),
            ChosenEquation<R, Next, Rest...>::make(choice - 1, p, c0, rho0)};
    }

    double lowestPressure() const
    { return chosen ? equation.lowestPressure() : others.lowestPressure(); }
    HD R pressure(R d) const
    {
        if (chosen) return equation.pressure(d);
        return others.pressure(d);
    }
    HD R deviation(R p) const
    {
        if (chosen) return equation.deviation(p);
        return others.deviation(p);
    }
    HD R soundSpeed(R d) const
    {
        if (chosen) return equation.soundSpeed(d);
        return others.soundSpeed(d);
    }
    HD double elasticEnergy(double d) const
    {
        if (chosen) return equation.elasticEnergy(d);
        return others.elasticEnergy(d);
    }
};

template<class R, class Table = EquationsOfState<R>> struct EquationOfState;

template<class R, class... M>
struct EquationOfState<R, Models<M...>> : ChosenEquation<R, M...>
{
    //- By its word; std::invalid_argument with the valid ones if there is no such equation
    static EquationOfState make(const EquationProperties& p, double c0, double rho0)
    {
        const int choice = choiceOf<Models<M...>>("equationOfState", p.eos);
        return {ChosenEquation<R, M...>::make(choice, p, c0, rho0)};
    }
};

} // namespace riprap

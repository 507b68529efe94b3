/*  When solids are kicked by their forces: dem/motion/mover.hpp has the formulas.

        kicksTwice      half a kick before the drift, half with the forces after it (FinishVerlet);
                        else one kick, from the middle of the last step to that of this one
        lag             by which part of a step the velocities that are kept are behind positions

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "api/models.hpp"

namespace riprap
{

struct DemLeapfrog
{
    static constexpr const char* word = "leapfrog";
    static constexpr const char* text = "velocities of the middle of steps, one kick a step";
    static constexpr bool kicksTwice = false;
    static constexpr double lag = 0.5;
};

struct DemVelocityVerlet
{
    static constexpr const char* word = "velocityVerlet";
    static constexpr const char* text = "kick, drift, kick (paper 2, Eqs. 21 to 23)";
    static constexpr bool kicksTwice = true;
    static constexpr double lag = 0;
};

using DemIntegrators = Models<DemLeapfrog, DemVelocityVerlet>;

struct DemIntegrator
{
    const char* word;
    const char* text;
    bool kicksTwice;
    double lag;

    template<class M>
    explicit DemIntegrator(Model<M>)
    : word(M::word), text(M::text), kicksTwice(M::kicksTwice), lag(M::lag)
    { static_assert(M::kicksTwice == (M::lag == 0), "whole kicks leave velocities in the middle"); }

    //- The sum of the kicks of a step of dt that is taken in so many, after one of `last`
    double kickTime(double dt, int subcycles, double last) const
    { return dt + lag*(last - dt/subcycles); }
};

//- By its word; std::invalid_argument with the valid ones if there is none
inline const DemIntegrator& demIntegratorOf(const std::string& word)
{ return cardOf<DemIntegrator, DemIntegrators>("timeIntegration", word); }

} // namespace riprap

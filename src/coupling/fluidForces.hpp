/*  When solids get the force of the fluid over a step of it (docs/coupling.md, A step). The fluid
    gets that of each instant half in the step before it and half in the one after it: the shares of
    the last two forces make the solids' impulse of whole steps the same.

        blows           half a step's impulse at once, before and after the step
        eachSubstep     the shares change with the solids' own steps, and the force before is kept
        shares          of the last two forces, at a fraction of the step; ratio: of the step before
                        over this one, 0 in the first step

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "api/models.hpp"

namespace riprap
{

struct ForceShares { double now, before; };

//- That of the step's beginning
struct HeldForce
{
    static constexpr const char* word = "held";
    static constexpr const char* text = "the force of the step's beginning, all through the step";
    static constexpr bool blows = false, eachSubstep = false;

    static ForceShares shares(double ratio, double) { return {0.5*(1 + ratio), 0}; }
};

//- On the line through the last two forces
struct InterpolatedForce
{
    static constexpr const char* word = "interpolated";
    static constexpr const char* text = "on the line through the last two forces";
    static constexpr bool blows = false, eachSubstep = true;

    static ForceShares shares(double ratio, double fraction)
    {
        const double slope = 0.5*ratio + (ratio > 0 ? (fraction - 0.5)/ratio : 0);
        return {1 + slope, -slope};
    }
};

//- As one blow in the first of their own steps
struct ImpulsiveForce
{
    static constexpr const char* word = "impulse";
    static constexpr const char* text = "half a step's impulse before the step, half after it";
    static constexpr bool blows = true, eachSubstep = false;

    static ForceShares shares(double, double) { return {0, 0}; }
};

using FluidForces = Models<HeldForce, InterpolatedForce, ImpulsiveForce>;

struct FluidForceCard
{
    const char* word;
    const char* text;
    bool blows, eachSubstep;
    ForceShares (*shares)(double ratio, double fraction);

    template<class M>
    explicit FluidForceCard(Model<M>)
    : word(M::word), text(M::text), blows(M::blows), eachSubstep(M::eachSubstep),
      shares(M::shares)
    {}
};

//- By its word; std::invalid_argument with the valid ones if there is none
inline const FluidForceCard& fluidForceOf(const std::string& word)
{ return cardOf<FluidForceCard, FluidForces>("fluidForce", word); }

} // namespace riprap

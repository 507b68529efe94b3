/*  How viscosity is stepped (viscosity.hpp has the formulas).

        acts                is there any?
        limitsStep          always explicit: the step stays below the explicit one's limit
        implicit(dt, limit) for a step of dt where the explicit one's is limit [s]

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "api/models.hpp"

namespace riprap
{

struct ViscosityTraits
{
    static constexpr bool acts = true, limitsStep = false;
};

struct AutomaticViscosity : ViscosityTraits
{
    static constexpr const char* word = "automatic";
    static constexpr const char* text = "implicit in steps that the explicit one does not bear";
    static bool implicit(double dt, double limit) { return dt > limit; }
};

struct ExplicitViscosity : ViscosityTraits
{
    static constexpr const char* word = "explicit";
    static constexpr const char* text = "explicit (Heun), which limits the step";
    static constexpr bool limitsStep = true;
    static bool implicit(double, double) { return false; }
};

struct ImplicitViscosity : ViscosityTraits
{
    static constexpr const char* word = "implicit";
    static constexpr const char* text = "implicit (Alexander 1977), stable in any step";
    static bool implicit(double, double) { return true; }
};

struct NoViscosity : ViscosityTraits
{
    static constexpr const char* word = "none";
    static constexpr const char* text = "the fluid has no viscosity";
    static constexpr bool acts = false;
    static bool implicit(double, double) { return false; }
};

using ViscousSchemes = Models<AutomaticViscosity, ExplicitViscosity, ImplicitViscosity,
    NoViscosity>;

struct ViscousScheme
{
    const char* word;
    const char* text;
    bool acts, limitsStep;
    bool (*implicit)(double dt, double limit);

    template<class M>
    explicit ViscousScheme(Model<M>)
    : word(M::word), text(M::text), acts(M::acts), limitsStep(M::limitsStep),
      implicit(M::implicit)
    {}
};

//- By its word; std::invalid_argument with the valid ones if there is none
inline const ViscousScheme& viscousSchemeOf(const std::string& word)
{ return cardOf<ViscousScheme, ViscousSchemes>("viscosity", word); }

} // namespace riprap

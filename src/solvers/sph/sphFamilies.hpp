/*  From the words of a case to compiled passes: kernel, smoothing and terms become types here,
    once, outside the loops.

    The combinations that cases usually take (sph/models.hpp) are compiled exactly; all others run a
    general one in which each term is switched by a flag that is the same for all pairs. Rare terms
    (TermCard::frequent) are in a general one of their own: cases without them do not carry their
    flags.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <tuple>
#include "solvers/sph/sphModels.hpp"
#include "sph/boundary/extrapolatedWall.hpp"
#include "sph/boundary/wallForcePass.hpp"
#include "sph/passes/fluidPass.hpp"
#include "sph/models.hpp"
#include "sph/passes/samplePass.hpp"

namespace riprap
{

//- The parameters of every term of a table, in the precision R, and which of them a case uses
template<int D, class R, class Table = PairTerms<D, R>> class TermParameters;

template<int D, class R, class... M>
class TermParameters<D, R, Models<M...>>
{
    static_assert(((!M::atWalls || (M::part == Part::momentum && !M::needsW)) && ...),
        "at walls there is neither density rate nor drift nor W");
    static_assert(((M::part != Part::all) && ...), "a term adds to one half of a symplectic step");

    std::tuple<M...> terms_;
    bool on_[sizeof...(M)], walls_[sizeof...(M)];
    bool noSlip_;

    template<class Term>
    static constexpr int place()
    {
        int k = 0, found = -1;
        ((found = std::is_same<Term, M>::value ? k : found, ++k), ...);
        return found;
    }

    template<class Term>
    static constexpr bool acts(Part part) { return part == Part::all || Term::part == part; }
    static constexpr bool hasRare(Part part) { return ((acts<M>(part) && !M::frequent) || ...); }
    static constexpr bool hasSmoothing(Part part) { return ((acts<M>(part) && M::smooths) || ...); }
    static constexpr bool hasRareAtWalls() { return ((M::atWalls && !M::frequent) || ...); }

    bool usesRare(Part part) const { return ((acts<M>(part) && !M::frequent && on<M>()) || ...); }
    bool usesRareAtWalls() const { return ((M::atWalls && !M::frequent && on<M>()) || ...); }
    bool smooths() const { return ((M::smooths && on<M>()) || ...); }

    template<class Term, class... T>
    static constexpr bool isOneOf() { return (std::is_same<Term, T>::value || ...); }

    //- Are the terms of the case exactly these?
    template<Part part, class... T>
    bool exactly(Model<Terms<T...>>) const
    { return ((!acts<M>(part) || on<M>() == isOneOf<M, T...>()) && ...); }

    //- Pressure and Continuity have no parameters
    template<class Term>
    Term parameters() const
    {
        if constexpr (place<Term>() < 0) return Term{};
        else return get<Term>();
    }

    template<class... T>
    Terms<T...> make(Model<Terms<T...>>) const { return Terms<T...>{parameters<T>()...}; }

    //- A term in a general combination, or nothing
    template<class Term, bool there>
    auto slot([[maybe_unused]] bool isOn) const
    {
        using Slot = std::tuple<Switchable<Term>>;
        if constexpr (there) return Slot(Switchable<Term>(get<Term>(), isOn));
        else return std::tuple<>();
    }

    template<class... T>
    static Terms<T...> together(const std::tuple<T...>& t)
    { return Terms<T...>{std::get<T>(t)...}; }

    template<class Term, bool rare> static constexpr bool isIn = rare || Term::frequent;

    template<Part part>
    static auto always()
    {
        if constexpr (part == Part::all) return std::tuple<Pressure, Continuity>();
        else if constexpr (part == Part::momentum) return std::tuple<Pressure>();
        else return std::tuple<Continuity>();
    }

    template<Part part, bool smoothing, bool rare>
    auto general() const
    {
        return together(std::tuple_cat(always<part>(),
            slot<M, acts<M>(part) && (smoothing || !M::smooths) && isIn<M, rare>>(on<M>())...));
    }

    template<Part part, bool rare>
    auto wallTerms(bool viscous) const
    {
        if constexpr (part == Part::density) return Terms<Continuity>{};
        else return together(std::tuple_cat(std::tuple<Pressure, Continuity>(),
            slot<M, M::atWalls && isIn<M, rare>>(viscous && noSlip_ && meetsWalls<M>())...));
    }

    template<bool rare>
    auto solidTerms(bool on) const
    {
        return together(std::tuple_cat(
            slot<M, M::atWalls && isIn<M, rare>>(on && meetsWalls<M>())...));
    }

    template<Part part, bool rare, class F>
    void withGeneralTerms(const F& f) const
    {
        const auto walls = wallTerms<part, rare>(true);
        if constexpr (part != Part::momentum)
        {
            if (shifts) return f(general<part, true, rare>(), walls, std::true_type());
        }
        if constexpr (hasSmoothing(part))
        {
            if (smooths()) return f(general<part, true, rare>(), walls, std::false_type());
        }
        f(general<part, false, rare>(), walls, std::false_type());
    }

public:

    bool shifts;
    ShiftingModel<R> shifting;

    explicit TermParameters(const SphConfig& c)
    :
        terms_(M::make(c, termFluid(c))...), on_{isChosen<M>(c)...},
        walls_{M::actsAtWalls(c)...}, noSlip_(c.noSlip), shifts(shiftingOf(c).shifts)
    {
        const double usual = D == 2 ? 1.5 : 2.75;
        const double surface = c.shiftingSurfaceThreshold >= 0 ? c.shiftingSurfaceThreshold : usual;
        shifting = ShiftingModel<R>{R(c.shiftingCoefficient), R(surface), R(D)};
    }

    template<class Term> Term get() const { return std::get<Term>(terms_); }
    template<class Term> bool on() const { return on_[place<Term>()]; }
    template<class Term> bool meetsWalls() const { return on<Term>() && walls_[place<Term>()]; }

    //- Do particles move otherwise than by their velocity?
    bool drifts() const { return shifts || smooths(); }

    //- The kinematic viscosity that all terms together act as [m2/s]
    static double viscosity(const SphConfig& c)
    { return (0.0 + ... + (isChosen<M>(c) ? M::viscosity(c, termFluid(c)) : 0.0)); }

    //- Call f(fluid terms, wall terms, shifts?) with the types that fit the case
    template<Part part, bool Specialised, class F>
    void withFluidTerms(const F& f) const
    {
        bool done = false;
        if constexpr (Specialised)
        {
            const bool mayBe = part == Part::momentum || !shifts;
            FrequentTerms<part, D, R>::type::each([&](auto exact)
            {
                if (done || !mayBe || !exactly<part>(exact)) return;
                done = true;
                f(make(exact), wallTerms<part, false>(true), std::false_type());
            });
        }
        if (done) return;
        if constexpr (hasRare(part))
        {
            if (usesRare(part)) return withGeneralTerms<part, true>(f);
        }
        withGeneralTerms<part, false>(f);
    }

    //- f(terms of the force on walls); viscous: else the pressure alone
    template<class F>
    void withWallTerms(bool viscous, const F& f) const
    {
        if constexpr (hasRareAtWalls())
        {
            if (usesRareAtWalls()) return f(wallTerms<Part::momentum, true>(viscous));
        }
        f(wallTerms<Part::momentum, false>(viscous));
    }

    //- f(viscous terms between fluid and solids), which may be switched off
    template<class F>
    void withSolidTerms(bool on, const F& f) const
    {
        if constexpr (hasRareAtWalls()) { if (usesRareAtWalls()) return f(solidTerms<true>(on)); }
        f(solidTerms<false>(on));
    }
};

//- Call f(the wall model's card)
template<class F>
void withWallModel(const SphConfig& c, const F& f)
{
    WallModels::at(choiceOf<WallModels>("wall model", c.wallModel),
        [&](auto model) { f(typename decltype(model)::type()); });
}

//- Call f(the integrator's card)
template<class F>
void withIntegrator(const SphConfig& c, const F& f)
{
    Integrators::at(choiceOf<Integrators>("timeIntegration", c.integrator),
        [&](auto model) { f(typename decltype(model)::type()); });
}

//- Call f(kernel, variable h?) with the types that fit the case
template<class F>
void withKernel(const SphConfig& c, const F& f)
{
    Kernels::at(kernelChoice(c.kernel), [&](auto kernel)
    {
        using Kernel = typename decltype(kernel)::type;
        if (c.variableSmoothing) f(Kernel(), std::true_type());
        else f(Kernel(), std::false_type());
    });
}

} // namespace riprap

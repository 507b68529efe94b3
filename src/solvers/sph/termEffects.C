/*  Terms are tried at some pairs, near and far, that approach and that part.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "solvers/sph/termEffects.hpp"
#include "sph/models.hpp"

namespace riprap
{

namespace
{

using Sum = std::array<double, 4>;

//- What a term adds to the channels of pair k, whose state is unlike on both sides
template<class Term>
Sum added(const Term& term, const SphConfig& c, int k)
{
    constexpr int D = 3;
    const TermFluid fluid = termFluid(c);
    const double sign = k % 2 ? -1 : 1, r = fluid.h*(0.2 + 0.3*k);
    PairParticle<D, double> i{}, j{};
    PairGeometry<D, double> g{};
    for (int d = 0; d < D; ++d)
    {
        g.dx.c[d] = r*(d == 1 ? 0.8 : 0.6*0.70710678);
        i.velocity.c[d] = sign*(0.1 + 0.05*d);
        j.velocity.c[d] = -0.3*sign;
        g.dv.c[d] = i.velocity.c[d] - j.velocity.c[d];
        g.approach += g.dx.c[d]*g.dv.c[d];
        g.r2 += g.dx.c[d]*g.dx.c[d];
    }
    i.h = j.h = g.h = fluid.h;
    i.density = 1.01*fluid.density;
    j.density = 0.98*fluid.density;
    i.pressureTerm = 0.3;
    j.pressureTerm = -0.2;
    g.f = -1;
    g.w = g.wRatio = 0.5;
    Channels<double> sum{0, 0, 0, 0};
    term(i, j, g, sum);
    return {sum.radial, sum.cross, sum.rate, sum.smooth};
}

template<class Term>
std::vector<Sum> added(SphConfig c, double viscosity)
{
    c.viscosity = viscosity;
    const Term term = Term::make(c, termFluid(c));
    std::vector<Sum> all;
    all.reserve(6);
    for (int k = 0; k < 6; ++k) all.push_back(added(term, c, k));
    return all;
}

} // namespace

std::vector<TermEffect> termEffects(const SphConfig& c)
{
    std::vector<TermEffect> effects;
    PairTerms<3, double>::each([&](auto model)
    {
        using Term = typename decltype(model)::type;
        const std::vector<Sum> now = added<Term>(c, c.viscosity);
        TermEffect e;
        e.idle = now == std::vector<Sum>(now.size(), Sum{{0, 0, 0, 0}});
        e.seesViscosity = added<Term>(c, 0) != added<Term>(c, 1);
        e.atWalls = Term::atWalls && Term::actsAtWalls(c);
        effects.push_back(e);
    });
    return effects;
}

} // namespace riprap

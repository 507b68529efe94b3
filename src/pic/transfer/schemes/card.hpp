/*  What transfer schemes say about themselves besides word, text, entries and formula: defaults of
    their cards.

    A particle brings its velocity v to the faces, and with the gradient C that it keeps C.(x_f -
    x_p) (particleToGrid.hpp). The step makes u of the grid's velocity, a change by du. What the
    particle then has is the scheme's formula, a component at a time (gridToParticle.hpp):

        v = formula(v, sum W du, sum W u)

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/simd/math.hpp"
#include "api/transferProperties.hpp"

namespace riprap
{

//- Entries of several schemes
namespace transferEntry
{
inline constexpr TransferEntry affine =
    TransferEntry("affine", "gradient", &TransferProperties::affine, true).show(Shown::never);
}

struct SchemeCard
{
    // particles keep it always; else where the scheme has the entry `affine`, as that says
    static constexpr bool gradient = false;
    // with it, a velocity that is linear in space comes back as it was
    static constexpr bool keepsLinear = true;
    template<int Order> static constexpr bool goesWith = true;      // splines of this order

    //- The longest step that the formula bears [s]
    static double timeStep(const TransferProperties&) { return 1e300; }
};

//- Formulas
struct FormulaCard
{
    // reals of a component that it keeps from step to step, up to mostMemory (particles.hpp): 0 at
    // first and away from the water
    static constexpr int memory = 0;
    // may a particle keep a velocity of its own? Then du is read, and beside the surface the speed
    // is bounded
    static constexpr bool own = true;

    //- Does it, with its numbers?
    HD bool keepsOwn() const { return true; }

    //- Is u read?
    HD bool readsGrid() const { return true; }
};

} // namespace riprap

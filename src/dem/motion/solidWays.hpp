/*  Of solids as they are now, between two steps: how fast, and do neighbours hold for the next
    step? A fluid's blow may have changed either since the last one.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/motion/mover.hpp"

namespace riprap
{

//- Velocity of particle i; a member of a rigid body has the body's. The position comes with it
template<int D, class P>
HD Vec<D, double> velocityNow(const MoveSolids<D, P>& m, int i, Vec<D, std::int64_t>& x)
{
    const SolidFields<D, P>& s = m.fields;
    x = s.position(i);
    Vec<D, double> v = s.velocity(i);
    Spin<D, typename P::real> w = s.spin(i);
    if (m.clumps && s.clump[i] >= 0) m.follow(m.clumps[s.clump[i]], s.id[i], x, v, w);
    return v;
}

template<int D, class P>
struct SpeedOfSolids
{
    static constexpr const char* name = "speedOfSolids";
    MoveSolids<D, P> move;

    HD double value(int i) const
    {
        if (i >= *move.active) return 0;
        Vec<D, std::int64_t> x;
        return sqrt(squaredNorm(velocityNow(move, i, x)));
    }
};

template<int D, class P>
struct CheckWays
{
    using real = typename P::real;
    static constexpr const char* name = "checkWays";
    MoveSolids<D, P> move;

    HD void operator()(int i) const
    {
        if (i >= *move.active || move.fields.asleep(i)) return;
        Vec<D, std::int64_t> x;
        const Vec<D, double> v = velocityNow(move, i, x);
        Vec<D, typename P::position> p;
        for (int d = 0; d < D; ++d) p.c[d] = move.box.pairPosition(d, x.c[d]);
        move.checkSkin(i, p, x, convert<real>(v), *move.clock, move.clock);
    }
};

} // namespace riprap

/*  Of solids as they are now, between two steps: how fast, and do neighbours hold for the next step? A fluid's blow may have changed
    either since the last one.

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

//- The speed of particle i, and whether neighbours hold for its next step
template<int D, class P>
HD double speedNow(const MoveSolids<D, P>& m, int i)
{
    if (i >= *m.active) return 0;
    Vec<D, std::int64_t> x;
    return sqrt(squaredNorm(velocityNow(m, i, x)));
}

template<int D, class P>
HD void checkWay(const MoveSolids<D, P>& m, int i)
{
    if (i >= *m.active || m.fields.asleep(i)) return;
    Vec<D, std::int64_t> x;
    const Vec<D, double> v = velocityNow(m, i, x);
    Vec<D, typename P::position> p;
    for (int d = 0; d < D; ++d) p.c[d] = m.box.pairPosition(d, x.c[d]);
    m.checkSkin(i, p, x, convert<typename P::real>(v), *m.clock, m.clock);
}

template<int D, class P>
struct SpeedOfSolids
{
    static constexpr const char* name = "speedOfSolids";
    MoveSolids<D, P> move;

    HD double value(int i) const { return speedNow(move, i); }
};

template<int D, class P>
struct CheckWays
{
    static constexpr const char* name = "checkWays";
    MoveSolids<D, P> move;

    HD void operator()(int i) const { checkWay(move, i); }
};

} // namespace riprap

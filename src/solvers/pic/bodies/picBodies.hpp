/*  Solids in the water of a PIC scene, on the host: the rigid bodies that the particles and clumps
    of a DemScene are, what they are about to do when the pressure is solved, and what the water
    does to them.

    Velocities of the water stand half a step behind positions (leapfrog); so do those at which
    bodies displace it, W. With V the velocity at the time of the positions, F the water's force and
    G what else accelerates, of the step before (') and the one at hand,

        W* = V - dt'/2 F'/M + dt/2 (g + G),     W = W* + k F/M,     k = (dt' + dt)/2

    where W and F come from the pressure equation together (pic/bodies/bodyTerm.hpp; paper 2, Eqs. 5
    and 6); a body that then moves by dt under F + M (g
        + G) from
    V + dt'/2 (F - F')/M has W for its mean velocity: it goes where the water has made way for it.
    Weakly coupled, W = W* + k F'/M, and F is
    what the pressure about such walls does.

    G is the prediction for contacts. Paper 2 takes the force of the moment, over the whole step; a
    stiff collision, over in a small part of it, would hit the water many times as hard as the body.
    Here it is the smaller of that force and the mean over the step before, 0 where they do not
    agree in direction: contacts that last are foreseen, blows are not.

    Solids at rest sleep, where they may (dem/passes/sleep.hpp): the water sees them as walls,
        and they feel the force under which they fell asleep until the water's differs from it by
        what
    would set them in motion faster than v_s within the time after which they sleep. Who sleeps has
    velocity 0 to the bit, which nobody has who is pushed.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/pic/bodies/bodyForces.hpp"
#include "solvers/pic/bodies/bodyReader.hpp"

namespace riprap
{

template<int D>
struct PicBodies
{
    BodySetting<D> set;
    BodyTable<D> table;
    BodyReader<D> reader;
    BodyForces<D> forces{set, table};

    PicBodies(const PicConfig& config, const PicSolids& solids, DemScene& scene)
    :
        set(config, solids, scene), table(set, solids.input), reader(set, table, solids.shapes)
    {}
};

} // namespace riprap

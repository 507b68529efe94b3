/*  The deepest overlap with walls: asked for at samples.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/walls/wallTouching.hpp"

namespace riprap
{

//- Of a particle, in diameters
template<int D, class P>
struct DeepestAtWalls
{
    using real = typename P::real;
    static constexpr const char* name = "deepestAtWalls";
    SolidFields<D, P> solids;
    const int* entryFirst;
    const WallEntry* entry;
    const real* force;              // wallWords<D> an entry, the overlap behind force and moment
    const double* gap;              // of each material with each wall
    int walls;
    const int* active;
    const std::int32_t* calm;       // nullptr: nobody is a ghost

    HD double value(int i) const
    {
        double most = 0;
        if (i >= *active || (calm && calm[i] == ghostMark)) return most;
        for (int e = entryFirst[i]; e < entryFirst[i + 1]; ++e)
        {
            const double all = double(force[e*wallWords<D> + D + spins<D> + 1]);
            const double left = all - gap[solids.material[i]*walls + entry[e].wall];
            most = maximum(most, 0.5*left/double(solids.radius[i]));
        }
        return most;
    }
};

} // namespace riprap

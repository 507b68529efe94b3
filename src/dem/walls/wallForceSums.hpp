/*  Forces and moments that walls bear: asked for at samples.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/walls/wallTouching.hpp"

namespace riprap
{

//- On one wall, in the order of DemWallForce: 3 numbers each
template<int D, class P>
struct WallForceSums
{
    using real = typename P::real;
    static constexpr const char* name = "wallForceSums";
    static constexpr int values = 12, S = spins<D>;
    SolidFields<D, P> solids;
    Box<D, P> box;
    const int* entryFirst;
    const WallEntry* entry;
    const real* force;              // wallWords<D> an entry
    const int* on;                  // of each touch
    const real* normal;             // D of each, in the wall's frame
    const WallData* walls;
    int axes[3];
    double spinSign;
    const int* active;
    const std::int32_t* calm;       // nullptr: nobody is a ghost
    int wall;

    HD void add(int i, double* sums) const
    {
        if (i >= *active || (calm && calm[i] == ghostMark)) return;
        Vec<3, double> centre{{0, 0, 0}};
        for (int d = 0; d < D; ++d) centre.c[axes[d]] = box.toMetres(d, solids.x[d][i]);
        for (int e = entryFirst[i]; e < entryFirst[i + 1]; ++e)
            if (entry[e].wall == wall) addEntry(e, centre, sums);
    }

    //- Of one entry: a particle with its centre there
    HD void addEntry(int e, const Vec<3, double>& centre, double* sums) const
    {
        Vec<3, double> f{{0, 0, 0}}, m{{0, 0, 0}};
        for (int d = 0; d < D; ++d) f.c[axes[d]] = -double(force[e*wallWords<D> + d]);
        for (int c = 0; c < S; ++c)
            m.c[D == 2 ? axes[2] : c] = -(D == 2 ? spinSign : 1)
                *double(force[e*wallWords<D> + D + c]);
        const Vec<3, double> pressed = alongNormals(e, f), turned = cross(centre, pressed);
        m = m + cross(centre, f);
        for (int d = 0; d < 3; ++d)
        {
            sums[d] += f.c[d];
            sums[3 + d] += m.c[d];
            sums[6 + d] += pressed.c[d];
            sums[9 + d] += turned.c[d];
        }
    }

private:

    //- The part of a force along the normals of an entry's touches
    HD Vec<3, double> alongNormals(int e, const Vec<3, double>& of) const
    {
        Vec<3, double> sum{{0, 0, 0}}, basis[wallTouches];
        int known = 0;
        for (int slot = e*wallTouches; slot < (e + 1)*wallTouches; ++slot)
        {
            if (!on[slot]) continue;
            Vec<D, double> local;
            for (int d = 0; d < D; ++d) local.c[d] = double(normal[slot*D + d]);
            local = outOfFrame<D>(walls[entry[e].wall].frame.R, local);
            Vec<3, double> b{{0, 0, 0}};
            for (int d = 0; d < D; ++d) b.c[axes[d]] = local.c[d];
            for (int k = 0; k < known; ++k) b = b - dot(b, basis[k])*basis[k];
            const double size = squareRoot(squaredNorm(b));
            if (!(size > 1e-3)) continue;           // as others
            basis[known] = (1/size)*b;
            sum = sum + dot(of, basis[known])*basis[known];
            ++known;
        }
        return sum;
    }
};

} // namespace riprap

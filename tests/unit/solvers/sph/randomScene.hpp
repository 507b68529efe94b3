/*  A scene of random particles on a floor: not like water, but no error hides in it.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "sceneTest.hpp"

namespace riprap
{

class RandomScene : public SceneTest
{
protected:

    //- Periodic along the first axis; particles up to the middle of the second, filling the others
    SphConfig base() const
    {
        SphConfig c = config();
        if (D() == 3)
        {
            // keeps the reference, 4e5 pairs, short; a period of 10 spacings has no room for a wide
            // skin
            c.spacing = 0.1;
            c.skin = 0.1;
        }
        c.domainMin[1] = -0.5;      // room for walls
        c.domainMax[1] = 1.5;
        c.wallSpacing = 0.5*c.spacing;
        c.periodic[0] = c.periodic[2] = true;
        c.gravity = {{0.3, -9.81, 1}};
        return c;
    }

    FluidInput particles(const SphConfig& c) const
    {
        FluidInput f = lattice(
            c, {{0, 0, 0}}, {{c.domainMax[0], 0.6, D() == 3 ? c.domainMax[2] : 0.0}});
        disturb(c, f, 0.3, 1, 0.02);
        for (std::size_t i = 0; i < f.size(); ++i)
        {
            // the jitter must not leave the bottom; across the periodic edges it may
            f.position[3*i + 1] = std::max(f.position[3*i + 1], 0.1*c.spacing);
            for (const int d : {0, 2})
                if (c.periodic[d])
                    f.position[3*i + d] -= c.domainMax[d]
                        *std::floor(f.position[3*i + d]/c.domainMax[d]);
        }
        return f;
    }
};

} // namespace riprap

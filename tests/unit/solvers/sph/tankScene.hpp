/*  A small dam break: a column of fluid at the left of a tank of wall points, which may have a
    piston for its left wall.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "sceneTest.hpp"

namespace riprap
{

class TankScene : public SceneTest
{
protected:

    static constexpr int layers = 3;

    //- Tank of 1 x 0.7 (x 0.5) m, open above; column of 0.4 x 0.4 (x 0.5) m
    SphConfig tank() const
    {
        SphConfig c = config();
        c.wallSpacing = c.spacing;
        const double thick = layers*c.wallSpacing;
        c.domainMin = {{-thick, -thick, -thick}};
        c.domainMax = {{1 + thick, 1, 0.5 + thick}};
        c.gravity = {{0, -9.81, 0}};
        c.maxVelocity = 2.8;            // sqrt(2 g 0.4)
        c.soundSpeed = 28;
        c.viscosityModel = "artificial";
        return c;
    }

    FluidInput column(const SphConfig& c) const
    {
        return lattice(c, {{0, 0, 0}}, {{0.4, 0.4, D() == 3 ? 0.5 : 0.0}});
    }

    WallInput walls(const SphConfig& c) const
    {
        SphConfig points = c;
        points.spacing = c.wallSpacing;
        const double thick = layers*c.wallSpacing;
        const double z0 = D() == 3 ? -thick : 0, z1 = D() == 3 ? 0.5 + thick : 0;
        const std::vector<double> x = lattice(points, {{-thick, -thick, z0}},
            {{1 + thick, 0.7, z1}}).position;
        WallInput w;
        for (std::size_t i = 0; i < x.size()/3; ++i)
        {
            const double* p = &x[3*i];
            if (p[0] > 0 && p[0] < 1 && p[1] > 0 && (D() == 2 || (p[2] > 0 && p[2] < 0.5)))
                continue;
            w.position.insert(w.position.end(), p, p + 3);
            const double n[3] = {p[0] < 0 ? 1.0 : (p[0] > 1 ? -1.0 : 0.0),
                p[0] > 0 && p[0] < 1 && p[1] < 0 ? 1.0 : 0.0, 0};
            w.normal.insert(w.normal.end(), n, n + 3);
        }
        return w;
    }

    //- The left wall is group 0; group 1 has no points
    static void makePiston(WallInput& w)
    {
        w.nBodies = 2;
        for (std::size_t i = 0; i < w.size(); ++i)
            w.body.push_back(w.position[3*i] < 0 && w.position[3*i + 1] > 0 ? 0 : -1);
    }

    //- Forth and back by 0.1 m in 0.4 s, without a jerk at the start
    static double stroke(double t) { return 0.05*(1 - std::cos(5*std::acos(-1.0)*t)); }
    static WallMotion pistonMotion()
    {
        return [](int body, double t)
        {
            WallPose p;
            if (body == 0) p.translation[0] = stroke(t);
            return p;
        };
    }
};

} // namespace riprap

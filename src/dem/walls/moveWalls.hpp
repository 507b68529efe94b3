/*  Moving walls: each wall's frame at the end of the step and its velocity in the middle of it,
    from the motion table.

    Numbers of a sample: rotation (9), translation (3), and their rates (12).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/state/clock.hpp"
#include "dem/motion/motionTable.hpp"
#include "dem/walls/wallSet.hpp"

namespace riprap
{

static constexpr int poseNumbers = 24;

struct MoveWalls
{
    static constexpr const char* name = "moveWalls";

    WallData* walls;
    MotionTable poses;
    const DemClockData* clock;
    DemClockData* raised;       // where flags go
    double halfSkin;
    double most;                // way in a step [m]; more would pass particles by

    HD void operator()(int k) const
    {
        WallData& w = walls[k];
        if (!clock->active || w.motion < 0) return;
        setFrame(w, clock->time, clock->time - 0.5*clock->dt);
        checkSkin(w);
    }

    //- The pose at time t, the velocity at time `middle`
    HD void setFrame(WallData& w, double t, double middle) const
    {
        double R[9], rate[9];
        for (int e = 0; e < 9; ++e)
        {
            w.frame.R[e] = poses.at(w.motion, e, t);
            R[e] = poses.at(w.motion, e, middle);
            rate[e] = poses.at(w.motion, 12 + e, middle);
        }
        for (int d = 0; d < 3; ++d)
        {
            w.frame.T[d] = poses.at(w.motion, 9 + d, t);
            w.frame.velocity[d] = poses.at(w.motion, 21 + d, middle);
        }
        const auto spin = [&](int a, int b)     // element of R' R^T, which is antisymmetric
        {
            double s = 0;
            for (int e = 0; e < 3; ++e) s += rate[3*a + e]*R[3*b + e] - rate[3*b + e]*R[3*a + e];
            return 0.5*s;
        };
        w.frame.spin[0] = spin(2, 1);
        w.frame.spin[1] = spin(0, 2);
        w.frame.spin[2] = spin(1, 0);
    }

    HD static double cornerSpeed2(const WallData& w, int corner)
    {
        double X[3], x[3];
        cornerOf(w, corner, X);
        for (int d = 0; d < 3; ++d)
        {
            x[d] = 0;
            for (int e = 0; e < 3; ++e) x[d] += w.frame.R[3*d + e]*X[e];
        }
        const double* s = w.frame.spin;
        const double u[3] = {w.frame.velocity[0] + s[1]*x[2] - s[2]*x[1],
            w.frame.velocity[1] + s[2]*x[0] - s[0]*x[2],
            w.frame.velocity[2] + s[0]*x[1] - s[1]*x[0]};
        return u[0]*u[0] + u[1]*u[1] + u[2]*u[2];
    }

private:

    HD static void cornerOf(const WallData& w, int corner, double* X)
    { for (int d = 0; d < 3; ++d) X[d] = (corner >> d) & 1 ? w.high[d] : w.low[d]; }

    //- The corners of the wall's extent travel farthest
    HD void checkSkin(const WallData& w) const
    {
        double farthest2 = 0, fastest2 = 0;
        for (int corner = 0; corner < 8; ++corner)
        {
            double X[3], moved2 = 0;
            cornerOf(w, corner, X);
            for (int d = 0; d < 3; ++d)
            {
                double now = w.frame.T[d], before = w.referenceT[d];
                for (int e = 0; e < 3; ++e)
                {
                    now += w.frame.R[3*d + e]*X[e];
                    before += w.referenceR[3*d + e]*X[e];
                }
                moved2 += (now - before)*(now - before);
            }
            const double speed2 = cornerSpeed2(w, corner);
            farthest2 = moved2 > farthest2 ? moved2 : farthest2;
            fastest2 = speed2 > fastest2 ? speed2 : fastest2;
        }
        const double distance = sqrt(farthest2);
        if (!(distance + 1.25*sqrt(fastest2)*clock->fullDt <= halfSkin)) raised->needRebuild = 1;
        if (distance <= halfSkin) return;
        raised->far[0] = raised->far[1] = 1;
        if (!(sqrt(fastest2)*clock->dt <= most)) raised->halt = DemHalt::wallTooFar;
    }
};

struct KeepWallReference
{
    static constexpr const char* name = "keepWallReference";
    WallData* walls;

    HD void operator()(int k) const
    {
        WallData& w = walls[k];
        for (int e = 0; e < 9; ++e) w.referenceR[e] = w.frame.R[e];
        for (int d = 0; d < 3; ++d) w.referenceT[d] = w.frame.T[d];
    }
};

} // namespace riprap

/*  Moving walls: points carried by the rigid motion of their group, known at equally spaced
    instants of the interval that is being advanced and interpolated between them by cubic Hermite
    polynomials (error of order interval^4).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "sph/boundary/wallFields.hpp"
#include "sph/state/clock.hpp"

namespace riprap
{

//- Pose of a group at an instant: x = R X + t, row-major R then t, and their rates of change
struct PoseSample { double value[12], rate[12]; };

struct PoseTable
{
    const PoseSample* samples;  // group*(intervals + 1) + instant
    int intervals;
    double begin, step;         // [s]

    //- value, first and second derivative of entry k of the pose of `body` at time t
    HD void evaluate(int body, int k, double t, double& p, double& v, double& a) const
    {
        double s = (t - begin)/step;
        int n = int(s);
        n = n < 0 ? 0 : (n >= intervals ? intervals - 1 : n);
        s -= n;
        const PoseSample& l = samples[body*(intervals + 1) + n];
        const PoseSample& r = samples[body*(intervals + 1) + n + 1];
        const double p0 = l.value[k], p1 = r.value[k], m0 = l.rate[k]*step, m1 = r.rate[k]*step;
        const double c2 = 3*(p1 - p0) - 2*m0 - m1, c3 = 2*(p0 - p1) + m0 + m1;
        p = p0 + s*(m0 + s*(c2 + s*c3));
        v = (m0 + s*(2*c2 + 3*s*c3))/step;
        a = (2*c2 + 6*s*c3)/(step*step);
    }
};

template<class Backend, int D, class P>
struct MoveWalls
{
    using real = typename P::real;
    static constexpr const char* name = "moveWalls";

    Box<D, P> box;
    WallFields<D, P> fields;
    RecordsView<Backend, D, P> wall;
    const double* rest;         // 3 n, position for the unit pose, by input index [m]
    int axes[3];                // axis of the case for each axis here
    PoseTable table;
    typename P::position* reference[D];
    real allowedWay;
    bool half;                  // at the middle of the step (predictor) instead of its end
    ClockData* clock;

    HD void operator()(int i) const
    {
        if (!clock->active) return;
        const int body = fields.body[i];
        if (body < 0) return;
        const double t = clock->time - (half ? 0.5*clock->dt : 0.0);
        const double* X = rest + 3*fields.id[i];
        real distance2 = 0, speed2 = 0;
        Vec<D, typename P::position> pairX;
        for (int d = 0; d < D; ++d)
        {
            const int row = axes[d];
            double x, u, a;
            table.evaluate(body, 9 + row, t, x, u, a);
            for (int c = 0; c < 3; ++c)
            {
                double r, ru, ra;
                table.evaluate(body, 3*row + c, t, r, ru, ra);
                x += r*X[c];
                u += ru*X[c];
                a += ra*X[c];
            }
            const std::int64_t fixed = box.toFixedInside(d, x);
            fields.x[d][i] = fixed;
            fields.v[d][i] = real(u);
            fields.a[d][i] = real(a);
            pairX.c[d] = box.pairPosition(d, fixed);
            const real s = box.template separation<real>(d, pairX.c[d], reference[d][i]);
            distance2 += s*s;
            speed2 += real(u*u);
        }
        wall.storePosition(i, pairX);
        const real distance = squareRoot(distance2);
        if (distance > allowedWay) clock->skinViolations = 1;
        if (distance + real(1.25)*squareRoot(speed2)*real(clock->fullDt) > allowedWay)
            clock->needRebuild = 1;
    }
};

} // namespace riprap

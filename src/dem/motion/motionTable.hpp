/*  Prescribed motions as the device sees them: samples over a window of time, a row of numbers
    each, between which is interpolated linearly. Samples are half a step apart, so that whole and
    half steps are met exactly.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/simd/macros.hpp"

namespace riprap
{

struct MotionTable
{
    const double* sample;       // [motion][time][numbers]
    int times, numbers;
    double begin, interval;

    HD double at(int motion, int number, double t) const
    {
        double s = (t - begin)/interval;
        s = s < 0 ? 0 : (s > times - 1 ? times - 1 : s);
        int k = int(s);
        if (k > times - 2) k = times - 2;
        const double* row = sample + (long long)(motion*times + k)*numbers + number;
        return row[0] + (s - k)*(row[numbers] - row[0]);
    }
};

//- Velocity, spin and centre of a rigid motion
static constexpr int rigidMotionNumbers = 9;

} // namespace riprap

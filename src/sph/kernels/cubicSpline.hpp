/*  Cubic spline (M4) kernel, Monaghan & Lattanzio 1985, support 2h, q = r/h:

        W = alpha h^-D ((2 - q)^3 - 4 (1 - q)^3)/4   (each bracket clipped at zero)
        alpha = 10/(7 pi) in 2D, 1/pi in 3D

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "sph/kernels/card.hpp"

namespace riprap
{

struct CubicSpline : KernelCard
{
    static constexpr const char* word = "cubicSpline";
    static constexpr const char* text = "cubic spline M4 (Monaghan & Lattanzio 1985)";

    static double alpha(int D)
    {
        constexpr double pi = 3.14159265358979323846;
        return D == 2 ? 10/(7*pi) : 1/pi;
    }

    template<class T>
    static HD T value(T q)
    {
        const T outer = maximum(T(2) - q, T(0)), inner = maximum(T(1) - q, T(0));
        return T(0.25)*(power<3>(outer) - T(4)*power<3>(inner));
    }

    //- (dW/dq)/q: -3 + 9q/4 inside q < 1, where the general form would cancel; -3 (2 - q)^2/(4q)
    //  outside
    template<class T>
    static HD T slope(T q)
    {
        const T outer = maximum(T(2) - q, T(0));
        const T far = T(-0.75)*outer*outer/maximum(q, T(0.5));
        return selectGreater(T(1), q, T(-3) + T(2.25)*q, far);
    }
};

} // namespace riprap

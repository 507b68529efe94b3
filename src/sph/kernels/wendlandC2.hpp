/*  Wendland C2 kernel (paper Eq. 28 in 2D; 3D form: Wendland 1995), support 2h, q = r/h:

        W = alpha h^-D (1 - q/2)^4 (2q + 1)          alpha = 7/(4 pi) in 2D, 21/(16 pi) in 3D
        grad W = F (x_i - x_j),  F = -5 alpha h^-(D+2) (1 - q/2)^3     [1/m^(D+2)]

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "sph/kernels/card.hpp"

namespace riprap
{

struct WendlandC2 : KernelCard
{
    static constexpr const char* word = "wendlandC2";
    static constexpr const char* text = "Wendland 1995, of C2 smoothness";
    static constexpr bool frequent = true;

    static double alpha(int D)
    {
        constexpr double pi = 3.14159265358979323846;
        return D == 2 ? 7/(4*pi) : 21/(16*pi);
    }

    //- W h^D/alpha; zero beyond the support
    template<class T>
    static HD T value(T q)
    {
        const T t = maximum(T(1) - T(0.5)*q, T(0));
        return power<4>(t)*(T(2)*q + T(1));
    }

    //- (dW/dq)/q h^D/alpha: finite at q = 0
    template<class T>
    static HD T slope(T q)
    {
        const T t = maximum(T(1) - T(0.5)*q, T(0));
        return T(-5)*power<3>(t);
    }
};

} // namespace riprap

/*  A template: copy it to src/sph/kernels, rename Gaussian and its word, replace the formula.

    Gaussian kernel, truncated at 3h and lowered to zero there (Colagrossi & Landrini 2003),
    q = r/h:

        W = alpha h^-D (exp(-q^2) - exp(-9))          q < 3
        alpha = 1/(pi (1 - 10 exp(-9))) in 2D, 1/(pi^(3/2) erf(3) - 42 pi exp(-9)) in 3D

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "sph/kernels/card.hpp"

namespace riprap
{

struct Gaussian : KernelCard
{
    static constexpr const char* word = "gaussian";
    static constexpr const char* text = "Gaussian truncated at 3h (Colagrossi & Landrini 2003)";
    static constexpr double support = 3;

    static constexpr double atSupport = 1.2340980408667956e-4;      // exp(-9)

    static double alpha(int D)
    {
        constexpr double pi = 3.14159265358979323846;
        return D == 2 ? 1/(pi*(1 - 10*atSupport))
          : 1/(std::pow(pi, 1.5)*std::erf(3.0) - 42*pi*atSupport);
    }

    //- exp(-q^2) for q <= 3: 1/(exp(q^2/8))^8, by the series of exp, which serves packs too
    template<class T>
    static HD T bell(T q)
    {
        const T x = T(0.125)*q*q;
        T sum = T(1);
        for (int k = 18; k > 0; --k) sum = T(1) + sum*x*T(1.0/k);
        return inverse(power<8>(sum));
    }

    //- W h^D/alpha; zero from the support on. T is a scalar or a Pack: no branches on q
    template<class T>
    static HD T value(T q)
    {
        const T inside = bell(minimum(q, T(support))) - T(atSupport);
        return selectGreater(T(support), q, inside, T(0));
    }

    //- (dW/dq)/q h^D/alpha: finite at q = 0, zero from the support on
    template<class T>
    static HD T slope(T q)
    {
        const T inside = T(-2)*bell(minimum(q, T(support)));
        return selectGreater(T(support), q, inside, T(0));
    }
};

} // namespace riprap

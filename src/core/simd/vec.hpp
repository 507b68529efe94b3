/*  Small fixed-size vectors of any arithmetic type (scalar or Pack). Aggregates: no constructors.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/simd/macros.hpp"

namespace riprap
{

template<int D, class T>
struct Vec
{
    T c[D];

    HD T& operator[](int d) { return c[d]; }
    HD const T& operator[](int d) const { return c[d]; }
};

template<int D, class T>
HD Vec<D, T> operator+(const Vec<D, T>& a, const Vec<D, T>& b)
{
    Vec<D, T> r;
    for (int d = 0; d < D; ++d) r.c[d] = a.c[d] + b.c[d];
    return r;
}

template<int D, class T>
HD Vec<D, T> operator-(const Vec<D, T>& a, const Vec<D, T>& b)
{
    Vec<D, T> r;
    for (int d = 0; d < D; ++d) r.c[d] = a.c[d] - b.c[d];
    return r;
}

template<int D, class T>
HD Vec<D, T> operator*(const T& s, const Vec<D, T>& a)
{
    Vec<D, T> r;
    for (int d = 0; d < D; ++d) r.c[d] = s*a.c[d];
    return r;
}

template<int D, class T>
HD T dot(const Vec<D, T>& a, const Vec<D, T>& b)
{
    T r = a.c[0]*b.c[0];
    for (int d = 1; d < D; ++d) r = r + a.c[d]*b.c[d];
    return r;
}

template<int D, class T>
HD T squaredNorm(const Vec<D, T>& a) { return dot(a, a); }

template<class T>
HD Vec<3, T> cross(const Vec<3, T>& a, const Vec<3, T>& b)
{
    return Vec<3, T>
    {{
        a.c[1]*b.c[2] - a.c[2]*b.c[1],
        a.c[2]*b.c[0] - a.c[0]*b.c[2],
        a.c[0]*b.c[1] - a.c[1]*b.c[0]
    }};
}

//- A vector with every component s
template<int D, class T>
HD Vec<D, T> filled(const T& s)
{
    Vec<D, T> r;
    for (int d = 0; d < D; ++d) r.c[d] = s;
    return r;
}

//- Every component converted (scalar to scalar, or scalar broadcast to Pack)
template<class To, int D, class T>
HD Vec<D, To> convert(const Vec<D, T>& a)
{
    Vec<D, To> r;
    for (int d = 0; d < D; ++d) r.c[d] = To(a.c[d]);
    return r;
}

} // namespace riprap

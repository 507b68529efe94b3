/*  Vectors of a contact in 2D and 3D. In 2D a spin is one number (about the third axis) and so is a
    tangential vector, along t = (-n2, n1) (paper 1, Eq. 3); in 3D both have three components.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/simd/math.hpp"
#include "core/simd/vec.hpp"

namespace riprap
{

//- Components of a spin, and of a vector in the contact plane
template<int D> inline constexpr int spins = D == 2 ? 1 : 3;

template<int D, class T> using Spin = Vec<spins<D>, T>;
template<int D, class T> using Tangent = Vec<spins<D>, T>;

//- w x r for a spin w: a velocity
template<class T> HD Vec<2, T> spinCross(const Vec<1, T>& w, const Vec<2, T>& r)
{
    return Vec<2, T>{{-w.c[0]*r.c[1], w.c[0]*r.c[0]}};
}
template<class T>
HD Vec<3, T> spinCross(const Vec<3, T>& w, const Vec<3, T>& r) { return cross(w, r); }

//- r x f: a moment
template<class T> HD Vec<1, T> moment(const Vec<2, T>& r, const Vec<2, T>& f)
{
    return Vec<1, T>{{r.c[0]*f.c[1] - r.c[1]*f.c[0]}};
}
template<class T>
HD Vec<3, T> moment(const Vec<3, T>& r, const Vec<3, T>& f) { return cross(r, f); }

//- The part of v in the contact plane
template<class T> HD Vec<1, T> toTangent(const Vec<2, T>& n, const Vec<2, T>& v)
{
    return Vec<1, T>{{n.c[0]*v.c[1] - n.c[1]*v.c[0]}};
}
template<class T>
HD Vec<3, T> toTangent(const Vec<3, T>& n, const Vec<3, T>& v) { return v - dot(v, n)*n; }

//- Its direction in space
template<class T> HD Vec<2, T> fromTangent(const Vec<2, T>& n, const Vec<1, T>& s)
{
    return Vec<2, T>{{-n.c[1]*s.c[0], n.c[0]*s.c[0]}};
}
template<class T>
HD Vec<3, T> fromTangent(const Vec<3, T>&, const Vec<3, T>& s) { return s; }

//- Moment of a tangential force about a centre at distance 1 along -n: n x s
template<class T>
HD Vec<1, T> tangentMoment(const Vec<2, T>&, const Vec<1, T>& s) { return s; }
template<class T>
HD Vec<3, T> tangentMoment(const Vec<3, T>& n, const Vec<3, T>& s) { return cross(n, s); }

//- A tangential vector of the last step in today's contact plane, as long as it was: the contact
//  turns with its particles
template<class T>
HD Vec<1, T> turned(const Vec<2, T>&, const Vec<1, T>& s) { return s; }
template<class T>
HD Vec<3, T> turned(const Vec<3, T>& n, const Vec<3, T>& s)
{
    const Vec<3, T> p = s - dot(s, n)*n;
    const T before = squaredNorm(s), after = squaredNorm(p), tiny(1e-36f);
    return rootOfRatio(before, maximum(after, tiny))*p;
}

//- A relative spin without twist about n (none in 2D)
template<class T>
HD Vec<1, T> withoutTwist(const Vec<2, T>&, const Vec<1, T>& w) { return w; }
template<class T>
HD Vec<3, T> withoutTwist(const Vec<3, T>& n, const Vec<3, T>& w) { return w - dot(w, n)*n; }

} // namespace riprap

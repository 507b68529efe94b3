/*  Parallel bond: an elastic beam of cement between two particles (paper 1, Eqs. 17-24, corrected
    as ERRATA has them; Potyondy & Cundall 2004).

        F_n = kn A (U_n - U_0)                  tension positive; U_n = d - R_A - R_B, U_0 the gap
                                                at which the bond was made
        F_s <- F_s + ks A V_s dt                on A, along the motion of B past A
        M   <- M + kn I (w_B - w_A) dt          bending; in 3D the part along n is twist, with ks J
                                                instead
        on A: F_n n + F_s, moment a_A n x F_s + M (+ M_t n); on B the reverse, moment a_B n x F_s -
        M; a = R + U_n/2
        2D      A = 2 Rb, I = 2/3 Rb^3 (plate of unit thickness)
        3D      A = pi Rb^2, I = pi Rb^4/4, J = 2 I; also in 2D as `cylinder`
        breaks  in tension when F_n/A + |M| Rb/I > sigma_c, in shear when |F_s|/A + |M_t| Rb/J >
                tau_c

    The normal part comes from positions, not increments: it cannot drift. A dashpot of ratio zeta
    may stand beside each spring: c = 2 zeta sqrt(m* kn A), and alike with ks A; with reduced
    inertias for bending and twist.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstdint>
#include <type_traits>
#include "dem/bond/bondRadius.hpp"
#include "dem/contact/contact.hpp"

namespace riprap
{

template<class R>
struct BondParameters
{
    R normal, shear;            // kn, ks [Pa/m]
    R tensile, shearStrength;   // sigma_c, tau_c [Pa]
    R twoZeta;
    R radiusFactor;
    std::uint8_t radius;        // place in BondRadii
    bool round;
};

//- Section of the cement
template<class R>
struct BondSection { R radius, area, inertia, polar; };

template<class R>
HD BondSection<R> bondSection(const BondParameters<R>& p, R radiusA, R radiusB)
{
    const R sum = radiusA + radiusB, pi = R(3.14159265358979323846);
    BondSection<R> s;
    s.radius = p.radiusFactor*radiusOf(Model<BondRadii>(), p.radius, radiusA, radiusB, sum);
    const R r2 = s.radius*s.radius;
    s.area = p.round ? pi*r2 : 2*s.radius;
    s.inertia = p.round ? R(0.25)*pi*r2*r2 : R(2)/R(3)*r2*s.radius;
    s.polar = 2*s.inertia;
    return s;
}

//- What a bond remembers: shear force, bending moment, twisting moment (3D)
template<int D> inline constexpr int bondHistory = D == 2 ? 2 : 7;

enum class BondBreak : int {none = 0, tension, shear, lost};

template<int D, class R>
struct BondForce
{
    Vec<D, R> force;            // on A
    Spin<D, R> momentA, momentB;
    Spin<D, R> bending;         // M on A, twist included
    R normal;                   // F_n
    // BondBreak, as wide as a real
    std::conditional_t<sizeof(R) == 8, std::int64_t, std::int32_t> broken;
};

//- Padding has whatever bits were there before, and they would be part of a written state
template<int D, class R>
inline constexpr bool bondForceIsFull = sizeof(BondForce<D, R>)
    == (D + 3*spins<D> + 2)*sizeof(R);
static_assert(bondForceIsFull<2, float> && bondForceIsFull<2, double>);
static_assert(bondForceIsFull<3, float> && bondForceIsFull<3, double>);

//- stretch: U_n - U_0; h: history, read and written
template<int D, class R>
HD BondForce<D, R> bondForce(const BondParameters<R>& p, const ContactBody<D, R>& a,
    const ContactBody<D, R>& b, const Vec<D, R>& n, R distance, R stretch, R dt, R* h)
{
    constexpr int S = spins<D>;
    const BondSection<R> s = bondSection(p, a.radius, b.radius);
    const R half = R(0.5)*(distance - a.radius - b.radius), armA = a.radius + half,
            armB = b.radius + half;
    ContactGeometry<D, R> g;
    g.n = n;
    setMotion(g, a, b, armA, armB);
    const Spin<D, R> relative = b.spin - a.spin;
    Tangent<D, R> shear;
    Spin<D, R> bending;
    for (int c = 0; c < S; ++c) { shear.c[c] = h[c]; bending.c[c] = h[S + c]; }
    shear = turned(n, shear) + (p.shear*s.area*dt)*g.slip;
    bending = turned(n, bending) + (p.normal*s.inertia*dt)*g.roll;
    R twist = 0, twistRate = 0;
    if constexpr (D == 3)
    {
        twistRate = dot(relative, n);
        twist = h[2*S] + p.shear*s.polar*dt*twistRate;
        h[2*S] = twist;
    }
    for (int c = 0; c < S; ++c) { h[c] = shear.c[c]; h[S + c] = bending.c[c]; }
    BondForce<D, R> f;
    f.normal = p.normal*s.area*stretch;

    const R tension = f.normal/s.area + squareRoot(squaredNorm(bending))*s.radius/s.inertia;
    const R stress = squareRoot(squaredNorm(shear))/s.area + absolute(twist)*s.radius/s.polar;
    f.broken = int(tension > p.tensile
            ? BondBreak::tension
            : (stress > p.shearStrength ? BondBreak::shear : BondBreak::none));

    const R m = a.mass*b.mass/(a.mass + b.mass), factor = R(D == 2 ? 0.5 : 0.4);
    const R ia = factor*a.mass*a.radius*a.radius, ib = factor*b.mass*b.radius*b.radius,
            inertia = ia*ib/(ia + ib);
    const R normal = f.normal - p.twoZeta*squareRoot(m*p.normal*s.area)*g.approach;
    const Tangent<D, R> pull = shear + (p.twoZeta*squareRoot(m*p.shear*s.area))*g.slip;
    f.bending = bending + (p.twoZeta*squareRoot(inertia*p.normal*s.inertia))*g.roll;
    if constexpr (D == 3)
        f.bending = f.bending
            + (twist + p.twoZeta*squareRoot(inertia*p.shear*s.polar)*twistRate)*n;
    const Spin<D, R> lever = tangentMoment(n, pull);
    f.force = normal*n + fromTangent(n, pull);
    f.momentA = armA*lever + f.bending;
    f.momentB = armB*lever - f.bending;
    return f;
}

//- Elastic energy [J]
template<int D, class R>
HD R bondEnergy(const BondParameters<R>& p, R radiusA, R radiusB, R stretch, const R* h)
{
    constexpr int S = spins<D>;
    const BondSection<R> s = bondSection(p, radiusA, radiusB);
    R shear2 = 0, bending2 = 0;
    for (int c = 0; c < S; ++c) { shear2 += h[c]*h[c]; bending2 += h[S + c]*h[S + c]; }
    const R twist = D == 3 ? h[bondHistory<D> - 1] : R(0);
    return R(0.5)
        *(p.normal*s.area*stretch*stretch + shear2/(p.shear*s.area)
            + bending2/(p.normal*s.inertia) + twist*twist/(p.shear*s.polar));
}

} // namespace riprap

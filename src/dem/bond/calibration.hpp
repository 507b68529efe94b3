/*  Stiffnesses of bonds and contacts from elastic constants.

        Eq. 42          kn = E/(R_A + R_B),  ks = G/(R_A + R_B)                              [Pa/m]
        Eq. 43          k_n = E 2 Rb/(R_A + R_B), k_s = G 2 Rb/(R_A + R_B) [N/m per metre of depth]
        section 6.3.3   E -> E (1 - nu)/((1 + nu)(1 - 2 nu)),  k_s = k_n/2
        tip deflection of a row of n bonded particles, held at one end, load P at the other
        (ERRATA): each bond bends at its middle
                        P/(kn I) sum_{k=1}^{n-1} ((k - 1/2) L)^2 + P (n - 1)/(ks A)

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

namespace riprap
{

struct BondStiffness { double normal, shear; };

inline double shearModulus(double young, double nu) { return young/(2*(1 + nu)); }
inline double constrainedModulus(double young, double nu)
{
    return young*(1 - nu)/((1 + nu)*(1 - 2*nu));
}

inline BondStiffness bondStiffness(double young, double shear, double radiusA, double radiusB)
{ return {young/(radiusA + radiusB), shear/(radiusA + radiusB)}; }

inline BondStiffness contactStiffness(
    double young, double shear, double bondRadius, double radiusA, double radiusB)
{ return {young*2*bondRadius/(radiusA + radiusB), shear*2*bondRadius/(radiusA + radiusB)}; }

inline BondStiffness plateBondStiffness(double young, double nu, double radiusA, double radiusB)
{
    const double normal = constrainedModulus(young, nu)/(radiusA + radiusB);
    return {normal, 0.5*normal};
}

inline double cantileverDeflection(
    int n, double spacing, double load, BondStiffness k, double area, double inertia)
{
    double sum = 0;
    for (int b = 1; b < n; ++b) sum += (b - 0.5)*spacing*(b - 0.5)*spacing;
    return load/(k.normal*inertia)*sum + load*(n - 1)/(k.shear*area);
}

} // namespace riprap

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

#include <iterator>
#include <map>
#include "api/models.hpp"

namespace riprap
{

struct BondStiffness { double normal, shear; };

//- What a calibration is given [Pa]
struct CalibrationNumbers
{
    double normalStiffness = 0, shearStiffness = 0;     // [Pa/m]
    double young = 0, shear = 0, poisson = 0;           // E, G [Pa], nu
    std::map<std::string, double> more;
};

using CalibrationEntry = ModelEntry<CalibrationNumbers>;

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

//- Of a plate, section 6.3.3: times the sum of the radii [Pa]
inline BondStiffness plateModuli(double young, double nu)
{
    const double normal = constrainedModulus(young, nu);
    return {normal, 0.5*normal};
}

inline BondStiffness plateBondStiffness(double young, double nu, double radiusA, double radiusB)
{
    const BondStiffness k = plateModuli(young, nu);
    return bondStiffness(k.normal, k.shear, radiusA, radiusB);
}

inline double cantileverDeflection(
    int n, double spacing, double load, BondStiffness k, double area, double inertia)
{
    double sum = 0;
    for (int b = 1; b < n; ++b) sum += (b - 0.5)*spacing*(b - 0.5)*spacing;
    return load/(k.normal*inertia)*sum + load*(n - 1)/(k.shear*area);
}

//- As typed
struct DirectCalibration
{
    static constexpr const char* word = "direct";
    static constexpr const char* text = "stiffnesses as they are typed";
    static constexpr CalibrationEntry entries[] =
    {
        CalibrationEntry("normalStiffness", "Pa/m", "normal stiffness",
            &CalibrationNumbers::normalStiffness),
        CalibrationEntry("shearStiffness", "Pa/m", "shear stiffness",
            &CalibrationNumbers::shearStiffness)
    };
    static constexpr bool byRadii = false;

    static BondStiffness of(const CalibrationNumbers& c)
    { return {c.normalStiffness, c.shearStiffness}; }
};

//- Eqs. 42, 43
struct ModuliCalibration
{
    static constexpr const char* word = "moduli";
    static constexpr const char* text = "E and G over the sum of the radii (Eq. 42)";
    static constexpr CalibrationEntry entries[] =
    {
        CalibrationEntry("E", "Pa", "Young's modulus", &CalibrationNumbers::young),
        CalibrationEntry("G", "Pa", "shear modulus", &CalibrationNumbers::shear)
    };
    static constexpr bool byRadii = true;

    static BondStiffness of(const CalibrationNumbers& c) { return {c.young, c.shear}; }
};

//- Section 6.3.3
struct PlaneStrainCalibration
{
    static constexpr const char* word = "planeStrain";
    static constexpr const char* text = "a plate's modulus of E and nu, half of it in shear";
    static constexpr CalibrationEntry entries[] =
    {
        CalibrationEntry("E", "Pa", "Young's modulus", &CalibrationNumbers::young),
        // at 0.5 the stiffness is infinite
        CalibrationEntry("nu", "", "Poisson's ratio", &CalibrationNumbers::poisson)
            .in(Range::zeroOrPositive).atMost(0.4999).like(0.3)
    };
    static constexpr bool byRadii = true;

    static BondStiffness of(const CalibrationNumbers& c)
    { return plateModuli(c.young, c.poisson); }
};

//- byRadii: `of` is over the sum of the radii, and a contact may be a column of such a material
//  (Eq. 43)
using Calibrations = Models<DirectCalibration, ModuliCalibration, PlaneStrainCalibration>;

struct CalibrationCard
{
    const char* word;
    const char* text;
    std::vector<CalibrationEntry> entries;
    bool byRadii;
    BondStiffness (*of)(const CalibrationNumbers&);
};

//- All there are, in the order of their table
inline const std::vector<CalibrationCard>& calibrations()
{
    static const std::vector<CalibrationCard> all = []
    {
        std::vector<CalibrationCard> cards;
        Calibrations::each([&](auto model)
        {
            using C = typename decltype(model)::type;
            cards.push_back({C::word, C::text, {std::begin(C::entries), std::end(C::entries)},
                C::byRadii, C::of});
        });
        return cards;
    }();
    return all;
}

//- By a word that there is
inline const CalibrationCard& calibrationOf(const std::string& word)
{
    const int found = Calibrations::find(word);
    if (found < 0) throw std::invalid_argument("unknown calibration " + word);
    return calibrations()[std::size_t(found)];
}

} // namespace riprap

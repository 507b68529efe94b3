// SPDX-License-Identifier: GPL-3.0-or-later
/*  A case with solidProperties, in which regions of solids are placed.

        SolidRegionCase c;                                  // the unit cube, walls on all sides
        const solidRegion r(c.one("source box; box (0 0 0) (1 1 1); spacing 0.1;"));
        c.said("source bix;");                              // the message of the same region
*/
#pragma once

#include "particleCase.hpp"
#include "quaternion.H"
#include "solidRegions.H"

#include <cmath>
#include <gtest/gtest.h>
#include <memory>

struct SolidRegionCase : ParticleCase
{
    std::unique_ptr<const Foam::demSettings> settings;
    std::unique_ptr<const Foam::geometryWalls> bodies;

    static constexpr const char* rock = "materials { rock { rho 2000; E 1e7; nu 0.2; } } ";
    static constexpr const char* rockAndWood =
        "materials { rock { rho 2000; E 1e7; nu 0.2; } wood { rho 500; E 1e7; nu 0.2; } } ";

    explicit SolidRegionCase(const BoxMesh& box = BoxMesh(), const std::string& properties = rock,
        const std::string& control = "")
    :
        ParticleCase(box, control)
    {
        writeDict("constant/solidProperties", properties);
        settings = std::make_unique<const Foam::demSettings>(Foam::readDemSettings(mesh()));
    }

    //- The cube flat: x and z, the mid-plane at y = 0.5
    static BoxMesh flat()
    {
        BoxMesh box;
        box.sides(1, "empty");
        return box;
    }

    Foam::solidSpace space() const { return {mesh(), *settings, bodies.get()}; }

    //- Of "a { .. } b { .. }"; others: entries beside the list
    Foam::List<Foam::solidRegion> regions(
        const std::string& list, const std::string& others = "") const
    {
        return Foam::readSolidRegions(entries(others + " regions (" + list + ");"), space());
    }

    //- A region with the name a
    Foam::solidRegion one(const std::string& text, const std::string& others = "") const
    {
        return regions("a { set solids; " + text + " }", others)[0];
    }

    std::string said(const std::string& text, const std::string& others = "") const
    {
        return messageOf([&]() { one(text, others); });
    }
};

//- A closed surface as a file .off
inline std::string boxSurface(const Foam::boundBox& box)
{
    std::string text("OFF\n8 12 0\n");
    const Foam::pointField corners(box.points());
    for (const Foam::point& p : corners)
    {
        for (int d = 0; d < 3; ++d) text += std::to_string(p[d]) + ' ';
        text += '\n';
    }
    for (const Foam::face& f : Foam::boundBox::faces)
        for (int half = 1; half < 3; ++half)
        {
            text += '3';
            for (const int v : {0, half, half + 1}) text += ' ' + std::to_string(f[v]);
            text += '\n';
        }
    return text;
}

//- From principal axes to space
inline Foam::tensor turnOf(const riprap::DemClump& b)
{
    const auto& q = b.orientation;
    return Foam::quaternion(q[0], Foam::vector(q[1], q[2], q[3])).R();
}

inline Foam::point centreOf(const riprap::DemClump& b)
{
    return Foam::point(b.position[0], b.position[1], b.position[2]);
}

//- In space
inline Foam::tensor inertiaOf(const riprap::DemClump& b)
{
    const Foam::tensor R(turnOf(b));
    return R & Foam::tensor(b.inertia[0], 0, 0, 0, b.inertia[1], 0, 0, 0, b.inertia[2]) & R.T();
}

//- Volume of a ball
inline double ballOf(double radius) { return 4*std::acos(-1.0)/3*radius*radius*radius; }

//- Distance between the nearest two
inline double leastDistance(const Foam::pointField& x)
{
    double least = 1e300;
    forAll(x, i)
        for (Foam::label j = 0; j < i; ++j) least = std::min(least, Foam::mag(x[i] - x[j]));
    return least;
}

//- Pairs whose distance is this
inline int pairsAt(const Foam::pointField& x, double distance)
{
    int n = 0;
    forAll(x, i)
        for (Foam::label j = 0; j < i; ++j) n += std::abs(Foam::mag(x[i] - x[j]) - distance) < 1e-9;
    return n;
}

/*  What contact laws say about themselves besides word, text, entries, history and force: defaults
    of their cards.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <string>
#include "dem/contact/geometry.hpp"
#include "api/pairProperties.hpp"

namespace riprap
{

//- Entries of several laws
namespace pairEntry
{
inline constexpr PairEntry restitution = PairEntry("restitution", "", "restitution coefficient",
                               &PairProperties::restitution)
                                             .in(Range::fraction)
                                             .losslessAt(1),
                           attraction = PairEntry(
                               "attraction", "pulling dashpot", &PairProperties::attraction, false),
                           gap = PairEntry("gap", "m", "gap", &PairProperties::gap)
                                     .in(Range::zeroOrPositive)
                                     .byDefault(0)
                                     .show(Shown::ifSet)
                                     .like(0),
                           friction = PairEntry(
                               "friction", "", "friction", &PairProperties::friction)
                                          .in(Range::zeroOrPositive),
                           stiffnessRatio = PairEntry("stiffnessRatio", "",
                               "tangential over normal stiffness", &PairProperties::stiffnessRatio)
                                                .atMost(10)
                                                .byDefault(-1)
                                                .show(Shown::never),
                           tangentialDamping = PairEntry("tangentialDamping", "tangential dashpot",
                               &PairProperties::tangentialDamping, true)
                                                   .show(Shown::never)
                                                   .losslessAt(0),
                           rollingFriction = PairEntry("rollingFriction", "", "rolling friction",
                               &PairProperties::rollingFriction)
                                                 .in(Range::zeroOrPositive)
                                                 .like(0.1);
}

//- A body that meets another like it, or a wall
struct Impact { double mass, radius, speed; };

//- Of a normal dashpot: 2 zeta of dashpot.hpp, or c/sqrt(m k) of one that knows no step
struct NormalDashpot { double twoZeta, plain; };

//- Normal laws. `stiffness(pair, impact)` is what the step must resolve: the largest slope of the
//  force in that impact
struct NormalCard
{
    static constexpr bool off = false;
    static constexpr bool elasticConstants = false;     // needs E and nu of the materials
    static constexpr bool gravity = false;              // needs |g|
    // the slope does not depend on the overlap: then there is dashpot(pair)
    static constexpr bool constantStiffness = false;
    // it is proportional to the particles' masses
    static constexpr bool stiffnessByMass = false;
    // NormalForce::stiffness is no less than the slope, else it is the slope
    static constexpr bool bounds = false;
    // acts beyond the surfaces once they have touched: reach(pair, R), acts(h)
    static constexpr bool reaches = false;

    //- How far apart surfaces may act on each other, at most, of bodies up to this reduced radius
    //  [m]
    static double reach(const PairProperties&, double) { return 0; }

    //- What of ContactGeometry::overlap is that reach
    template<class T, class Q> HD static T reachOf(const Q&) { return T(0.0f); }

    //- Does it carry force, by what it remembers?
    template<class T> HD static bool acts(const T*) { return true; }

    //- What is to be said where bodies can fall this fast; empty: nothing
    static std::string warning(const PairProperties&, double) { return ""; }
};

//- Springs: an impact's overlap goes with k^(-1/2)
struct SpringNormal : NormalCard
{
    static constexpr bool constantStiffness = true;
    static constexpr const char* stiffenedBy = "A stiffness";
    static constexpr double stiffening = 2;             // times 1/overlap to this power
};

//- By elastic constants: with E^(-2/5)
struct ElasticNormal : NormalCard
{
    static constexpr bool elasticConstants = true;
    static constexpr const char* stiffenedBy = "E";
    static constexpr double stiffening = 2.5;
};

struct TangentialCard
{
    static constexpr bool off = false;                  // no friction at all
    // remembers; else what it does goes with the step
    static constexpr bool spring = true;
    template<class Normal> static constexpr bool goesWith = true;
};

struct RollingCard
{
    static constexpr bool off = false;
    static constexpr bool spring = false;
    //- Without friction bodies slide, and nothing makes them roll
    template<class Tangential> static constexpr bool goesWith = !Tangential::off;
};

} // namespace riprap

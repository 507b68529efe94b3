/*  A block of fluid, or a single particle, thrown down on a flat wall without gravity: the scene of
    the violent experiments (2D).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "api/sphScene.hpp"

namespace riprap
{

struct ThrownBlock
{
    std::string kernel = "wendlandC2";
    double ratio = 1.25;        // h/dp
    std::string walls = "extrapolated";
    double wallRatio = 1;       // the wall's spacing over dp
    std::string integrator = "leapfrog";
    double artificial = 0;      // alpha of the artificial viscosity
    int side = 12;              // particles of the block's side
    double offset = 0;          // of the fluid's lattice along the wall, in wall spacings
    double speed = 1;           // [m/s]
    double timeStep = 0;        // fixed [s]; 0: as riprap chooses it
    bool defaults = false;      // riprap's terms and step, with `artificial` within the fluid
    bool impermeable = false;   // the wall's face as well as its points
    bool wildRule = false;
    double courant = 0.5;       // of the defaults
    // steps are limited by force alone, with a factor of 1 (to measure accelerations)
    bool forceLimit = false;

    static constexpr double spacing = 0.01, soundSpeed = 10, density = 1000;

    double h() const { return ratio*spacing; }
    int layers() const;         // of wall points: as many as the support needs
    double thickness() const { return layers()*wallRatio*spacing; }
    double floorHalf() const { return (0.5*side + 60)*spacing; }
    double duration() const;    // until the block's top has come down [s]
};

//- Guards are off. The floor is so wide that nothing gets to its ends in the block's duration
//  unless it is faster than three times the block
std::unique_ptr<SphScene> throwBlock(const ThrownBlock&);

//- Terms and limits of the step as an empty sphProperties has them, but for alpha; the rule of wild
//  particles with its limits
void setDefaults(SphConfig&, double alpha);
void setWildRule(SphConfig&);

//- Depth of the lowest particle below the floor's surface, its ends apart [m]. Escaped particles
//  count where they left
double depth(SphScene&, const SphReport&, const ThrownBlock&);

} // namespace riprap

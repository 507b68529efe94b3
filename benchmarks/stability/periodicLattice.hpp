/*  A square lattice of fluid in a periodic box (2D), in double precision on the CPU: the scene of
    the linear experiments.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "latticeModes.hpp"

namespace riprap
{

struct PeriodicLattice
{
    SphConfig config;
    FluidInput fluid;
};

//- Sites x sites particles at rest, at the model's density and spacing, with its terms and a fixed
//  time step
PeriodicLattice makeLattice(const LatticeModel&, int sites, const std::string&, double timeStep);

//- Density as rho (1 + amplitude cos(k.x + 0.3))
void addDensityWave(PeriodicLattice&, const Wave&, double amplitude);

//- Every density, or velocity component (times c0), or coordinate (times dp) changed at random by
//  up to `amplitude`
void addDensityNoise(PeriodicLattice&, double amplitude);
void addVelocityNoise(PeriodicLattice&, double amplitude);
void addPositionNoise(PeriodicLattice&, double amplitude);

//- Root mean square of (v/c0, rho/rho0 - 1): the size of a disturbance of a fluid at rest and rest
//  density
double disturbance(SphScene&, const SphConfig&);

//- Advance by some steps; false when a guard stopped the run
bool take(SphScene&, int steps);

} // namespace riprap

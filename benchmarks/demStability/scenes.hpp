/*  Small scenes for experiments: periodic lattices of equal bodies that press on each other or are
    bonded, and single bodies.

    Units: radius 1, mass 1, contact stiffness 1, so that sqrt(m/k) = 1 and a step is its fraction.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "api/demScene.hpp"

namespace riprap
{

enum class Lattice {chain, square, hexagonal, cubic, closePacked};

struct LatticeOptions
{
    Lattice lattice = Lattice::chain;
    std::string normal = "linear";
    bool tangential = false, bonded = false;
    double stiffnessRatio = 1;          // k_t/k_n of contacts, ks/kn of bonds
    double overlap = 1e-3;              // in the state of rest [radii]
    double restitution = 1;
};

//- Positions of a periodic lattice of bodies of radius 1 that overlap, and its box
struct LatticePoints { std::vector<double> position; Vector3 size{{0, 0, 0}}; int dimensions = 2; };
LatticePoints latticePoints(Lattice, double overlap);

//- A scene of it at rest, double precision on the CPU, with any step allowed
void latticeScene(const LatticeOptions&, DemConfig&, DemInput&);

//- One body of radius 1 and mass 1 in a wide box, contact stiffness 1 (linear), elastic and without
//  friction
void singleScene(DemConfig&, DemInput&);
void addBody(DemInput&, Vector3 x, Vector3 v = {{0, 0, 0}}, int group = 0);
void addFloor(DemInput&, double height = 0, Vector3 normal = {{0, 0, 1}});

inline const std::string integrators[] = {"leapfrog", "velocityVerlet"};

} // namespace riprap

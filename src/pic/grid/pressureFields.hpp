/*  What the pressure step takes and gives: views of arrays on the backend.

    The flux into a cell through a face of area |S| is |S| (a u + (1 - a) w): a is the part of the
    face that is open to water, u the water's velocity along the face's direction, w the velocity of
    the wall that closes the rest. So

    - a face that is closed (a wall) has a = 0; a moving wall there has w; an inlet is a closed face
    with w = its velocity;
    - a face at the end of the block that is not closed (a > 0) is open to the atmosphere: p = 0 at
    the face itself; - a cell is wet if it lies deeper than wetDepth and one of its faces is open; p
    = 0 where phi = 0 between a wet cell and a dry one, at the
      fraction theta = phi_wet/(phi_wet - phi_dry) of their distance, through the open part of the
      face. A dry cell that lies a hair under the surface makes theta a little more than 1: so theta
      needs no bound that would bend a flat surface, wherever it lies.

    The step finds p [Pa] in wet cells (0 elsewhere) such that the fluxes of every wet cell sum to
    zero with u = u* - dt/rho grad p, and changes u on every open face that has a wet cell on either
    side; all other faces keep their u.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/grid/uniformGrid.hpp"

namespace riprap
{

template<int D, class R>
struct PressureFields
{
    UniformGrid<D> grid;
    const R* phi;               // cells: distance to the surface [m], negative in water
    const R* aperture[D];       // faces: 0 (closed) .. 1 (open)
    const R* wallVelocity[D];   // faces: along the face's direction [m/s]; nullptr: all walls rest
    R* u[D];                    // faces: along the face's direction [m/s]; u* in, u out
    double* p;                  // cells [Pa]; in: a first guess, out: p
    double timeStep, density;   // [s], [kg/m3]
};

//- Depth of the middle of a cell, in cells, from which it is wet: theta is at least about this much
static constexpr double wetDepth = 0.01;

//- For a phi that is no distance: below this the surface would pull at a cell without bound
static constexpr double smallestTheta = 0.005;

template<int D, class R>
HD bool isWet(const PressureFields<D, R>& f, int cell, const typename UniformGrid<D>::Index& c)
{
    if (!(f.phi[cell] < R(-wetDepth*f.grid.h))) return false;
    bool open = false;
    for (int d = 0; d < D; ++d)
        for (int side = 0; side < 2; ++side)
            open = open || f.aperture[d][f.grid.faceOf(d, c, side)] > R(0);
    return open;
}

} // namespace riprap

/*  The fastest oscillation of bodies on springs, in plain algebra and without any of the solver's
    code.

    Springs of pairs i, j at distance s along n: k_n (n.du) n along n, k_t of the slip of the two
    surfaces' meeting point, which turns with both bodies on arms of s/2; bonds also resist bending
    (k_b) and twist (k_w). The operator M^-1/2 K M^-1/2 is symmetric; its largest eigenvalue w^2
    comes from power iteration. An explicit scheme of second order without damping stands w dt <= 2.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <vector>
#include "scenes.hpp"

namespace riprap
{

struct Springs { double normal = 1, shear = 0, bending = 0, twist = 0; };

//- Largest w of the lattice's neighbours (closer than 2 + 1e-6), periodic along `periodic`
double fastestMode(const LatticePoints&, const bool periodic[3], const Springs&);

} // namespace riprap

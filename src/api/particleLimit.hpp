/*  How many particles a scene may have: ids have 32 bits, and lists that count several of each particle (contacts, wall points, coordinates) 31.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <stdexcept>
#include <string>

namespace riprap
{

static constexpr double mostFluidParticles = 5e8, mostSolidParticles = 2.5e8;

//- \throw std::invalid_argument that names the limit
inline void requireCountable(double n, double most, const char* what)
{
    if (n <= most) return;
    throw std::invalid_argument("there are " + std::to_string(static_cast<long long>(n)) + ' ' + what + ", and a scene, which counts them in 32 bits, can have "
      + std::to_string(static_cast<long long>(most)));
}

} // namespace riprap

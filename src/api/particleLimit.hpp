/*  How many particles a scene may have: ids have 32 bits, and lists that count several of each
    particle (contacts, wall points, coordinates) 31.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace riprap
{

static constexpr double mostFluidParticles = 5e8, mostSolidParticles = 2.5e8, mostCells = 5e8;

//- \throw std::invalid_argument that names the limit
inline void requireCountable(double n, double most, const char* what)
{
    if (n <= most) return;
    throw std::invalid_argument("there are " + std::to_string(static_cast<long long>(n)) + ' '
        + what + ", and a scene, which counts them in 32 bits, can have "
        + std::to_string(static_cast<long long>(most)));
}

//- Entries of lists, summed up in 31 bits: a sum beyond them is negative. \throw std::runtime_error
inline std::size_t requireListed(int entries, const char* what)
{
    if (entries >= 0) return std::size_t(entries);
    throw std::runtime_error(std::string("lists of ") + what
        + " have more than 2147483647 entries, which a scene counts in 31 bits: give them a "
          "smaller skin, or divide the scene among ranks");
}

} // namespace riprap

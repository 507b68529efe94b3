/*  Numbers of the transfer between particles and grid, whichever is chosen.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <map>
#include <string>
#include "api/models.hpp"

namespace riprap
{

struct TransferProperties
{
    double picPart = 0.05;                  // share of the grid's velocity
    // particles keep the gradient of the grid's velocity, and bring it to the grid
    bool affine = true;
    std::map<std::string, double> more;     // of schemes that have numbers of their own, by name
};

using TransferEntry = ModelEntry<TransferProperties>;

} // namespace riprap

/*  What a case says of its equation of state, in double, on the host.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <map>
#include <string>
#include "api/models.hpp"

namespace riprap
{

struct EquationProperties
{
    std::string eos = "Tait";
    double gamma = 7;

    //- Numbers of equations that need others than these, by the names of their entries
    std::map<std::string, double> more;
};

using EquationEntry = ModelEntry<EquationProperties>;

} // namespace riprap

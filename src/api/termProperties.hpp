/*  What a case says of its pair terms, in double, on the host. Each term makes its own parameters
    of it.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <map>
#include <string>
#include "api/models.hpp"

namespace riprap
{

struct TermProperties
{
    std::string viscosityModel = "laminar";
    double viscositySoftening = 0.01;       // eta of Eq. 36: r^2 + eta h^2
    double artificialAlpha = 0.02;
    bool artificialAtWalls = true;          // it also acts between fluid and walls or solids
    double antiClump = 0;                   // coefficient of Eq. 38 (0.01), 0: off
    double xsph = 0;                        // epsilon of Eq. 39, 0: off
    std::string diffusion = "none";
    double diffusionDelta = 0.1;

    //- Numbers and words of terms that need others than these, by the names of their entries
    std::map<std::string, double> more;
    std::map<std::string, std::string> moreWords;
};

using TermEntry = ModelEntry<TermProperties>;

//- What terms may know of the fluid
struct TermFluid
{
    int dimensions = 2;
    double density = 1000, viscosity = 0;   // rho0 [kg/m3], mu [Pa s]
    double soundSpeed = 10;                 // c0 [m/s]
    double spacing = 0, h = 0;              // dp, h0 [m]
    double gravity[3] = {0, 0, 0};          // along the solved axes [m/s2]
};

//- An entry of sphProperties whose word chooses terms; none: no term
struct TermSwitch
{
    const char* entry;
    const char* otherwise;                  // where a case does not say
    Member<TermProperties, std::string> place = nullptr;

    std::string word(const TermProperties& p) const
    {
        if (place) return p.*place;
        const auto found = p.moreWords.find(entry);
        return found == p.moreWords.end() ? otherwise : found->second;
    }
    void set(TermProperties& p, const std::string& word) const
    { (place ? p.*place : p.moreWords[entry]) = word; }
};

} // namespace riprap

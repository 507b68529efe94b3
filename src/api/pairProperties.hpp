/*  What is known of a pair of materials, in double, on the host. Each law makes its own parameters
    of it.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <map>
#include <string>
#include "api/models.hpp"

namespace riprap
{

struct PairProperties
{
    // The two materials, and the largest radius of any particle [m]
    double youngA = 0, youngB = 0;          // E [Pa]
    double poissonA = 0.25, poissonB = 0.25;
    double largestRadius = 0;

    // Normal
    double normalStiffness = 0;             // k of the linear springs [N/m] (2D: [N/m2])
    double restitution = 1;                 // e, of a head-on impact
    bool attraction = false;                // may the dashpot pull at the end of an impact?
    double theta = 0.01, alpha = 0;         // paper 2, Eqs. 10, 11
    double cellSize = 0, gravity = 0;       // its dx [m], |g| [m/s2]
    // contact begins at this distance of the surfaces [m] (Eq. 19)
    double gap = 0;

    // Tangential
    double friction = 0;                    // mu
    // k_t/k_n; < 0: from Poisson's ratio, as the tangential law has it
    double stiffnessRatio = -1;
    bool tangentialDamping = true;

    // Rolling
    double rollingFriction = 0;             // mu_r
    double rollingDamping = 0;              // fraction of critical, elastic-plastic model

    //- Numbers of laws that need others than these, by the names of their entries
    std::map<std::string, double> more;

    //- E* of Hertz
    double effectiveYoung() const
    { return 1/((1 - poissonA*poissonA)/youngA + (1 - poissonB*poissonB)/youngB); }

    //- k_t/k_n of two spheres of one material pressed together (Mindlin 1949)
    double ratioByPoisson() const
    {
        const double nu = 0.5*(poissonA + poissonB);
        return (1 - nu)/(1 - 0.5*nu);
    }

    //- G* of Mindlin: 1/G* = (2 - nu_A)/G_A + (2 - nu_B)/G_B, G = E/(2(1 + nu))
    double effectiveShear() const
    {
        const auto compliance = [](double young, double nu) { return (2 - nu)*2*(1 + nu)/young; };
        return 1/(compliance(youngA, poissonA) + compliance(youngB, poissonB));
    }
};

using PairEntry = ModelEntry<PairProperties>;

} // namespace riprap

/*  The fluid's state on the device (structure of arrays) and the constants of its model.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstdint>
#include "core/containers/records.hpp"
#include "sph/eos/equationOfState.hpp"

namespace riprap
{

//- State that is integrated, sorted and saved. What a case does not use is null.
template<int D, class P>
struct FluidFields
{
    using real = typename P::real;

    std::int64_t* x[D];         // fixed-point position
    real* v[D];                 // velocity [m/s]
    real* deviation;            // rho/rho0 - 1
    real* a[D];                 // acceleration of the last pass [m/s2]
    real* rate;                 // d(deviation)/dt of the last pass [1/s]
    // XSPH and shifting: added to v when positions move [m/s]; null: off
    real* drift[D];
    std::int32_t* id;           // negative, -1 - id: it ran wild and leaves with the next sort
};

template<int D, class P>
struct FluidModel
{
    using real = typename P::real;

    EquationOfState<real> eos;
    Vec<D, real> gravity;
    real rho0;
    real h0;
    real hMin, hMax;            // limits of a variable h [m]
    real mass;                  // of a fluid particle [kg] (2D: a metre of depth)
    real wallMass;
    real spacing;
    bool variableH;
    bool drifts;
    bool removesWild;           // particles beyond these are taken out of the scene
    real maxDeviation, maxSpeed2, maxAcceleration2;     // |rho/rho0 - 1|, [m2/s2], [m2/s4]
    double domainMin[D], domainMax[D];  // above the box's corner [m]; beyond: escaped

    //- Eq. 37 integrated: h rho^(1/D) stays what it was
    HD real smoothingLength(real deviation) const
    {
        if (!variableH) return h0;
        const real r = real(1) + deviation;
        const real ratio = D == 2 ? real(1)/squareRoot(r) : real(1)/real(cbrt(double(r)));
        return minimum(maximum(h0*ratio, hMin), hMax);
    }

    //- Written so that what is no number is wild
    HD bool wild(real deviation, real speed2, real acceleration2) const
    {
        return removesWild
            && !(absolute(deviation) <= maxDeviation && speed2 <= maxSpeed2
                && acceleration2 <= maxAcceleration2);
    }

    template<class Box>
    HD bool inside(const Box& box, const Vec<D, std::int64_t>& x) const
    {
        bool in = true;
        for (int d = 0; d < D; ++d)
        {
            const double r = box.relative(d, x.c[d]);
            in = in && (box.periodic[d] || (r >= domainMin[d] && r <= domainMax[d]));
        }
        return in;
    }
};

//- Fills the pair record of a particle from its velocity and density deviation
template<int D, class P>
HD PairParticle<D, typename P::real> pairParticle
(const FluidModel<D, P>& m, const Vec<D, typename P::real>& v, typename P::real deviation)
{
    using real = typename P::real;
    PairParticle<D, real> p;
    p.velocity = v;
    p.density = m.rho0*(real(1) + deviation);
    p.pressureTerm = m.eos.pressure(deviation)/(p.density*p.density);
    p.h = m.smoothingLength(deviation);
    return p;
}

} // namespace riprap

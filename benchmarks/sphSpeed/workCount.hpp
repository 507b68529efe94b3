/*  Operations and bytes that one particle-step takes at the least, counted by hand from the
    sources.

    Operations: every addition, multiplication, comparison, conversion, division and square root
    counts one, on real pairs only (those within the support): lanes that a pack or a skin wastes
    are not useful work. Bytes: every array that a kernel reads or writes passes memory once;
    neighbours' records come from caches. Work on wall points is not counted.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cmath>
#include "speedOptions.hpp"

namespace riprap
{

//- Passes over the pairs a step. The two of a symplectic step are half passes: one of the momentum,
//  one of the density terms
inline int passesPerStep(const std::string& integrator)
{
    return integrator == "symplectic" ? 2 : 1;
}

//- Operations on one pair in all passes of a step (src/sph/passes/fluidPass.hpp, terms/,
//  sph/kernels/wendlandC2.hpp)
inline double operationsPerPair(const SpeedOptions& o)
{
    const int D = o.dimensions;
    // what every pass does
    const double separation = 3*D, r2 = 2*D - 1, dv = D, approach = 2*D - 1, root = 1, q = 1;
    const double gradient = 3 + 2 + 1 + 1;  // 1 - q/2 and its clip, cube, -5, factor
    const double massFactor = 1;
    const double geometry = separation + r2 + dv + root + q + gradient + massFactor;
    const double kernel = 2 + 2 + 1 + 1;    // fourth power, 2q + 1, product, factor
    // terms, and the sums they go to
    const double pressure = 2, laminar = 6, artificial = 8, continuity = 3,
                 momentumSums = 2 + 4*D, densitySums = 2;
    const double antiClump = 1 + 1 + 2 + 2 + 1;     // W/W(dp), sum, fourth power, factors, channel
    const double xsph = 3 + 2 + 2*D;
    const double diffusion = 1 + 2*D + 4;
    const double viscosity = o.terms == TermSet::delta ? artificial : laminar;
    double momentum = pressure + viscosity + momentumSums,
           density = approach + continuity + densitySums;
    bool needsW = false;
    if (o.terms == TermSet::paper) { momentum += antiClump; density += xsph; needsW = true; }
    if (o.terms == TermSet::delta) density += diffusion;
    const double w = needsW ? kernel : 0;
    if (o.integrator == "leapfrog") return geometry + w + momentum + density;
    return 2*(geometry + w) + momentum + density;
}

//- Operations on a particle outside pairs: kick, drift, equation of state, record, check of the
//  skin, finish
inline double operationsPerParticle(const SpeedOptions& o) { return 60 + 20*o.dimensions; }

//- Bytes of a particle-step. listed: neighbours in the list, 0 where there is none; interval: steps
//  between rebuilds
inline double bytesPerParticleStep(const SpeedOptions& o, double listed, double interval)
{
    const int D = o.dimensions;
    const double r = o.precision == PrecisionKind::mixed ? 4 : 8;
    const double vector = D*r, position = 8*D, records = (2*D + 2)*r;
    const double drift = o.terms == TermSet::paper ? vector : 0;
    const double list = 4*listed + (listed > 0 ? 4 : 0);
    const double state = position + 2*vector + 2*r + drift + 4;

    double step = 0;
    if (o.integrator == "leapfrog")
    {
        // drift: reads x, v, a, deviation, rate, drift, reference; writes x, v, deviation, records
        step += 2*position + 4*vector + 3*r + drift + records;
        // pass: reads records, list, v, deviation; writes v, a, deviation, rate, drift
        step += records + list + 3*vector + 3*r + drift;
    }
    else
    {
        step += 2*position + 3*vector + r + drift + records;            // kick
        step += records + list + vector + 3*r + drift;                  // density pass
        step += 2*position + 3*vector + r + drift + records;            // drift
        step += records + list + 3*vector + r;                          // momentum pass
    }
    // keys, four passes of a radix sort, state permuted, records placed, lists written
    const double rebuild = position + 8 + 4*16 + 2*state + 4 + position + 2*vector + r
        + records + records/2 + list;
    return step + rebuild/interval;
}

} // namespace riprap

/*  What this machine can do, measured: the limits that benchmarks put beside what riprap reaches.

        triad    a[i] = b[i] + s c[i], doubles, arrays far larger than caches: 24 bytes an element
                 (McCalpin's STREAM)
        fma      independent multiply-adds in registers: two operations each
        gather   what the pair loop on the GPU loads of a neighbour and nothing else: four bytes of
                 list and two records of 16 bytes, neighbours of a perfectly sorted cubic lattice.
                 The pair loop cannot be faster than its loads.

    Best of several runs, in the first GPU or all OpenMP threads. Zero where there is no such
    device.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/backend.hpp"

namespace riprap
{

//- Bytes a second
double triadBandwidth(Cpu);
double triadBandwidth(Gpu);

//- Operations a second in Real (float or double)
template<class Real> double fmaPeak(Cpu);
template<class Real> double fmaPeak(Gpu);

//- Neighbours a second
double gatherRate(Gpu);

} // namespace riprap

/*  What kernels say about themselves besides word, text, alpha, value and slope: defaults of their
    cards.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/simd/math.hpp"

namespace riprap
{

struct KernelCard
{
    static constexpr double support = 2;        // W is zero from here on, in smoothing lengths
    static constexpr bool frequent = false;     // passes with FrequentTerms alone are compiled
};

} // namespace riprap

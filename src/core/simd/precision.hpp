/*  Precision is a type: what pairs are computed in, and how positions enter them.

    The position of a particle is a 64-bit fixed-point number an axis (2^64 units span the box),
    integrated in integers: translation-invariant, and periodic without a branch because differences
    wrap. Pairs see
      Mixed : its upper 32 bits and float arithmetic (box/2^32 resolution: 2e-9 m in a box of 10 m)
      Double: double positions in the box and double arithmetic, wrapped by rounding.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstdint>
#include "core/simd/math.hpp"
#include "core/simd/vec.hpp"

namespace riprap
{

struct Mixed
{
    using real = float;
    using position = std::int32_t;
    static constexpr const char* name = "mixed";
};

struct Double
{
    using real = double;
    using position = double;
    static constexpr const char* name = "double";
};

//- The box in which fixed-point positions live; axis d spans lower[d] .. lower[d] + length[d]
template<int D, class P>
struct Box
{
    using real = typename P::real;

    double lower[D];
    double length[D];
    double unit[D];             // metres a 64-bit unit
    double unitsPerMetre[D];
    real scale[D];              // Mixed: metres a 32-bit unit
    real period[D];             // Double: length where periodic, else 0
    real inversePeriod[D];      // Double: 1/length where periodic, else 0
    bool periodic[D];

    void set(int d, double lo, double extent, bool isPeriodic)
    {
        lower[d] = lo;
        length[d] = extent;
        unit[d] = extent/18446744073709551616.0;
        unitsPerMetre[d] = 18446744073709551616.0/extent;
        scale[d] = real(extent/4294967296.0);
        period[d] = isPeriodic ? real(extent) : real(0);
        inversePeriod[d] = isPeriodic ? real(1.0/extent) : real(0);
        periodic[d] = isPeriodic;
    }

    //- Metres to fixed point. Outside a non-periodic box: undefined, check before.
    HD std::int64_t toFixed(int d, double x) const
    {
        double f = (x - lower[d])/length[d];
        f -= floor(f);
        const std::uint64_t u = f >= 1.0 ? 0 : std::uint64_t(f*18446744073709551616.0);
        return std::int64_t(u ^ 0x8000000000000000ull);
    }

    //- The same for positions that may lie beyond: they are taken to the edge of a box that is not
    //  periodic
    HD std::int64_t toFixedInside(int d, double x) const
    {
        if (periodic[d]) return toFixed(d, x);
        const double top = lower[d] + length[d]*(1 - 1e-9);
        return toFixed(d, maximum(minimum(x, top), lower[d]));
    }

    //- Fixed point to metres above the box's lower corner
    HD double relative(int d, std::int64_t x) const
    {
        return double(std::uint64_t(x) ^ 0x8000000000000000ull)*unit[d];
    }

    HD double toMetres(int d, std::int64_t x) const { return lower[d] + relative(d, x); }

    //- What pairs see of a position
    HD typename P::position pairPosition(int d, std::int64_t x) const
    {
        if constexpr (sizeof(real) == 4) return std::int32_t(x >> 32);
        else return relative(d, x);
    }

    //- Metres above the box's lower corner, from what pairs see
    HD real pairRelative(int d, typename P::position x) const
    {
        if constexpr (sizeof(real) == 4) return (real(x) + real(2147483648.0))*scale[d];
        else return x;
    }

    //- x_i - x_j of axis d in metres, nearest image; T and X are scalars or packs
    template<class T, class X>
    HD T separation(int d, const X& a, const X& b) const
    {
        if constexpr (sizeof(real) == 4) return wrappedDifference(a, b)*T(scale[d]);
        else return wrapped<T>(a - b, d);
    }

private:

    template<class T>
    HD T wrapped(T difference, int d) const
    {
        if (periodic[d])        // uniform over all particles
        {
            const T half(real(0.5)*period[d]);
            const T p(period[d]);
            difference = selectGreater(difference, half, difference - p, difference);
            difference = selectGreater(-half, difference, difference + p, difference);
        }
        return difference;
    }
};

} // namespace riprap

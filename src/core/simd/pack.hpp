/*  Pack<R>: one vector register of R, so that the branch-free physics functors run eight (float) or
    four (double) pairs at a time on the CPU. GCC vector extensions; never seen by nvcc.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include "core/simd/macros.hpp"

namespace riprap
{

template<class R> struct PackTypes;

template<> struct PackTypes<float>
{
    static constexpr int width = 8;
    typedef float vec __attribute__((vector_size(32)));
    typedef std::int32_t mask __attribute__((vector_size(32)));
    typedef float loose __attribute__((vector_size(32), aligned(4), may_alias));
};

template<> struct PackTypes<double>
{
    static constexpr int width = 4;
    typedef double vec __attribute__((vector_size(32)));
    typedef std::int64_t mask __attribute__((vector_size(32)));
    typedef double loose __attribute__((vector_size(32), aligned(8), may_alias));
};

//- Integer pack of fixed-point positions: differences wrap
struct PackInt32
{
    static constexpr int width = 8;
    typedef std::int32_t vec __attribute__((vector_size(32)));
    typedef std::int32_t loose __attribute__((vector_size(32), aligned(4), may_alias));
    typedef std::uint32_t bits __attribute__((vector_size(32)));
    vec v;

    PackInt32() = default;
    HD explicit PackInt32(std::int32_t s) : v(vec{} + s) {}
    HD static PackInt32 load(const std::int32_t* p)
    {
        PackInt32 r;
        r.v = *reinterpret_cast<const loose*>(p);
        return r;
    }
};

template<class R>
struct Pack
{
    using Types = PackTypes<R>;
    using vec = typename Types::vec;
    using mask = typename Types::mask;
    static constexpr int width = Types::width;
    vec v;

    Pack() = default;
    HD Pack(R s) : v(vec{} + s) {}
    HD Pack(vec w) : v(w) {}
    HD static Pack load(const R* p)
    {
        return Pack(vec(*reinterpret_cast<const typename Types::loose*>(p)));
    }
};

template<class R> HD Pack<R> operator+(Pack<R> a, Pack<R> b) { return Pack<R>(a.v + b.v); }
template<class R> HD Pack<R> operator-(Pack<R> a, Pack<R> b) { return Pack<R>(a.v - b.v); }
template<class R> HD Pack<R> operator*(Pack<R> a, Pack<R> b) { return Pack<R>(a.v*b.v); }
template<class R> HD Pack<R> operator/(Pack<R> a, Pack<R> b) { return Pack<R>(a.v/b.v); }
template<class R> HD Pack<R> operator-(Pack<R> a) { return Pack<R>(-a.v); }
template<class R> HD Pack<R>& operator+=(Pack<R>& a, Pack<R> b) { a.v += b.v; return a; }
template<class R> HD Pack<R>& operator-=(Pack<R>& a, Pack<R> b) { a.v -= b.v; return a; }
template<class R> HD Pack<R>& operator*=(Pack<R>& a, Pack<R> b) { a.v *= b.v; return a; }

template<class R> HD Pack<R> maximum(Pack<R> a, Pack<R> b)
{
    return Pack<R>(a.v > b.v ? a.v : b.v);
}
template<class R> HD Pack<R> minimum(Pack<R> a, Pack<R> b)
{
    return Pack<R>(a.v < b.v ? a.v : b.v);
}
template<class R> HD Pack<R> absolute(Pack<R> a) { return maximum(a, -a); }

template<class R>
HD Pack<R> squareRoot(Pack<R> a)
{
    Pack<R> r;
    for (int l = 0; l < Pack<R>::width; ++l) r.v[l] = std::sqrt(a.v[l]);
    return r;
}

template<class R> HD Pack<R> inverse(Pack<R> a) { return Pack<R>(R(1))/a; }
template<class R> HD Pack<R> inverseRoot(Pack<R> a) { return inverse(squareRoot(a)); }
template<class R> HD Pack<R> rootOfRatio(Pack<R> a, Pack<R> b) { return squareRoot(a/b); }

//- a > b ? x : y, lane by lane
template<class R> HD Pack<R> selectGreater(Pack<R> a, Pack<R> b, Pack<R> x, Pack<R> y)
{
    return Pack<R>(a.v > b.v ? x.v : y.v);
}

//- Four or eight 32-bit integers, as they lie in memory
template<int lanes>
struct IntegerPack
{
    typedef std::int32_t vec __attribute__((vector_size(lanes*4)));
    typedef std::int32_t loose __attribute__((vector_size(lanes*4), aligned(4), may_alias));
    HD static vec load(const void* p) { return *reinterpret_cast<const loose*>(p); }
};

//- Bit l: the sign of lane l, of a register of 32-bit or 64-bit lanes
template<class V>
HD unsigned signBits(const V& v)
{
#ifdef __AVX__
    typedef float eight __attribute__((vector_size(32)));
    typedef float four __attribute__((vector_size(16)));
    typedef double wide __attribute__((vector_size(32)));
    if constexpr (sizeof(V) == 16) return unsigned(__builtin_ia32_movmskps(four(v)));
    else if constexpr (sizeof(v[0]) == 4) return unsigned(__builtin_ia32_movmskps256(eight(v)));
    else return unsigned(__builtin_ia32_movmskpd256(wide(v)));
#else
    unsigned bits = 0;
    for (unsigned l = 0; l < sizeof(V)/sizeof(v[0]); ++l) bits |= unsigned(v[l] < 0) << l;
    return bits;
#endif
}

//- Bit l: a > b in lane l
template<class R>
HD unsigned greaterBits(Pack<R> a, Pack<R> b)
{
    const typename Pack<R>::mask m = a.v > b.v;
    return signBits(m);
}

//- Lanes 0 .. count-1 keep a, the others become b
template<class R>
HD Pack<R> keepFirst(Pack<R> a, int count, R b)
{
    using mask = typename Pack<R>::mask;
    mask lane;
    for (int l = 0; l < Pack<R>::width; ++l) lane[l] = l;
    return Pack<R>(lane < (mask{} + count) ? a.v : (typename Pack<R>::vec{} + b));
}

//- Sum over lanes, in a fixed order
template<class R>
HD R sumLanes(Pack<R> a)
{
    R r = 0;
    for (int l = 0; l < Pack<R>::width; ++l) r += a.v[l];
    return r;
}

//- Four registers as a matrix, transposed: rows of four numbers, one a lane, become one register a
//  number, and back.
//  Eight lanes: lane l stands in the lower half of v[l % 4], or for l >= 4 in its upper half.
HD void transposeRows(Pack<float>* v)
{
    using vec = Pack<float>::vec;
    const vec t0 = __builtin_shufflevector(v[0].v, v[1].v, 0, 8, 1, 9, 4, 12, 5, 13);
    const vec t1 = __builtin_shufflevector(v[0].v, v[1].v, 2, 10, 3, 11, 6, 14, 7, 15);
    const vec t2 = __builtin_shufflevector(v[2].v, v[3].v, 0, 8, 1, 9, 4, 12, 5, 13);
    const vec t3 = __builtin_shufflevector(v[2].v, v[3].v, 2, 10, 3, 11, 6, 14, 7, 15);
    v[0].v = __builtin_shufflevector(t0, t2, 0, 1, 8, 9, 4, 5, 12, 13);
    v[1].v = __builtin_shufflevector(t0, t2, 2, 3, 10, 11, 6, 7, 14, 15);
    v[2].v = __builtin_shufflevector(t1, t3, 0, 1, 8, 9, 4, 5, 12, 13);
    v[3].v = __builtin_shufflevector(t1, t3, 2, 3, 10, 11, 6, 7, 14, 15);
}

HD void transposeRows(Pack<double>* v)
{
    using vec = Pack<double>::vec;
    const vec t0 = __builtin_shufflevector(v[0].v, v[1].v, 0, 4, 2, 6),
              t1 = __builtin_shufflevector(v[0].v, v[1].v, 1, 5, 3, 7);
    const vec t2 = __builtin_shufflevector(v[2].v, v[3].v, 0, 4, 2, 6),
              t3 = __builtin_shufflevector(v[2].v, v[3].v, 1, 5, 3, 7);
    v[0].v = __builtin_shufflevector(t0, t2, 0, 1, 4, 5);
    v[1].v = __builtin_shufflevector(t1, t3, 0, 1, 4, 5);
    v[2].v = __builtin_shufflevector(t0, t2, 2, 3, 6, 7);
    v[3].v = __builtin_shufflevector(t1, t3, 2, 3, 6, 7);
}

//- Four numbers as one lane's row
template<class R> struct Row;
template<> struct Row<float>
{
    typedef float vec __attribute__((vector_size(16)));
    typedef float loose __attribute__((vector_size(16), aligned(4), may_alias));
};
template<> struct Row<double>
{
    typedef double vec __attribute__((vector_size(32)));
    typedef double loose __attribute__((vector_size(32), aligned(8), may_alias));
};

//- The rows that row(l) points at, one register a number
template<class F>
HD void loadRows(const F& row, Pack<float>* v)
{
    using vec = Row<float>::vec;
    for (int l = 0; l < 4; ++l)
    {
        const vec low = *reinterpret_cast<const Row<float>::loose*>(row(l)),
                  high = *reinterpret_cast<const Row<float>::loose*>(row(l + 4));
        v[l].v = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
    }
    transposeRows(v);
}

template<class F>
HD void loadRows(const F& row, Pack<double>* v)
{
    for (int l = 0; l < 4; ++l) v[l].v = *reinterpret_cast<const Row<double>::loose*>(row(l));
    transposeRows(v);
}

//- Registers of four numbers as rows: lane l's is row[l]
HD void storeRows(const Pack<float>* v, Row<float>::vec* row)
{
    Pack<float> r[4] = {v[0], v[1], v[2], v[3]};
    transposeRows(r);
    for (int l = 0; l < 4; ++l)
    {
        row[l] = __builtin_shufflevector(r[l].v, r[l].v, 0, 1, 2, 3);
        row[l + 4] = __builtin_shufflevector(r[l].v, r[l].v, 4, 5, 6, 7);
    }
}

HD void storeRows(const Pack<double>* v, Row<double>::vec* row)
{
    Pack<double> r[4] = {v[0], v[1], v[2], v[3]};
    transposeRows(r);
    for (int l = 0; l < 4; ++l) row[l] = r[l].v;
}

//- Fixed-point difference a - b (wrapping) as a number of units
HD Pack<float> wrappedDifference(PackInt32 a, PackInt32 b)
{
    using bits = PackInt32::bits;
    const PackInt32::vec d = PackInt32::vec(bits(a.v) - bits(b.v));
    return Pack<float>(__builtin_convertvector(d, Pack<float>::vec));
}

} // namespace riprap

/*  Pack<R>: one vector register of R, so that the branch-free physics functors run eight (float) or four
    (double) pairs at a time on the CPU. GCC vector extensions; never seen by nvcc.
*/
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include "core/macros.hpp"

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
    HD static Pack load(const R* p) { return Pack(vec(*reinterpret_cast<const typename Types::loose*>(p))); }
};

template<class R> HD Pack<R> operator+(Pack<R> a, Pack<R> b) { return Pack<R>(a.v + b.v); }
template<class R> HD Pack<R> operator-(Pack<R> a, Pack<R> b) { return Pack<R>(a.v - b.v); }
template<class R> HD Pack<R> operator*(Pack<R> a, Pack<R> b) { return Pack<R>(a.v*b.v); }
template<class R> HD Pack<R> operator/(Pack<R> a, Pack<R> b) { return Pack<R>(a.v/b.v); }
template<class R> HD Pack<R> operator-(Pack<R> a) { return Pack<R>(-a.v); }
template<class R> HD Pack<R>& operator+=(Pack<R>& a, Pack<R> b) { a.v += b.v; return a; }
template<class R> HD Pack<R>& operator-=(Pack<R>& a, Pack<R> b) { a.v -= b.v; return a; }
template<class R> HD Pack<R>& operator*=(Pack<R>& a, Pack<R> b) { a.v *= b.v; return a; }

template<class R> HD Pack<R> maximum(Pack<R> a, Pack<R> b) { return Pack<R>(a.v > b.v ? a.v : b.v); }
template<class R> HD Pack<R> minimum(Pack<R> a, Pack<R> b) { return Pack<R>(a.v < b.v ? a.v : b.v); }
template<class R> HD Pack<R> absolute(Pack<R> a) { return maximum(a, -a); }

template<class R>
HD Pack<R> squareRoot(Pack<R> a)
{
    Pack<R> r;
    for (int l = 0; l < Pack<R>::width; ++l) r.v[l] = std::sqrt(a.v[l]);
    return r;
}

//- a > b ? x : y, lane by lane
template<class R>
HD Pack<R> selectGreater(Pack<R> a, Pack<R> b, Pack<R> x, Pack<R> y) { return Pack<R>(a.v > b.v ? x.v : y.v); }

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

//- Fixed-point difference a - b (wrapping) as a number of units
HD Pack<float> wrappedDifference(PackInt32 a, PackInt32 b)
{
    using bits = PackInt32::bits;
    const PackInt32::vec d = PackInt32::vec(bits(a.v) - bits(b.v));
    return Pack<float>(__builtin_convertvector(d, Pack<float>::vec));
}

} // namespace riprap

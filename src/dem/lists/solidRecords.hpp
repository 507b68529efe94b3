/*  What contacts read of a particle: aligned records of four words, so that a neighbour costs two
    or three loads.

        3D  A: position, radius     B: velocity, mass       C: spin, material
        2D  A: position, radius, mass                       B: velocity, spin, material

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/backend.hpp"
#include "core/simd/precision.hpp"
#include "dem/contact/contact.hpp"

namespace riprap
{

template<int D, class P> struct SolidA;
template<class P> struct alignas(4*sizeof(typename P::real)) SolidA<3, P>
{ typename P::position x[3]; typename P::real radius; };
template<class P> struct alignas(4*sizeof(typename P::real)) SolidA<2, P>
{ typename P::position x[2]; typename P::real radius, mass; };

template<class P>
struct alignas(4*sizeof(typename P::real)) SolidWords { typename P::real c[4]; };

template<int D, class P>
struct SolidRecords
{
    using real = typename P::real;

    SolidA<D, P>* a;
    SolidWords<P>* b;
    SolidWords<P>* c;           // 3D only

    HD Vec<D, typename P::position> position(int i) const
    {
        Vec<D, typename P::position> x;
        for (int d = 0; d < D; ++d) x.c[d] = a[i].x[d];
        return x;
    }

    HD real radius(int i) const { return a[i].radius; }

    //- All but the position
    HD ContactBody<D, real> body(int i, int& material) const
    {
        const SolidA<D, P> first = a[i];
        return bodyOf(first, words(i), material);
    }

    //- The records behind the first
    struct Words { SolidWords<P> b, c; };
    HD Words words(int i) const
    {
        Words w;
        w.b = b[i];
        if constexpr (D == 3) w.c = c[i];
        return w;
    }

    HD static ContactBody<D, real> bodyOf(
        const SolidA<D, P>& first, const Words& words, int& material)
    {
        ContactBody<D, real> q;
        const SolidWords<P>& w = words.b;
        q.radius = first.radius;
        if constexpr (D == 2)
        {
            q.velocity = Vec<2, real>{{w.c[0], w.c[1]}};
            q.spin.c[0] = w.c[2];
            q.mass = first.mass;
            material = int(w.c[3]);
        }
        else
        {
            const SolidWords<P>& s = words.c;
            q.velocity = Vec<3, real>{{w.c[0], w.c[1], w.c[2]}};
            q.spin = Vec<3, real>{{s.c[0], s.c[1], s.c[2]}};
            q.mass = w.c[3];
            material = int(s.c[3]);
        }
        return q;
    }

    HD void store(int i, const Vec<D, typename P::position>& x, const ContactBody<D, real>& q,
        int material) const
    {
        SolidA<D, P> first;
        for (int d = 0; d < D; ++d) first.x[d] = x.c[d];
        first.radius = q.radius;
        if constexpr (D == 2)
        {
            first.mass = q.mass;
            b[i] = SolidWords<P>{{q.velocity.c[0], q.velocity.c[1], q.spin.c[0], real(material)}};
        }
        else
        {
            b[i] = SolidWords<P>{{q.velocity.c[0], q.velocity.c[1], q.velocity.c[2], q.mass}};
            c[i] = SolidWords<P>{{q.spin.c[0], q.spin.c[1], q.spin.c[2], real(material)}};
        }
        a[i] = first;
    }
};

//- Their memory
template<class Backend, int D, class P>
class SolidRecordMemory
{
public:
    void allocate(Context<Backend>& context, std::size_t n)
    {
        a_.allocate(context, n + 1);
        b_.allocate(context, n + 1);
        if (D == 3) c_.allocate(context, n + 1);
    }
    SolidRecords<D, P> view() { return SolidRecords<D, P>{a_.data(), b_.data(), c_.data()}; }
    std::size_t bytes() const { return a_.bytes() + b_.bytes() + c_.bytes(); }
    void swap(SolidRecordMemory& o)
    {
        a_.swap(o.a_);
        b_.swap(o.b_);
        c_.swap(o.c_);
    }

private:
    Array<Backend, SolidA<D, P>> a_;
    Array<Backend, SolidWords<P>> b_, c_;
};

} // namespace riprap

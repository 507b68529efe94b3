/*  Pair records: what the pair loop reads of a particle, laid out for the machine.

    Cpu: one array a component, so that a pack of neighbours is one load.
    Gpu: two aligned records A (position, p/rho^2[, rho]) and B (velocity[, rho]), so that a
    neighbour costs two gathers. The smoothing length is a third array that exists only where it
    varies.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/backend.hpp"
#include "core/simd/precision.hpp"

namespace riprap
{

//- A particle as pair functors see it. T: real or Pack<real>
template<int D, class T>
struct PairParticle
{
    Vec<D, T> velocity;
    T pressureTerm;             // p/rho^2
    T density;
    T h;
};

template<class Backend, int D, class P> struct RecordsView;

#ifndef __CUDACC__

template<class P> struct PositionPack;
template<> struct PositionPack<Mixed> { using type = PackInt32; };
template<> struct PositionPack<Double> { using type = Pack<double>; };

template<int D, class P>
struct RecordsView<Cpu, D, P>
{
    using real = typename P::real;
    using position = typename P::position;

    position* x[D];
    real* velocity[D];
    real* pressureTerm;
    real* density;
    real* h;                    // null where h is constant

    Vec<D, position> loadPosition(int i) const
    {
        Vec<D, position> r;
        for (int d = 0; d < D; ++d) r.c[d] = x[d][i];
        return r;
    }

    void storePosition(int i, const Vec<D, position>& v) const
    {
        for (int d = 0; d < D; ++d) x[d][i] = v.c[d];
    }

    template<bool VariableH>
    PairParticle<D, real> load(int i) const
    {
        PairParticle<D, real> r;
        for (int d = 0; d < D; ++d) r.velocity.c[d] = velocity[d][i];
        r.pressureTerm = pressureTerm[i];
        r.density = density[i];
        if constexpr (VariableH) r.h = h[i]; else r.h = 0;
        return r;
    }

    template<bool VariableH>
    void loadPack(
        int j, Vec<D, typename PositionPack<P>::type>& xj, PairParticle<D, Pack<real>>& r) const
    {
        for (int d = 0; d < D; ++d)
        {
            xj.c[d] = PositionPack<P>::type::load(x[d] + j);
            r.velocity.c[d] = Pack<real>::load(velocity[d] + j);
        }
        r.pressureTerm = Pack<real>::load(pressureTerm + j);
        r.density = Pack<real>::load(density + j);
        if constexpr (VariableH) r.h = Pack<real>::load(h + j); else r.h = Pack<real>(real(0));
    }

    void store(int i, const PairParticle<D, real>& p) const
    {
        for (int d = 0; d < D; ++d) velocity[d][i] = p.velocity.c[d];
        pressureTerm[i] = p.pressureTerm;
        density[i] = p.density;
        if (h) h[i] = p.h;
    }
};

#else

template<int D, class P> struct RecordA;
template<int D, class P> struct RecordB;
template<class P> struct alignas(4*sizeof(typename P::real)) RecordA<2, P>
{ typename P::position x[2]; typename P::real pressureTerm, density; };
template<class P> struct alignas(2*sizeof(typename P::real)) RecordB<2, P>
{ typename P::real velocity[2]; };
template<class P> struct alignas(4*sizeof(typename P::real)) RecordA<3, P>
{ typename P::position x[3]; typename P::real pressureTerm; };
template<class P> struct alignas(4*sizeof(typename P::real)) RecordB<3, P>
{ typename P::real velocity[3], density; };

template<int D, class P>
struct RecordsView<Gpu, D, P>
{
    using real = typename P::real;
    using position = typename P::position;

    RecordA<D, P>* a;
    RecordB<D, P>* b;
    real* h;

    HD Vec<D, position> loadPosition(int i) const
    {
        const RecordA<D, P> ra = a[i];
        Vec<D, position> r;
        for (int d = 0; d < D; ++d) r.c[d] = ra.x[d];
        return r;
    }

    HD void storePosition(int i, const Vec<D, position>& v) const
    {
        for (int d = 0; d < D; ++d) a[i].x[d] = v.c[d];
    }

    template<bool VariableH>
    HD void loadAll(int i, Vec<D, position>& xi, PairParticle<D, real>& r) const
    {
        const RecordA<D, P> ra = a[i];
        const RecordB<D, P> rb = b[i];
        for (int d = 0; d < D; ++d) { xi.c[d] = ra.x[d]; r.velocity.c[d] = rb.velocity[d]; }
        r.pressureTerm = ra.pressureTerm;
        if constexpr (D == 2) r.density = ra.density; else r.density = rb.density;
        if constexpr (VariableH) r.h = h[i]; else r.h = 0;
    }

    template<bool VariableH>
    HD PairParticle<D, real> load(int i) const
    {
        Vec<D, position> x;
        PairParticle<D, real> r;
        loadAll<VariableH>(i, x, r);
        return r;
    }

    HD void store(int i, const PairParticle<D, real>& p) const
    {
        for (int d = 0; d < D; ++d) b[i].velocity[d] = p.velocity.c[d];
        a[i].pressureTerm = p.pressureTerm;
        if constexpr (D == 2) a[i].density = p.density; else b[i].density = p.density;
        if (h) h[i] = p.h;
    }
};

#endif

//- Owns the memory of records of n particles
template<class Backend, int D, class P>
class Records
{
public:
    using real = typename P::real;
    using position = typename P::position;

    void allocate(Context<Backend>& context, std::size_t n, bool withH)
    {
        // padded: packs may read up to one register past the end
        const std::size_t padded = n + 16;
        stride_ = padded;
        memory_.allocate(context, padded*(2*D + 2));
        if (withH) h_.allocate(context, padded);
        // lanes that a pack reads past the end are discarded, but must be finite: no density or h
        // of zero
        const std::vector<real> ones(padded, real(1));
        if constexpr (!Backend::gpu)
            context.toDevice(
                memory_.data() + stride_*(2*D + 1), ones.data(), padded*sizeof(real));
        if (withH) context.toDevice(h_.data(), ones.data(), padded*sizeof(real));
    }

    RecordsView<Backend, D, P> view()
    {
        RecordsView<Backend, D, P> v;
        view(v);
        return v;
    }

    std::size_t bytesPerParticle() const
    {
        return (2*D + 2)*sizeof(real) + (h_.size() ? sizeof(real) : 0);
    }
    std::size_t bytes() const { return memory_.bytes() + h_.bytes(); }

private:

    static_assert(sizeof(real) == sizeof(position), "records are laid out in words of one size");

#ifndef __CUDACC__
    void view(RecordsView<Cpu, D, P>& v)
    {
        real* p = memory_.data();
        for (int d = 0; d < D; ++d) v.x[d] = reinterpret_cast<position*>(p + stride_*d);
        for (int d = 0; d < D; ++d) v.velocity[d] = p + stride_*(D + d);
        v.pressureTerm = p + stride_*2*D;
        v.density = p + stride_*(2*D + 1);
        v.h = h_.data();
    }
#else
    void view(RecordsView<Gpu, D, P>& v)
    {
        v.a = reinterpret_cast<RecordA<D, P>*>(memory_.data());
        v.b = reinterpret_cast<RecordB<D, P>*>(memory_.data() + stride_*4);
        v.h = h_.data();
    }
#endif

    Array<Backend, real> memory_;
    Array<Backend, real> h_;
    std::size_t stride_ = 0;
};

} // namespace riprap

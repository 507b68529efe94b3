/*  Kernel interpolation of the fluid at points: sum V W, sum V p W, sum V v W (paper Eq. 27), sum V
    (x_j - x) W. The caller divides by the first where it wants a value that does not fade at the
    surface (Shepard); the last gives the centroid that such a value belongs to. Fluid behind a
    point's planes (SightPlanes) is left out.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/neighbours/pairLoop.hpp"
#include "sph/passes/fluidPass.hpp"

namespace riprap
{

//- A point, and which planes are its own
template<int Dim, class T>
struct SamplePoint
{
    PairParticle<Dim, T> particle;
    int firstPlane, endPlane;
};

template<class Backend, int Dim, class P, class Kernel, bool VariableH>
struct SamplePass
{
    using precision = P;
    using real = typename P::real;
    template<class T> using Self = SamplePoint<Dim, T>;

    static constexpr const char* name = "sample";
    static constexpr int dimensions = Dim, sources = 1, channels = 2 + 2*Dim;
    static constexpr bool variableH = VariableH, hasMaxima = false;

    Box<Dim, P> box;
    CellGrid<Dim, P> grid;
    Source<Backend, Dim, P> source[1];
    KernelConstants<Dim, real> kernel;
    FluidModel<Dim, P> model;
    const typename P::position* points;     // Dim a point
    const std::int32_t* firstPlane;         // count + 1, or null
    const real* planes;                     // Dim + 1 a plane: normal, depth
    real* result;                           // channels a point
    int count;

    HD bool enabled() const { return true; }
    HD int targets() const { return count; }
    HD float* maxima() const { return nullptr; }

    HD Vec<Dim, typename P::position> position(int i) const
    {
        Vec<Dim, typename P::position> x;
        for (int d = 0; d < Dim; ++d) x.c[d] = points[Dim*i + d];
        return x;
    }

    template<class T>
    HD Self<T> self(int i) const
    {
        return Self<T>{{filled<Dim>(T(real(0))), T(real(0)), T(real(1)), T(model.h0)},
            firstPlane ? firstPlane[i] : 0, firstPlane ? firstPlane[i + 1] : 0};
    }

    //- value, or 0 where x_j = x_i - dx is behind a plane
    template<class T>
    HD T seen(const Self<T>& i, const Vec<Dim, T>& dx, T value) const
    {
        for (int k = i.firstPlane; k < i.endPlane; ++k)
        {
            const real* plane = planes + (Dim + 1)*k;
            T height = T(plane[Dim]);
            for (int d = 0; d < Dim; ++d) height -= T(plane[d])*dx.c[d];
            value = selectGreater(T(real(0)), height, T(real(0)), value);
        }
        return value;
    }

    template<int S, class T>
    HD void pair(const Self<T>& i, const PairParticle<Dim, T>& j, const Vec<Dim, T>& dx, T r2, int,
        T* sums) const
    {
        const PairGeometry<Dim, T> g = pairGeometry<Kernel, VariableH, true>(
            kernel, model.h0, i.particle, j, dx, r2);
        const T vw = seen(i, dx, T(model.mass)*g.w/j.density);
        sums[0] += vw;
        sums[1] += j.pressureTerm*j.density*j.density*vw;
        for (int d = 0; d < Dim; ++d)
        {
            sums[2 + d] += j.velocity.c[d]*vw;
            sums[2 + Dim + d] -= dx.c[d]*vw;
        }
    }

    HD void finish(int i, const real* sums, float*) const
    {
        for (int k = 0; k < channels; ++k) result[channels*i + k] = sums[k];
    }
};

} // namespace riprap

/*  The kernels of everything that is read back: see solvers/sph/driver/sphReadings.hpp.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/neighbours/pairLoop.hpp"
#include "sph/time/leapfrog.hpp"

namespace riprap
{

//- Makes records those of the state at hand (steps leave predicted ones)
template<class Backend, int D, class P>
struct RefreshRecords : Mover<Backend, D, P>
{
    using real = typename P::real;
    static constexpr const char* name = "refreshRecords";

    HD void operator()(int i) const
    {
        if (i >= *this->count || this->ghosts(i)) return;
        Vec<D, real> v;
        for (int d = 0; d < D; ++d) v.c[d] = this->fluid.v[d][i];
        this->record(i, this->position(i), v, this->fluid.deviation[i]);
    }
};

//- Kinetic, potential and elastic energy [J]
template<int D, class P>
struct EnergySums
{
    static constexpr const char* name = "energy";
    Box<D, P> box;
    FluidModel<D, P> model;
    FluidFields<D, P> fluid;

    HD void add(int i, double* sums) const
    {
        double v2 = 0, height = 0;
        for (int d = 0; d < D; ++d)
        {
            v2 += double(fluid.v[d][i])*fluid.v[d][i];
            height -= double(model.gravity.c[d])*box.toMetres(d, fluid.x[d][i]);
        }
        sums[0] += 0.5*model.mass*v2;
        sums[1] += model.mass*height;
        sums[2] += model.mass*model.eos.elasticEnergy(fluid.deviation[i]);
    }
};

template<int D, class P>
struct FluidSpeed2
{
    static constexpr const char* name = "fluidSpeed";
    FluidFields<D, P> fluid;

    HD double value(int i) const
    {
        double v2 = 0;
        for (int d = 0; d < D; ++d) v2 += double(fluid.v[d][i])*fluid.v[d][i];
        return v2;
    }
};

template<int D, class P>
struct FluidDeviation
{
    static constexpr const char* name = "fluidDeviation";
    FluidFields<D, P> fluid;

    HD double value(int i) const { return fabs(double(fluid.deviation[i])); }
};

template<class Backend, int D, class P>
struct FluidPlaces
{
    Box<D, P> box;
    FluidFields<D, P> fluid;
    GhostMarks<Backend> ghosts;

    HD bool skips(int i) const { return ghosts(i); }

    HD double x(int d, int i) const { return box.toMetres(d, fluid.x[d][i]); }
};

//- Pressures of walls into the order of the input
template<class Backend, int D, class P>
struct ReadWalls
{
    using real = typename P::real;
    static constexpr const char* name = "readWalls";
    RecordsView<Backend, D, P> wall;
    const std::int32_t* id;
    real* pressure;

    HD void operator()(int i) const
    {
        const PairParticle<D, real> p = wall.template load<false>(i);
        pressure[id[i]] = p.pressureTerm*p.density*p.density;
    }
};

//- How far from the usual is the record of a particle: speed, p/rho and volume, in units of c0,
//  c0^2 and 1/rho0
template<class Backend, int D, class P>
struct Suspicion
{
    static constexpr const char* name = "suspicion";
    RecordsView<Backend, D, P> fluid;
    double soundSpeed, density;
    double* result;

    HD void operator()(int i) const
    {
        const PairParticle<D, typename P::real> p = fluid.template load<false>(i);
        double sum = density/fabs(double(p.density))
            + density*fabs(double(p.pressureTerm))/(soundSpeed*soundSpeed);
        for (int d = 0; d < D; ++d) sum += fabs(double(p.velocity.c[d]))/soundSpeed;
        result[i] = sum;
    }
};

//- Neighbours within the support, of one set among another
template<class Backend, int Dim, class P>
struct CountPass
{
    using precision = P;
    using real = typename P::real;
    template<class T> using Self = T;

    static constexpr const char* name = "countNeighbours";
    static constexpr int dimensions = Dim, sources = 1, channels = 1;
    static constexpr bool variableH = false, hasMaxima = false;

    Box<Dim, P> box;
    CellGrid<Dim, P> grid;
    Source<Backend, Dim, P> source[1];
    RecordsView<Backend, Dim, P> target;
    real support2;
    real* result;
    int count;

    HD bool enabled() const { return true; }
    HD int targets() const { return count; }
    HD float* maxima() const { return nullptr; }
    HD Vec<Dim, typename P::position> position(int i) const { return target.loadPosition(i); }
    template<class T> HD T self(int) const { return T(real(0)); }

    template<int S, class T>
    HD void pair(
        const T&, const PairParticle<Dim, T>&, const Vec<Dim, T>&, T r2, int, T* sums) const
    {
        const T within = selectGreater(T(support2), r2, T(real(1)), T(real(0)));
        sums[0] += selectGreater(r2, T(real(0)), within, T(real(0)));
    }

    HD void finish(int i, const real* sums, float*) const { result[i] = sums[0]; }
};

} // namespace riprap

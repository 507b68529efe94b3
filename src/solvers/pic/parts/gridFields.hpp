/*  What the grid holds: the surface, velocities at faces, the pressure.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/backend.hpp"
#include "pic/projection/pressureStep.hpp"
#include "pic/terms/absorb.hpp"
#include "solvers/pic/parts/picSetting.hpp"

namespace riprap
{

template<class Backend, int D, class P>
struct SurfaceFields
{
    using real = typename P::real;

    Array<Backend, real> phi, carried, spare;
    Array<Backend, unsigned char> wet, near;
    // of water without flying particles [cells]; flying particles
    double volume = 0, flying = 0;

    explicit SurfaceFields(PicSetting<Backend, D, P>& set)
    {
        const int cells = set.grid.cells();
        for (auto* a : {&phi, &carried, &spare}) a->allocate(set.context, cells);
        for (auto* a : {&wet, &near}) a->allocate(set.context, cells);
    }
};

template<class Backend, int D, class P>
class FaceVelocities
{
public:

    using real = typename P::real;

    Array<Backend, real> u[D], before[D], change[D], mass[D];
    // with reflection: of particles after the step, and what carries them
    Array<Backend, real> after[D], carrier[D];
    // rates of zones that absorb waves; empty: there are none
    Array<Backend, real> absorb[D];
    Array<Backend, unsigned char> layer[D];

    explicit FaceVelocities(PicSetting<Backend, D, P>& set) : set_(set)
    {
        for (int d = 0; d < D; ++d)
        {
            const int faces = set.grid.faces(d);
            for (auto* a : {&u[d], &before[d], &change[d], &mass[d]})
                a->allocate(set.context, faces);
            layer[d].allocate(set.context, faces);
            if (set.config.reflection > 0)
                for (auto* a : {&after[d], &carrier[d]}) a->allocate(set.context, faces);
        }
        setAbsorbers();
    }

    //- What particles and the surface move with
    Array<Backend, real>* carrying() { return set_.config.reflection > 0 ? carrier : u; }

private:

    void setAbsorbers();

    PicSetting<Backend, D, P>& set_;
};

//- Where zones overlap their rates add up
template<class Backend, int D, class P>
void FaceVelocities<Backend, D, P>::setAbsorbers()
{
    std::vector<AbsorbingZone<D>> zones;
    for (const PicAbsorber& a : set_.config.absorbers)
    {
        AbsorbingZone<D> z;
        for (int d = 0; d < D; ++d)
        {
            z.from.c[d] = a.from[set_.config.axes[d]];
            z.to.c[d] = a.to[set_.config.axes[d]];
        }
        z.rate = a.rate;
        zones.push_back(z);
    }
    for (int d = 0; d < D && !zones.empty(); ++d)
    {
        std::vector<real> rate(set_.grid.faces(d), real(0));
        for (int i = 0; i < set_.grid.faces(d); ++i)
            for (const AbsorbingZone<D>& z : zones)
                rate[i] += real(z.at(faceMiddle(set_.grid, d, i)));
        absorb[d].upload(set_.context, rate);
    }
}

template<class Backend, int D, class P>
class PressureOfWater
{
public:

    // that of the step, and what takes away the divergence that drift brings
    Array<Backend, double> p, reflected;
    // with reflection: impulse by which particles are ahead [Pa s]; pressure with that
    Array<Backend, double> ahead, total;
    PressureStep<Backend, D, typename P::real> step;
    MultigridLinear own;
    LinearSolver& solver;                       // the caller's, else `own`
    PressureReport last;

    PressureOfWater(PicSetting<Backend, D, P>& set, LinearSolver* callers)
        : solver(callers ? *callers : own), set_(set)
    {
        own.controls.tolerance = set.config.pressureTolerance;
        own.controls.reflectionTolerance = set.config.reflectionTolerance;
        const int cells = set.grid.cells();
        p.allocate(set.context, cells);
        if (set.config.reflection > 0)
            for (auto* a : {&reflected, &ahead, &total}) a->allocate(set.context, cells);
        if (set.gathersPressure()) step.allocateWet(set.context, set.grid);
        else step.allocate(set.context, set.grid);
        if (set.bricks && !set.gathersPressure()) step.divide(set.context, *set.bricks);
    }

    Array<Backend, double>& whole() { return set_.config.reflection > 0 ? total : p; }

private:

    PicSetting<Backend, D, P>& set_;
};

} // namespace riprap

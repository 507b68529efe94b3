/*  Extrapolated wall pressure (Adami, Hu & Adams 2012): each wall point takes from the fluid around it

        p_w = (sum p_f W + (g - a_w) . sum rho_f (x_w - x_f) W)/sum W        (their Eq. 27)
        v_w = 2 u_w - sum v_f W/sum W                                        (their Eqs. 22, 23)

    and the density that the equation of state gives for p_w. u_w and a_w are the wall's own velocity and
    acceleration; v_w enters laminar viscosity only, volume changes and artificial viscosity see u_w (with v_w there, energy
    grows: docs/theory). p_w is not let below zero: a wall does not pull.
*/
#pragma once

#include "core/pairLoop.hpp"
#include "sph/boundary/wallFields.hpp"
#include "sph/fluidPass.hpp"

namespace riprap
{

template<class Backend, int Dim, class P, class Kernel, bool VariableH>
struct ExtrapolatedWallPass
{
    using precision = P;
    using real = typename P::real;
    template<class T> using Self = PairParticle<Dim, T>;

    static constexpr const char* name = "extrapolatedWall";
    static constexpr int dimensions = Dim, sources = 1, channels = 2 + 2*Dim;
    static constexpr bool variableH = VariableH, hasMaxima = false;

    Box<Dim, P> box;
    CellGrid<Dim, P> grid;
    Source<Backend, Dim, P> source[1];      // fluid
    RecordsView<Backend, Dim, P> wall;
    WallFields<Dim, P> fields;
    KernelConstants<Dim, real> kernel;
    FluidModel<Dim, P> model;
    int count;
    const ClockData* clock;     // in a step; null: now

    HD bool enabled() const { return !clock || clock->active; }
    HD int targets() const { return count; }
    HD float* maxima() const { return nullptr; }
    HD Vec<Dim, typename P::position> position(int i) const { return wall.loadPosition(i); }

    template<class T>
    HD Self<T> self(int) const
    {
        return Self<T>{filled<Dim>(T(real(0))), T(real(0)), T(real(1)), T(model.h0)};
    }

    template<int S, class T>
    HD void pair(const Self<T>& i, const PairParticle<Dim, T>& j, const Vec<Dim, T>& dx, T r2, int, T* sums) const
    {
        const PairGeometry<Dim, T> g = pairGeometry<Kernel, VariableH, true>(kernel, model.h0, i, j, dx, r2);
        sums[0] += g.w;
        sums[1] += j.pressureTerm*j.density*j.density*g.w;
        for (int d = 0; d < Dim; ++d)
        {
            sums[2 + d] += j.density*dx.c[d]*g.w;
            sums[2 + Dim + d] += j.velocity.c[d]*g.w;
        }
    }

    HD void finish(int i, const real* sums, float*) const
    {
        PairParticle<Dim, real> p;
        p.pressureTerm = 0;
        p.density = model.rho0;
        p.h = model.h0;
        Vec<Dim, real> u = filled<Dim>(real(0)), lift = model.gravity;
        if (fields.v[0])
            for (int d = 0; d < Dim; ++d) { u.c[d] = fields.v[d][i]; lift.c[d] -= fields.a[d][i]; }
        p.velocity = u;
        if (sums[0] > real(1e-6)*kernel.wFactor)
        {
            const real inverse = real(1)/sums[0];
            real pressure = sums[1];
            for (int d = 0; d < Dim; ++d)
            {
                pressure += lift.c[d]*sums[2 + d];
                p.velocity.c[d] = real(2)*u.c[d] - sums[2 + Dim + d]*inverse;
            }
            pressure = maximum(pressure*inverse, real(0));
            p.density = model.rho0*(real(1) + model.eos.deviation(pressure));
            p.pressureTerm = pressure/(p.density*p.density);
        }
        wall.store(i, p);
    }
};

} // namespace riprap

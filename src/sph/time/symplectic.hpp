/*  Predictor-corrector (symplectic position Verlet with density update; Monaghan 2005, Leimkuhler & Matthews 2016):
    two passes over the pairs a step.

        pass at n:    a_n, rate_n
        predictor:    x, v, rho at n+1/2 = x_n + (v_n + drift) dt/2, v_n + a_n dt/2, rho_n + rate_n dt/2
        pass at n+1/2
        corrector:    v_{n+1} = v_n + a_{n+1/2} dt;  x_{n+1} = x_n + ((v_n + v_{n+1})/2 + drift) dt
                      rho_{n+1} = rho_n (2 - e)/(2 + e),  e = - rate_{n+1/2} rho0 dt/rho_{n+1/2}
*/
#pragma once

#include "sph/time/leapfrog.hpp"

namespace riprap
{

//- State at the beginning of a step, kept while it lasts
template<int D, class P>
struct StepStart
{
    std::int64_t* x[D];
    typename P::real* v[D];
    typename P::real* deviation;
};

template<class Backend, int D, class P>
struct SymplecticPredictor : Mover<Backend, D, P>
{
    using real = typename P::real;
    static constexpr const char* name = "symplecticPredictor";
    StepStart<D, P> start;

    HD void operator()(int i) const
    {
        const ClockData& c = *this->clock;
        if (!c.active || i >= *this->count) return;
        const FluidFields<D, P>& f = this->fluid;
        const real half = real(0.5*c.dt);
        const Vec<D, std::int64_t> x0 = this->position(i);
        Vec<D, real> v;
        for (int d = 0; d < D; ++d)
        {
            start.x[d][i] = x0.c[d];
            start.v[d][i] = v.c[d] = f.v[d][i];
        }
        const real deviation0 = f.deviation[i];
        start.deviation[i] = deviation0;
        const Vec<D, std::int64_t> x = this->moved(x0, v + this->drift(i), 0.5*c.dt);
        for (int d = 0; d < D; ++d)
        {
            v.c[d] += f.a[d][i]*half;
            f.x[d][i] = x.c[d];
            f.v[d][i] = v.c[d];
        }
        const real deviation = deviation0 + f.rate[i]*half;
        f.deviation[i] = deviation;
        this->record(i, x, v, deviation);
    }
};

template<class Backend, int D, class P>
struct SymplecticCorrector : Mover<Backend, D, P>
{
    using real = typename P::real;
    static constexpr const char* name = "symplecticCorrector";
    StepStart<D, P> start;

    HD void operator()(int i) const
    {
        const ClockData& c = *this->clock;
        if (!c.active || i >= *this->count) return;
        const FluidFields<D, P>& f = this->fluid;
        const real dt = real(c.dt);
        Vec<D, real> v, u;
        Vec<D, std::int64_t> x0;
        const Vec<D, real> drift = this->drift(i);
        for (int d = 0; d < D; ++d)
        {
            const real v0 = start.v[d][i];
            x0.c[d] = start.x[d][i];
            v.c[d] = v0 + f.a[d][i]*dt;
            u.c[d] = real(0.5)*(v0 + v.c[d]) + drift.c[d];
            f.v[d][i] = v.c[d];
        }
        const Vec<D, std::int64_t> x = this->moved(x0, u, c.dt);
        for (int d = 0; d < D; ++d) f.x[d][i] = x.c[d];
        // the ratio (2 - e)/(2 + e) in terms of the deviation: d1 = d0 + (1 + d0) 2 s/(2 - s), s = -e
        const real s = f.rate[i]*dt/(real(1) + f.deviation[i]);
        const real d0 = start.deviation[i];
        const real deviation = d0 + (real(1) + d0)*real(2)*s/(real(2) - s);
        f.deviation[i] = deviation;
        this->record(i, x, v, deviation);
        this->checkSkin(i, x, u);
    }
};

} // namespace riprap

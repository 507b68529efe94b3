/*  The largest speed of particles, which the Courant number limits:

        (|u|max + |g| dt) dt <= C h,        dt <= 0.4 sqrt(h/(pi |g|)), dt <= h^2/(2 D nu) for
                                            explicit viscosity

    Particles with no water about them fall freely, cell by cell (moveParticles.hpp): no field has
    to be followed, and C is a larger one for them.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cmath>
#include "pic/grid/inCell.hpp"
#include "pic/grid/particles.hpp"

namespace riprap
{

template<int D, class R>
struct ParticleSpeed
{
    static constexpr const char* name = "particleSpeed";
    PicParticles<D, R> particles;

    HD double value(int i) const
    {
        double sum = 0;
        for (int d = 0; d < D; ++d) sum += double(particles.v[d][i])*particles.v[d][i];
        return sqrt(sum);
    }
};

//- The same where water carries the particle; else a part of it
template<int D, class R>
struct CarriedSpeed
{
    static constexpr const char* name = "carriedSpeed";
    UniformGrid<D> grid;
    ParticleSpeed<D, R> speed;
    const unsigned char* nearWater;     // cells (wetCells.hpp)
    double flyingPart;          // C of water over C of particles that fly

    HD double value(int i) const
    {
        const bool flies = !nearWater[InCell<D, R>(grid, speed.particles.position(i)).cell(grid)];
        return (flies ? flyingPart : 1.0)*speed.value(i);
    }
};

//- The step that takes the fastest particle C cells on, gravity having acted on it
inline double courantStep(double courant, double h, double speed, double gravity)
{
    const double length = courant*h;
    return speed + std::sqrt(speed*speed + 4*gravity*length) > 0
      ? 2*length/(speed + std::sqrt(speed*speed + 4*gravity*length)) : 1e30;
}

//- Waves of two cells, the shortest that the grid carries, have omega = sqrt(pi g/h). Steps of
//  second order treat them well up to omega dt = 0.4 (their period is 0.7 % off); at 0.6 to 1
//  nonlinear waves feed them, and energy grows
inline double waveStep(double h, double gravity)
{
    return gravity > 0 ? 0.4/std::sqrt(M_PI*gravity/h) : 1e30;
}

inline double viscousStep(double h, double nu, int dimensions)
{
    return nu > 0 ? h*h/(2*dimensions*nu) : 1e30;
}

} // namespace riprap

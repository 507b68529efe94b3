/*  Linear theory of SPH on a square lattice (2D): how a small disturbance exp(i k.x) of a fluid at
    rest evolves.

    With x the separations of a site's neighbours, V the volume of a site, grad W = F x:
        s(k) = sum F x sin(k.x) what gradients and divergences become: -i k/V for long waves
        omega(k) = c V |s|                                  sound, where p = 0
        nu(k) = 2 nu V sum |F| r^2/(r^2 + 0.01 h^2) (1 - cos k.x) decay of a shear wave by laminar
        viscosity
        A(k) = alpha c0 h V sum |F| (k.x)^2/(k^2 (r^2 + 0.01 h^2)) (1 - cos k.x) decay of a sound
        wave's velocity by artificial viscosity
            if it acted all the time; it acts on approaching pairs, half of it
        D(k) = 2 delta h c0 V sum |F| (1 - cos k.x) decay of a density wave by density diffusion
    Under a pressure p the disturbance of displacement, velocity and density (xi, v, r) obeys
        xi' = v - epsilonX V sum W (1 - cos k.x) v          (XSPH)
        v'  = i V (c^2/rho - 2 p/rho^2) (s + sgn(p) epsilonA s_A) r - (2 V/rho) (p H(F) + epsilonA
            |p| H(F_A)) xi
        r'  = i rho V s.v - D r
    H(G) = sum (G 1 + (G'/r) x x) (1 - cos k.x), F_A = F (W/W(dp))^4, s_A likewise (anti-clump term,
    epsilonA). The second part of v' is the tensile instability (Swegle et al. 1995, J. Comput.
    Phys. 116, 123; Morris 1996, Publ. Astron. Soc. Aust. 13, 97; here for the continuity equation
    in place of a density sum): where s vanishes, nothing else acts.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <array>
#include <complex>
#include "solvers/sph/sphModels.hpp"

namespace riprap
{

struct LatticeModel
{
    std::string kernel = "wendlandC2";
    double spacing = 1;         // dp, of which h and W(dp) are made
    double stretch = 1;         // distance of the sites over dp
    double ratio = 1.25;        // h/dp
    double soundSpeed = 1;      // c0
    double density = 1;         // rho0
    double deviation = 0;       // rho/rho0 - 1, Tait's pressure with it
    double gamma = 7;
    double viscosity = 0;       // nu
    double diffusion = 0;       // delta
    double artificial = 0;      // alpha
    double antiClump = 0, xsph = 0;

    double h() const { return ratio*spacing; }
};

using Wave = std::array<double, 2>;         // k [1/m]

//- The wave (m, n) of a periodic box of `sites` by `sites`
Wave waveOf(const LatticeModel&, int sites, int m, int n);

double soundFrequency(const LatticeModel&, const Wave&);
double viscousRate(const LatticeModel&, const Wave&);
double diffusionRate(const LatticeModel&, const Wave&);
double artificialRate(const LatticeModel&, const Wave&);

//- Fastest growth of a disturbance [1/s]; 0 or less: none grows
double growthRate(const LatticeModel&, const Wave&);

//- The largest value of f(model, wave) over all waves of a box, and the wave numbers of it
struct Largest { double value; int m, n; };
template<class F>
Largest reduceMax(const LatticeModel& model, int sites, const F& f)
{
    Largest r{-1e300, 0, 0};
    for (int m = 0; m <= sites/2; ++m)
        for (int n = 0; n <= m; ++n)
        {
            if (m == 0) continue;
            const double value = f(model, waveOf(model, sites, m, n));
            if (value > r.value) r = Largest{value, m, n};
        }
    return r;
}

//- Growth of a mode a step, |lambda| - 1, for du/dt = mu u with z = mu dt. The leapfrog with
//  predicted velocity and density is the two-step Adams-Bashforth scheme: lambda^2 = lambda + z (3
//  lambda - 1)/2; for z = i omega dt: (omega dt)^4/4
double leapfrogGrowth(std::complex<double> z);

//- The same of the symplectic scheme, for sound of omega dt = z with decays D dt = d of density and
//  A dt = a of velocity; the latter is computed with the velocity predicted to the end of the step
double symplecticGrowth(double z, double d, double a);

} // namespace riprap

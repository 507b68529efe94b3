/*  The paper's SPH equations for one pair, in double, written from the paper (with the corrections
    of docs/theory.md) and the cited sources alone: what the tests of terms and of the pair loop
    compare with. Gradients are vectors here, kernels are functions of r and h.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cmath>
#include "solvers/sph/sphModels.hpp"

namespace riprap
{
namespace paper
{

inline Vector3 operator-(const Vector3& a, const Vector3& b)
{
    return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}};
}
inline double dot(const Vector3& a, const Vector3& b) { return a[0]*b[0] + a[1]*b[1] + a[2]*b[2]; }
inline void add(Vector3& a, double s, const Vector3& b)
{
    for (int d = 0; d < 3; ++d) a[d] += s*b[d];
}

//- Eq. 28 and its 3D form; Monaghan & Lattanzio's cubic spline. Others by their headers, which
//  kernels.hpp tests
inline double W(const std::string& kernel, int D, double r, double h)
{
    const double pi = std::acos(-1.0), q = r/h;
    if (kernel == "wendlandC2")
        return q >= 2 ? 0
                      : (D == 2 ? 7/(4*pi*h*h) : 21/(16*pi*h*h*h))
                *std::pow(1 - q/2, 4)*(2*q + 1);
    if (kernel != "cubicSpline") return kernelOf(kernel).weight(D, r, h);
    const double alpha = D == 2 ? 10/(7*pi*h*h) : 1/(pi*h*h*h);
    return q >= 2 ? 0 : alpha*(q < 1 ? 1 - 1.5*q*q + 0.75*q*q*q : 0.25*std::pow(2 - q, 3));
}

inline double dWdr(const std::string& kernel, int D, double r, double h)
{
    const double pi = std::acos(-1.0), q = r/h;
    if (kernel == "wendlandC2")
        return q >= 2 ? 0
                      : (D == 2 ? 7/(4*pi*h*h) : 21/(16*pi*h*h*h))/h*(-5*q)
                *std::pow(1 - q/2, 3);
    if (kernel != "cubicSpline") return r*kernelOf(kernel).gradient(D, r, h);
    const double alpha = D == 2 ? 10/(7*pi*h*h) : 1/(pi*h*h*h);
    return q >= 2 ? 0 : alpha/h*(q < 1 ? -3*q + 2.25*q*q : -0.75*std::pow(2 - q, 2));
}

//- x = x_i - x_j
inline Vector3 gradW(const std::string& kernel, int D, const Vector3& x, double h)
{
    const double r = std::sqrt(dot(x, x));
    Vector3 g{{0, 0, 0}};
    if (r > 0) add(g, dWdr(kernel, D, r, h)/r, x);
    return g;
}

struct Particle
{
    Vector3 x{{0, 0, 0}}, v{{0, 0, 0}};
    double rho = 0, p = 0, h = 0, m = 0;
    // of walls: their own velocity, where v is what laminar viscosity sees
    Vector3 u{{0, 0, 0}};
};

//- A pair, and what particle i gets from j
struct Pair
{
    Particle i, j;
    Vector3 x, v;               // i - j
    double h, r2, w;
    Vector3 grad;
    std::string kernel;
    int D;

    Vector3 a{{0, 0, 0}}, drift{{0, 0, 0}};     // dv/dt, added to dx/dt
    double rate = 0;                            // drho/dt

    //- separation: x_i - x_j, nearest image
    Pair(const std::string& k, int dimensions, const Particle& pi, const Particle& pj,
        const Vector3& separation)
        : i(pi), j(pj), x(separation), v(pi.v - pj.v), h(0.5*(pi.h + pj.h)), r2(dot(x, x)),
          w(W(k, dimensions, std::sqrt(r2), h)), grad(gradW(k, dimensions, x, h)), kernel(k),
          D(dimensions)
    {}

    // Eq. 32
    void continuity() { rate += i.rho*j.m/j.rho*dot(v, grad); }
    void wallContinuity() { rate += i.rho*j.m/j.rho*dot(i.v - j.u, grad); }
    // Eq. 34
    void pressure() { add(a, -j.m*(i.p/(i.rho*i.rho) + j.p/(j.rho*j.rho)), grad); }
    // Eq. 36
    void laminar(double mu, double eta = 0.01)
    {
        add(a, j.m*2*mu*dot(x, grad)/(i.rho*j.rho*(r2 + eta*h*h)), v);
    }
    // Eq. 38
    void antiClump(double epsilon, double spacing)
    {
        const double ratio = w/W(kernel, D, spacing, h);
        add(a,
            -j.m*epsilon*(std::abs(i.p)/(i.rho*i.rho) + std::abs(j.p)/(j.rho*j.rho))
                *std::pow(ratio, 4),
            grad);
    }
    // Eq. 39
    void xsph(double epsilon) { add(drift, -epsilon*j.m/(0.5*(i.rho + j.rho))*w, v); }
    // Monaghan 1992
    void artificial(double alpha, double c0) { artificial(alpha, c0, v); }
    void wallArtificial(double alpha, double c0) { artificial(alpha, c0, i.v - j.u); }
    // Molteni: g = 0; Fourtakas et al. 2019
    void diffusion(double delta, double c0, double rho0, const Vector3& g)
    {
        const Vector3 ji{{-x[0], -x[1], -x[2]}};
        const double difference = 2*(j.rho - i.rho - rho0*dot(g, ji)/(c0*c0));
        if (r2 > 0) rate += delta*h*c0*j.m/j.rho*difference*dot(ji, grad)/r2;
    }

private:

    void artificial(double alpha, double c0, const Vector3& velocity)
    {
        if (dot(velocity, x) >= 0) return;
        const double mu = h*dot(velocity, x)/(r2 + 0.01*h*h);
        add(a, j.m*alpha*c0*mu/(0.5*(i.rho + j.rho)), grad);
    }
};

} // namespace paper
} // namespace riprap

// SPDX-License-Identifier: GPL-3.0-or-later

#include "latticeModes.hpp"

#include <algorithm>
#include <cmath>

namespace riprap
{

namespace
{

using Complex = std::complex<double>;
using Matrix = std::array<std::array<Complex, 5>, 5>;

constexpr double pi = 3.14159265358979323846;

struct KernelValues { double w, f; };

KernelValues kernelAt(const LatticeModel& l, double r)
{
    const KernelModel& kernel = kernelOf(l.kernel);
    return {kernel.weight(2, r, l.h()), kernel.gradient(2, r, l.h())};
}

//- F of the anti-clump term: F (W/W(dp))^4
double clumpGradient(const LatticeModel& l, double r)
{
    const KernelValues k = kernelAt(l, r);
    return k.f*std::pow(k.w/kernelAt(l, l.spacing).w, 4);
}

//- Call f(x, y, r) for every neighbour of a site
template<class F>
void forNeighbours(const LatticeModel& l, const F& f)
{
    const double d = l.spacing*l.stretch;
    const int reach = int(2*l.ratio/l.stretch) + 1;
    for (int j = -reach; j <= reach; ++j)
        for (int i = -reach; i <= reach; ++i)
        {
            const double r = d*std::sqrt(double(i*i + j*j));
            if (r > 0 && r < 2*l.h()) f(i*d, j*d, r);
        }
}

double volume(const LatticeModel& l) { return std::pow(l.spacing*l.stretch, 2); }

template<class Gradient>
std::array<double, 2> sineSum(const LatticeModel& l, const Wave& k, const Gradient& gradient)
{
    std::array<double, 2> s{{0, 0}};
    forNeighbours(l, [&](double x, double y, double r)
    {
        const double sine = gradient(r)*std::sin(k[0]*x + k[1]*y);
        s[0] += sine*x;
        s[1] += sine*y;
    });
    return s;
}

//- H(G): xx, xy, yy
template<class Gradient>
std::array<double, 3> hessianSum(const LatticeModel& l, const Wave& k, const Gradient& gradient)
{
    std::array<double, 3> h{{0, 0, 0}};
    const double step = 1e-5*l.h();
    forNeighbours(l, [&](double x, double y, double r)
    {
        const double g = gradient(r), slope = (gradient(r + step) - gradient(r - step))/(2*step*r);
        const double c = 1 - std::cos(k[0]*x + k[1]*y);
        h[0] += (g + slope*x*x)*c;
        h[1] += slope*x*y*c;
        h[2] += (g + slope*y*y)*c;
    });
    return h;
}

template<class Weight>
double cosineSum(const LatticeModel& l, const Wave& k, const Weight& weight)
{
    double sum = 0;
    forNeighbours(l,
        [&](double x, double y, double r)
        { sum += weight(r)*(1 - std::cos(k[0]*x + k[1]*y)); });
    return sum;
}

Matrix product(const Matrix& a, const Matrix& b)
{
    Matrix c{};
    for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 5; ++j)
            for (int k = 0; k < 5; ++k) c[i][j] += a[i][k]*b[k][j];
    return c;
}

double largestEntry(const Matrix& a)
{
    double r = 0;
    for (const auto& row : a) for (const Complex& e : row) r = std::max(r, std::abs(e));
    return r;
}

//- Logarithm of the spectral radius: log|A^n|/n for n = 2^40
double logSpectralRadius(Matrix power)
{
    double logarithm = 0, n = 1;
    for (int doubling = 0; doubling < 40; ++doubling)
    {
        const double size = largestEntry(power);
        if (size == 0) return -1e300;
        for (auto& row : power) for (Complex& e : row) e /= size;
        logarithm = 2*(logarithm + std::log(size));
        power = product(power, power);
        n *= 2;
    }
    return (logarithm + std::log(largestEntry(power)))/n;
}

//- Growth of the fastest solution of y' = M y, from exp(M t) with a short t
double fastestGrowth(Matrix m)
{
    const double scale = largestEntry(m);
    if (scale == 0) return 0;
    const double step = 1e-2/scale;
    Matrix power{}, term{};
    for (int i = 0; i < 5; ++i) power[i][i] = term[i][i] = 1;
    for (auto& row : m) for (Complex& e : row) e *= step;
    for (int n = 1; n < 10; ++n)
    {
        term = product(term, m);
        for (auto& row : term) for (Complex& e : row) e /= n;
        for (int i = 0; i < 5; ++i) for (int j = 0; j < 5; ++j) power[i][j] += term[i][j];
    }
    return logSpectralRadius(power)/step;
}

} // namespace

Wave waveOf(const LatticeModel& l, int sites, int m, int n)
{
    const double k = 2*pi/(sites*l.spacing*l.stretch);
    return Wave{{m*k, n*k}};
}

double soundFrequency(const LatticeModel& l, const Wave& k)
{
    const auto s = sineSum(l, k, [&](double r) { return kernelAt(l, r).f; });
    return l.soundSpeed*volume(l)*std::hypot(s[0], s[1]);
}

double viscousRate(const LatticeModel& l, const Wave& k)
{
    return -2*l.viscosity*volume(l)
        *cosineSum(l, k,
            [&](double r) { return kernelAt(l, r).f*r*r/(r*r + 0.01*l.h()*l.h()); });
}

double diffusionRate(const LatticeModel& l, const Wave& k)
{
    return -2*l.diffusion*l.h()*l.soundSpeed*volume(l)
        *cosineSum(l, k, [&](double r) { return kernelAt(l, r).f; });
}

double artificialRate(const LatticeModel& l, const Wave& k)
{
    const double k2 = k[0]*k[0] + k[1]*k[1];
    double sum = 0;
    forNeighbours(l, [&](double x, double y, double r)
    {
        const double kx = k[0]*x + k[1]*y;
        sum -= kernelAt(l, r).f*kx*kx/(k2*(r*r + 0.01*l.h()*l.h()))*(1 - std::cos(kx));
    });
    return l.artificial*l.soundSpeed*l.h()*volume(l)*sum;
}

double growthRate(const LatticeModel& l, const Wave& k)
{
    const double c0 = l.soundSpeed, rho = l.density*(1 + l.deviation), V = volume(l);
    const double p = c0*c0*l.density/l.gamma*(std::pow(1 + l.deviation, l.gamma) - 1);
    const double c2 = c0*c0*std::pow(1 + l.deviation, l.gamma - 1);
    const auto gradient = [&](double r) { return kernelAt(l, r).f; };
    const auto clump = [&](double r) { return clumpGradient(l, r); };
    const auto s = sineSum(l, k, gradient), sA = sineSum(l, k, clump);
    const auto H = hessianSum(l, k, gradient), HA = hessianSum(l, k, clump);
    const double drift = l.xsph*V*cosineSum(l, k, [&](double r) { return kernelAt(l, r).w; });
    const double sign = p < 0 ? -1 : 1;
    // in units of h, c0 and rho0, so that entries are of one size: r is r c0/rho0, xi is xi c0/h
    const double h = l.h(), stiffness = V*(c2/rho - 2*p/(rho*rho))*l.density/c0;
    Matrix m{};
    for (int d = 0; d < 2; ++d)
    {
        m[d][2 + d] = (1 - drift)*c0/h;
        m[2 + d][4] = Complex(0, stiffness*(s[d] + sign*l.antiClump*sA[d]));
        m[4][2 + d] = Complex(0, rho*V*s[d]*c0/l.density);
        for (int e = 0; e < 2; ++e)
            m[2 + d][e] = -2*V/rho*(p*H[d + e] + l.antiClump*std::abs(p)*HA[d + e])*h/c0;
    }
    m[4][4] = -diffusionRate(l, k);
    return fastestGrowth(m);
}

double leapfrogGrowth(std::complex<double> z)
{
    const Complex b = 1.0 + 1.5*z, root = std::sqrt(b*b - 2.0*z);
    return std::max(std::abs(b + root), std::abs(b - root))/2 - 1;
}

double symplecticGrowth(double z, double d, double a)
{
    // y = (v, r, g), g = a dt of the last pass: r' = r + z (v + g/2) - d r, g' = -z r' - a (v + g),
    // v' = v + (g + g')/2
    const std::array<double, 3> r{{z, 1 - d, 0.5*z}}, g{{-z*r[0] - a, -z*r[1], -z*r[2] - a}};
    Matrix m{};
    for (int k = 0; k < 3; ++k)
    {
        m[0][k] = (k == 0) + 0.5*(k == 2) + 0.5*g[k];
        m[1][k] = r[k];
        m[2][k] = g[k];
    }
    return std::expm1(logSpectralRadius(m));
}

} // namespace riprap

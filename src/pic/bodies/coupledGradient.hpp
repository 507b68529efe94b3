/*  Conjugate gradients for the pressure with free bodies, (A + U U^T) x = rhs, on the host: any
    preconditioner for A alone, deflated by the bodies (deflation.hpp). Flexible: beta of Polak and
    Ribiere, since a V-cycle in single precision is not quite a constant operator. Residuals are
    OpenFOAM's (conjugateGradient.hpp). Sums are taken in blocks of rows: the same bits with any
    number of threads.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <cmath>
#include "pic/bodies/deflation.hpp"
#include "pic/bodies/freeConstants.hpp"

namespace riprap
{

//- Sum of f(row); f may write what belongs to its row
template<class F>
double sumRows(int rows, const F& f)
{
    constexpr int block = 2048;
    const int blocks = (rows + block - 1)/block;
    std::vector<double> part(blocks);
    #pragma omp parallel for if (blocks > 1)
    for (int b = 0; b < blocks; ++b)
    {
        const int end = std::min(rows, (b + 1)*block);
        double sum = 0;
        for (int i = b*block; i < end; ++i) sum += f(i);
        part[b] = sum;
    }
    double sum = 0;
    for (const double p : part) sum += p;
    return sum;
}

//- OpenFOAM's: sum(|A x - A xRef| + |b - A xRef|), xRef the mean of x; q: A x
inline double normFactor(
    const ReducedSystem& s, const BodyDeflation& bodies, const std::vector<double>& q)
{
    constexpr double small = 1e-20;
    const int n = s.rows();
    const double reference = sumRows(n, [&](int i) { return s.x[i]; })/n;
    return small + sumRows(n, [&](int i)
    {
        const double of = bodies.rowSum(i)*reference;
        return std::fabs(q[i] - of) + std::fabs(s.rhs[i] - of);
    });
}

//- z in the span of Z is what takes the residual r - A z off it
inline void deflate(const BodyDeflation& bodies, const std::vector<double>& r,
    std::vector<double>& z, std::vector<double>& w)
{
    bodies.product(z.data(), w.data());
    sumRows(int(r.size()), [&](int i) { w[i] = r[i] - w[i]; return 0.0; });
    bodies.correct(w.data(), z.data());
}

//- x += alpha p, r -= alpha q. \return sum |r|
inline double advance(double* x, std::vector<double>& r, const std::vector<double>& p,
    const std::vector<double>& q, double alpha)
{
    return sumRows(int(r.size()), [&](int i)
    {
        x[i] += alpha*p[i];
        r[i] -= alpha*q[i];
        return std::fabs(r[i]);
    });
}

//- precondition(const double* r, double* z): z = B r
template<class Precondition>
PressureReport coupledGradient(ReducedSystem& s, const BodyDeflation& bodies,
    const MultigridControls& controls, const Precondition& precondition)
{
    const int n = s.rows();
    PressureReport report;
    if (!n) return report;
    std::vector<double> r(n), z(n), p(n, 0.0), q(n), w(n);
    double* x = s.x.data();

    bodies.product(x, q.data());
    const double norm = normFactor(s, bodies, q);
    const auto takeResidual = [&](int i)
    {
        r[i] = s.rhs[i] - q[i];
        return std::fabs(r[i]);
    };
    double residual = sumRows(n, takeResidual)/norm;
    report.initialResidual = residual;
    const auto converged = [&]
    {
        return residual < controls.tolerance
            || (controls.relTol > 0 && residual < controls.relTol*report.initialResidual);
    };
    const auto done = [&] { return report.iterations >= controls.minIter && converged(); };
    const bool deflates = bodies.columns() > 0;
    if (deflates && !done())        // the residual has then nothing in the span of Z
    {
        const FreeConstants free(s);
        free.takeFrom(r.data());
        bodies.correct(r.data(), x);
        bodies.product(x, q.data());
        residual = sumRows(n, takeResidual)/norm;
        free.takeFrom(r.data());
    }
    double rz = 0, alpha = 0;
    while (!done() && report.iterations < controls.maxIter && residual < 1e300)
    {
        precondition(r.data(), z.data());
        if (deflates) deflate(bodies, r, z, w);
        const double before = rz,
                     change = before != 0 ? -alpha*sumRows(n, [&](int i) { return z[i]*q[i]; })
                                          : 0;
        rz = sumRows(n, [&](int i) { return z[i]*r[i]; });
        const double beta = before != 0 ? change/before : 0;
        sumRows(n, [&](int i) { p[i] = z[i] + beta*p[i]; return 0.0; });
        bodies.product(p.data(), q.data());
        const double pq = sumRows(n, [&](int i) { return p[i]*q[i]; });
        if (!(pq > 0)) break;
        alpha = rz/pq;
        residual = advance(x, r, p, q, alpha)/norm;
        ++report.iterations;
    }
    report.finalResidual = residual;
    report.converged = converged();
    return report;
}

} // namespace riprap

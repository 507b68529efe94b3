/*  Conjugate gradients in double precision over the finest level, preconditioned by a V-cycle in single precision.

        z = B r,  beta = z.(r - r_old)/(z_old.r_old),  p = z + beta p,  q = A p,  alpha = z.r/p.q,  x += alpha p,  r -= alpha q

    (Polak and Ribiere's beta, r - r_old = -alpha q: it forgives that B is not exactly linear in single precision.)
    Residuals are OpenFOAM's: sum |b - A x| / sum(|A x - A xRef| + |b - A xRef|) with xRef the mean of the first guess, so that
    tolerances of fvSolution mean the same for every solver. The scalars live on the device.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cmath>
#include "pic/pressure/level.hpp"
#include "pic/pressure/rowPasses.hpp"

namespace riprap
{

//- The finest level in double precision; a and s as in LevelData
template<int D>
struct FineData
{
    GridShape<D> shape;
    double* a[D];
    double* s;
    double* rhs;
    double* x;
    double* r;
    double* p;
    double* q;
    float* inverse;         // > 0 where there is an unknown
    float* b;               // what the V-cycle takes
    const float* z;         // what it gives

    HD double apply(const Place<D>& c, const double* v) const
    {
        double sum = s[c.c]*v[c.c];
        for (int d = 0; d < D; ++d)
        {
            const int below = shape.below(c, d), above = shape.above(c, d);
            sum += a[d][c.c]*(v[c.c] - v[below]) + a[d][above]*(v[c.c] - v[above]);
        }
        return sum;
    }

    //- The product for the cells of a row, 0 where there is no unknown
    HD void applyRow(const Place<D>& first, const double* v, double* to) const
    {
        const RowNeighbours<D> by(shape, first);
        INDEPENDENT
        for (int k = 0; k < rowCells; ++k)
        {
            const int c = first.c + k;
            const double own = v[c];
            double sum = s[c]*own;
            for (int d = 0; d < D; ++d) sum += a[d][c]*(own - v[c + by.below[d]]) + a[d][c + by.above[d]]*(own - v[c + by.above[d]]);
            to[k] = sum;
        }
        INDEPENDENT
        for (int k = 0; k < rowCells; ++k) to[k] = inverse[first.c + k] > 0 ? to[k] : 0.0;
    }
};

struct CgState
{
    double tolerance, relTol;
    int maxIter, minIter;
    double xRef, normFactor, initial, residual;
    double rz, alpha, beta;
    int iterations, again, cells;

    HD void decide()
    {
        const bool done = residual < tolerance || (relTol > 0 && residual < relTol*initial);
        again = ((!done || iterations < minIter) && iterations < maxIter && residual < 1e300) ? 1 : 0;      // false for NaN
    }
};

template<int D>
struct AverageGuess
{
    static constexpr const char* name = "pressureAverage";
    FineData<D> f;
    TiledCells<D> cells;

    HD void add(int i, double* sums) const
    {
        Place<D> c;
        if (!cells.at(i, c) || !(f.inverse[c.c] > 0)) return;
        sums[0] += f.x[c.c];
        sums[1] += 1;
    }

    HD void addRow(const Place<D>& first, double* sums) const
    {
        RowSum x, count;
        INDEPENDENT
        for (int k = 0; k < rowCells; ++k)
        {
            const bool unknown = f.inverse[first.c + k] > 0;
            x.part[k] = unknown ? f.x[first.c + k] : 0.0;
            count.part[k] = unknown ? 1.0 : 0.0;
        }
        sums[0] += x.total();
        sums[1] += count.total();
    }
};

struct SetReference
{
    static constexpr const char* name = "pressureScalars";
    CgState* state;

    HD void operator()(const double* sums) const
    {
        state->xRef = sums[1] > 0 ? sums[0]/sums[1] : 0;
        state->cells = int(sums[1]);
    }
};

//- For what bodies add
template<int D>
struct ClearDirections
{
    static constexpr const char* name = "pressureClear";
    FineData<D> f;
    TiledCells<D> cells;

    HD void operator()(int i) const
    {
        Place<D> c;
        if (cells.at(i, c)) f.p[c.c] = f.q[c.c] = 0;
    }

    HD void row(const Place<D>& first) const
    {
        INDEPENDENT
        for (int k = 0; k < rowCells; ++k) f.p[first.c + k] = f.q[first.c + k] = 0;
    }
};

template<int D>
struct FirstResidual
{
    static constexpr const char* name = "pressureResidual";
    FineData<D> f;
    TiledCells<D> cells;
    const CgState* state;
    bool coupled;           // q has the bodies' part of the product with x, p that with ones

    HD void add(int i, double* sums) const
    {
        Place<D> c;
        if (!cells.at(i, c)) return;
        const bool unknown = f.inverse[c.c] > 0;
        const double ax = unknown ? f.apply(c, f.x) + (coupled ? f.q[c.c] : 0) : 0, r = unknown ? f.rhs[c.c] - ax : 0;
        const double reference = (f.s[c.c] + (coupled ? f.p[c.c] : 0))*state->xRef;
        f.r[c.c] = r;
        f.b[c.c] = float(r);
        f.p[c.c] = 0;
        f.q[c.c] = 0;
        if (!unknown) return;
        sums[0] += std::fabs(r);
        sums[1] += std::fabs(ax - reference) + std::fabs(f.rhs[c.c] - reference);
    }

    HD void addRow(const Place<D>& first, double* sums) const
    {
        double product[rowCells];
        RowSum residual, norm;
        f.applyRow(first, f.x, product);
        const double xRef = state->xRef, whole = coupled ? 1 : 0;
        INDEPENDENT
        for (int k = 0; k < rowCells; ++k)
        {
            const int c = first.c + k;
            const double ax = product[k] + whole*f.q[c], reference = (f.s[c] + whole*f.p[c])*xRef, rhs = f.rhs[c];
            residual.part[k] = rhs - ax;
            norm.part[k] = std::fabs(ax - reference) + std::fabs(rhs - reference);
        }
        INDEPENDENT
        for (int k = 0; k < rowCells; ++k)
        {
            const int c = first.c + k;
            const bool unknown = f.inverse[c] > 0;
            const double r = unknown ? residual.part[k] : 0.0;
            norm.part[k] = unknown ? norm.part[k] : 0.0;
            residual.part[k] = std::fabs(r);
            f.r[c] = r;
            f.b[c] = float(r);
            f.p[c] = 0;
            f.q[c] = 0;
        }
        sums[0] += residual.total();
        sums[1] += norm.total();
    }
};

struct StartIterations
{
    static constexpr const char* name = "pressureScalars";
    static constexpr double small = 1e-20;      // as OpenFOAM's
    CgState* state;

    HD void operator()(const double* sums) const
    {
        state->normFactor = sums[1] + small;
        state->initial = state->residual = sums[0]/state->normFactor;
        state->rz = state->alpha = state->beta = 0;
        state->iterations = 0;
        state->decide();
    }
};

template<int D>
struct DotPreconditioned
{
    static constexpr const char* name = "pressureDotZ";
    FineData<D> f;
    TiledCells<D> cells;

    HD void add(int i, double* sums) const
    {
        Place<D> c;
        if (!cells.at(i, c)) return;
        const double z = f.z[c.c];
        sums[0] += z*f.r[c.c];
        sums[1] += z*f.q[c.c];
    }

    HD void addRow(const Place<D>& first, double* sums) const
    {
        RowSum zr, zq;
        INDEPENDENT
        for (int k = 0; k < rowCells; ++k)
        {
            const double z = f.z[first.c + k];
            zr.part[k] = z*f.r[first.c + k];
            zq.part[k] = z*f.q[first.c + k];
        }
        sums[0] += zr.total();
        sums[1] += zq.total();
    }
};

struct SetBeta
{
    static constexpr const char* name = "pressureScalars";
    CgState* state;

    HD void operator()(const double* sums) const
    {
        state->beta = state->rz != 0 ? -state->alpha*sums[1]/state->rz : 0;
        state->rz = sums[0];
    }
};

template<int D>
struct NewDirection
{
    static constexpr const char* name = "pressureDirection";
    FineData<D> f;
    TiledCells<D> cells;
    const CgState* state;

    HD void operator()(int i) const
    {
        Place<D> c;
        if (cells.at(i, c)) f.p[c.c] = f.z[c.c] + state->beta*f.p[c.c];
    }

    HD void row(const Place<D>& first) const
    {
        const double beta = state->beta;
        INDEPENDENT
        for (int k = 0; k < rowCells; ++k) f.p[first.c + k] = f.z[first.c + k] + beta*f.p[first.c + k];
    }
};

template<int D>
struct ApplyDirection
{
    static constexpr const char* name = "pressureApply";
    FineData<D> f;
    TiledCells<D> cells;

    HD void add(int i, double* sums) const
    {
        Place<D> c;
        if (!cells.at(i, c)) return;
        const double q = f.inverse[c.c] > 0 ? f.apply(c, f.p) : 0;
        f.q[c.c] = q;
        sums[0] += q*f.p[c.c];
    }

    HD void addRow(const Place<D>& first, double* sums) const
    {
        RowSum pq;
        f.applyRow(first, f.p, pq.part);
        INDEPENDENT
        for (int k = 0; k < rowCells; ++k)
        {
            const double q = pq.part[k];
            f.q[first.c + k] = q;
            pq.part[k] = q*f.p[first.c + k];
        }
        sums[0] += pq.total();
    }
};

struct SetAlpha
{
    static constexpr const char* name = "pressureScalars";
    CgState* state;

    HD void operator()(const double* sums) const { state->alpha = sums[0] != 0 ? state->rz/sums[0] : 0; }
};

template<int D>
struct Advance
{
    static constexpr const char* name = "pressureAdvance";
    FineData<D> f;
    TiledCells<D> cells;
    const CgState* state;

    HD void add(int i, double* sums) const
    {
        Place<D> c;
        if (!cells.at(i, c)) return;
        f.x[c.c] += state->alpha*f.p[c.c];
        const double r = f.r[c.c] - state->alpha*f.q[c.c];
        f.r[c.c] = r;
        f.b[c.c] = float(r);
        sums[0] += std::fabs(r);
    }

    HD void addRow(const Place<D>& first, double* sums) const
    {
        const double alpha = state->alpha;
        RowSum size;
        INDEPENDENT
        for (int k = 0; k < rowCells; ++k)
        {
            const int c = first.c + k;
            f.x[c] += alpha*f.p[c];
            const double r = f.r[c] - alpha*f.q[c];
            f.r[c] = r;
            f.b[c] = float(r);
            size.part[k] = std::fabs(r);
        }
        sums[0] += size.total();
    }
};

struct EndIteration
{
    static constexpr const char* name = "pressureScalars";
    CgState* state;

    HD void operator()(const double* sums) const
    {
        state->residual = sums[0]/state->normFactor;
        ++state->iterations;
        state->decide();
    }
};

} // namespace riprap

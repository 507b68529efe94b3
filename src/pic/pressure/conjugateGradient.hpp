/*  Conjugate gradients in double precision over the finest level, preconditioned by a V-cycle in
    single precision.

        z = B r,  w = A z, beta = -z.q/pq, pq = w.z + beta z.q, alpha = z.r/pq, p = z + beta p, q =
                  w + beta q, x += alpha p, r -= alpha q

    (q = A p by that of z, so that an iteration has two passes over the grid and sums twice; after
    Chronopoulos & Gear 1989, J. Comput. Appl. Math. 25, 153. beta makes p exactly conjugate to the
    one before: it is Polak's and Ribiere's, which forgives that B is not exactly linear in single
    precision. p.A p = w.z + beta z.q, since p_old.q_old = pq and z.q = -beta pq.) Residuals are
    OpenFOAM's: sum |b - A x| / sum(|A x - A xRef| + |b - A xRef|) with xRef the mean of the first
    guess, so that tolerances of fvSolution mean the same for every solver. The scalars live on the
    device.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cmath>
#include "core/loops/deviceLoop.hpp"
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
    double* rhs;            // from the first iteration on w
    double* x;
    double* r;
    double* p;
    double* q;
    float* inverse;         // > 0 where there is an unknown
    float* b;               // what the V-cycle takes
    const float* z;         // what it gives

    template<class V>
    HD double apply(const Place<D>& c, const V* values) const
    {
        const double v = values[c.c];
        double sum = s[c.c]*v;
        for (int d = 0; d < D; ++d)
        {
            const int below = shape.below(c, d), above = shape.above(c, d);
            sum += a[d][c.c]*(v - double(values[below])) + a[d][above]*(v - double(values[above]));
        }
        return sum;
    }

    //- The product for the cells of a row, 0 where there is no unknown
    template<class V>
    HD void applyRow(const Place<D>& first, const V* v, double* to) const
    {
        const RowNeighbours<D> by(shape, first);
        INDEPENDENT
        for (int k = 0; k < rowCells; ++k)
        {
            const int c = first.c + k;
            const double own = v[c];
            double sum = s[c]*own;
            for (int d = 0; d < D; ++d)
                sum += a[d][c]*(own - double(v[c + by.below[d]]))
                    + a[d][c + by.above[d]]*(own - double(v[c + by.above[d]]));
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
    double pq, alpha, beta;
    int iterations, again, cells;

    HD void decide()
    {
        const bool done = residual < tolerance || (relTol > 0 && residual < relTol*initial);
        // false for NaN
        again = ((!done || iterations < minIter) && iterations < maxIter && residual < 1e300) ? 1
                                                                                              : 0;
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
        const double ax = unknown ? f.apply(c, f.x) + (coupled ? f.q[c.c] : 0) : 0,
                     r = unknown ? f.rhs[c.c] - ax : 0;
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
            const double ax = product[k] + whole*f.q[c],
                         reference = (f.s[c] + whole*f.p[c])*xRef, rhs = f.rhs[c];
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
        state->pq = state->alpha = state->beta = 0;
        state->iterations = 0;
        state->decide();
    }
};

//- w of a cell, and what it adds to z.r, z.q, z.w
template<int D>
struct ApplyPreconditioned
{
    static constexpr const char* name = "pressureApply";
    FineData<D> f;
    TiledCells<D> cells;

    HD void add(int i, double* sums) const
    {
        Place<D> c;
        if (cells.at(i, c)) add(c, f.inverse[c.c] > 0 ? f.apply(c, f.z) : 0, sums);
    }

    HD void add(const Place<D>& c, double w, double* sums) const
    {
        const double z = f.z[c.c];
        f.rhs[c.c] = w;
        sums[0] += z*f.r[c.c];
        sums[1] += z*f.q[c.c];
        sums[2] += z*w;
    }

    HD void addRow(const Place<D>& first, double* sums) const
    {
        RowSum zw;
        f.applyRow(first, f.z, zw.part);
        addRow(first, zw, sums);
    }

    //- w: of the row's cells
    HD void addRow(const Place<D>& first, RowSum& w, double* sums) const
    {
        RowSum zr, zq;
        INDEPENDENT
        for (int k = 0; k < rowCells; ++k)
        {
            const int c = first.c + k;
            const double z = f.z[c];
            f.rhs[c] = w.part[k];
            zr.part[k] = z*f.r[c];
            zq.part[k] = z*f.q[c];
            w.part[k] *= z;
        }
        sums[0] += zr.total();
        sums[1] += zq.total();
        sums[2] += w.total();
    }
};

struct SetDirection
{
    static constexpr const char* name = "pressureScalars";
    CgState* state;

    HD void operator()(const double* sums) const
    {
        state->beta = state->pq != 0 ? -sums[1]/state->pq : 0;
        state->pq = sums[2] + state->beta*sums[1];
        state->alpha = state->pq != 0 ? sums[0]/state->pq : 0;
    }
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
        const double p = f.z[c.c] + state->beta*f.p[c.c], q = f.rhs[c.c] + state->beta*f.q[c.c];
        const double r = f.r[c.c] - state->alpha*q;
        f.p[c.c] = p;
        f.q[c.c] = q;
        f.x[c.c] += state->alpha*p;
        f.r[c.c] = r;
        f.b[c.c] = float(r);
        sums[0] += std::fabs(r);
    }

    HD void addRow(const Place<D>& first, double* sums) const
    {
        const double alpha = state->alpha, beta = state->beta;
        RowSum size;
        INDEPENDENT
        for (int k = 0; k < rowCells; ++k)
        {
            const int c = first.c + k;
            const double p = f.z[c] + beta*f.p[c], q = f.rhs[c] + beta*f.q[c], r = f.r[c] - alpha*q;
            f.p[c] = p;
            f.q[c] = q;
            f.x[c] += alpha*p;
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
    LoopCondition condition;

    HD void operator()(const double* sums) const
    {
        state->residual = sums[0]/state->normFactor;
        ++state->iterations;
        state->decide();
        condition.set(state->again);
    }
};

} // namespace riprap

/*  The pressure step by the simplest means, conjugate gradients with the diagonal as preconditioner, matrix-free: what better ones are tested against.

    Balance of a wet cell, divided by |S|: sum over faces of +-(a (u* - dt/(rho h theta) (p_above - p_below)) + (1 - a) w) = 0.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cmath>
#include "core/launch.hpp"
#include "pic/wetCells.hpp"

namespace riprap
{

//- dt/(rho h theta) of a face, 0 if no wet cell is there; which cells are wet
template<int D, class R>
struct PressureFace
{
    int low, high;              // cells, -1 beyond the block
    bool wetLow, wetHigh;
    double factor;              // of (p_high - p_low), dry p = 0

    HD PressureFace(const PressureFields<D, R>& f, const unsigned char* wet, int d, const typename UniformGrid<D>::Index& at)
    {
        low = f.grid.cellOf(d, at, 0);
        high = f.grid.cellOf(d, at, 1);
        wetLow = low >= 0 && wet[low];
        wetHigh = high >= 0 && wet[high];
        factor = 0;
        if (!(wetLow || wetHigh)) return;
        double theta = 1;
        if (low < 0 || high < 0) theta = 0.5;                   // the atmosphere begins at the face
        else if (wetLow != wetHigh)
        {
            const double water = f.phi[wetLow ? low : high], air = f.phi[wetLow ? high : low];
            theta = air > 0 ? water/(water - air) : 1;          // a dry cell in a wall is no surface
            theta = theta < smallestTheta ? smallestTheta : theta;
        }
        factor = f.timeStep/(f.density*f.grid.h*theta);
    }
};

template<int D, class R>
struct PressureRow
{
    PressureFields<D, R> fields;
    const unsigned char* wet;

    //- f(aperture, factor, other cell or -1, sign of the face's direction, face) over the faces of a cell
    template<class F>
    HD void forEachFace(int i, const F& f) const
    {
        const auto& g = fields.grid;
        const typename UniformGrid<D>::Index c = g.cellIndex(i);
        for (int d = 0; d < D; ++d)
            for (int side = 0; side < 2; ++side)
            {
                typename UniformGrid<D>::Index at = c;
                at.c[d] += side;
                const PressureFace<D, R> face(fields, wet, d, at);
                const int other = side ? face.high : face.low;
                const bool wetOther = side ? face.wetHigh : face.wetLow;
                const int index = g.face(d, at);
                f(double(fields.aperture[d][index]), face.factor, wetOther ? other : -1, side ? 1 : -1, d, index);
            }
    }
};

template<int D, class R>
struct PressureStart : PressureRow<D, R>
{
    static constexpr const char* name = "pressureStart";
    double* diagonal;
    double* residual;           // rhs - A p

    HD void operator()(int i) const
    {
        diagonal[i] = residual[i] = 0;
        if (!this->wet[i]) { this->fields.p[i] = 0; return; }
        double sum = 0, r = 0;
        this->forEachFace(i, [&](double a, double factor, int other, int sign, int d, int face)
        {
            const R* w = this->fields.wallVelocity[d];
            sum += a*factor;
            r -= sign*(a*double(this->fields.u[d][face]) + (w ? (1 - a)*double(w[face]) : 0.0));
            r -= a*factor*(this->fields.p[i] - (other >= 0 ? this->fields.p[other] : 0.0));
        });
        diagonal[i] = sum;
        residual[i] = r;
    }
};

template<int D, class R>
struct PressureApply : PressureRow<D, R>
{
    static constexpr const char* name = "pressureApply";
    const double* x;
    double* y;

    HD void operator()(int i) const
    {
        double sum = 0;
        if (this->wet[i])
            this->forEachFace(i, [&](double a, double factor, int other, int, int, int) { sum += a*factor*(x[i] - (other >= 0 ? x[other] : 0.0)); });
        y[i] = sum;
    }
};

struct PressureDots
{
    static constexpr const char* name = "pressureDots";
    const double* a;
    const double* b;
    const double* diagonal;     // divides b; nullptr: 1
    HD void add(int i, double* sums) const
    {
        const double c = diagonal ? (diagonal[i] > 0 ? b[i]/diagonal[i] : 0) : b[i];
        sums[0] += a[i]*c;
        sums[1] += fabs(a[i]);
    }
};

//- y = x + s y, or with a diagonal y = x/diagonal + s y
struct PressureCombine
{
    static constexpr const char* name = "pressureCombine";
    const double* x;
    const double* diagonal;
    double s, t;                // y = t x + s y
    double* y;
    HD void operator()(int i) const { y[i] = t*(diagonal ? (diagonal[i] > 0 ? x[i]/diagonal[i] : 0) : x[i]) + s*y[i]; }
};

template<int D, class R>
struct PressureCorrect
{
    static constexpr const char* name = "pressureCorrect";
    PressureFields<D, R> fields;
    const unsigned char* wet;
    int component;

    HD void operator()(int i) const
    {
        if (!(fields.aperture[component][i] > R(0))) return;
        const PressureFace<D, R> face(fields, wet, component, fields.grid.faceIndex(component, i));
        if (!(face.factor > 0)) return;
        const double low = face.wetLow ? fields.p[face.low] : 0, high = face.wetHigh ? fields.p[face.high] : 0;
        fields.u[component][i] = R(double(fields.u[component][i]) - face.factor*(high - low));
    }
};

template<class Backend, int D, class R>
class ReferencePressure
{
public:

    double tolerance = 1e-12;   // of the sum of |rhs| when p = 0
    int mostIterations = 20000;

    PressureReport project(Context<Backend>& context, const PressureFields<D, R>& fields, const unsigned char* wet)
    {
        const int n = fields.grid.cells();
        for (Array<Backend, double>* a : {&diagonal_, &residual_, &direction_, &image_}) a->allocate(context, n);
        double *r = residual_.data(), *d = direction_.data(), *q = image_.data();
        const double* diagonal = diagonal_.data();
        const PressureRow<D, R> row{fields, wet};
        PressureReport report;
        report.solver = "PCG";
        forEach(context, n, PressureStart<D, R>{row, diagonal_.data(), r});
        context.zero(d, n*sizeof(double));
        double rz = 0, scale = 0;
        for (;; ++report.iterations)
        {
            const auto dots = sumOver<2>(context, n, PressureDots{r, r, diagonal});
            if (report.iterations == 0) { scale = dots[1]; report.initialResidual = scale > 0 ? 1 : 0; }
            report.finalResidual = scale > 0 ? dots[1]/scale : 0;
            if (!(dots[1] > tolerance*scale) || !(dots[0] > 0)) break;
            if (report.iterations == mostIterations) { report.converged = false; break; }
            forEach(context, n, PressureCombine{r, diagonal, rz > 0 ? dots[0]/rz : 0, 1, d});
            rz = dots[0];
            forEach(context, n, PressureApply<D, R>{row, d, q});
            const double step = rz/sumOver<2>(context, n, PressureDots{d, q, nullptr})[0];
            forEach(context, n, PressureCombine{d, nullptr, 1, step, fields.p});
            forEach(context, n, PressureCombine{q, nullptr, 1, -step, r});
        }
        for (int c = 0; c < D; ++c) forEach(context, fields.grid.faces(c), PressureCorrect<D, R>{fields, wet, c});
        return report;
    }

private:
    Array<Backend, double> diagonal_, residual_, direction_, image_;
};

} // namespace riprap

/*  Between the levels of the multigrid: a coarse cell is 2^D fine ones.

    Corrections are piecewise constant, residuals are summed (R = P^T). Coefficients of a coarse
    face: half the sum of its fine ones (half, because the correction has half the slope that it
    should have); of ties to p = 0: the full sum.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/loops/deterministicAtomics.hpp"
#include "pic/pressure/level.hpp"

namespace riprap
{

//- Fine cells of a coarse one: f(place) for each that exists
template<int D, class F>
HD void eachChild(const GridShape<D>& fine, const Place<D>& coarse, const F& f)
{
    for (int o = 0; o < (1 << D); ++o)
    {
        Place<D> p;
        p.c = 0;
        bool in = true;
        for (int d = 0; d < D; ++d)
        {
            p.x[d] = 2*coarse.x[d] + (o >> d & 1);
            p.c += p.x[d]*fine.stride[d];
            in = in && p.x[d] < fine.n[d];
        }
        if (in) f(p, o);
    }
}

//- Coefficients of a coarse level from the next finer one; tileFlag: of the coarse level's tiles,
//  nullptr if it has none
template<int D>
struct Coarsen
{
    static constexpr const char* name = "pressureCoarsen";
    static constexpr float half = 0.5f;
    LevelData<D> fine, coarse;
    // colours clash around an odd ring: it is cut for the preconditioner
    bool oddPeriodic[D];
    int* tileFlag;

    HD void operator()(int i) const { cell(coarse.shape.place(i)); }

    HD void cell(const Place<D>& c) const
    {
        const int i = c.c;
        float lower[D], upper[D], s = 0;
        for (int d = 0; d < D; ++d) lower[d] = upper[d] = 0;
        if (coarse.shape.inside(c))
            eachChild(fine.shape, c, [&](const Place<D>& p, int o)
            {
                s += fine.s[p.c];
                for (int d = 0; d < D; ++d)
                {
                    const bool top = p.x[d] == fine.shape.n[d] - 1;
                    if (!(o >> d & 1)) lower[d] += fine.a[d][p.c];
                    if ((o >> d & 1) || top) upper[d] += fine.a[d][fine.shape.above(p, d)];
                }
            });
        float sum = s;
        for (int d = 0; d < D; ++d)
        {
            if (oddPeriodic[d] && c.x[d] == 0) lower[d] = 0;
            if (oddPeriodic[d] && c.x[d] == coarse.shape.n[d] - 1) upper[d] = 0;
            coarse.a[d][i] = half*lower[d];
            sum += half*(lower[d] + upper[d]);
        }
        coarse.s[i] = s;
        coarse.inverse[i] = sum > 0 ? 1/sum : 0.0f;
        // also where no pass comes: products with a coefficient of zero must be zero
        coarse.x[i] = 0;
        if (sum > 0 && tileFlag) raise(tileFlag + coarse.shape.tileOf(c));
    }
};

//- Right-hand side of a coarse level: residuals of the fine one, whose black cells have just been
//  relaxed and have none
template<int D, class Cells>
struct RestrictResidual
{
    static constexpr const char* name = "pressureRestrict";
    LevelData<D> fine, coarse;
    Cells cells;        // of the coarse level

    HD void operator()(int i) const
    {
        Place<D> c;
        if (!cells.at(i, c)) return;
        float sum = 0;
        if (coarse.inverse[c.c] > 0)
            eachChild(fine.shape, c, [&](const Place<D>& p, int o)
            {
                const bool red = ((o ^ o >> 1 ^ o >> 2) & 1) == 0;
                if (red && fine.inverse[p.c] > 0) sum += fine.residual(p);
            });
        coarse.b[c.c] = sum;
    }
};

//- The same, row by row of the coarse level: the residuals of a pair of fine cells side by side are
//  those of a red one and nothing. Not for rings
template<int D, class Cells>
struct RestrictRow
{
    static constexpr const char* name = "pressureRestrict";
    static constexpr int most = 64;
    LevelData<D> fine, coarse;
    Cells cells;        // of the coarse level

    HD void operator()(int i) const
    {
        Place<D> c;
        if (!cells.row(i, c)) return;
        // of which the fine level has cells
        const int length = cells.rowLength(), stored = fine.shape.size[0]/2 - c.x[0];
        for (int from = 0; from < length; from += most)
        {
            Place<D> begin = c;
            begin.c += from;
            begin.x[0] += from;
            const int count = length - from < most ? length - from : most,
                      has = stored - from < count ? stored - from : count;
            add(begin, count, has < 0 ? 0 : has);
        }
    }

private:

    HD void add(const Place<D>& c, int count, int has) const
    {
        float sum[most];
        for (int k = 0; k < most; ++k) sum[k] = 0;
        for (int o = 0; o < (1 << D); o += 2)       // rows of children
        {
            Place<D> p;
            p.x[0] = 2*c.x[0];
            p.c = p.x[0];
            bool in = true;
            for (int d = 1; d < D; ++d)
            {
                p.x[d] = 2*c.x[d] + (o >> d & 1);
                p.c += p.x[d]*fine.shape.stride[d];
                in = in && p.x[d] < fine.shape.n[d];
            }
            if (in) addRow(p, has, sum);
        }
        INDEPENDENT
        for (int k = 0; k < count; ++k)
            coarse.b[c.c + k] = coarse.inverse[c.c + k] > 0 ? sum[k] : 0.0f;
    }

    HD void addRow(const Place<D>& p, int has, float* sum) const
    {
        const RowNeighbours<D> to(fine.shape, p);
        float residual[2*most];
        INDEPENDENT
        for (int k = 0; k < 2*has; ++k)
        {
            const int c = p.c + k;
            const float x = fine.x[c];
            float all = 0;
            for (int d = 0; d < D; ++d)
                all += fine.a[d][c]*(x - fine.x[c + to.below[d]])
                    + fine.a[d][c + to.above[d]]*(x - fine.x[c + to.above[d]]);
            residual[k] = fine.b[c] - all - fine.s[c]*x;
        }
        INDEPENDENT
        for (int k = 0; k < 2*has; ++k)
            residual[k] = fine.inverse[p.c + k] > 0 ? residual[k] : 0.0f;
        const float* red = residual + oddRow(p, 0);
        INDEPENDENT
        for (int k = 0; k < has; ++k) sum[k] += red[2*k];
    }
};

//- Black sweep that sees the red cells corrected from the coarse level. They themselves need not
//  be: the red sweep that follows reads black cells alone
template<int D, class Cells>
struct ProlongSweep
{
    static constexpr const char* name = "pressureProlong";
    LevelData<D> fine, coarse;
    Cells cells;        // of the fine level

    HD void operator()(int i) const
    {
        Place<D> p;
        if (!cells.half(i, 1, p)) return;
        const float inverse = fine.inverse[p.c];
        if (!(inverse > 0)) return;
        float sum = fine.b[p.c];
        for (int d = 0; d < D; ++d)
        {
            const int below = fine.shape.below(p, d), above = fine.shape.above(p, d);
            sum += fine.a[d][p.c]
                *(fine.x[below]
                    + correction(
                        p, d, p.x[d] == 0 ? wrapped(p, d, fine.shape.n[d] - 1) : p.x[d] - 1));
            sum += fine.a[d][above]
                *(fine.x[above]
                    + correction(
                        p, d, p.x[d] == fine.shape.n[d] - 1 ? wrapped(p, d, 0) : p.x[d] + 1));
        }
        fine.x[p.c] = sum*inverse;
    }

private:

    //- The index around the ring; where there is none the coefficient is zero, and the own cell
    //  will do
    HD int wrapped(const Place<D>& p, int d, int other) const
    {
        return fine.shape.first[d] > 0 ? other : p.x[d];
    }

    //- Of the coarse cell that holds index x along d, other indices as p's
    HD float correction(const Place<D>& p, int d, int x) const
    {
        int c = 0;
        for (int e = 0; e < D; ++e) c += ((e == d ? x : p.x[e]) >> 1)*coarse.shape.stride[e];
        return coarse.x[c];
    }
};

//- The same, row by row. Not for rings
template<int D, class Cells>
struct ProlongRow
{
    static constexpr const char* name = "pressureProlong";
    static constexpr int length = Cells::rowCells;
    LevelData<D> fine, coarse;
    Cells cells;        // of the fine level

    HD void operator()(int i) const
    {
        Place<D> p;
        if (!cells.row(i, p)) return;
        const GridShape<D>& shape = fine.shape;
        const RowNeighbours<D> to(shape, p);
        // corrected: the row with a cell more at either end, and those beside it
        float own[length + 2], beside[2*D][length];
        correct(p, p.c, own + 1);
        own[0] = p.x[0] > 0 ? fine.x[p.c - 1] + coarse.x[under(p, 0, p.x[0] - 1)] : 0.0f;
        own[length + 1] = p.x[0] + length < shape.n[0]
            ? fine.x[p.c + length] + coarse.x[under(p, 0, p.x[0] + length)]
            : 0.0f;
        for (int d = 1; d < D; ++d)
            for (int side = 0; side < 2; ++side)
            {
                Place<D> row = p;
                const bool end = p.x[d] == (side ? shape.n[d] - 1 : 0);
                if (!end) row.x[d] += side ? 1 : -1;
                else if (shape.first[d] > 0) row.x[d] = side ? 0 : shape.n[d] - 1;
                correct(row, p.c + (side ? to.above[d] : to.below[d]), beside[2*d + side]);
            }
        const int odd = oddRow(p, 1);
        float relaxed[length];
        INDEPENDENT
        for (int k = 0; k < length; ++k)
        {
            const int c = p.c + k;
            float sum = fine.b[c];
            sum += fine.a[0][c]*own[k];
            sum += fine.a[0][c + 1]*own[k + 2];
            for (int d = 1; d < D; ++d)
            {
                sum += fine.a[d][c]*beside[2*d][k];
                sum += fine.a[d][c + to.above[d]]*beside[2*d + 1][k];
            }
            relaxed[k] = sum*fine.inverse[c];
        }
        INDEPENDENT
        for (int k = 0; k < length; ++k)
        {
            const float before = fine.x[p.c + k];
            fine.x[p.c + k] = (k & 1) == odd ? relaxed[k] : before;
        }
    }

private:

    //- The coarse cell that holds index x along d, other indices as p's
    HD int under(const Place<D>& p, int d, int x) const
    {
        int c = 0;
        for (int e = 0; e < D; ++e) c += ((e == d ? x : p.x[e]) >> 1)*coarse.shape.stride[e];
        return c;
    }

    //- A row of the fine level from number c on, where p tells what lies over it
    HD void correct(const Place<D>& p, int c, float* to) const
    {
        const float* over = coarse.x + under(p, 0, p.x[0]);
        const float* x = fine.x + c;
        INDEPENDENT
        for (int k = 0; k < length/2; ++k)
        {
            to[2*k] = x[2*k] + over[k];
            to[2*k + 1] = x[2*k + 1] + over[k];
        }
    }
};

} // namespace riprap

/*  Between the levels of the multigrid: a coarse cell is 2^D fine ones.

    Corrections are piecewise constant, residuals are summed (R = P^T). Coefficients of a coarse face: half the sum of its fine
    ones (half, because the correction has half the slope that it should have); of ties to p = 0: the full sum.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/sharedWrites.hpp"
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

//- Coefficients of a coarse level from the next finer one; tileFlag: of the coarse level's tiles, nullptr if it has none
template<int D>
struct Coarsen
{
    static constexpr const char* name = "pressureCoarsen";
    static constexpr float half = 0.5f;
    LevelData<D> fine, coarse;
    bool oddPeriodic[D];        // colours clash around an odd ring: it is cut for the preconditioner
    int* tileFlag;

    HD void operator()(int i) const
    {
        const Place<D> c = coarse.shape.place(i);
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
        coarse.x[i] = 0;        // also where no pass comes: products with a coefficient of zero must be zero
        if (sum > 0 && tileFlag) raise(tileFlag + coarse.shape.tileOf(c));
    }
};

//- Right-hand side of a coarse level: residuals of the fine one, whose black cells have just been relaxed and have none
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

//- Black sweep that sees the red cells corrected from the coarse level. They themselves need not be: the red sweep that follows
//  reads black cells alone
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
            sum += fine.a[d][p.c]*(fine.x[below] + correction(p, d, p.x[d] == 0 ? wrapped(p, d, fine.shape.n[d] - 1) : p.x[d] - 1));
            sum += fine.a[d][above]*(fine.x[above] + correction(p, d, p.x[d] == fine.shape.n[d] - 1 ? wrapped(p, d, 0) : p.x[d] + 1));
        }
        fine.x[p.c] = sum*inverse;
    }

private:

    //- The index around the ring; where there is none the coefficient is zero, and the own cell will do
    HD int wrapped(const Place<D>& p, int d, int other) const { return fine.shape.first[d] > 0 ? other : p.x[d]; }

    //- Of the coarse cell that holds index x along d, other indices as p's
    HD float correction(const Place<D>& p, int d, int x) const
    {
        int c = 0;
        for (int e = 0; e < D; ++e) c += ((e == d ? x : p.x[e]) >> 1)*coarse.shape.stride[e];
        return coarse.x[c];
    }
};

} // namespace riprap

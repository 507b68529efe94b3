/*  Bodies' shares of faces at the surface of the water.

    Between a wet cell and a dry one the water of a face ends at the surface, at the fraction theta
    of the way (ghost fluid: pic/pressure/assemble.hpp), and the pressure of the wet cell acts on
    what bodies have of that part of the volume. With their share of the whole volume a deck that
    lies between the surface and the next cell would bear water that is not there, and a bottom that
    dips in would feel water before it reaches it: up to a quarter of a cell's depth. Of shapes of
    their own alone: they have flat sides.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/bodies/bodyShares.hpp"
#include "pic/pressure/assemble.hpp"

namespace riprap
{

//- Of the volume of a face that is not at an end of the grid: what lies in water; false: all of it
//  or nothing
template<int D, class R>
HD bool wetPart(const UniformGrid<D>& g, const R* phi, int d,
    const typename UniformGrid<D>::Index& face, AlongFace& part)
{
    const int lower = g.cellOf(d, face, 0), upper = g.cellOf(d, face, 1);
    if (lower < 0 || upper < 0) return false;
    const R surface = R(-wetDepth*g.h);
    const bool wetLower = phi[lower] < surface, wetUpper = phi[upper] < surface;
    if (wetLower == wetUpper) return false;
    const double theta = wetLower ? surfaceTheta(phi[lower], phi[upper])
                                  : surfaceTheta(phi[upper], phi[lower]);
    if (!(theta < 1)) return false;
    if (wetLower) part.to = part.from + theta;
    else part.from = part.to - theta;
    return true;
}

//- Shares of what is under water, and what they leave open, of faces on which a body has a shape of
//  its own
template<int D, class R>
struct CutToWater
{
    static constexpr const char* name = "cutToWater";
    CloseByBodies<D, R> close;
    const R* phi;

    HD void operator()(int q) const
    {
        close.sorted.onceAFace(q, [&](int d, int face, int end)
        {
            const UniformGrid<D>& g = close.blocks.grid;
            bool own = false;
            for (int s = q; s < end; ++s) own = own || close.shapeOf(s).lattice();
            AlongFace part;
            const typename UniformGrid<D>::Index f = g.faceIndex(d, face);
            if (!own || !wetPart(g, phi, d, f, part)) return;
            for (int s = q; s < end; ++s)
            {
                const int number = int(close.sorted.number[s]);
                close.share[number] = measureShare(
                    close.blocks, close.body[number], d, f, part, close.arm[number]);
            }
            close(d, face, q, end);
        });
    }
};

//- What the cut has made of shares and faces, kept; or put back
template<int D, class R>
struct KeepShares
{
    static constexpr const char* name = "keepShares";
    SortedShares<D> sorted;
    R* aperture[D];
    double* share;
    Vec<D, double>* arm;
    double* keptAperture;       // of a face, where its first share is
    double* keptShare;
    Vec<D, double>* keptArm;
    bool back;

    HD void operator()(int q) const
    {
        sorted.onceAFace(q, [&](int d, int face, int end)
        {
            if (back) aperture[d][face] = R(keptAperture[q]);
            else keptAperture[q] = double(aperture[d][face]);
            for (int s = q; s < end; ++s)
            {
                const int number = int(sorted.number[s]);
                exchange(share[number], keptShare[number]);
                exchange(arm[number], keptArm[number]);
            }
        });
    }

private:
    template<class T> HD void exchange(T& now, T& kept) const
    {
        if (back) now = kept;
        else kept = now;
    }
};

} // namespace riprap

/*  The surface and the particles that a run begins with, on the host.

    A cloud's particle stands for a box of its spacing; the boxes' parts of each cell are its fill
    alpha. phi is (1/2 - alpha) h in cells that are part filled, the distance from there elsewhere,
    and is moved until the cut cells' parts are alpha. Where cells are seeded, each gets m^D
    particles, one at a place of its own in each of m^D equal parts of the cell, where phi < 0.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>
#include "pic/surface/advectLevelSet.hpp"
#include "pic/surface/redistance.hpp"
#include "pic/surface/waterVolume.hpp"

namespace riprap
{

//- Fills that differ less than this from an empty or a full cell are taken for one
static constexpr double wholeCell = 0.04;

//- Parts of cells that boxes of edge `spacing` about the points fill, 0 .. 1; positions above the
//  block's corner, D a point
template<int D>
std::vector<double> fillOfBoxes(
    const UniformGrid<D>& g, const std::vector<double>& x, double spacing)
{
    std::vector<double> fill(g.cells(), 0.0);
    const double half = 0.5*spacing/g.h;
    for (std::size_t p = 0; p < x.size()/D; ++p)
    {
        int low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
        double s[D];
        for (int d = 0; d < D; ++d)
        {
            s[d] = x[p*D + d]/g.h;
            low[d] = floorInt(s[d] - half);
            high[d] = floorInt(s[d] + half);
        }
        typename UniformGrid<D>::Index c{{0, 0, 0}};
        for (c.c[2] = low[2]; c.c[2] <= high[2]; ++c.c[2])
            for (c.c[1] = low[1]; c.c[1] <= high[1]; ++c.c[1])
                for (c.c[0] = low[0]; c.c[0] <= high[0]; ++c.c[0])
                {
                    double part = 1;
                    typename UniformGrid<D>::Index at = c;
                    for (int d = 0; d < D; ++d)
                    {
                        part *= std::max(0.0,
                            std::min(s[d] + half, c.c[d] + 1.0)
                                - std::max(s[d] - half, double(c.c[d])));
                        at.c[d] = evenNode(g, d, c.c[d]);
                    }
                    fill[g.cell(at)] += part;
                }
    }
    for (double& f : fill)
    {
        // a lattice that was stretched to fit has slits, which are no surface
        if (f > 1 - wholeCell) f = 1;
        if (f < wholeCell) f = 0;
    }
    return fill;
}

//- phi of full and empty cells from their neighbours: a full one beside an empty one is half a cell
//  from the surface, one beside a part filled one a cell further than that, those behind them
//  another cell, so that slopes at the surface come out right; all others are far
template<int D, class R>
void surroundParts(
    const UniformGrid<D>& g, const std::vector<double>& fill, std::vector<R>& phi, R band)
{
    const auto part = [&](int i) { return fill[i] > 0 && fill[i] < 1; };
    #pragma omp parallel for
    for (int i = 0; i < g.cells(); ++i)
    {
        if (part(i)) continue;
        const R sign = fill[i] > 0 ? R(-1) : R(1), h = R(g.h);
        R distance = band;
        for (int d = 0; d < D; ++d)
            for (int offset = -1; offset <= 1; offset += 2)
            {
                const int j = g.neighbour(g.cellIndex(i), d, offset);
                if (j < 0) continue;
                if (part(j)) distance = std::min(distance, std::max(h + sign*phi[j], R(0)));
                else if ((fill[j] > 0) != (fill[i] > 0)) distance = std::min(distance, h/2);
            }
        phi[i] = sign*distance;
    }
    const std::vector<R> ring(phi);
    #pragma omp parallel for
    for (int i = 0; i < g.cells(); ++i)
    {
        if (part(i) || absolute(ring[i]) < band) continue;
        R distance = band;
        for (int d = 0; d < D; ++d)
            for (int offset = -1; offset <= 1; offset += 2)
            {
                const int j = g.neighbour(g.cellIndex(i), d, offset);
                if (j >= 0) distance = std::min(distance, absolute(ring[j]) + R(g.h));
            }
        phi[i] = ring[i] < 0 ? -distance : distance;
    }
}

//- phi of a fill
template<int D, class R>
std::vector<R> surfaceOf(const UniformGrid<D>& g, const std::vector<double>& fill, R band)
{
    constexpr int sweeps = 20;
    const int n = g.cells();
    std::vector<R> carried(n), phi(n), next(n);
    for (int i = 0; i < n; ++i) carried[i] = R((0.5 - fill[i])*g.h);
    const bool parts = std::any_of(
        fill.begin(), fill.end(), [](double f) { return f > 0 && f < 1; });
    for (int sweep = 0;; ++sweep)
    {
        surroundParts(g, fill, carried, band);
        #pragma omp parallel for
        for (int i = 0; i < n; ++i) StartDistance<D, R>{g, carried.data(), phi.data(), band}(i);
        for (int pass = 0; pass < int(band/R(g.h)) + 2; ++pass)
        {
            #pragma omp parallel for
            for (int i = 0; i < n; ++i)
                SpreadDistance<D, R>{g, carried.data(), phi.data(), next.data(), band}(i);
            phi.swap(next);
        }
        if (sweep == sweeps || !parts) return phi;
        // towards the phi whose cut cells hold the fill
        #pragma omp parallel for
        for (int i = 0; i < n; ++i)
            if (fill[i] > 0 && fill[i] < 1)
                carried[i] = phi[i] + R(0.5*(waterFraction(g, phi.data(), i, 0) - fill[i])*g.h);
    }
}

//- A number in 0 .. 1 that looks random and depends on the key alone (SplitMix64)
inline double scattered(std::uint64_t key)
{
    key += 0x9e3779b97f4a7c15ull;
    key = (key ^ (key >> 30))*0xbf58476d1ce4e5b9ull;
    key = (key ^ (key >> 27))*0x94d049bb133111ebull;
    return double((key ^ (key >> 31)) >> 11)/9007199254740992.0;
}

//- Particles of the cells, D coordinates each. jitter 0: at the middle of each part; 1: anywhere in
//  it
template<int D, class R>
std::vector<double> seeds(const UniformGrid<D>& g, const R* phi, int perDirection, double jitter)
{
    std::vector<double> x;
    const int parts = D == 2 ? perDirection*perDirection : perDirection*perDirection*perDirection;
    for (int i = 0; i < g.cells(); ++i)
    {
        if (phi[i] > R(g.h)) continue;
        const typename UniformGrid<D>::Index c = g.cellIndex(i);
        for (int part = 0; part < parts; ++part)
        {
            Vec<D, double> at;
            int rest = part;
            for (int d = 0; d < D; ++d)
            {
                const double off = jitter*(scattered((std::uint64_t(i)*parts + part)*D + d) - 0.5);
                at.c[d] = g.h*(c.c[d] + (rest % perDirection + 0.5 + off)/perDirection);
                rest /= perDirection;
            }
            // is the middle of the part in the water? So that the number does not depend on the
            // jitter
            Vec<D, double> middle;
            rest = part;
            for (int d = 0; d < D; ++d)
            {
                middle.c[d] = g.h*(c.c[d] + (rest % perDirection + 0.5)/perDirection);
                rest /= perDirection;
            }
            // a hair, so that rounding does not tell between the parts of a row that lies on the
            // surface
            if (sampleCell<1>(g, phi, middle) < R(-1e-3*g.h))
                for (int d = 0; d < D; ++d) x.push_back(at.c[d]);
        }
    }
    return x;
}

} // namespace riprap

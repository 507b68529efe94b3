/*  Views of the particles of PIC: positions above the block's lower corner [m], velocities, the
    affine part where they keep it, and what a transfer remembers.

    Particles stand in the order of the cells that they are in; `start` tells where each cell
    begins.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstdint>
#include "pic/grid/inCell.hpp"

namespace riprap
{

//- Reals that a transfer's formula may remember of a component
static constexpr int mostMemory = 2;

template<int D, class R>
struct PicParticles
{
    int count;
    double* x[D];
    R* v[D];
    // row d: gradient of component d [1/s]; nullptr: particles keep none
    R* affine[D*D];
    // of the transfer's formula, the same number for each component; nullptr from the first that
    // there is not
    R* memory[D*mostMemory];
    std::int32_t* id;
    const PlaceInCell<R>* place;
    const int* start;           // cells + 1 entries; particles from start[cells] on are outside

    HD Vec<D, double> position(int i) const
    {
        Vec<D, double> at;
        for (int d = 0; d < D; ++d) at.c[d] = x[d][i];
        return at;
    }
};

//- The cell of a point; one more than there are: it is in none
template<int D, class R>
HD std::uint32_t cellKey(const UniformGrid<D>& grid, double inverse, const Vec<D, double>& x)
{
    const InCell<D, R> at(grid, inverse, x);
    bool inside = true;
    for (int d = 0; d < D; ++d) inside = inside && at.c[d] >= 0 && at.c[d] < grid.n[d];
    return inside ? at.cell(grid) : grid.cells();
}

//- Sorts by the cell
template<int D, class R>
struct PicCellKeys
{
    static constexpr const char* name = "picKeys";
    UniformGrid<D> grid;
    PicParticles<D, R> particles;
    std::uint32_t* keys;
    std::uint32_t* indices;

    HD void operator()(int i) const
    {
        keys[i] = cellKey<D, R>(grid, 1/grid.h, particles.position(i));
        indices[i] = i;
    }
};

//- Particles into the order of their cells, with their places there
template<int D, class R>
struct PutInOrder
{
    static constexpr const char* name = "putInOrder";
    double inverse;             // 1/h
    const std::uint32_t* order;
    PicParticles<D, R> from, to;
    PlaceInCell<R>* place;

    HD void operator()(int i) const
    {
        if (from.affine[0]) put<true>(i);
        else put<false>(i);
    }

private:

    //- All is read before anything is written, so that a thread waits once
    template<bool Affine>
    HD void put(int i) const
    {
        const int j = int(order[i]);
        const Vec<D, double> x = from.position(j);
        R v[D], affine[Affine ? D*D : 1];
        UNROLL
        for (int d = 0; d < D; ++d) v[d] = from.v[d][j];
        if constexpr (Affine)
        {
            UNROLL
            for (int k = 0; k < D*D; ++k) affine[k] = from.affine[k][j];
        }
        const std::int32_t id = from.id[j];
        const InCell<D, R> at(inverse, x);
        PlaceInCell<R> p{};
        UNROLL
        for (int d = 0; d < D; ++d)
        {
            p.t[d] = at.t[d];
            to.x[d][i] = x.c[d];
            to.v[d][i] = v[d];
        }
        p.cell = R(at.c[0]);
        place[i] = p;
        if constexpr (Affine)
        {
            UNROLL
            for (int k = 0; k < D*D; ++k) to.affine[k][i] = affine[k];
        }
        for (int k = 0; k < D*mostMemory && from.memory[k]; ++k)
            to.memory[k][i] = from.memory[k][j];
        to.id[i] = id;
    }
};

} // namespace riprap

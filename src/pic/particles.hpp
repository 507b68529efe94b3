/*  Views of the particles of PIC: positions above the block's lower corner [m], velocities, and for APIC the affine part.

    Particles stand in the order of the cells that they are in; `start` tells where each cell begins.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstdint>
#include "pic/inCell.hpp"

namespace riprap
{

template<int D, class R>
struct PicParticles
{
    int count;
    double* x[D];
    R* v[D];
    R* affine[D*D];             // row d: gradient of component d [1/s]; nullptr unless APIC
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
        typename UniformGrid<D>::Index c{{0, 0, 0}};
        bool inside = true;
        for (int d = 0; d < D; ++d)
        {
            c.c[d] = floorInt(particles.x[d][i]/grid.h);
            inside = inside && c.c[d] >= 0 && c.c[d] < grid.n[d];
        }
        keys[i] = inside ? grid.cell(c) : grid.cells();
        indices[i] = i;
    }
};

//- After sorting
template<int D, class R>
struct PlaceInCells
{
    static constexpr const char* name = "placeInCells";
    UniformGrid<D> grid;
    PicParticles<D, R> particles;
    PlaceInCell<R>* place;

    HD void operator()(int i) const
    {
        const InCell<D, R> at(grid, particles.position(i));
        PlaceInCell<R> p{};
        for (int d = 0; d < D; ++d) p.t[d] = at.t[d];
        p.cell = R(at.c[0]);
        place[i] = p;
    }
};

} // namespace riprap

/*  The kernels of a rebuild: keys of particles, and their records in the new order.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/neighbours/cellGrid.hpp"
#include "sph/time/leapfrog.hpp"

namespace riprap
{

template<int D, class P>
struct FluidKeys
{
    static constexpr const char* name = "fluidKeys";

    Box<D, P> box;
    CellGrid<D, P> grid;
    FluidModel<D, P> model;
    std::int64_t* x[D];
    std::uint32_t* keys;
    std::uint32_t* indices;
    const std::int32_t* id;     // negative: it ran wild
    const int* active;          // those behind have left before
    ClockData* clock;

    HD void operator()(int i) const
    {
        // most have no larger one: those few that have raise it when they are placed
        if (i == 0) clock->foundH = float(model.h0);
        Vec<D, std::int64_t> p;
        Vec<D, typename P::real> r;
        for (int d = 0; d < D; ++d)
        {
            p.c[d] = x[d][i];
            r.c[d] = box.pairRelative(d, box.pairPosition(d, p.c[d]));
        }
        const bool in = i < *active && id[i] >= 0 && model.inside(box, p);
        keys[i] = in ? std::uint32_t(grid.cellOf(r)) : std::uint32_t(grid.cells);
        indices[i] = std::uint32_t(i);
    }
};

template<int D, class P>
struct WallKeys
{
    static constexpr const char* name = "wallKeys";

    Box<D, P> box;
    CellGrid<D, P> grid;
    std::int64_t* x[D];
    std::uint32_t* keys;
    std::uint32_t* indices;

    HD void operator()(int i) const
    {
        Vec<D, typename P::real> r;
        for (int d = 0; d < D; ++d) r.c[d] = box.pairRelative(d, box.pairPosition(d, x[d][i]));
        keys[i] = std::uint32_t(grid.cellOf(r));
        indices[i] = std::uint32_t(i);
    }
};

//- Fluid records from the state at hand, and the positions that the skin is measured from
template<class Backend, int D, class P>
struct PlaceFluid : Mover<Backend, D, P>
{
    using real = typename P::real;
    static constexpr const char* name = "placeFluid";

    HD void operator()(int i) const
    {
        if (i == 0) this->clock->search();
        if (i >= *this->count) return;
        const Vec<D, std::int64_t> x = this->position(i);
        Vec<D, real> v;
        [[maybe_unused]] Vec<D, typename P::position> p;
        for (int d = 0; d < D; ++d)
        {
            v.c[d] = this->fluid.v[d][i];
            p.c[d] = this->reference[d][i] = this->box.pairPosition(d, x.c[d]);
        }
        if (this->tookOut(i, v, this->fluid.deviation[i])) return;
        if constexpr (Backend::gpu) this->frames.include(this->box, p, v);
        [[maybe_unused]] const real h = this->record(i, x, v, this->fluid.deviation[i]);
        if (Backend::gpu && this->model.variableH) raiseTo(&this->clock->foundH, float(h));
    }
};

template<class Backend, int D, class P>
struct PlaceWalls
{
    static constexpr const char* name = "placeWalls";

    Box<D, P> box;
    std::int64_t* x[D];
    RecordsView<Backend, D, P> records;
    typename P::position* reference[D];     // null where walls are fixed
    LocalFrames<D, P> frames;

    HD void operator()(int i) const
    {
        Vec<D, typename P::position> p;
        for (int d = 0; d < D; ++d)
        {
            p.c[d] = box.pairPosition(d, x[d][i]);
            if (reference[d]) reference[d][i] = p.c[d];
        }
        records.storePosition(i, p);
        frames.includeStill(box, p);
    }
};

} // namespace riprap

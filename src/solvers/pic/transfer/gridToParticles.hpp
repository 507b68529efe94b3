/*  Grid to particles, by the scheme of the case. Compiled by units of its own
    (gridToParticlesCpu2.C ...), which alone know the schemes' types.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/grid/particles.hpp"
#include "pic/grid/tiles.hpp"
#include "solvers/pic/transfer/picTransfers.hpp"

namespace riprap
{

//- Particles, and what the step has made of the grid
template<int D, class R>
struct GridVelocities
{
    UniformGrid<D> grid;
    PicParticles<D, R> particles;
    const R* u[D];
    const R* du[D];
    const unsigned char* nearWater;         // cells (pic/grid/wetCells.hpp)
    R fall[D];                              // of particles without water about them [m/s]
    TileChoice<D> only;                     // particles there
    bool waited;                            // is du what they have waited for?
};

template<class Backend, int D, class R>
class GridToParticles
{
public:

    explicit GridToParticles(const PicConfig&);

    //- Do particles keep the gradient of the grid's velocity? How many reals else?
    bool gradient() const { return gradient_; }
    int memory() const { return D*card_.memory; }

    //- The longest step that the scheme bears [s]
    double longestStep() const { return card_.timeStep(numbers_); }

    //- Of states that were written: 0 without memory, else by the scheme
    int mark() const;

    //- occupied: tiles that have particles, of those chosen
    void take(Context<Backend>&, const GridVelocities<D, R>&, const TileList<D>& occupied,
        double dt) const;

    //- Particles from `first` on that have come in have the grid's velocity
    void enter(Context<Backend>&, const GridVelocities<D, R>&, int first, int count) const;

private:
    template<int Order, class Formula, class F>
    void run(const GridVelocities<D, R>&, const Formula&, const F&) const;

    int choice_, order_;
    TransferCard card_;
    TransferProperties numbers_;
    bool gradient_;
};

} // namespace riprap

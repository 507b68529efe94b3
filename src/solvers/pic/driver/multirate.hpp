/*  When particles of slow water wait, and what of a step is done for them: pic/multirate.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/pic/parts/picParts.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class Multirate
{
public:

    using real = typename P::real;

    explicit Multirate(PicParts<Backend, D, P>& parts) : p_(parts) {}

    void start();
    //- What a step has made of the grid; which particles have waited long enough
    void addStep(double dt);
    //- Particles are where the step has taken them, and not yet sorted
    void enterSlow();
    void endStep(double dt);

private:

    FindFastTiles<D, real> fast(double dt);

    PicParts<Backend, D, P>& p_;
};

template<class Backend, int D, class P>
void Multirate<Backend, D, P>::start()
{
    if (!p_.multirate()) return;
    const UniformGrid<D>& grid = p_.set.grid;
    const CellTiles<D> tiles(grid);
    std::vector<unsigned char> always;
    for (int d = 0; p_.opens() && d < D; ++d)
    {
        const std::vector<real> aperture = p_.walls.aperture[d].download();
        for (std::size_t i = 0; i < p_.openings.number[d].size(); ++i)
        {
            auto c = grid.faceIndex(d, int(i));
            const bool side = !grid.periodic[d] && (c.c[d] == 0 || c.c[d] == grid.n[d]);
            if (p_.openings.number[d][i] < 0 && !(side && aperture[i] > real(0))) continue;
            always.resize(tiles.count(), 0);
            c.c[d] = std::min(c.c[d], grid.n[d] - 1);
            always[tiles.of(c)] = 1;
        }
    }
    p_.slow.allocate(p_.set.context, grid, always);
}

//- Limit: at that speed a path of slowCourant cells takes an interval of such steps
template<class Backend, int D, class P>
FindFastTiles<D, typename P::real> Multirate<Backend, D, P>::fast(double dt)
{
    const PicConfig& config = p_.set.config;
    FindFastTiles<D, real> f{};
    f.start = p_.particles.sort.start();
    f.nearWater = p_.surface.near.data();
    for (int d = 0; d < D; ++d)
    {
        f.u[d] = p_.faces.carrying()[d].data();
        f.wallVelocity[d] = p_.walls.move ? p_.walls.velocity[d].data() : nullptr;
        f.aperture[d] = p_.walls.aperture[d].data();
        f.baseAperture[d] = p_.solids.bodies ? p_.cut.baseAperture[d].data() : nullptr;
    }
    f.limit = real(config.slowCourant*p_.set.grid.h/(config.slowInterval*dt));
    return f;
}

template<class Backend, int D, class P>
void Multirate<Backend, D, P>::addStep(double dt)
{
    if (!p_.multirate()) return;
    SlowTiles<Backend, D, real>& slow = p_.slow;
    ++slow.steps;
    slow.time += dt;
    if (!slow.any()) return;
    p_.rows.eachFace(p_.set.context,
        [&](int d)
        {
            return AddToInterval<real>{p_.faces.change[d].data(),
                p_.faces.carrying()[d].data(), slow.change[d].data(), slow.mean[d].data(),
                real(dt/slow.time)};
        });
    slow.wake(p_.set.context, fast(dt), slow.steps >= p_.set.config.slowInterval,
        p_.particles.sort);
}

template<class Backend, int D, class P>
void Multirate<Backend, D, P>::enterSlow()
{
    SlowTiles<Backend, D, real>& slow = p_.slow;
    if (!slow.any()) return;
    withSpline(p_.set.config.splineOrder, [&](auto order)
    {
        const TileChoice<D> waiting = slow.in(slowTile);
        EnterSlowTiles<decltype(order)::value, D, real> enter{
            p_.set.grid, waiting.tiles, p_.particles.view(), waiting.state, {}};
        for (int d = 0; d < D; ++d) enter.change[d] = slow.change[d].data();
        p_.rows.eachCell(p_.set.context, enter);
    });
}

template<class Backend, int D, class P>
void Multirate<Backend, D, P>::endStep(double dt)
{
    if (!p_.multirate()) return;
    SlowTiles<Backend, D, real>& slow = p_.slow;
    slow.endStep(p_.set.context);
    if (slow.steps >= p_.set.config.slowInterval)
        slow.choose(p_.set.context, fast(dt), p_.particles.sort);
}

} // namespace riprap

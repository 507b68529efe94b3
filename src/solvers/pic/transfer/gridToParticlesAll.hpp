/*  GridToParticles with the schemes' types, for the instantiating units.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/launch.hpp"
#include "pic/openings/openFaces.hpp"
#include "pic/transfer/cellLanes.hpp"
#include "pic/transfer/gridToParticle.hpp"
#include "solvers/pic/transfer/gridToParticles.hpp"
#include "solvers/pic/transfer/picFamilies.hpp"
#include "solvers/checkpointWords.hpp"

namespace riprap
{

template<class Backend, int D, class R>
GridToParticles<Backend, D, R>::GridToParticles(const PicConfig& c)
    : choice_(transferChoice(c)), order_(c.splineOrder), card_(transferOf(c)),
      numbers_(c.transferNumbers), gradient_(keepsGradient(card_, numbers_))
{}

template<class Backend, int D, class R>
int GridToParticles<Backend, D, R>::mark() const
{
    if (!memory()) return 0;
    std::vector<std::int32_t> letters;
    for (const char* c = card_.word; *c; ++c) letters.push_back(*c);
    return detail::checksum(letters, letters.size()) & 0x7fffff;
}

//- f(kernel), with and without places around which the nodes are no block
template<class Backend, int D, class R>
template<int Order, class Formula, class F>
void GridToParticles<Backend, D, R>::run(
    const GridVelocities<D, R>& v, const Formula& formula, const F& f) const
{
    const auto start = [&](auto around)
    {
        GridToParticle<Order, D, R, decltype(around)::value, Formula> k{};
        k.grid = v.grid;
        k.inverse = 1/v.grid.h;
        k.particles = v.particles;
        for (int d = 0; d < D; ++d)
        {
            k.u[d] = v.u[d];
            k.du[d] = v.du[d];
            k.fall[d] = v.fall[d];
        }
        k.nearWater = v.nearWater;
        k.formula = formula;
        k.affine = gradient_;
        k.only = v.only;
        k.waited = v.waited;
        f(k);
    };
    if (needsAround(v.grid, Order)) start(std::true_type());
    else start(std::false_type());
}

//- Cell by cell where the CPU has registers full of particles
template<class Backend, int Order, int D, class R, bool Around, class Formula>
void takeFromGrid(Context<Backend>& context,
    const GridToParticle<Order, D, R, Around, Formula>& kernel,
    const TileList<D>& occupied)
{
    if constexpr (!Backend::gpu && D == 2 && Order == 2)
        forEachRow(context, occupied.count, cellsOf(kernel, occupied.tiles, occupied.list));
    else forEach(context, kernel.particles.count, kernel);
}

template<class Backend, int D, class R>
void GridToParticles<Backend, D, R>::take(Context<Backend>& context, const GridVelocities<D, R>& v,
    const TileList<D>& occupied, double dt) const
{
    withTransfer(choice_, order_,
        [&](auto scheme, auto order)
        {
            run<decltype(order)::value>(v, scheme.template make<R>(numbers_, dt),
                [&](const auto& kernel) { takeFromGrid(context, kernel, occupied); });
        });
}

template<class Backend, int D, class R>
void GridToParticles<Backend, D, R>::enter(
    Context<Backend>& context, const GridVelocities<D, R>& v, int first, int count) const
{
    withSpline(order_, [&](auto order)
    {
        run<decltype(order)::value>(v, TakeGrid(), [&](const auto& kernel)
        { forEach(context, count, FromParticle<std::decay_t<decltype(kernel)>>{kernel, first}); });
    });
}

} // namespace riprap

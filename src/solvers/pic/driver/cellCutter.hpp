/*  Walls, obstacles and bodies cut the grid. Without solids inside the domain only its walls are
    set.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/cutCells/extendSurface.hpp"
#include "pic/terms/viscosity.hpp"
#include "solvers/pic/driver/openBoundaries.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class CellCutter
{
public:

    using real = typename P::real;

    CellCutter(PicParts<Backend, D, P>& parts, OpenBoundaries<Backend, D, P>& openings)
    :
        p_(parts), openings_(openings)
    {}

    void setWalls(const PicWalls&);
    void cut(double t, double dt);

private:

    void measureOpenParts(bool all);
    void keepSurfaces();
    void keepBase();
    void keepPushed();
    void cutByBodies();

    PicParts<Backend, D, P>& p_;
    OpenBoundaries<Backend, D, P>& openings_;
};

template<class Backend, int D, class P>
void CellCutter<Backend, D, P>::setWalls(const PicWalls& walls)
{
    const UniformGrid<D>& grid = p_.set.whole();
    std::vector<real> open[D];
    for (int d = 0; d < D; ++d)
    {
        open[d] = openParts<real>(grid, d, walls.aperture[d]);
        const std::vector<real>& a = open[d];
        p_.walls.aperture[d].upload(p_.set.context, p_.halo ? p_.halo->partOf(a, d) : a);
        if (!walls.wallVelocity[d].empty() || p_.solids.bodies) p_.walls.move = true;
        if (p_.opens()) openings_.keepOpenParts(d, a);
    }
    p_.walls.setSides(open);
    if (!p_.walls.move) return;
    for (int d = 0; d < D; ++d)
    {
        std::vector<real> w(grid.faces(d), real(0));
        std::copy(walls.wallVelocity[d].begin(), walls.wallVelocity[d].end(), w.begin());
        if (p_.halo) w = p_.halo->partOf(w, d);
        p_.walls.velocity[d].upload(p_.set.context, w);
    }
    if (p_.opens()) openings_.writeFaces();
}

//- For the step dt that begins at t; nothing is to be done where nothing moves
template<class Backend, int D, class P>
void CellCutter<Backend, D, P>::cut(double t, double dt)
{
    const UniformGrid<D>& grid = p_.set.grid;
    Context<Backend>& context = p_.set.context;
    SolidsInWater<Backend, D, P>& solids = p_.solids;
    const bool anew = p_.cut.base.nodeDistance.empty() || p_.cut.base.moves,
               moved = solids.bodies && solids.bodies->reader.read();
    if (!anew && !moved && !solids.loaded)
    {
        if (solids.bodies) solids.cut.forgetWater(context, p_.cutFields());
        return;
    }
    solids.rest = solids.loaded = false;
    // where blocks, before and after, are more than all there is
    const bool all = anew || 2*solids.cut.blockNodes() > grid.cells();
    if (anew)
    {
        p_.cut.base = cutWalls(
            p_.set.config, p_.walls.sides, p_.inside.obstacles, p_.inside.motion, t, dt);
        setWalls(p_.cut.base.walls);
        keepSurfaces();
        if (solids.bodies) keepBase();
        if (p_.cut.base.moves) keepPushed();
    }
    else if (solids.bodies)
    {
        solids.cut.restore(context, p_.cutFields());
        if (!all) measureOpenParts(false);       // where the new cut may not come
    }
    if (solids.bodies) cutByBodies();
    measureOpenParts(all);
    for (int d = 0; d < D && p_.sticksInside(); ++d)
        forEach(context, grid.faces(d),
            FaceDistances<D, real>{
                {grid}, d, p_.cut.nodeDistance.data(), p_.cut.faceDistance[d].data()});
    p_.cut.moves = p_.cut.base.moves || solids.bodies;
}

//- Open parts of cells: of all, or of those about the bodies. What an opening's neighbours see of
//  it across a periodic side lies in no block
template<class Backend, int D, class P>
void CellCutter<Backend, D, P>::measureOpenParts(bool all)
{
    const UniformGrid<D>& grid = p_.set.grid;
    Context<Backend>& context = p_.set.context;
    CutCells<Backend, D, P>& cut = p_.cut;
    const OpenVolumes<D, real> volumes{{grid}, cut.nodeDistance.data(), cut.open.data()};
    const OpenWeights<D, real> weights{grid, cut.open.data(), cut.openWeight.data()};
    for (int d = 0; d < D; ++d) all = all || grid.periodic[d];
    if (all)
    {
        forEach(context, grid.cells(), volumes);
        forEach(context, grid.cells(), weights);
        return;
    }
    p_.solids.cut.eachCell(context, volumes);
    p_.solids.cut.eachCell(context, weights);
}

//- Of several ranks: what this one's part has of the whole block
template<class Backend, int D, class P>
void CellCutter<Backend, D, P>::keepSurfaces()
{
    Context<Backend>& context = p_.set.context;
    CutCells<Backend, D, P>& cut = p_.cut;
    for (int d = 0; d < D; ++d)
    {
        std::vector<unsigned char> sealed(cut.base.sealed[d].begin(), cut.base.sealed[d].end());
        if (p_.halo) sealed = p_.halo->partOf(sealed, d);
        cut.sealed[d].upload(context, sealed);
    }
    if (!p_.halo) cut.nodeDistance.upload(context, cut.base.nodeDistance);
    else
        cut.nodeDistance.upload(
            context, p_.halo->partOf(cut.base.nodeDistance, GridField::nodes));
}

//- The grid without bodies, to put back what they change
template<class Backend, int D, class P>
void CellCutter<Backend, D, P>::keepBase()
{
    Context<Backend>& context = p_.set.context;
    CutCells<Backend, D, P>& cut = p_.cut;
    const auto here = [&](const auto& whole, int direction)
    { return p_.halo ? p_.halo->partOf(whole, direction) : whole; };
    cut.baseDistance.upload(context, here(cut.base.nodeDistance, GridField::nodes));
    for (int d = 0; d < D; ++d)
    {
        const std::vector<double>& a = cut.base.walls.aperture[d];
        const std::vector<double>& w = cut.base.walls.wallVelocity[d];
        cut.baseAperture[d].upload(context, here(std::vector<real>(a.begin(), a.end()), d));
        if (!w.empty())
            cut.baseVelocity[d].upload(context, here(std::vector<real>(w.begin(), w.end()), d));
    }
}

//- Fluxes of the obstacles that move, for their work
template<class Backend, int D, class P>
void CellCutter<Backend, D, P>::keepPushed()
{
    const PicWalls& walls = p_.cut.base.walls;
    for (int d = 0; d < D; ++d)
    {
        std::vector<real> flux(walls.wallVelocity[d].size());
        #pragma omp parallel for schedule(static) if (flux.size() > 10000)
        for (std::size_t i = 0; i < flux.size(); ++i)
            flux[i] = real((1 - double(walls.aperture[d][i]))*double(walls.wallVelocity[d][i]));
        p_.cut.pushed[d].upload(
            p_.set.context, p_.halo && !flux.empty() ? p_.halo->partOf(flux, d) : flux);
    }
}

//- What bodies leave of the grid that walls and obstacles have cut
template<class Backend, int D, class P>
void CellCutter<Backend, D, P>::cutByBodies()
{
    SolidsInWater<Backend, D, P>& solids = p_.solids;
    if (p_.opens()) openings_.openFully();
    const int up = std::max(p_.set.steepest(), 0);
    CountedOfBodies counted = CountedOfBodies::all();
    if (p_.halo)
    {
        const GridBricks<D>& bricks = *p_.set.bricks;
        counted = {bricks.brick(), bricks.facesOfBrick(bricks.rank(), up)};
    }
    solids.cut.cut(p_.set.context, p_.set.grid, solids.bodies->table.bodies, up, p_.cutFields(),
        counted);
    if (p_.halo)
    {
        std::vector<double> volumes = solids.cut.volumes();
        addByRank(p_.halo->ranks(), volumes);
        solids.cut.setVolumes(volumes);
    }
    if (p_.opens()) openings_.keepOpenParts();
    std::vector<double> velocity;
    for (const auto& b : solids.bodies->table.bodies)
        velocity.insert(velocity.end(), b.velocity.begin(), b.velocity.end());
    solids.cut.setVelocities(p_.set.context, velocity, p_.cutFields());
    if (p_.opens()) openings_.writeFaces();
}

} // namespace riprap

/*  Bodies on the device: where they and their blocks are, and the lattices of their shapes.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <map>
#include "core/backend/launch.hpp"
#include "pic/bodies/bodyBlocks.hpp"

namespace riprap
{

//- Numbers differ from step to step: some room to spare, since memory is given and taken back
//  slowly
template<class Backend, class T>
void allocateWithRoom(Context<Backend>& context, Array<Backend, T>& a, std::size_t n)
{
    constexpr int share = 8;
    if (a.bytes() < n*sizeof(T)) a.allocate(context, n + n/share + 1);
    a.allocate(context, n);
}

template<class Backend, int D>
class PlacedBodies
{
public:

    //- bodies: shape, centre and reach of each
    template<class Bodies>
    void place(Context<Backend>& context, const UniformGrid<D>& grid, const Bodies& bodies);

    BodyBlocks<D> blocks() const
    {
        return {grid_, count_, body_.data(), firstRow_.data(), bodyOfRow_.data(), ball_.data(),
            sampled_.data()};
    }
    const UniformGrid<D>& grid() const { return grid_; }
    int count() const { return count_; }
    int rows() const { return rows_; }
    const Array<Backend, int>& firstRow() const { return firstRow_; }

    //- Nodes of all blocks: of bodies near each other some are counted twice
    std::int64_t nodes() const { return nodes_; }

    //- How many have a shape of their own
    std::size_t sampled() const { return sampled_.size(); }

private:

    template<class Bodies> void keepLattices(Context<Backend>& context, const Bodies& bodies);

    UniformGrid<D> grid_{};
    int count_ = 0, rows_ = 0;
    std::int64_t nodes_ = 0;
    Array<Backend, PlacedBody<D>> body_;
    Array<Backend, Ball<D>> ball_;
    Array<Backend, SampledShape<D>> sampled_;
    Array<Backend, double> latticeDistance_;                    // of shapes, one after the other
    std::map<const double*, std::size_t> latticeAt_;            // where those of the host are in it
    Array<Backend, int> firstRow_, bodyOfRow_;                  // of bodies; of rows
};

//- Lattices of shapes are copied once: they stay where they are on the host
template<class Backend, int D>
template<class Bodies>
void PlacedBodies<Backend, D>::keepLattices(Context<Backend>& context, const Bodies& bodies)
{
    std::vector<double> all;
    for (const auto& b : bodies)
    {
        const ShapeLattice<D>& l = b.shape.sampled.lattice;
        if (!l.distance || latticeAt_.count(l.distance)) continue;
        if (all.empty()) all = latticeDistance_.download();
        latticeAt_[l.distance] = all.size();
        all.insert(all.end(), l.distance, l.distance + l.points());
    }
    if (!all.empty()) latticeDistance_.upload(context, all);
}

template<class Backend, int D>
template<class Bodies>
void PlacedBodies<Backend, D>::place(
    Context<Backend>& context, const UniformGrid<D>& grid, const Bodies& bodies)
{
    std::vector<PlacedBody<D>> placed(bodies.size());
    std::vector<Ball<D>> balls;
    std::vector<SampledShape<D>> sampled;
    std::vector<int> firstRow(1, 0);
    keepLattices(context, bodies);
    nodes_ = 0;
    for (std::size_t b = 0; b < bodies.size(); ++b)
    {
        PlacedBody<D>& p = placed[b];
        p.centre = bodies[b].centre;
        p.firstBall = int(balls.size());
        const auto& own = bodies[b].shape.balls.balls;
        p.balls = int(own.size());
        balls.insert(balls.end(), own.begin(), own.end());
        p.sampled = bodies[b].shape.hasOwn() ? int(sampled.size()) : -1;
        if (p.sampled >= 0)
        {
            sampled.push_back(bodies[b].shape.sampled);
            const double*& distance = sampled.back().lattice.distance;
            distance = latticeDistance_.data() + latticeAt_[distance];
        }
        p.setBlock(grid, bodies[b].reach);
        firstRow.push_back(firstRow.back() + p.rows());
        nodes_ += std::int64_t(p.size[0])*p.rows();
    }
    grid_ = grid;
    count_ = int(bodies.size());
    rows_ = firstRow.back();
    body_.upload(context, placed);
    ball_.upload(context, balls);
    sampled_.upload(context, sampled);
    firstRow_.upload(context, firstRow);
    allocateWithRoom(context, bodyOfRow_, rows_);
    forEach(context, rows_, BodiesOfRows{count_, firstRow_.data(), bodyOfRow_.data()});
}

} // namespace riprap

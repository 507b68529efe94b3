/*  Walls: their surfaces on the device, and what contacts with them remember.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/state/frame.hpp"
#include "dem/walls/moveWalls.hpp"
#include "dem/walls/repeatSurface.hpp"
#include "dem/walls/wallPass.hpp"
#include "solvers/dem/parts/demSetting.hpp"

namespace riprap
{

//- Memory of wall contacts
template<class Backend, class R>
struct WallMemoryArrays
{
    Array<Backend, int> entryFirst, elementFirst;
    Array<Backend, WallEntry> entry;
    Array<Backend, int> element, on;
    Array<Backend, R> normal, history, force;
    int entries = 0;

    std::size_t bytes() const
    {
        return entryFirst.bytes() + elementFirst.bytes() + entry.bytes() + element.bytes()
            + on.bytes() + normal.bytes() + history.bytes() + force.bytes();
    }
};

template<class Backend, int D, class P>
class Walls
{
public:

    using real = typename P::real;

    int count = 0;
    bool surfaces = false;      // are there walls that are no planes?
    Array<Backend, WallData> walls;
    WallMemoryArrays<Backend, real> memory, oldMemory;
    Array<Backend, WallPassings> passed;

    explicit Walls(DemSetting<Backend, D, P>& set) : set_(set) {}

    //- cell: of the grid that surfaces are sorted into [m]. \return how many motions there are
    int set(double cell, int particles);

    SurfaceView<D> surface();
    WallMemory<D, real> view(WallMemoryArrays<Backend, real>&);
    WallMemory<D, real> view() { return view(memory); }
    bool touch() const { return count && memory.entries; }          // is any particle near one?
    const int* entryFirst() { return touch() ? memory.entryFirst.data() : nullptr; }

    //- Nobody has gone through them yet
    void clearPassed(int particles);

    double largestSpeed();
    std::size_t bytes() const;

private:

    DemSetting<Backend, D, P>& set_;
    Array<Backend, double> vertices_;
    Array<Backend, int> elements_, sharedFirst_, shared_, cellFirst_, cellElement_;
};

template<class Backend, int D, class P>
int Walls<Backend, D, P>::set(double cell, int particles)
{
    count = int(set_.input.walls.size());
    if (!count) return 0;
    SurfaceBuilder<D> builder;
    std::vector<WallData> data;
    int motions = 0;
    for (const DemWall& in : set_.input.walls)
    {
        WallData w{};
        w.material = in.material;
        w.plane = in.plane;
        surfaces = surfaces || !in.plane;
        w.motion = in.motion;
        motions = std::max(motions, in.motion + 1);
        for (int d = 0; d < 3; ++d) w.frame.R[4*d] = 1;
        double length = 0;
        for (int d = 0; d < D; ++d)
            length += in.normal[set_.config.axes[d]]*in.normal[set_.config.axes[d]];
        for (int d = 0; d < D; ++d)
        {
            const int axis = set_.config.axes[d];
            w.point[d] = in.point[axis];
            w.normal[d] = in.normal[axis]/std::sqrt(std::max(length, 1e-300));
            w.low[d] = set_.config.domainMin[axis];
            w.high[d] = set_.config.domainMax[axis];
        }
        if (!in.plane)
        {
            std::vector<double> vertices;
            for (std::size_t v = 0; v < in.vertices.size(); v += 3)
                for (int d = 0; d < D; ++d)
                    vertices.push_back(in.vertices[v + set_.config.axes[d]]);
            std::vector<int> elements(in.elements.begin(), in.elements.end());
            for (int d = 0; d < D; ++d)
            {
                const int axis = set_.config.axes[d];
                if (!set_.config.periodic[axis] || in.motion >= 0) continue;
                repeatSurface<D>(vertices, elements, d, set_.config.domainMin[axis],
                    set_.config.domainMax[axis], cell);
            }
            builder.add(vertices, elements, cell, w);
        }
        data.push_back(w);
    }
    walls.upload(set_.context, data);
    vertices_.upload(set_.context, builder.vertex);
    elements_.upload(set_.context, builder.element);
    sharedFirst_.upload(set_.context, builder.sharedFirst);
    shared_.upload(set_.context, builder.shared);
    cellFirst_.upload(set_.context, builder.cellFirst);
    cellElement_.upload(set_.context, builder.cellElement);
    clearPassed(particles);
    return motions;
}

template<class Backend, int D, class P>
SurfaceView<D> Walls<Backend, D, P>::surface()
{
    return SurfaceView<D>{vertices_.data(), elements_.data(), sharedFirst_.data(), shared_.data(),
        cellFirst_.data(), cellElement_.data()};
}

template<class Backend, int D, class P>
WallMemory<D, typename P::real> Walls<Backend, D, P>::view(WallMemoryArrays<Backend, real>& m)
{
    return WallMemory<D, real>{m.entryFirst.data(), m.entry.data(), m.element.data(), m.on.data(),
        m.normal.data(), m.history.data(), m.force.data()};
}

template<class Backend, int D, class P>
void Walls<Backend, D, P>::clearPassed(int particles)
{
    if (surfaces)
        passed.upload(set_.context, std::vector<WallPassings>(1, WallPassings{0, particles, 0}));
}

template<class Backend, int D, class P>
double Walls<Backend, D, P>::largestSpeed()
{
    double most2 = 0;
    if (count)
        for (const WallData& w : walls.download())
            for (int corner = 0; corner < 8 && w.motion >= 0; ++corner)
                most2 = std::max(most2, MoveWalls::cornerSpeed2(w, corner));
    return std::sqrt(most2);
}

template<class Backend, int D, class P>
std::size_t Walls<Backend, D, P>::bytes() const
{
    return walls.bytes() + vertices_.bytes() + elements_.bytes() + sharedFirst_.bytes()
        + shared_.bytes() + cellFirst_.bytes() + cellElement_.bytes();
}

} // namespace riprap

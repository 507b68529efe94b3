/*  The rigid bodies of a scene of solids in water: what they are made of, what is remembered of
    them from step to step, and those that are there now.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/bodies/bodyShape.hpp"
#include "pic/bodies/contactArea.hpp"
#include "pic/bodies/freeBody.hpp"
#include "pic/grid/uniformGrid.hpp"
#include "solvers/pic/bodies/bodySetting.hpp"

namespace riprap
{

template<int D>
class BodyTable
{
public:

    static constexpr int modes = bodyModes<D>;
    using Modes = std::array<double, modes>;
    using Shape = BodyShape<D>;

    struct Body
    {
        std::vector<int> ids;
        int clump = -1, group = 0, shape = -1;
        double mass = 0;
        Vec<3, double> inertia{{0, 0, 0}};      // principal; 2D: the last
    };

    //- Of a body between two steps
    //  given: to the solid, last; drag: of force; ahead: of middle, what BodyForces::foresee has
    //  added
    struct Memory
    {
        Modes force{}, old{}, start{}, middle{}, given{}, drag{}, ahead{};
        bool begun = false;
    };

    //- Of those that are there
    struct Now
    {
        int body = 0;
        Modes velocity{}, total{}, predicted{}, moved{}, drag{};
        std::array<double, modes*modes> inverse{};
        // from the centre to the particle that carries the force
        Vec<3, double> arm{{0, 0, 0}};
        bool asleep = false;
    };

    std::vector<Body> all;
    std::vector<Memory> memory;                 // of all
    std::vector<Now> now;
    std::vector<FreeBody<D, Shape>> bodies;     // of now
    std::vector<Ball<D>> ballOfId;
    int largestId = 0;

    BodyTable(const BodySetting<D>&, const DemInput&);

    Modes times(const Now& n, const Modes& force) const;
    Modes gravityOf(const Now&) const;
    bool sleeps(const Now&) const;

    // else W of the step before
    std::vector<FreeBody<D, Shape>> withVelocities(bool predicted) const;
    //- Of all, one after the other: W*, or W of the step before less what was foreseen in it
    std::vector<double> velocities(bool predicted) const;

    void fill(std::vector<BodyTerm>&) const;                                // inverse masses and W*
    // L of each, M^-1 = L L^T
    std::vector<double> roots() const;
    bool anyLighter(const std::vector<double>& volume, double density) const;

    // does any give way to the water? Else they are walls
    bool yield() const;
    double fastest() const;                     // [m/s], the turning surface's
    // does one reach across a periodic side? The grid would see a part of it alone
    bool acrossPeriodic(const UniformGrid<D>&) const;
    std::vector<ContactArea<D>> contacts(const UniformGrid<D>&) const;

    //- f(body, face, its middle) for the faces of a direction whose middle is no farther than so
    //  many cells from a body
    template<class F>
    void eachFaceNear(const UniformGrid<D>& grid, int component, double cells, const F& f) const
    {
        for (int b = 0; b < int(bodies.size()); ++b)
        {
            int low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
            for (int d = 0; d < D; ++d)
            {
                const double at = bodies[b].centre[d] - grid.origin[d], reach = bodies[b].reach;
                low[d] = std::max(0,
                    int(std::floor((at - reach)/grid.h - cells)) - 1 - grid.first[d]);
                high[d] = std::min(grid.layers(component, d) - 1,
                    int(std::ceil((at + reach)/grid.h + cells)) + 1 - grid.first[d]);
            }
            typename UniformGrid<D>::Index at{{0, 0, 0}};
            for (at.c[2] = low[2]; at.c[2] <= high[2]; ++at.c[2])
                for (at.c[1] = low[1]; at.c[1] <= high[1]; ++at.c[1])
                    for (at.c[0] = low[0]; at.c[0] <= high[0]; ++at.c[0])
                    {
                        Vec<D, double> x;
                        for (int d = 0; d < D; ++d)
                            x[d] = grid.origin[d]
                                + grid.h*(grid.first[d] + at.c[d] + (d == component ? 0.0 : 0.5));
                        if (bodies[b].shape.distance(x) < cells*grid.h) f(b, at, x);
                    }
        }
    }

private:

    const BodySetting<D>& set_;
};

template<int D>
typename BodyTable<D>::Modes BodyTable<D>::times(const Now& n, const Modes& force) const
{
    Modes a{};
    for (int i = 0; i < modes; ++i)
        for (int k = 0; k < modes; ++k) a[i] += n.inverse[i*modes + k]*force[k];
    return a;
}

} // namespace riprap

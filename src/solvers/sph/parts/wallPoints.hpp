/*  Points of walls, and the motion of those that move.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/neighbours/cellSort.hpp"
#include "solvers/sph/parts/sphSetting.hpp"
#include "sph/boundary/movingWall.hpp"
#include "sph/boundary/wallFields.hpp"

namespace riprap
{

//- Where fields stand in the set of them; -1: there is none
struct WallFieldNumbers
{
    int x = 0, id = 0, body = -1, v = -1, a = -1, work = -1, pressureWork = -1;
};

template<class Backend, int D, class P>
class WallPoints
{
public:

    using real = typename P::real;
    using position = typename P::position;

    int count = 0, bodies = 0;                  // bodies: groups that move
    real allowedWay = 0;                        // [m] of one that moves, for which neighbours hold
    WallFieldNumbers at;
    FieldSet<Backend> values;
    Records<Backend, D, P> records;
    // where they were when neighbours were sought, if any moves
    Array<Backend, position> reference;
    CellSort<Backend> sort;
    // positions of the unit pose, by id, if any moves [m]
    Array<Backend, double> rest;
    std::vector<double> input;                  // positions as given
    std::vector<std::int32_t> bodyOf, partOf;   // by id

    explicit WallPoints(SphSetting<Backend, D, P>& set) : set_(set) {}

    void set(const WallInput&);
    WallFields<D, P> fields();

    //- Component d of the velocity; null: none moves
    const real* velocity(int d)
    {
        return at.v < 0 ? nullptr : values.template data<real>(at.v + d);
    }

private:

    void addFields();

    SphSetting<Backend, D, P>& set_;
};

template<class Backend, int D, class P>
void WallPoints<Backend, D, P>::set(const WallInput& in)
{
    count = int(in.size());
    bodies = in.nBodies;
    input = in.position;
    bodyOf = in.body.empty() ? std::vector<std::int32_t>(count, -1) : in.body;
    partOf = in.part.empty() ? std::vector<std::int32_t>(count, 0) : in.part;
    if (!count) return;
    addFields();
    values.allocate(set_.context, count);
    records.allocate(set_.context, count, set_.model.variableH);
    sort.allocate(set_.context, count, set_.grid.cells);
    std::vector<std::int64_t> x(count);
    std::vector<std::int32_t> id(count);
    for (int d = 0; d < D; ++d)
    {
        for (int i = 0; i < count; ++i)
            x[i] = set_.box.toFixedInside(d, in.position[3*std::size_t(i) + set_.config.axes[d]]);
        values.upload(set_.context, at.x + d, x);
    }
    for (int i = 0; i < count; ++i) id[i] = i;
    values.upload(set_.context, at.id, id);
    if (bodies) values.upload(set_.context, at.body, bodyOf);
}

template<class Backend, int D, class P>
void WallPoints<Backend, D, P>::addFields()
{
    at.x = values.fields();
    for (int d = 0; d < D; ++d) values.template add<std::int64_t>("position." + std::to_string(d));
    at.id = values.template add<std::int32_t>("id");
    if (!bodies) return;
    at.body = values.template add<std::int32_t>("body");
    at.v = values.fields();
    for (int d = 0; d < D; ++d) values.template add<real>("velocity." + std::to_string(d));
    at.a = values.fields();
    for (int d = 0; d < D; ++d) values.template add<real>("acceleration." + std::to_string(d));
    at.work = values.template add<double>("work");
    at.pressureWork = values.template add<double>("pressureWork");
    rest.upload(set_.context, input);
    reference.allocate(set_.context, std::size_t(count)*D);
}

template<class Backend, int D, class P>
WallFields<D, P> WallPoints<Backend, D, P>::fields()
{
    WallFields<D, P> f{};
    for (int d = 0; d < D; ++d)
    {
        f.x[d] = values.template data<std::int64_t>(at.x + d);
        f.v[d] = at.v < 0 ? nullptr : values.template data<real>(at.v + d);
        f.a[d] = at.a < 0 ? nullptr : values.template data<real>(at.a + d);
    }
    f.id = values.template data<std::int32_t>(at.id);
    f.body = at.body < 0 ? nullptr : values.template data<std::int32_t>(at.body);
    return f;
}

} // namespace riprap

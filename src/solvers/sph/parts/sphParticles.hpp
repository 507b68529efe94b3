/*  The particles of the fluid, in the order of their cells.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/hostMemory.hpp"
#include "core/neighbours/cellSort.hpp"
#include "solvers/sph/parts/sphSetting.hpp"
#include "sph/state/fluidFields.hpp"

namespace riprap
{

//- Where fields stand in the set of them; -1: there is none
struct FluidFieldNumbers { int x = 0, v = 0, deviation = 0, a = 0, rate = 0, drift = -1, id = 0; };

template<class Backend, int D, class P>
class SphParticles
{
public:

    using real = typename P::real;
    using position = typename P::position;

    int n;                      // with memory
    int reported;               // of them known to be in the scene
    FluidFieldNumbers at;
    FieldSet<Backend> values;
    Records<Backend, D, P> records;
    Array<Backend, position> reference;         // where they were when neighbours were sought
    CellSort<Backend> sort;

    SphParticles(SphSetting<Backend, D, P>& set, int particles)
        : n(particles), reported(particles), set_(set)
    {}

    void set(const FluidInput&);

    //- Memory for so many from now on; the first `residents` stay in their slots, and a rebuild
    //  does the rest
    void setCapacity(int capacity, int residents);

    //- So many are loaded into their fields: what is laid out by their number
    void setLoaded(int particles);

    FluidFields<D, P> fields();

    //- Particles in the scene
    int active();

private:

    void addFields();

    SphSetting<Backend, D, P>& set_;
};

template<class Backend, int D, class P>
void SphParticles<Backend, D, P>::set(const FluidInput& in)
{
    addFields();
    std::vector<std::int64_t> x(n);
    std::vector<real> value(n);
    for (int d = 0; d < D; ++d)
    {
        const int axis = set_.config.axes[d];
        for (int i = 0; i < n; ++i)
            x[i] = set_.box.toFixed(d, in.position[3*std::size_t(i) + axis]);
        values.upload(set_.context, at.x + d, x);
        for (int i = 0; i < n; ++i) value[i] = real(in.velocity[3*std::size_t(i) + axis]);
        values.upload(set_.context, at.v + d, value);
    }
    for (int i = 0; i < n; ++i) value[i] = real(in.density[i]/set_.config.density - 1);
    values.upload(set_.context, at.deviation, value);
    std::vector<std::int32_t> id = in.id;
    if (id.empty()) for (int i = 0; i < n; ++i) id.push_back(i);
    values.upload(set_.context, at.id, id);
}

template<class Backend, int D, class P>
void SphParticles<Backend, D, P>::addFields()
{
    const char* axisName[3] = {"x", "y", "z"};
    const auto addVector = [&](const char* name)
    {
        const int first = values.fields();
        for (int d = 0; d < D; ++d)
            values.template add<real>(std::string(name) + "." + axisName[d]);
        return first;
    };
    at.x = values.fields();
    for (int d = 0; d < D; ++d)
        values.template add<std::int64_t>(std::string("position.") + axisName[d]);
    at.v = addVector("velocity");
    at.deviation = values.template add<real>("densityDeviation");
    at.a = addVector("acceleration");
    at.rate = values.template add<real>("densityRate");
    if (set_.model.drifts) at.drift = addVector("drift");
    at.id = values.template add<std::int32_t>("id");
    values.allocate(set_.context, n);
    records.allocate(set_.context, n, set_.model.variableH);
    reference.allocate(set_.context, std::size_t(n)*D);
    sort.allocate(set_.context, n, set_.grid.cells);
}

template<class Backend, int D, class P>
void SphParticles<Backend, D, P>::setCapacity(int capacity, int residents)
{
    const int inScene = std::min(active(), capacity), kept = std::min({residents, n, capacity});
    FieldSet<Backend> old(std::move(values));
    values = FieldSet<Backend>();
    const auto info = old.info();
    for (int f = 0; f < old.fields(); ++f)
    {
        if (old.elementBytes(f) == 8) values.template add<std::int64_t>(info[f].name);
        else values.template add<std::int32_t>(info[f].name);
    }
    values.allocate(set_.context, capacity);
    for (int f = 0; f < values.fields(); ++f)
        copyOnDevice(set_.context, values.bytes(f), old.bytes(f),
            std::size_t(kept)*old.elementBytes(f));
    records = Records<Backend, D, P>();
    records.allocate(set_.context, capacity, set_.model.variableH);
    reference = Array<Backend, position>();
    reference.allocate(set_.context, std::size_t(capacity)*D);
    sort = CellSort<Backend>();
    sort.allocate(set_.context, capacity, set_.grid.cells);
    set_.context.toDevice(const_cast<int*>(sort.active()), &inScene, sizeof(int));
    set_.context.synchronise();     // before the old memory goes
    n = capacity;
}

template<class Backend, int D, class P>
void SphParticles<Backend, D, P>::setLoaded(int particles)
{
    n = reported = particles;
    reference.allocate(set_.context, std::size_t(n)*D);
    sort.allocate(set_.context, n, set_.grid.cells);
}

template<class Backend, int D, class P>
FluidFields<D, P> SphParticles<Backend, D, P>::fields()
{
    FluidFields<D, P> f{};
    for (int d = 0; d < D; ++d)
    {
        f.x[d] = values.template data<std::int64_t>(at.x + d);
        f.v[d] = values.template data<real>(at.v + d);
        f.a[d] = values.template data<real>(at.a + d);
        f.drift[d] = at.drift < 0 ? nullptr : values.template data<real>(at.drift + d);
    }
    f.deviation = values.template data<real>(at.deviation);
    f.rate = values.template data<real>(at.rate);
    f.id = values.template data<std::int32_t>(at.id);
    return f;
}

template<class Backend, int D, class P>
int SphParticles<Backend, D, P>::active()
{
    int active = 0;
    set_.context.toHost(&active, sort.active(), sizeof(int));
    return active;
}

} // namespace riprap

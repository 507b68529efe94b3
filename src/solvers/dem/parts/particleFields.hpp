/*  The particles of a scene: their fields on the device, and who they are.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/snapshot.hpp"
#include "core/containers/fieldSet.hpp"
#include "dem/passes/gatherPlaces.hpp"
#include "dem/state/solidFields.hpp"
#include "solvers/dem/parts/demSetting.hpp"

namespace riprap
{

//- In place of what an array has; memory of more is given back
template<class Backend, class T>
void replaceBy(Context<Backend>& context, Array<Backend, T>& array, const std::vector<T>& values)
{
    Array<Backend, T> fresh;
    fresh.upload(context, values);
    array.swap(fresh);
}

//- Where a field of the set stands, its first component; -1: there is none
struct SolidFieldNumbers
{
    int x = 0, v = 0, w = 0, f = 0, m = 0;
    int radius = 0, mass = 0, inertia = 0, material = 0, group = 0, clump = -1, turn = -1, id = 0,
        calm = -1;
};

template<class Backend, int D, class P>
class ParticleFields
{
public:

    using real = typename P::real;
    static constexpr int S = spins<D>;

    int n = 0;                              // particles with memory
    int reported;                           // of them known to be in the scene
    FieldSet<Backend> values;
    SolidFieldNumbers at;
    // of keys: a particle's key is its place in the input, until ranks change it
    std::vector<std::int32_t> ids;
    std::vector<double> emptyCoordinate;    // of keys, in 2D
    Array<Backend, real> external;          // D forces, then moments, a key; empty: there are none

    ParticleFields(DemSetting<Backend, D, P>& set, int count) : n(count), reported(count), set_(set)
    {}

    //- The fields that a scene needs. calm: how long a particle has been slow
    void add(bool calm);
    void fill(const DemParticles&);

    SolidFields<D, P> view();
    const real* externalForces() const { return external.size() ? external.data() : nullptr; }

    //- For the host: one field; vectors and positions of the first `count`, and positions of some,
    //  in three components
    template<class T> std::vector<T> field(int f)
    {
        return values.template download<T>(set_.context, f);
    }
    std::vector<double> positions(int count);
    std::vector<double> positionsOf(const std::vector<int>& who);

    //- The same of the first `count`, as a snapshot has them
    template<class T> ReadValues<T> fieldOf(Snapshot<Backend>& now, int count, int f)
    {
        return now.values(values.template data<T>(f), std::size_t(count));
    }
    template<class T>
    ReadValues<double> vectorOf(
        Snapshot<Backend>& now, int count, int first, int components, bool spin);
    ReadValues<double> positionsOf(Snapshot<Backend>& now, int count);

private:

    template<class T, class Values> void uploadField(int field, const Values& of);
    template<class T>
    void uploadVector(int field, int components, const std::vector<double>& from, bool spin);

    DemSetting<Backend, D, P>& set_;
};

//- A field from of(i)
template<class Backend, int D, class P>
template<class T, class Values>
void ParticleFields<Backend, D, P>::uploadField(int field, const Values& of)
{
    std::vector<T> all(n);
    #pragma omp parallel for schedule(static)
    for (int i = 0; i < n; ++i) all[i] = of(i);
    values.upload(set_.context, field, all);
}

//- Components of vectors in the solver's axes, or the one spin of 2D
template<class Backend, int D, class P>
template<class T>
void ParticleFields<Backend, D, P>::uploadVector(
    int field, int components, const std::vector<double>& from, bool spin)
{
    if (from.empty()) return;               // memory begins as zero
    for (int d = 0; d < components; ++d)
    {
        const int axis = spin && D == 2 ? set_.config.axes[2] : set_.config.axes[d];
        const double sign = spin && D == 2 ? set_.spinSign() : 1;
        uploadField<T>(field + d, [&](int i) { return T(sign*from[3*std::size_t(i) + axis]); });
    }
}

template<class Backend, int D, class P>
void ParticleFields<Backend, D, P>::add(bool calm)
{
    static const char* axis[3] = {"x", "y", "z"};
    const auto addVector = [&](const char* name, int components)
    {
        const int first = values.fields();
        for (int d = 0; d < components; ++d)
            values.template add<real>(std::string(name) + "." + axis[components == 1 ? 2 : d]);
        return first;
    };
    at.x = values.fields();
    for (int d = 0; d < D; ++d)
        values.template add<std::int64_t>(std::string("position.") + axis[d]);
    at.v = values.fields();
    for (int d = 0; d < D; ++d) values.template add<double>(std::string("velocity.") + axis[d]);
    at.w = addVector("spin", S);
    at.f = addVector("force", D);
    at.m = addVector("moment", S);
    at.radius = values.template add<real>("radius");
    at.mass = values.template add<real>("mass");
    at.inertia = values.template add<real>("inverseInertia");
    at.material = values.template add<std::int32_t>("material");
    at.group = values.template add<std::int32_t>("group");
    if (!set_.input.clumps.empty()) at.clump = values.template add<std::int32_t>("clump");
    if (set_.config.orientation)
    {
        at.turn = values.fields();
        for (int k = 0; k < (D == 2 ? 1 : 4); ++k)
            values.template add<real>("orientation." + std::to_string(k));
    }
    if (calm) at.calm = values.template add<std::int32_t>("calm");
    at.id = values.template add<std::int32_t>("key");
}

template<class Backend, int D, class P>
void ParticleFields<Backend, D, P>::fill(const DemParticles& in)
{
    values.allocate(set_.context, n);
    for (int d = 0; d < D; ++d)
        uploadField<std::int64_t>(at.x + d,
            [&](int i)
            { return set_.box.toFixed(d, in.position[3*std::size_t(i) + set_.config.axes[d]]); });
    uploadVector<double>(at.v, D, in.velocity, false);
    uploadVector<real>(at.w, S, in.spin, true);
    uploadField<real>(at.radius, [&](int i) { return real(in.radius[i]); });
    uploadField<real>(at.mass, [&](int i) { return real(in.mass[i]); });
    uploadField<real>(at.inertia,
        [&](int i)
        {
            return real(1
                /(in.inertia.empty()
                        ? (D == 2 ? 0.5 : 0.4)*in.mass[i]*in.radius[i]*in.radius[i]
                        : in.inertia[i]));
        });
    ids = in.id;
    if (ids.empty()) for (int i = 0; i < n; ++i) ids.push_back(i);
    uploadField<std::int32_t>(at.id, [](int i) { return i; });
    if (!in.material.empty()) values.upload(set_.context, at.material, in.material);
    if (!in.group.empty()) values.upload(set_.context, at.group, in.group);
    if (at.clump >= 0)
        values.upload(
            set_.context, at.clump, in.clump.empty() ? std::vector<std::int32_t>(n, -1) : in.clump);
    if (at.turn >= 0)
        for (int k = 0; k < (D == 2 ? 1 : 4); ++k)
            values.upload(set_.context, at.turn + k, std::vector<real>(n, real(D == 3 && k == 0)));
    if (D == 2) emptyCoordinate.resize(n);
    if (D == 2)
        for (int i = 0; i < n; ++i)
            emptyCoordinate[i] = in.position[3*std::size_t(i) + set_.config.axes[2]];
}

template<class Backend, int D, class P>
SolidFields<D, P> ParticleFields<Backend, D, P>::view()
{
    SolidFields<D, P> s{};
    for (int d = 0; d < D; ++d)
    {
        s.x[d] = values.template data<std::int64_t>(at.x + d);
        s.v[d] = values.template data<double>(at.v + d);
        s.f[d] = values.template data<real>(at.f + d);
    }
    for (int c = 0; c < S; ++c)
    {
        s.w[c] = values.template data<real>(at.w + c);
        s.m[c] = values.template data<real>(at.m + c);
    }
    s.radius = values.template data<real>(at.radius);
    s.mass = values.template data<real>(at.mass);
    s.inverseInertia = values.template data<real>(at.inertia);
    s.material = values.template data<std::int32_t>(at.material);
    s.group = values.template data<std::int32_t>(at.group);
    s.clump = at.clump < 0 ? nullptr : values.template data<std::int32_t>(at.clump);
    s.id = values.template data<std::int32_t>(at.id);
    s.calm = at.calm < 0 ? nullptr : values.template data<std::int32_t>(at.calm);
    if (at.turn >= 0)
        for (int k = 0; k < (D == 2 ? 1 : 4); ++k)
            s.turn[k] = values.template data<real>(at.turn + k);
    return s;
}

template<class Backend, int D, class P>
template<class T>
ReadValues<double> ParticleFields<Backend, D, P>::vectorOf(
    Snapshot<Backend>& now, int count, int first, int components, bool spin)
{
    std::vector<ReadValues<T>> component(components);
    for (int d = 0; d < components; ++d) component[d] = fieldOf<T>(now, count, first + d);
    return [this, component, count, spin]
    {
        std::vector<double> out(3*std::size_t(count), 0.0);
        const bool one = spin && D == 2;
        for (int d = 0; d < int(component.size()); ++d)
        {
            const std::vector<T> v = component[d]();
            #pragma omp parallel for schedule(static) if (count > 10000)
            for (int i = 0; i < count; ++i)
                out[3*std::size_t(i) + set_.config.axes[one ? 2 : d]] = (one ? set_.spinSign() : 1)
                    *double(v[i]);
        }
        return out;
    };
}

//- Positions of the first count, in metres
template<class Backend, int D, class P>
std::vector<double> ParticleFields<Backend, D, P>::positions(int count)
{
    Snapshot<Backend> now(set_.context, false);
    return positionsOf(now, count)();
}

template<class Backend, int D, class P>
ReadValues<double> ParticleFields<Backend, D, P>::positionsOf(Snapshot<Backend>& now, int count)
{
    ReadValues<std::int32_t> keys;
    if (D == 2) keys = fieldOf<std::int32_t>(now, count, at.id);
    std::vector<ReadValues<std::int64_t>> component(D);
    for (int d = 0; d < D; ++d) component[d] = fieldOf<std::int64_t>(now, count, at.x + d);
    return [this, keys, component, count, box = set_.box]
    {
        std::vector<double> out(3*std::size_t(count), 0.0);
        if (D == 2)
        {
            const std::vector<std::int32_t> key = keys();
            for (int i = 0; i < count; ++i)
                out[3*std::size_t(i) + set_.config.axes[2]] = emptyCoordinate[key[i]];
        }
        for (int d = 0; d < D; ++d)
        {
            const std::vector<std::int64_t> x = component[d]();
            #pragma omp parallel for schedule(static) if (count > 10000)
            for (int i = 0; i < count; ++i)
                out[3*std::size_t(i) + set_.config.axes[d]] = box.toMetres(d, x[i]);
        }
        return out;
    };
}

//- Positions of some, in metres
template<class Backend, int D, class P>
std::vector<double> ParticleFields<Backend, D, P>::positionsOf(const std::vector<int>& who)
{
    std::vector<double> out(3*who.size(), 0.0);
    if (D == 2)
    {
        const auto key = field<std::int32_t>(at.id);
        for (std::size_t k = 0; k < who.size(); ++k)
            out[3*k + set_.config.axes[2]] = emptyCoordinate[key[who[k]]];
    }
    Array<Backend, int> some;
    Array<Backend, std::int64_t> there;
    some.upload(set_.context, who);
    there.allocate(set_.context, D*who.size());
    GatherPlaces<D> gather{some.data(), {}, there.data()};
    for (int d = 0; d < D; ++d)
        gather.x[d] = reinterpret_cast<const std::int64_t*>(values.bytes(at.x + d));
    forEach(set_.context, int(who.size()), gather);
    const std::vector<std::int64_t> x = there.download();
    for (std::size_t k = 0; k < who.size(); ++k)
        for (int d = 0; d < D; ++d)
            out[3*k + set_.config.axes[d]] = set_.box.toMetres(d, x[D*k + d]);
    return out;
}

} // namespace riprap

/*  The water's particles: their fields on the device, and the order of the cells that they stand
    in.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <numeric>
#include "core/containers/fieldSet.hpp"
#include "core/neighbours/cellSort.hpp"
#include "pic/grid/particles.hpp"
#include "solvers/pic/parts/picSetting.hpp"
#include "solvers/pic/transfer/gridToParticles.hpp"

namespace riprap
{

//- A particle that comes in; number: among those of all ranks that come in with it
template<int D>
struct EnteringParticle
{
    Vec<D, double> x, v;
    std::int32_t id;
    int number;
};

//- Where a field of the set stands, its first component; -1: there is none
struct PicFieldNumbers { int x = 0, v = 0, affine = -1, id = 0, memory = 0; };

template<class Backend, int D, class P>
class PicParticleFields
{
public:

    using real = typename P::real;

    int n = 0;                                  // particles here, ghosts of other ranks included
    FieldSet<Backend> values;
    PicFieldNumbers at;
    CellSort<Backend> sort;
    Array<Backend, PlaceInCell<real>> place;    // of particles, from one sort to the next
    Array<Backend, real> shift[D];              // of position correction
    GridToParticles<Backend, D, real> scheme;   // which says what fields they have
    // of several ranks: numbers of the last ones here, which have come in since the sort
    std::vector<int> entered;

    explicit PicParticleFields(PicSetting<Backend, D, P>& set) : scheme(set.config), set_(set) {}

    void fill(const std::vector<double>& x, const std::vector<double>& v,
        const std::vector<double>& gradient, const std::vector<std::int32_t>& id);
    void append(const std::vector<EnteringParticle<D>>& those);
    void reserve(std::size_t particles);

    //- In the scene; told by those who know where there are several ranks
    std::int64_t all() const { return set_.bricks ? all_ : n; }
    void setAll(std::int64_t particles) { all_ = particles; }
    std::vector<int> own() const;
    std::vector<int> starts() const;

    PicParticles<D, real> view(bool spare = false);
    Vec<D, double> momentum();

private:

    template<class T> void enlarge(Array<Backend, T>&, std::size_t room);

    PicSetting<Backend, D, P>& set_;
    std::int64_t all_ = 0;
};

//- Where each cell begins, and where the last one ends, on the host
template<class Backend, int D, class P>
std::vector<int> PicParticleFields<Backend, D, P>::starts() const
{
    std::vector<int> all(std::size_t(set_.grid.cells()) + 1);
    set_.context.toHost(all.data(), sort.start(), all.size()*sizeof(int));
    return all;
}

//- Numbers of those in cells of this rank's brick, which is all where there is one rank; after a
//  sort
template<class Backend, int D, class P>
std::vector<int> PicParticleFields<Backend, D, P>::own() const
{
    std::vector<int> numbers;
    if (!set_.bricks)
    {
        numbers.resize(n);
        std::iota(numbers.begin(), numbers.end(), 0);
        return numbers;
    }
    const UniformGrid<D>& grid = set_.grid;
    const CellBox& brick = set_.bricks->brick();
    const std::vector<int> start = starts();
    int c[3];
    for (c[2] = brick.low[2]; c[2] < brick.high[2]; ++c[2])
        for (c[1] = brick.low[1]; c[1] < brick.high[1]; ++c[1])
        {
            typename UniformGrid<D>::Index at{{brick.low[0], c[1], c[2]}};
            for (int d = 0; d < D; ++d) at.c[d] -= grid.first[d];
            const int first = grid.cell(at), end = first + brick.high[0] - brick.low[0];
            for (int i = start[first]; i < start[end]; ++i) numbers.push_back(i);
        }
    return numbers;
}

//- spare: those that a sort fills
template<class Backend, int D, class P>
PicParticles<D, typename P::real> PicParticleFields<Backend, D, P>::view(bool spare)
{
    const auto field = [&](auto type, int k)
    {
        using T = decltype(type);
        return spare ? values.template spare<T>(k) : values.template data<T>(k);
    };
    PicParticles<D, real> p{};
    p.count = n;
    for (int d = 0; d < D; ++d)
    {
        p.x[d] = field(double(), at.x + d);
        p.v[d] = field(real(), at.v + d);
    }
    for (int k = 0; k < D*D; ++k)
        p.affine[k] = at.affine >= 0 ? field(real(), at.affine + k) : nullptr;
    for (int k = 0; k < scheme.memory(); ++k) p.memory[k] = field(real(), at.memory + k);
    p.id = field(std::int32_t(), at.id);
    p.place = place.data();
    p.start = sort.start();
    return p;
}

template<class Backend, int D, class P>
void PicParticleFields<Backend, D, P>::fill(const std::vector<double>& x,
    const std::vector<double>& v, const std::vector<double>& gradient,
    const std::vector<std::int32_t>& id)
{
    n = int(x.size()/D);
    values = FieldSet<Backend>();
    at.x = values.template add<double>("x");
    for (int d = 1; d < D; ++d) values.template add<double>("x");
    at.v = values.template add<real>("v");
    for (int d = 1; d < D; ++d) values.template add<real>("v");
    if (scheme.gradient())
    {
        at.affine = values.template add<real>("affine");
        for (int k = 1; k < D*D; ++k) values.template add<real>("affine");
    }
    at.id = values.template add<std::int32_t>("id");
    at.memory = values.fields();
    for (int k = 0; k < scheme.memory(); ++k) values.template add<real>("transfer");
    values.allocate(set_.context, n, true);
    sort.allocate(set_.context, n, set_.grid.cells());
    place.allocate(set_.context, n);
    if (set_.config.positionCorrection > 0)
        for (int d = 0; d < D; ++d) shift[d].allocate(set_.context, n);
    std::vector<double> component(n);
    std::vector<real> velocity(n);
    std::vector<std::int32_t> ids(id);
    if (ids.empty()) { ids.resize(n); std::iota(ids.begin(), ids.end(), 0); }
    set_.clock.nextId = n ? std::int64_t(*std::max_element(ids.begin(), ids.end())) + 1 : 0;
    for (int d = 0; d < D; ++d)
    {
        const double length = set_.whole().n[d]*set_.grid.h,
                     margin = set_.grid.periodic[d] ? 0 : set_.wallMargin*set_.grid.h;
        for (int i = 0; i < n; ++i)
        {
            component[i] = std::max(margin, std::min(x[i*D + d], length - margin));
            velocity[i] = real(v[i*D + d]);
        }
        values.upload(set_.context, at.x + d, component);
        values.upload(set_.context, at.v + d, velocity);
    }
    values.upload(set_.context, at.id, ids);
    for (int k = 0; at.affine >= 0 && k < D*D; ++k)
    {
        for (int i = 0; i < n; ++i) velocity[i] = real(gradient[i*D*D + k]);
        values.upload(set_.context, at.affine + k, velocity);
    }
    for (int k = 0; k < scheme.memory(); ++k)
        values.upload(set_.context, at.memory + k, std::vector<real>(n, real(0)));
}

//- More particles, after the others
template<class Backend, int D, class P>
void PicParticleFields<Backend, D, P>::append(const std::vector<EnteringParticle<D>>& those)
{
    const int more = int(those.size()), first = n;
    if (!more) return;
    reserve(std::size_t(n) + more);
    std::vector<double> x(more);
    std::vector<real> v(more);
    std::vector<std::int32_t> id(more);
    const auto put = [&](int field, const auto& of)
    {
        set_.context.toDevice(values.bytes(field) + std::size_t(first)*sizeof(of[0]), of.data(),
            of.size()*sizeof(of[0]));
    };
    for (int d = 0; d < D; ++d)
    {
        for (int i = 0; i < more; ++i) { x[i] = those[i].x.c[d]; v[i] = real(those[i].v.c[d]); }
        put(at.x + d, x);
        put(at.v + d, v);
    }
    for (int i = 0; i < more; ++i) { id[i] = those[i].id; v[i] = 0; }
    put(at.id, id);
    for (int k = 0; at.affine >= 0 && k < D*D; ++k) put(at.affine + k, v);
    for (int k = 0; k < scheme.memory(); ++k) put(at.memory + k, v);
    if (set_.config.positionCorrection > 0)
        for (int d = 0; d < D; ++d) set_.context.zero(shift[d].data() + first, more*sizeof(real));
    n += more;
}

//- Room for so many particles; those that there are stay
template<class Backend, int D, class P>
void PicParticleFields<Backend, D, P>::reserve(std::size_t count)
{
    if (count <= values.size()) return;
    const std::size_t room = count + count/4;
    std::vector<std::vector<unsigned char>> kept(values.fields());
    for (int k = 0; k < values.fields(); ++k)
    {
        kept[k].resize(std::size_t(n)*values.elementBytes(k));
        if (n) set_.context.toHost(kept[k].data(), values.bytes(k), kept[k].size());
    }
    values.allocate(set_.context, room);
    for (int k = 0; k < values.fields(); ++k)
        if (n) set_.context.toDevice(values.bytes(k), kept[k].data(), kept[k].size());
    sort.allocate(set_.context, room, set_.grid.cells());
    enlarge(place, room);
    // this step's, which solids that run over particles still ask for
    if (set_.config.positionCorrection > 0) for (int d = 0; d < D; ++d) enlarge(shift[d], room);
}

//- With what it holds
template<class Backend, int D, class P>
template<class T>
void PicParticleFields<Backend, D, P>::enlarge(Array<Backend, T>& array, std::size_t room)
{
    std::vector<T> kept = array.download();
    kept.resize(room);
    array.upload(set_.context, kept);
}

//- Sum of the particles' momentum along the solved directions
template<class Backend, int D, class P>
Vec<D, double> PicParticleFields<Backend, D, P>::momentum()
{
    Vec<D, double> sum{};
    const double mass = set_.config.density*set_.clock.particleVolume;
    for (int d = 0; d < D; ++d)
    {
        const std::vector<real> v = values.template download<real>(set_.context, at.v + d);
        for (int i = 0; i < n; ++i) sum[d] += mass*v[i];
    }
    return sum;
}

} // namespace riprap

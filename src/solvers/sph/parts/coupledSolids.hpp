/*  Solids in the fluid: their own scene, their points among the fluid, and what they do to its
    particles.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/neighbours/cellSort.hpp"
#include "coupling/couplings.hpp"
#include "coupling/fluidForces.hpp"
#include "coupling/solidPasses.hpp"
#include "solvers/sph/parts/sphSetting.hpp"
#include "solvers/sph/sphInstances.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class CoupledSolids
{
public:

    using real = typename P::real;
    using position = typename P::position;

    std::unique_ptr<DemScene> scene;
    SolidSide<D, P>* side = nullptr;            // the same; null: there are none
    CouplingConfig coupling;
    int count = 0, subcycles = 0;
    bool meetFluid = false;                     // is there fluid near any of them?
    Array<Backend, int> meets;
    Records<Backend, D, P> records;
    CellSort<Backend> sort;
    Array<Backend, position> reference;         // where they were when neighbours were sought
    Array<Backend, real> own[D];
    Array<Backend, real> mass, velocity, acceleration, force, forceBefore;

    explicit CoupledSolids(SphSetting<Backend, D, P>& set) : set_(set) {}

    //- particles: of the fluid
    void set(SolidPart, int particles);
    void allocateAction(int particles);

    SolidPoints<D, P> points();

    //- How solids get the fluid's force
    const FluidForceCard& fluidForce() const { return fluidForceOf(coupling.force); }

    //- Of solids on the fluid
    SolidAction<D, real> action();

    //- By key, -1 of those that have left; and the keys of the others, ascending
    std::vector<std::int32_t> ids(std::vector<int>& there);

    std::size_t cellBytes() const { return sort.bytes() + reference.bytes() + last_.bytes(); }
    std::size_t motionBytes() const
    {
        return own[0].bytes()*D + mass.bytes() + massOfKey_.bytes() + addedOfKey_.bytes()
            + velocity.bytes() + acceleration.bytes();
    }
    std::size_t actionBytes() const
    {
        return actionA_[0].bytes()*D + actionRate_.bytes() + actionDrift_[0].bytes()*D;
    }

private:

    SphSetting<Backend, D, P>& set_;
    Array<Backend, std::int64_t> last_;
    Array<Backend, real> massOfKey_, addedOfKey_;
    Array<Backend, real> actionA_[D], actionRate_, actionDrift_[D];
};

template<class Backend, int D, class P>
void CoupledSolids<Backend, D, P>::set(SolidPart part, int particles)
{
    if (!part.scene) return;
    scene = std::move(part.scene);
    side = dynamic_cast<SolidSide<D, P>*>(scene.get());
    if (!side || scene->device() != (Backend::gpu ? DeviceKind::gpu : DeviceKind::cpu))
        throw std::invalid_argument(
            "solids of another device, dimension or precision than the fluid's");
    dynamic_cast<LaunchOrder<Backend>&>(*scene).follow(set_.context);
    coupling = part.coupling;
    count = side->keys();
    const std::size_t all = std::size_t(count)*D;
    records.allocate(set_.context, count, set_.model.variableH);
    sort.allocate(set_.context, count, set_.grid.cells);
    reference.allocate(set_.context, all);
    last_.allocate(set_.context, all);
    // packs may be loaded at the last point
    for (auto& u : own) u.allocate(set_.context, std::size_t(count) + 16);
    mass.allocate(set_.context, std::size_t(count) + 16);
    for (auto* a : {&velocity, &acceleration, &force}) a->allocate(set_.context, all);
    if (fluidForce().eachSubstep) forceBefore.allocate(set_.context, all);
    std::vector<real> massByKey(count);
    for (int k = 0; k < count; ++k) massByKey[k] = real(set_.config.density*part.volume[k]);
    massOfKey_.upload(set_.context, massByKey);
    addedOfKey_.upload(set_.context, std::vector<real>(part.added.begin(), part.added.end()));
    allocateAction(particles);
    forEach(set_.context, count, FirstVelocities<D, P>{side->view(), points()});
}

template<class Backend, int D, class P>
void CoupledSolids<Backend, D, P>::allocateAction(int particles)
{
    for (int d = 0; d < D; ++d) actionA_[d].allocate(set_.context, particles);
    actionRate_.allocate(set_.context, particles);
    if (coupling.xsph)
        for (int d = 0; d < D; ++d) actionDrift_[d].allocate(set_.context, particles);
}

template<class Backend, int D, class P>
SolidPoints<D, P> CoupledSolids<Backend, D, P>::points()
{
    SolidPoints<D, P> p{};
    p.key = sort.order();
    p.active = sort.active();
    p.mass = mass.data();
    p.massOfKey = massOfKey_.data();
    p.addedOfKey = addedOfKey_.data();
    for (int d = 0; d < D; ++d)
    {
        p.last[d] = last_.data() + std::size_t(d)*count;
        p.own[d] = own[d].data();
    }
    p.velocity = velocity.data();
    p.acceleration = acceleration.data();
    p.force = force.data();
    return p;
}

template<class Backend, int D, class P>
SolidAction<D, typename P::real> CoupledSolids<Backend, D, P>::action()
{
    SolidAction<D, real> a{};
    if (!meetFluid) return a;
    for (int d = 0; d < D; ++d)
    {
        a.a[d] = actionA_[d].data();
        a.drift[d] = coupling.xsph ? actionDrift_[d].data() : nullptr;
    }
    a.rate = actionRate_.data();
    return a;
}

template<class Backend, int D, class P>
std::vector<std::int32_t> CoupledSolids<Backend, D, P>::ids(std::vector<int>& there)
{
    std::vector<std::int32_t> byKey(count, -1);
    if (!side) return byKey;
    const std::vector<std::int32_t> keys = side->order(), id = scene->motion().id;
    for (std::size_t i = 0; i < keys.size(); ++i) byKey[keys[i]] = id[i];
    for (int key = 0; key < count; ++key) if (byKey[key] >= 0) there.push_back(key);
    return byKey;
}

} // namespace riprap

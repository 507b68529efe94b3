/*  Everything that is read back.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/loops/reduceMax.hpp"
#include "dem/passes/contactProbe.hpp"
#include "dem/walls/deepestAtWalls.hpp"
#include "dem/walls/wallForceSums.hpp"
#include "solvers/dem/driver/contactForces.hpp"
#include "solvers/dem/driver/rankedSolids.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class SceneReadings
{
public:

    using real = typename P::real;
    static constexpr int S = spins<D>;

    SceneReadings(DemParts<Backend, D, P>& parts, ContactForces<Backend, D, P>& forces,
        RankedSolids<Backend, D, P>& ranks)
        : p_(parts), forces_(forces), ranks_(ranks)
    {}

    // As DemScene has them
    DemState particles() { return particles(false).take(); }
    DemState motion();
    Later<DemState> particlesLater() { return particles(true); }
    DemContacts contacts();
    DemClumpState clumps();
    std::vector<DemSpringState> springs() { return p_.clumps.springs(bodies()); }
    DemEnergy energy();
    DemGroupSums groupSums(int group);
    DemMomentum momentum();
    double deepestOverlap();
    std::vector<DemWallForce> wallForces();
    std::vector<ArrayInfo> arrays() const;
    std::vector<KernelInfo> kernels() const;
    double neighboursPerParticle();
    double contactsPerParticle();

private:

    double halfStep() const;
    std::vector<ClumpData> bodies();
    // of a snapshot, where they are wanted later
    Later<DemState> particles(bool later);
    std::function<DemState()> motion(Snapshot<Backend>& now);
    ReadValues<double> orientations(Snapshot<Backend>& now, int n);
    std::function<DemState()> fields(Snapshot<Backend>& now, int n);
    ReadValues<std::int32_t> contactCounts(Snapshot<Backend>& now, int n);
    ReadValues<int> wallContacts(Snapshot<Backend>& now);
    void toNow(DemState&, int i, double half, double inverseInertia, bool asleep,
        const real* more) const;
    void dropGhosts(DemState&);
    template<class Put> void eachWallContact(int n, const Put&);
    std::vector<int> atWalls(const std::vector<int>& first);
    Array<Backend, ProbedContact<real>> probe(ProbedForce<D, real>* forces = nullptr);
    ContactSums<Backend, real> contactSums(const Array<Backend, ProbedContact<real>>& probed);

    DemParts<Backend, D, P>& p_;
    ContactForces<Backend, D, P>& forces_;
    RankedSolids<Backend, D, P>& ranks_;
};

//- By how much velocities of now are ahead of those kept
template<class Backend, int D, class P>
double SceneReadings<Backend, D, P>::halfStep() const
{ return p_.set.integrator.lag*p_.clock.now.dt; }

//- Quaternions of the first n, in the axes of the scene
template<class Backend, int D, class P>
ReadValues<double> SceneReadings<Backend, D, P>::orientations(Snapshot<Backend>& now, int n)
{
    std::vector<ReadValues<real>> component(D == 2 ? 1 : 4);
    for (std::size_t k = 0; k < component.size(); ++k)
        component[k] = p_.particles.template fieldOf<real>(
            now, n, p_.particles.at.turn + int(k));
    return [this, component, n]
    {
        std::vector<double> turns(4*std::size_t(n), 0.0);
        for (int k = 0; k < int(component.size()); ++k)
        {
            const std::vector<real> q = component[k]();
            #pragma omp parallel for schedule(static) if (n > 10000)
            for (int i = 0; i < n; ++i)
            {
                if (D == 3) { turns[4*std::size_t(i) + k] = double(q[i]); continue; }
                turns[4*std::size_t(i)] = std::cos(0.5*double(q[i]));
                turns[4*std::size_t(i) + 1 + p_.set.config.axes[2]] = p_.set.spinSign()
                    *std::sin(0.5*double(q[i]));
            }
        }
        return turns;
    };
}

//- As the device has it, ghosts included
template<class Backend, int D, class P>
std::function<DemState()> SceneReadings<Backend, D, P>::fields(Snapshot<Backend>& now, int n)
{
    ParticleFields<Backend, D, P>& all = p_.particles;
    const SolidFieldNumbers& at = all.at;
    const auto position = all.positionsOf(now, n);
    const auto velocity = all.template vectorOf<double>(now, n, at.v, D, false);
    const auto spin = all.template vectorOf<real>(now, n, at.w, S, true);
    const auto force = all.template vectorOf<real>(now, n, at.f, D, false);
    const auto moment = all.template vectorOf<real>(now, n, at.m, S, true);
    const auto material = all.template fieldOf<std::int32_t>(now, n, at.material);
    const auto group = all.template fieldOf<std::int32_t>(now, n, at.group);
    ReadValues<std::int32_t> clump;
    if (at.clump >= 0) clump = all.template fieldOf<std::int32_t>(now, n, at.clump);
    ReadValues<double> turned;
    if (at.turn >= 0) turned = orientations(now, n);
    return [=]
    {
        DemState s;
        s.position = position();
        s.velocity = velocity();
        s.spin = spin();
        s.force = force();
        s.moment = moment();
        s.material = material();
        s.group = group();
        s.clump = clump ? clump() : std::vector<std::int32_t>(n, -1);
        s.id.resize(n);
        for (auto* v : {&s.radius, &s.mass}) v->resize(n);
        if (turned) s.orientation = turned();
        return s;
    };
}

template<class Backend, int D, class P>
void SceneReadings<Backend, D, P>::dropGhosts(DemState& s)
{
    for (auto* v : {&s.position, &s.velocity, &s.spin, &s.force, &s.moment})
        ranks_.dropGhosts(*v, 3);
    for (auto* v : {&s.radius, &s.mass}) ranks_.dropGhosts(*v, 1);
    for (auto* v : {&s.material, &s.group, &s.clump, &s.id}) ranks_.dropGhosts(*v, 1);
    ranks_.dropGhosts(s.orientation, 4);
}

template<class Backend, int D, class P>
DemState SceneReadings<Backend, D, P>::motion()
{
    Snapshot<Backend> now(p_.set.context, false);
    return motion(now)();
}

template<class Backend, int D, class P>
std::function<DemState()> SceneReadings<Backend, D, P>::motion(Snapshot<Backend>& now)
{
    p_.clock.read();
    const int n = p_.order.active();
    const SolidFieldNumbers& at = p_.particles.at;
    const std::function<DemState()> read = fields(now, n);
    const auto keys = p_.particles.template fieldOf<std::int32_t>(now, n, at.id);
    const auto radii = p_.particles.template fieldOf<real>(now, n, at.radius),
               masses = p_.particles.template fieldOf<real>(now, n, at.mass),
               inverses = p_.particles.template fieldOf<real>(now, n, at.inertia);
    const auto externals = now.values(p_.particles.external);
    ReadValues<std::int32_t> calms;
    if (at.calm >= 0) calms = p_.particles.template fieldOf<std::int32_t>(now, n, at.calm);
    // leapfrog keeps velocities of half a step ago: forces are of now
    return [=, half = halfStep()]
    {
        DemState s(read());
        const std::vector<std::int32_t> key = keys();
        const std::vector<real> radius = radii(), mass = masses();
        const std::vector<real> inverse = inverses(), external = externals();
        const auto calm = calms ? calms() : std::vector<std::int32_t>();
        #pragma omp parallel for schedule(static) if (n > 10000)
        for (int i = 0; i < n; ++i)
        {
            s.id[i] = p_.particles.ids[key[i]];
            s.radius[i] = double(radius[i]);
            s.mass[i] = double(mass[i]);
            const real* more = external.empty() ? nullptr : &external[std::size_t(key[i])*(D + S)];
            toNow(s, i, half, double(inverse[i]), !calm.empty() && calm[i] >= asleepFrom, more);
        }
        dropGhosts(s);
        return s;
    };
}

//- Forces with those of the group, and velocities half a step on. more: from outside, or null
template<class Backend, int D, class P>
void SceneReadings<Backend, D, P>::toNow(
    DemState& s, int i, double half, double inverseInertia, bool asleep, const real* more) const
{
    const DemConfig& config = p_.set.config;
    const DemGroup& g = p_.set.input.groups[s.group[i]];
    const bool kicked = g.motion < 0 && s.clump[i] < 0 && !asleep;
    for (int d = 0; d < D; ++d)
    {
        const int axis = config.axes[d];
        double& f = s.force[3*std::size_t(i) + axis];
        double& v = s.velocity[3*std::size_t(i) + axis];
        f += (g.gravity ? s.mass[i]*config.gravity[axis] : 0) + g.force[axis]
            + (more ? double(more[d]) : 0);
        const double damped = locallyDamped(f, v, g.localDamping) - g.viscousDamping*s.mass[i]*v;
        if (kicked && !g.held[axis]) v += half*damped/s.mass[i];
    }
    for (int c = 0; c < S; ++c)
    {
        const int axis = D == 2 ? config.axes[2] : c;
        double& m = s.moment[3*std::size_t(i) + axis];
        double& w = s.spin[3*std::size_t(i) + axis];
        m += g.moment[axis] + (more ? (D == 2 ? p_.set.spinSign() : 1)*double(more[D + c]) : 0);
        const double rate = locallyDamped(m, w, g.localDamping)*inverseInertia
            - g.viscousSpinDamping*w;
        if (kicked && !g.heldSpin) w += half*rate;
    }
}

template<class Backend, int D, class P>
Later<DemState> SceneReadings<Backend, D, P>::particles(bool later)
{
    Snapshot<Backend> now(p_.set.context, later && !ranks_.others);
    const std::function<DemState()> moving = motion(now);
    const int n = p_.order.active();
    const auto contacts = contactCounts(now, n);
    const auto broken = std::make_shared<const std::vector<std::int32_t>>(
        p_.bonds.brokenAt(p_.order.slotOf, n));
    const auto all = [=]
    {
        DemState s(moving());
        s.contacts = contacts();
        ranks_.dropGhosts(s.contacts, 1);
        s.brokenBonds = *broken;
        ranks_.dropGhosts(s.brokenBonds, 1);
        return s;
    };
    return takenOf<DemState>(now.keeps() || !later, n, all);
}

//- Slots of walls that carry force
template<class Backend, int D, class P>
ReadValues<int> SceneReadings<Backend, D, P>::wallContacts(Snapshot<Backend>& now)
{
    const auto touched = now.values(p_.walls.memory.on);
    ReadValues<real> remembered;
    withLaw(p_.set.laws, [&](auto law)
    {
        if (decltype(law)::NormalLaw::reaches) remembered = now.values(p_.walls.memory.history);
    });
    return [this, touched, remembered]
    {
        std::vector<int> on = touched();
        withLaw(p_.set.laws, [&](auto law)
        {
            using Law = decltype(law);
            if constexpr (Law::NormalLaw::reaches)
            {
                const auto history = remembered();
                for (std::size_t s = 0; s < on.size(); ++s)
                    on[s] = on[s] && Law::NormalLaw::acts(&history[s*Law::template history<D>]);
            }
        });
        return on;
    };
}

//- Of each entry of the lists of contacts
template<class Backend, int D, class P>
auto SceneReadings<Backend, D, P>::probe(ProbedForce<D, real>* forces)
    -> Array<Backend, ProbedContact<real>>
{
    Array<Backend, ProbedContact<real>> probed;
    probed.allocate(p_.set.context, p_.order.list.entries() + 1);
    withLaw(p_.set.laws, [&](auto law)
    {
        ProbeContacts<Backend, D, P, decltype(law)> pass;
        forces_.setModel(pass);
        pass.out = probed.data();
        pass.forces = forces;
        forEach(p_.set.context, p_.particles.n, pass);
    });
    return probed;
}

template<class Backend, int D, class P>
auto SceneReadings<Backend, D, P>::contactSums(
    const Array<Backend, ProbedContact<real>>& probed) -> ContactSums<Backend, real>
{
    return {p_.order.list.view(), probed.data(), p_.order.sort.active(),
        ranks_.others ? p_.particles.view().calm : nullptr};
}

//- Of the first n with others and with walls: as contacts() lists them, without what they are
template<class Backend, int D, class P>
ReadValues<std::int32_t> SceneReadings<Backend, D, P>::contactCounts(Snapshot<Backend>& now, int n)
{
    const auto counted = std::make_shared<Array<Backend, int>>();
    counted->allocate(p_.set.context, p_.particles.n + 1);
    p_.set.context.zero(counted->data(), counted->size()*sizeof(int));
    const auto probed = probe();
    forEach(p_.set.context, p_.particles.n, CountActing<Backend, real>{p_.order.list.view(),
        probed.data(), p_.order.sort.active(), counted->data()});
    const auto counts = now.values(counted->data(), std::size_t(n));
    const auto hold = now.keeps() ? nullptr : counted;
    if (!p_.walls.count || !p_.walls.memory.entries) return [hold, counts] { return counts(); };
    const auto firsts = now.values(p_.walls.memory.entryFirst);
    const auto acting = wallContacts(now);
    return [hold, counts, firsts, acting, n]
    {
        std::vector<std::int32_t> contacts = counts();
        const std::vector<int> first = firsts(), acts = acting();
        #pragma omp parallel for schedule(static) if (n > 10000)
        for (int i = 0; i < n; ++i)
            for (int e = first[i]; e < first[i + 1]; ++e)
                if (acts[std::size_t(e)*wallTouches]) ++contacts[i];
        return contacts;
    };
}

//- put(particle, number of the wall from -1 down, force, overlap, normal, arm) of each
template<class Backend, int D, class P>
template<class Put>
void SceneReadings<Backend, D, P>::eachWallContact(int n, const Put& put)
{
    if (!p_.walls.count || !p_.walls.memory.entries) return;
    const auto first = p_.walls.memory.entryFirst.download();
    const auto entry = p_.walls.memory.entry.download();
    Snapshot<Backend> now(p_.set.context, false);
    const auto acts = wallContacts(now)();
    const auto material = p_.particles.template field<std::int32_t>(p_.particles.at.material);
    const auto force = p_.walls.memory.force.download(), normal = p_.walls.memory.normal.download();
    const auto radius = p_.particles.template field<real>(p_.particles.at.radius);
    const std::vector<WallData> walls = p_.walls.walls.download();
    for (int i = 0; i < n; ++i)
        for (int e = first[i]; e < first[i + 1]; ++e)
        {
            const int slot = e*wallTouches;
            if (!acts[slot] || ranks_.ghost(i)) continue;
            Vec<D, double> local, f;
            for (int d = 0; d < D; ++d)
            {
                local.c[d] = double(normal[slot*D + d]);
                f.c[d] = double(force[e*wallWords<D> + d]);
            }
            const int other = p_.set.input.walls[entry[e].wall].material;
            const double overlap = double(force[e*wallWords<D> + D + S + 1]);
            // to the wall's surface
            const double arm =
                double(radius[i]) + double(p_.pairs.gap(material[i], other)) - overlap;
            put(i, -1 - entry[e].wall, f, overlap - double(p_.pairs.reach(material[i], other)),
                outOfFrame<D>(walls[entry[e].wall].frame.R, local), arm);
        }
}

template<class Backend, int D, class P>
DemContacts SceneReadings<Backend, D, P>::contacts()
{
    DemContacts out;
    const int n = p_.order.active();
    const std::vector<double> x = p_.particles.positions(n);
    const auto key = p_.particles.template field<std::int32_t>(p_.particles.at.id);
    Array<Backend, ProbedForce<D, real>> probed;
    probed.allocate(p_.set.context, p_.order.list.entries() + 1);
    const auto all = probe(probed.data()).download();
    const auto forces = probed.download();
    const auto [base, count] = p_.order.shape();
    const auto put =
        [&](int i, std::int32_t b, const auto& force, double overlap, const auto& n, double arm)
    {
        out.a.push_back(p_.particles.ids[key[i]]);
        out.b.push_back(b);
        out.overlap.push_back(overlap);
        const std::size_t at = out.force.size();
        out.force.resize(at + 3, 0.0);
        out.point.insert(out.point.end(), x.begin() + 3*i, x.begin() + 3*i + 3);
        for (int d = 0; d < D; ++d)
        {
            out.force[at + p_.set.config.axes[d]] = double(force[d]);
            out.point[at + p_.set.config.axes[d]] += double(n[d])*arm;
        }
    };
    constexpr int width = ContactList<Backend, real>::width;
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < count[i] && !ranks_.ghost(i); ++k)
        {
            const std::size_t e = std::size_t(base[i/width]) + std::size_t(k)*width + i % width;
            const int other = all[e].other;
            if (other < 0 || (Backend::gpu && other < i)) continue;
            const auto& c = forces[e];
            put(i, p_.particles.ids[key[other]], c.force, double(c.overlap), c.n, double(c.arm));
        }
    eachWallContact(n, put);
    return out;
}

//- All of them on each rank
template<class Backend, int D, class P>
std::vector<ClumpData> SceneReadings<Backend, D, P>::bodies()
{ return ranks_.others ? ranks_.bodies.all() : p_.clumps.known(); }

template<class Backend, int D, class P>
DemClumpState SceneReadings<Backend, D, P>::clumps()
{
    p_.clock.read();
    return p_.clumps.state(bodies(), halfStep());
}

template<class Backend, int D, class P>
DemEnergy SceneReadings<Backend, D, P>::energy()
{
    DemEnergy e;
    p_.clock.read();
    const std::vector<ClumpData> bodies = p_.clumps.reported();
    SumEnergies<D, P> free{};
    forces_.setMotion(free);
    free.box = p_.set.box;
    free.half = real(halfStep());
    const auto sums = sumOver<3>(p_.set.context, p_.order.active(), free);
    e.translation = sums[0];
    e.rotation = sums[1];
    e.potential = sums[2];
    p_.clumps.addEnergies(p_.clumps.state(bodies, halfStep()), e);
    e.spring = p_.clumps.springEnergy(bodies);
    const auto probed = probe();
    e.contact = sumOver<2>(p_.set.context, p_.order.active(), contactSums(probed))[0];
    const auto wall = p_.walls.memory.entries ? p_.walls.memory.force.download()
                                              : std::vector<real>();
    if (!ranks_.others)
        for (int k = 0; k < p_.walls.memory.entries; ++k)
            e.contact += double(wall[k*wallWords<D> + D + S]);
    const int held = ranks_.others && p_.walls.memory.entries ? p_.order.active() : 0;
    for (int i = 0; i < held; ++i)
        for (int k = p_.walls.memory.entryFirst.data()[i];
             !ranks_.ghost(i) && k < p_.walls.memory.entryFirst.data()[i + 1]; ++k)
            e.contact += double(wall[k*wallWords<D> + D + S]);
    e.bond = p_.bonds.energy(p_.order.slotOf);
    return e;
}

template<class Backend, int D, class P>
DemGroupSums SceneReadings<Backend, D, P>::groupSums(int group)
{
    p_.clock.read();
    DemGroupSums r;
    SumGroup<D, P> sum{};
    forces_.setMotion(sum);
    sum.box = p_.set.box;
    sum.half = real(halfStep());
    sum.group = group;
    const int n = p_.order.active();
    const auto sums = sumOver<2 + 2*D>(p_.set.context, n, sum);
    r.particles = sums[0];
    r.mass = sums[1];
    for (int d = 0; d < D; ++d)
    {
        const int axis = p_.set.config.axes[d];
        r.massPosition[axis] = sums[2 + d];
        r.momentum[axis] = sums[2 + D + d];
        if (!r.particles) continue;
        const auto reach = [&](bool up)
        {
            return reduceMax(p_.set.context, n,
                GroupReach<D, P>{
                    p_.particles.view(), p_.set.box, p_.order.sort.active(), group, d, up});
        };
        r.max[axis] = p_.set.box.lower[d] + reach(true);
        r.min[axis] = p_.set.box.lower[d] + p_.set.box.length[d] - reach(false);
    }
    return r;
}

template<class Backend, int D, class P>
DemMomentum SceneReadings<Backend, D, P>::momentum()
{
    p_.clock.read();
    DemMomentum r;
    SumMomentum<D, P> sum{};
    forces_.setMotion(sum);
    sum.box = p_.set.box;
    sum.half = real(halfStep());
    const auto sums = sumOver<D + S>(p_.set.context, p_.order.active(), sum);
    for (int d = 0; d < D; ++d) r.linear[p_.set.config.axes[d]] = sums[d];
    for (int c = 0; c < S; ++c)
        r.angular[D == 2 ? p_.set.config.axes[2] : c] = (D == 2 ? p_.set.spinSign() : 1)
            *sums[D + c];
    return r;
}

template<class Backend, int D, class P>
double SceneReadings<Backend, D, P>::deepestOverlap()
{
    const auto probed = probe();
    double most = reduceMax(p_.set.context, p_.order.active(), contactSums(probed));
    if (!p_.walls.count || !p_.walls.memory.entries) return most;
    std::vector<double> gaps;
    for (int m = 0; m < p_.pairs.materials(); ++m)
        for (const auto& wall : p_.set.input.walls)
            gaps.push_back(double(p_.pairs.gap(m, wall.material)));
    Array<Backend, double> gap;
    gap.upload(p_.set.context, gaps);
    const SolidFields<D, P> solids = p_.particles.view();
    return std::max(most, reduceMax(p_.set.context, p_.order.active(), DeepestAtWalls<D, P>{solids,
        p_.walls.memory.entryFirst.data(), p_.walls.memory.entry.data(),
        p_.walls.memory.force.data(), gap.data(), int(p_.set.input.walls.size()),
        p_.order.sort.active(), ranks_.others ? solids.calm : nullptr}));
}

//- Slots that have entries of walls, which begin at first, and are no ghosts
template<class Backend, int D, class P>
std::vector<int> SceneReadings<Backend, D, P>::atWalls(const std::vector<int>& first)
{
    const int n = p_.order.active();            // of a GPU the host asks
    std::vector<int> near;
    for (int i = 0; i < n; ++i)
        if (first[i] < first[i + 1] && !ranks_.ghost(i)) near.push_back(i);
    return near;
}

template<class Backend, int D, class P>
std::vector<DemWallForce> SceneReadings<Backend, D, P>::wallForces()
{
    std::vector<DemWallForce> out(p_.walls.count);
    if (!p_.walls.count || !p_.walls.memory.entries) return out;
    const auto& memory = p_.walls.memory;
    const SolidFields<D, P> solids = p_.particles.view();
    WallForceSums<D, P> sum{solids, p_.set.box, memory.entryFirst.data(), memory.entry.data(),
        memory.force.data(), memory.on.data(), memory.normal.data(), p_.walls.walls.data(),
        {p_.set.config.axes[0], p_.set.config.axes[1], p_.set.config.axes[2]},
        double(p_.set.spinSign()), p_.order.sort.active(),
        ranks_.others ? solids.calm : nullptr, 0};
    const auto put = [](DemWallForce& to, const double* sums)
    {
        for (int d = 0; d < 3; ++d)
        {
            to.force[d] += sums[d];
            to.moment[d] += sums[3 + d];
            to.normal[d] += sums[6 + d];
            to.normalMoment[d] += sums[9 + d];
        }
    };
    if constexpr (Backend::gpu && D == 3)
    {
        for (sum.wall = 0; sum.wall < p_.walls.count; ++sum.wall)
            put(out[sum.wall],
                sumOver<sum.values>(p_.set.context, p_.order.active(), sum).data());
        return out;
    }
    // in the order of particles
    const auto first = memory.entryFirst.download();
    const auto entry = memory.entry.download();
    const auto force = memory.force.download(), normal = memory.normal.download();
    const auto on = memory.on.download();
    const std::vector<WallData> walls = p_.walls.walls.download();
    sum.entry = entry.data();
    sum.force = force.data();
    sum.normal = normal.data();
    sum.on = on.data();
    sum.walls = walls.data();
    const std::vector<int> near = atWalls(first);
    const std::vector<double> x = p_.particles.positionsOf(near);
    for (std::size_t k = 0; k < near.size(); ++k)
        for (int e = first[near[k]]; e < first[near[k] + 1]; ++e)
        {
            double of[sum.values] = {};
            sum.addEntry(e, {{x[3*k], x[3*k + 1], x[3*k + 2]}}, of);
            put(out[entry[e].wall], of);
        }
    return out;
}

template<class Backend, int D, class P>
std::vector<ArrayInfo> SceneReadings<Backend, D, P>::arrays() const
{
    std::vector<ArrayInfo> r;
    const std::size_t n = std::max(p_.particles.n, 1);
    const auto put = [&](const char* set, const std::string& name, std::size_t bytes)
    { if (bytes) r.push_back(ArrayInfo{set, name, bytes/n, bytes}); };
    for (const auto& f : p_.particles.values.info()) put("solids", f.name, f.bytes);
    put("solids", "records", p_.order.records.bytes());
    put("solids", "reference", p_.order.reference.bytes());
    put("solids", "sort",
        p_.order.sort.bytes() + p_.order.inverse.bytes() + p_.order.slotOf.bytes());
    put("contacts", "lists and histories", p_.order.list.bytes() + p_.order.oldList.bytes());
    if constexpr (Backend::gpu)
    {
        put("solids", "fused steps",
            p_.memory.records.bytes() + p_.memory.low.bytes() + p_.memory.own.bytes()
                + p_.memory.frames.bytes());
        put("contacts", "rebuilding",
            p_.memory.nearCount.bytes() + p_.memory.keptFirst.bytes()
                + p_.memory.keptPartner.bytes() + p_.memory.keptHistory.bytes()
                + p_.memory.wallListFirst.bytes() + p_.memory.wallList.bytes());
        put("solids", "order",
            p_.memory.place.bytes() + p_.memory.order.bytes() + p_.memory.cost.bytes()
                + p_.memory.found.bytes() + p_.memory.foundNear.bytes()
                + p_.memory.foundWalls.bytes() + p_.memory.foundElements.bytes());
    }
    put("bonds", "bonds", p_.bonds.bytes());
    put("clumps", "clumps", p_.clumps.bytes());
    put("walls", "surfaces", p_.walls.bytes());
    put("walls", "contacts", p_.walls.memory.bytes() + p_.walls.oldMemory.bytes());
    return r;
}

template<class Backend, int D, class P>
std::vector<KernelInfo> SceneReadings<Backend, D, P>::kernels() const
{
    std::vector<KernelInfo> r;
    for (const auto& e : p_.set.context.profile.entries())
        r.push_back(KernelInfo{e.name, e.launches, e.seconds});
    return r;
}

template<class Backend, int D, class P>
double SceneReadings<Backend, D, P>::neighboursPerParticle()
{
    std::vector<int> count(std::size_t(p_.order.list.blocks())*p_.order.list.width);
    p_.set.context.toHost(count.data(), p_.order.list.count(), count.size()*sizeof(int));
    double sum = 0;
    const int n = p_.order.active();
    for (int i = 0; i < n; ++i) sum += count[i];
    return n ? sum*(Backend::gpu ? 1 : 2)/n : 0;
}

template<class Backend, int D, class P>
double SceneReadings<Backend, D, P>::contactsPerParticle()
{
    p_.clock.read();
    const int n = p_.order.active();
    const auto probed = probe();
    const double contacts = sumOver<2>(p_.set.context, n, contactSums(probed))[1];
    return n ? 2*contacts/n : 0;
}

} // namespace riprap

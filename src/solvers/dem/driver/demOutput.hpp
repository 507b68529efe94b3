/*  DemSolver: everything that is read back.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/loops/largest.hpp"
#include "dem/passes/contactProbe.hpp"
#include "solvers/dem/driver/demSolver.hpp"

namespace riprap
{

template<class Backend, int D, class P>
int DemSolver<Backend, D, P>::activeSolids()
{
    int active = 0;
    set_.context.toHost(&active, sort_.active(), sizeof(int));
    return active;
}

template<class Backend, int D, class P>
DemState DemSolver<Backend, D, P>::motion()
{
    clock_.read();
    const int n = activeSolids();
    DemState s;
    s.position = particles_.positions(n);
    s.velocity = particles_.template vector<double>(n, particles_.at.v, D, false);
    s.spin = particles_.template vector<real>(n, particles_.at.w, S, true);
    s.force = particles_.template vector<real>(n, particles_.at.f, D, false);
    s.moment = particles_.template vector<real>(n, particles_.at.m, S, true);
    const auto key = particles_.template field<std::int32_t>(particles_.at.id);
    const auto radius = particles_.template field<real>(particles_.at.radius), mass = particles_.template field<real>(particles_.at.mass), inverse = particles_.template field<real>(particles_.at.inertia);
    s.material = particles_.template field<std::int32_t>(particles_.at.material);
    s.group = particles_.template field<std::int32_t>(particles_.at.group);
    s.clump = particles_.at.clump < 0 ? std::vector<std::int32_t>(n, -1) : particles_.template field<std::int32_t>(particles_.at.clump);
    for (auto* v : {&s.material, &s.group, &s.clump}) v->resize(n);
    const std::vector<real> external = particles_.external.download();
    const auto calm = particles_.at.calm < 0 ? std::vector<std::int32_t>() : particles_.template field<std::int32_t>(particles_.at.calm);
    // leapfrog keeps velocities of half a step ago: forces are of now
    const double half = halfStep();
    for (auto* v : {&s.radius, &s.mass}) v->resize(n);
    s.id.resize(n);
    #pragma omp parallel for schedule(static) if (n > 10000)
    for (int i = 0; i < n; ++i)
    {
        s.id[i] = particles_.ids[key[i]];
        s.radius[i] = double(radius[i]);
        s.mass[i] = double(mass[i]);
        const DemGroup& g = set_.input.groups[s.group[i]];
        const bool asleep = !calm.empty() && calm[i] >= asleepFrom, kicked = g.motion < 0 && s.clump[i] < 0 && !asleep;
        const real* more = external.empty() ? nullptr : &external[std::size_t(key[i])*(D + S)];
        for (int d = 0; d < D; ++d)
        {
            const std::size_t at = 3*std::size_t(i) + set_.config.axes[d];
            double& f = s.force[at];
            double& v = s.velocity[at];
            f += (g.gravity ? s.mass[i]*set_.config.gravity[set_.config.axes[d]] : 0) + g.force[set_.config.axes[d]] + (more ? double(more[d]) : 0);
            const double damped = locallyDamped(f, v, g.localDamping) - g.viscousDamping*s.mass[i]*v;
            if (kicked && !g.held[set_.config.axes[d]]) v += half*damped/s.mass[i];
        }
        for (int c = 0; c < S; ++c)
        {
            const int axis = D == 2 ? set_.config.axes[2] : c;
            const std::size_t at = 3*std::size_t(i) + axis;
            double& m = s.moment[at];
            double& w = s.spin[at];
            m += g.moment[axis] + (more ? (D == 2 ? set_.spinSign() : 1)*double(more[D + c]) : 0);
            const double rate = locallyDamped(m, w, g.localDamping)*double(inverse[i]) - g.viscousSpinDamping*w;
            if (kicked && !g.heldSpin) w += half*rate;
        }
    }
    if (particles_.at.turn >= 0)
    {
        s.orientation.assign(4*std::size_t(n), 0.0);
        for (int k = 0; k < (D == 2 ? 1 : 4); ++k)
        {
            const auto q = particles_.template field<real>(particles_.at.turn + k);
            for (int i = 0; i < n; ++i)
            {
                if (D == 3) { s.orientation[4*std::size_t(i) + k] = double(q[i]); continue; }
                s.orientation[4*std::size_t(i)] = std::cos(0.5*double(q[i]));
                s.orientation[4*std::size_t(i) + 1 + set_.config.axes[2]] = set_.spinSign()*std::sin(0.5*double(q[i]));
            }
        }
    }
    for (auto* v : {&s.position, &s.velocity, &s.spin, &s.force, &s.moment}) dropGhosts(*v, 3);
    for (auto* v : {&s.radius, &s.mass}) dropGhosts(*v, 1);
    for (auto* v : {&s.material, &s.group, &s.clump, &s.id}) dropGhosts(*v, 1);
    dropGhosts(s.orientation, 4);
    return s;
}

template<class Backend, int D, class P>
DemState DemSolver<Backend, D, P>::particles()
{
    DemState s(motion());
    const int n = activeSolids();
    s.contacts = contactCounts(n);
    dropGhosts(s.contacts, 1);
    s.brokenBonds = bonds_.brokenAt(slotOf_, n);
    dropGhosts(s.brokenBonds, 1);
    return s;
}

//- Of the first n with others and with walls: as contacts() lists them, without what they are
//- Slots of walls that carry force
template<class Backend, int D, class P>
std::vector<int> DemSolver<Backend, D, P>::wallContacts()
{
    std::vector<int> on = wallMemory_.on.download();
    withLaw(set_.laws, [&](auto law)
    {
        using Law = decltype(law);
        if constexpr (Law::NormalLaw::reaches)
        {
            const auto history = wallMemory_.history.download();
            for (std::size_t s = 0; s < on.size(); ++s) on[s] = on[s] && Law::NormalLaw::acts(&history[s*Law::template history<D>]);
        }
    });
    return on;
}

template<class Backend, int D, class P>
std::vector<std::int32_t> DemSolver<Backend, D, P>::contactCounts(int n)
{
    std::vector<std::int32_t> contacts(n, 0);
    Array<Backend, int> others;
    others.allocate(set_.context, list_.entries() + 1);
    withLaw(set_.laws, [&](auto law)
    {
        ContactProbe<Backend, D, P, decltype(law)> probe;
        setModel(probe);
        forEach(set_.context, particles_.n, ProbeOthers<Backend, D, P, decltype(law)>{probe, others.data()});
    });
    const auto all = others.download();
    std::vector<int> base(list_.blocks() + 1), count(std::size_t(list_.blocks())*list_.width);
    set_.context.toHost(base.data(), list_.base(), base.size()*sizeof(int));
    set_.context.toHost(count.data(), list_.count(), count.size()*sizeof(int));
    constexpr int width = ContactList<Backend, real>::width;
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < count[i]; ++k)
        {
            const int j = all[std::size_t(base[i/width]) + std::size_t(k)*width + i % width];
            if (j < 0 || (Backend::gpu && j < i)) continue;
            ++contacts[i];
            ++contacts[j];
        }
    if (!nWalls_ || !wallMemory_.entries) return contacts;
    const auto first = wallMemory_.entryFirst.download();
    const auto acts = wallContacts();
    for (int i = 0; i < n; ++i)
        for (int e = first[i]; e < first[i + 1]; ++e) if (acts[std::size_t(e)*wallTouches]) ++contacts[i];
    return contacts;
}

template<class Backend, int D, class P>
DemContacts DemSolver<Backend, D, P>::contacts()
{
    DemContacts out;
    const int n = activeSolids();
    const std::vector<double> x = particles_.positions(n);
    const auto key = particles_.template field<std::int32_t>(particles_.at.id);
    Array<Backend, ProbedContact<D, real>> probed;
    probed.allocate(set_.context, list_.entries() + 1);
    withLaw(set_.laws, [&](auto law)
    {
        ContactProbe<Backend, D, P, decltype(law)> probe;
        setModel(probe);
        forEach(set_.context, particles_.n, ProbeAll<Backend, D, P, decltype(law)>{probe, probed.data()});
    });
    const auto all = probed.download();
    std::vector<int> base(list_.blocks() + 1), count(std::size_t(list_.blocks())*list_.width);
    set_.context.toHost(base.data(), list_.base(), base.size()*sizeof(int));
    set_.context.toHost(count.data(), list_.count(), count.size()*sizeof(int));
    const auto put = [&](int i, std::int32_t b, const auto& force, double overlap, const auto& n, double arm)
    {
        out.a.push_back(particles_.ids[key[i]]);
        out.b.push_back(b);
        out.overlap.push_back(overlap);
        const std::size_t at = out.force.size();
        out.force.resize(at + 3, 0.0);
        out.point.insert(out.point.end(), x.begin() + 3*i, x.begin() + 3*i + 3);
        for (int d = 0; d < D; ++d)
        {
            out.force[at + set_.config.axes[d]] = double(force[d]);
            out.point[at + set_.config.axes[d]] += double(n[d])*arm;
        }
    };
    constexpr int width = ContactList<Backend, real>::width;
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < count[i] && !ghost(i); ++k)
        {
            const auto& c = all[std::size_t(base[i/width]) + std::size_t(k)*width + i % width];
            if (c.other < 0 || (Backend::gpu && c.other < i)) continue;
            put(i, particles_.ids[key[c.other]], c.force, double(c.overlap), c.n, double(c.arm));
        }
    if (!nWalls_ || !wallMemory_.entries) return out;
    const auto first = wallMemory_.entryFirst.download();
    const auto entry = wallMemory_.entry.download();
    const auto acts = wallContacts();
    const auto material = particles_.template field<std::int32_t>(particles_.at.material);
    const auto force = wallMemory_.force.download();
    const auto normal = wallMemory_.normal.download();
    const auto radius = particles_.template field<real>(particles_.at.radius);
    const std::vector<WallData> walls = walls_.download();
    for (int i = 0; i < n; ++i)
        for (int e = first[i]; e < first[i + 1]; ++e)
        {
            const int slot = e*wallTouches;
            if (!acts[slot] || ghost(i)) continue;
            Vec<D, double> local, f;
            for (int d = 0; d < D; ++d) { local.c[d] = double(normal[slot*D + d]); f.c[d] = double(force[e*wallWords<D> + d]); }
            const real reach = pairs_.reach(material[i], set_.input.walls[entry[e].wall].material);
            put(i, -1 - entry[e].wall, f, double(force[e*wallWords<D> + D + S + 1]) - double(reach), outOfFrame<D>(walls[entry[e].wall].frame.R, local), double(radius[i]));
        }
    return out;
}

//- By how much velocities of now are ahead of those kept
template<class Backend, int D, class P>
double DemSolver<Backend, D, P>::halfStep() const
{ return set_.config.integrator == DemIntegratorKind::leapfrog ? 0.5*clock_.now.dt : 0; }

template<class Backend, int D, class P>
DemClumpState DemSolver<Backend, D, P>::clumps()
{
    clock_.read();
    return clumps_.state(halfStep());
}

template<class Backend, int D, class P>
DemEnergy DemSolver<Backend, D, P>::energy()
{
    DemEnergy e;
    const DemClumpState c = clumps();
    SumEnergies<D, P> free{};
    setMotion(free);
    free.box = set_.box;
    free.half = real(halfStep());
    const auto sums = sumOver<3>(set_.context, activeSolids(), free);
    e.translation = sums[0];
    e.rotation = sums[1];
    e.potential = sums[2];
    clumps_.addEnergies(c, e);
    e.spring = clumps_.springEnergy();
    withLaw(set_.laws, [&](auto law)
    {
        SumContactEnergy<Backend, D, P, decltype(law)> sum;
        setModel(sum.probe);
        if (others_) sum.calm = particles_.view().calm;
        e.contact = sumOver<1>(set_.context, activeSolids(), sum)[0];
    });
    const auto wall = wallMemory_.entries ? wallMemory_.force.download() : std::vector<real>();
    if (!others_) for (int k = 0; k < wallMemory_.entries; ++k) e.contact += double(wall[k*wallWords<D> + D + S]);
    for (int i = 0; others_ && wallMemory_.entries && i < activeSolids(); ++i)
        for (int k = wallMemory_.entryFirst.data()[i]; !ghost(i) && k < wallMemory_.entryFirst.data()[i + 1]; ++k)
            e.contact += double(wall[k*wallWords<D> + D + S]);
    e.bond = bonds_.energy(slotOf_);
    return e;
}

template<class Backend, int D, class P>
double DemSolver<Backend, D, P>::deepestOverlap()
{
    double most = 0;
    withLaw(set_.laws, [&](auto law)
    {
        DeepestOverlap<Backend, D, P, decltype(law)> deepest;
        setModel(deepest.probe);
        most = largestOver(set_.context, activeSolids(), deepest);
    });
    if (!nWalls_ || !wallMemory_.entries) return most;
    const auto first = wallMemory_.entryFirst.download();
    const auto entry = wallMemory_.entry.download();
    const auto force = wallMemory_.force.download();
    const auto radius = particles_.template field<real>(particles_.at.radius);
    const auto material = particles_.template field<std::int32_t>(particles_.at.material);
    const int n = activeSolids();
    for (int i = 0; i < n; ++i)
        for (int e = first[i]; e < first[i + 1] && !ghost(i); ++e)
        {
            const double gap = double(pairs_.gap(material[i], set_.input.walls[entry[e].wall].material));
            most = std::max(most, 0.5*(double(force[e*wallWords<D> + D + S + 1]) - gap)/double(radius[i]));
        }
    return most;
}

template<class Backend, int D, class P>
std::vector<DemWallForce> DemSolver<Backend, D, P>::wallForces()
{
    std::vector<DemWallForce> out(nWalls_);
    if (!nWalls_ || !wallMemory_.entries) return out;
    const int n = activeSolids();
    const auto first = wallMemory_.entryFirst.download();
    const auto entry = wallMemory_.entry.download();
    const auto force = wallMemory_.force.download();
    const auto on = wallMemory_.on.download();
    const auto normal = wallMemory_.normal.download();
    const std::vector<WallData> walls = walls_.download();
    const std::vector<double> x = particles_.positions(n);
    // the part of a force along the normals of an entry's touches
    const auto alongNormals = [&](int e, const Vec<3, double>& force)
    {
        Vec<3, double> sum{{0, 0, 0}}, basis[wallTouches];
        int known = 0;
        for (int slot = e*wallTouches; slot < (e + 1)*wallTouches; ++slot)
        {
            if (!on[slot]) continue;
            Vec<D, double> local;
            for (int d = 0; d < D; ++d) local.c[d] = double(normal[slot*D + d]);
            local = outOfFrame<D>(walls[entry[e].wall].frame.R, local);
            Vec<3, double> b{{0, 0, 0}};
            for (int d = 0; d < D; ++d) b.c[set_.config.axes[d]] = local.c[d];
            for (int k = 0; k < known; ++k) b = b - dot(b, basis[k])*basis[k];
            const double size = std::sqrt(squaredNorm(b));
            if (!(size > 1e-3)) continue;           // as others
            basis[known] = (1/size)*b;
            sum = sum + dot(force, basis[known])*basis[known];
            ++known;
        }
        return sum;
    };
    for (int i = 0; i < n; ++i)
        for (int e = first[i]; e < first[i + 1] && !ghost(i); ++e)
        {
            Vec<3, double> f{{0, 0, 0}}, m{{0, 0, 0}};
            for (int d = 0; d < D; ++d) f.c[set_.config.axes[d]] = -double(force[e*wallWords<D> + d]);
            for (int c = 0; c < S; ++c)
                m.c[D == 2 ? set_.config.axes[2] : c] = -(D == 2 ? set_.spinSign() : 1)*double(force[e*wallWords<D> + D + c]);
            const Vec<3, double> centre{{x[3*i], x[3*i + 1], x[3*i + 2]}}, pressed = alongNormals(e, f), turned = cross(centre, pressed);
            m = m + cross(centre, f);
            DemWallForce& w = out[entry[e].wall];
            for (int d = 0; d < 3; ++d)
            {
                w.force[d] += f.c[d];
                w.moment[d] += m.c[d];
                w.normal[d] += pressed.c[d];
                w.normalMoment[d] += turned.c[d];
            }
        }
    return out;
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::setExternalForces(const std::vector<double>& force, const std::vector<double>& moment)
{
    requireAlone("forces from outside");
    std::vector<real> all(std::size_t(particles_.n)*(D + S), real(0));
    for (int i = 0; i < particles_.n; ++i)
    {
        const std::size_t at = 3*std::size_t(particles_.ids[i]);
        if (!force.empty() && at + 3 > force.size()) throw std::invalid_argument("external forces: too few for the ids");
        if (!moment.empty() && at + 3 > moment.size()) throw std::invalid_argument("external moments: too few for the ids");
        real* to = &all[std::size_t(i)*(D + S)];
        if (!force.empty()) for (int d = 0; d < D; ++d) to[d] = real(force[at + set_.config.axes[d]]);
        if (!moment.empty())
            for (int c = 0; c < S; ++c) to[D + c] = real(D == 2 ? set_.spinSign()*moment[at + set_.config.axes[2]] : moment[at + c]);
    }
    if (sleeps()) wakeChanged(particles_.external.download(), all);
    particles_.external.upload(set_.context, all);
    clumps_.gather(nullptr, slotOf_.data());
}

template<class Backend, int D, class P>
std::vector<ArrayInfo> DemSolver<Backend, D, P>::arrays() const
{
    std::vector<ArrayInfo> r;
    const std::size_t n = std::max(particles_.n, 1);
    const auto put = [&](const char* set, const std::string& name, std::size_t bytes)
    { if (bytes) r.push_back(ArrayInfo{set, name, bytes/n, bytes}); };
    for (const auto& f : particles_.values.info()) put("solids", f.name, f.bytes);
    put("solids", "records", records_.bytes());
    put("solids", "reference", reference_.bytes());
    put("solids", "sort", sort_.bytes() + inverse_.bytes() + slotOf_.bytes());
    put("contacts", "lists and histories", list_.bytes() + oldList_.bytes());
    if constexpr (Backend::gpu)
    {
        put("solids", "fused steps", parts_.records.bytes() + parts_.low.bytes() + parts_.own.bytes() + parts_.frames.bytes());
        put("contacts", "rebuilding", parts_.nearCount.bytes() + parts_.keptFirst.bytes() + parts_.keptPartner.bytes()
          + parts_.keptHistory.bytes() + parts_.wallListFirst.bytes() + parts_.wallList.bytes());
        put("solids", "order", parts_.place.bytes() + parts_.order.bytes() + parts_.cost.bytes() + parts_.found.bytes()
          + parts_.foundNear.bytes() + parts_.foundWalls.bytes() + parts_.foundElements.bytes());
    }
    put("bonds", "bonds", bonds_.bytes());
    put("clumps", "clumps", clumps_.bytes());
    put("walls", "surfaces", walls_.bytes() + vertices_.bytes() + elements_.bytes() + sharedFirst_.bytes() + shared_.bytes()
      + cellFirst_.bytes() + cellElement_.bytes());
    put("walls", "contacts", wallMemory_.bytes() + oldWallMemory_.bytes());
    return r;
}

template<class Backend, int D, class P>
std::vector<KernelInfo> DemSolver<Backend, D, P>::kernels() const
{
    std::vector<KernelInfo> r;
    for (const auto& e : set_.context.profile.entries()) r.push_back(KernelInfo{e.name, e.launches, e.seconds});
    return r;
}

template<class Backend, int D, class P>
double DemSolver<Backend, D, P>::neighboursPerParticle()
{
    std::vector<int> count(std::size_t(list_.blocks())*list_.width);
    set_.context.toHost(count.data(), list_.count(), count.size()*sizeof(int));
    double sum = 0;
    const int n = activeSolids();
    for (int i = 0; i < n; ++i) sum += count[i];
    return n ? sum*(Backend::gpu ? 1 : 2)/n : 0;
}

template<class Backend, int D, class P>
double DemSolver<Backend, D, P>::contactsPerParticle()
{
    clock_.read();
    const int n = activeSolids();
    double contacts = 0;
    withLaw(set_.laws, [&](auto law)
    {
        SumContacts<Backend, D, P, decltype(law)> sum;
        setModel(sum.probe);
        contacts = sumOver<1>(set_.context, n, sum)[0];
    });
    return n ? 2*contacts/n : 0;
}

} // namespace riprap

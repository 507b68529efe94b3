/*  DemSolver: everything that is read back.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/loops/largest.hpp"
#include "dem/passes/contactProbe.hpp"
#include "solvers/dem/demSolver.hpp"

namespace riprap
{

template<class Backend, int D, class P>
int DemSolver<Backend, D, P>::activeSolids()
{
    int active = 0;
    context_.toHost(&active, sort_.active(), sizeof(int));
    return active;
}

//- Positions of the first n, in metres
template<class Backend, int D, class P>
std::vector<double> DemSolver<Backend, D, P>::positions(int n)
{
    std::vector<double> out(3*std::size_t(n), 0.0);
    const auto key = field<std::int32_t>(idField_);
    if (D == 2) for (int i = 0; i < n; ++i) out[3*std::size_t(i) + config_.axes[2]] = emptyCoordinate_[key[i]];
    for (int d = 0; d < D; ++d)
    {
        const auto x = field<std::int64_t>(xField_ + d);
        #pragma omp parallel for schedule(static) if (n > 10000)
        for (int i = 0; i < n; ++i) out[3*std::size_t(i) + config_.axes[d]] = box_.toMetres(d, x[i]);
    }
    return out;
}

template<class Backend, int D, class P>
template<class T>
void DemSolver<Backend, D, P>::putVector(int n, int field, int components, bool spin, std::vector<double>& out)
{
    out.assign(3*std::size_t(n), 0.0);
    for (int d = 0; d < components; ++d)
    {
        const auto v = this->field<T>(field + d);
        const bool one = spin && D == 2;
        #pragma omp parallel for schedule(static) if (n > 10000)
        for (int i = 0; i < n; ++i) out[3*std::size_t(i) + config_.axes[one ? 2 : d]] = (one ? spinSign() : 1)*double(v[i]);
    }
}

template<class Backend, int D, class P>
DemState DemSolver<Backend, D, P>::motion()
{
    readClock();
    const int n = activeSolids();
    DemState s;
    s.position = positions(n);
    putVector<double>(n, vField_, D, false, s.velocity);
    putVector<real>(n, wField_, S, true, s.spin);
    putVector<real>(n, fField_, D, false, s.force);
    putVector<real>(n, mField_, S, true, s.moment);
    const auto key = field<std::int32_t>(idField_);
    const auto radius = field<real>(radiusField_), mass = field<real>(massField_), inverse = field<real>(inertiaField_);
    s.material = field<std::int32_t>(materialField_);
    s.group = field<std::int32_t>(groupField_);
    s.clump = clumpField_ < 0 ? std::vector<std::int32_t>(n, -1) : field<std::int32_t>(clumpField_);
    for (auto* v : {&s.material, &s.group, &s.clump}) v->resize(n);
    const std::vector<real> external = external_.download();
    const auto calm = calmField_ < 0 ? std::vector<std::int32_t>() : field<std::int32_t>(calmField_);
    // leapfrog keeps velocities of half a step ago: forces are of now
    const double half = config_.integrator == DemIntegratorKind::leapfrog ? 0.5*host_.dt : 0;
    for (auto* v : {&s.radius, &s.mass}) v->resize(n);
    s.id.resize(n);
    #pragma omp parallel for schedule(static) if (n > 10000)
    for (int i = 0; i < n; ++i)
    {
        s.id[i] = ids_[key[i]];
        s.radius[i] = double(radius[i]);
        s.mass[i] = double(mass[i]);
        const DemGroup& g = input_.groups[s.group[i]];
        const bool asleep = !calm.empty() && calm[i] >= asleepFrom, kicked = g.motion < 0 && s.clump[i] < 0 && !asleep;
        const real* more = external.empty() ? nullptr : &external[std::size_t(key[i])*(D + S)];
        for (int d = 0; d < D; ++d)
        {
            const std::size_t at = 3*std::size_t(i) + config_.axes[d];
            double& f = s.force[at];
            double& v = s.velocity[at];
            f += (g.gravity ? s.mass[i]*config_.gravity[config_.axes[d]] : 0) + g.force[config_.axes[d]] + (more ? double(more[d]) : 0);
            const double damped = locallyDamped(f, v, g.localDamping) - g.viscousDamping*s.mass[i]*v;
            if (kicked && !g.held[config_.axes[d]]) v += half*damped/s.mass[i];
        }
        for (int c = 0; c < S; ++c)
        {
            const int axis = D == 2 ? config_.axes[2] : c;
            const std::size_t at = 3*std::size_t(i) + axis;
            double& m = s.moment[at];
            double& w = s.spin[at];
            m += g.moment[axis] + (more ? (D == 2 ? spinSign() : 1)*double(more[D + c]) : 0);
            const double rate = locallyDamped(m, w, g.localDamping)*double(inverse[i]) - g.viscousSpinDamping*w;
            if (kicked && !g.heldSpin) w += half*rate;
        }
    }
    if (turnField_ >= 0)
    {
        s.orientation.assign(4*std::size_t(n), 0.0);
        for (int k = 0; k < (D == 2 ? 1 : 4); ++k)
        {
            const auto q = field<real>(turnField_ + k);
            for (int i = 0; i < n; ++i)
            {
                if (D == 3) { s.orientation[4*std::size_t(i) + k] = double(q[i]); continue; }
                s.orientation[4*std::size_t(i)] = std::cos(0.5*double(q[i]));
                s.orientation[4*std::size_t(i) + 1 + config_.axes[2]] = spinSign()*std::sin(0.5*double(q[i]));
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
    s.brokenBonds.assign(n, 0);
    if (nBonds_)
    {
        const auto slotOf = slotOf_.download(), a = bondIds_[0].download(), b = bondIds_[1].download();
        const auto broken = bondBroken_.download();
        for (int k = 0; k < nBonds_; ++k)
            if (broken[k]) for (const int key : {a[k], b[k]}) if (slotOf[key] >= 0) ++s.brokenBonds[slotOf[key]];
    }
    dropGhosts(s.brokenBonds, 1);
    return s;
}

//- Of the first n with others and with walls: as contacts() lists them, without what they are
//- Slots of walls that carry force
template<class Backend, int D, class P>
std::vector<int> DemSolver<Backend, D, P>::wallContacts()
{
    std::vector<int> on = wallMemory_.on.download();
    withLaw(laws_, [&](auto law)
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
    others.allocate(context_, list_.entries() + 1);
    withLaw(laws_, [&](auto law)
    {
        ContactProbe<Backend, D, P, decltype(law)> probe;
        setModel(probe);
        forEach(context_, n_, ProbeOthers<Backend, D, P, decltype(law)>{probe, others.data()});
    });
    const auto all = others.download();
    std::vector<int> base(list_.blocks() + 1), count(std::size_t(list_.blocks())*list_.width);
    context_.toHost(base.data(), list_.base(), base.size()*sizeof(int));
    context_.toHost(count.data(), list_.count(), count.size()*sizeof(int));
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
    const std::vector<double> x = positions(n);
    const auto key = field<std::int32_t>(idField_);
    Array<Backend, ProbedContact<D, real>> probed;
    probed.allocate(context_, list_.entries() + 1);
    withLaw(laws_, [&](auto law)
    {
        ContactProbe<Backend, D, P, decltype(law)> probe;
        setModel(probe);
        forEach(context_, n_, ProbeAll<Backend, D, P, decltype(law)>{probe, probed.data()});
    });
    const auto all = probed.download();
    std::vector<int> base(list_.blocks() + 1), count(std::size_t(list_.blocks())*list_.width);
    context_.toHost(base.data(), list_.base(), base.size()*sizeof(int));
    context_.toHost(count.data(), list_.count(), count.size()*sizeof(int));
    const auto put = [&](int i, std::int32_t b, const auto& force, double overlap, const auto& n, double arm)
    {
        out.a.push_back(ids_[key[i]]);
        out.b.push_back(b);
        out.overlap.push_back(overlap);
        const std::size_t at = out.force.size();
        out.force.resize(at + 3, 0.0);
        out.point.insert(out.point.end(), x.begin() + 3*i, x.begin() + 3*i + 3);
        for (int d = 0; d < D; ++d)
        {
            out.force[at + config_.axes[d]] = double(force[d]);
            out.point[at + config_.axes[d]] += double(n[d])*arm;
        }
    };
    constexpr int width = ContactList<Backend, real>::width;
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < count[i] && !ghost(i); ++k)
        {
            const auto& c = all[std::size_t(base[i/width]) + std::size_t(k)*width + i % width];
            if (c.other < 0 || (Backend::gpu && c.other < i)) continue;
            put(i, ids_[key[c.other]], c.force, double(c.overlap), c.n, double(c.arm));
        }
    if (!nWalls_ || !wallMemory_.entries) return out;
    const auto first = wallMemory_.entryFirst.download();
    const auto entry = wallMemory_.entry.download();
    const auto acts = wallContacts();
    const auto material = field<std::int32_t>(materialField_);
    const auto force = wallMemory_.force.download();
    const auto normal = wallMemory_.normal.download();
    const auto radius = field<real>(radiusField_);
    const std::vector<WallData> walls = walls_.download();
    for (int i = 0; i < n; ++i)
        for (int e = first[i]; e < first[i + 1]; ++e)
        {
            const int slot = e*wallTouches;
            if (!acts[slot] || ghost(i)) continue;
            Vec<D, double> local, f;
            for (int d = 0; d < D; ++d) { local.c[d] = double(normal[slot*D + d]); f.c[d] = double(force[e*wallWords<D> + d]); }
            const real reach = reaches_[material[i]*input_.materials.size() + input_.walls[entry[e].wall].material];
            put(i, -1 - entry[e].wall, f, double(force[e*wallWords<D> + D + S + 1]) - double(reach), outOfFrame<D>(walls[entry[e].wall].frame.R, local), double(radius[i]));
        }
    return out;
}

template<class Backend, int D, class P>
DemBondState DemSolver<Backend, D, P>::bonds()
{
    DemBondState s;
    if (!nBonds_) return s;
    const auto a = bondIds_[0].download(), b = bondIds_[1].download();
    s.type = bondType_.download();
    s.broken = bondBroken_.download();
    s.restGap = bondRest_.download();
    const auto force = bondForce_.download();
    const auto slotOf = slotOf_.download();
    const auto radius = field<real>(radiusField_);
    std::vector<std::int64_t> x[D];
    for (int d = 0; d < D; ++d) x[d] = field<std::int64_t>(xField_ + d);
    s.force.assign(3*std::size_t(nBonds_), 0.0);
    s.moment = s.force;
    for (int k = 0; k < nBonds_; ++k)
    {
        s.a.push_back(ids_[a[k]]);
        s.b.push_back(ids_[b[k]]);
        double d2 = 0;
        const int i = slotOf[a[k]], j = slotOf[b[k]];
        for (int d = 0; d < D; ++d)
        {
            s.force[3*std::size_t(k) + config_.axes[d]] = double(force[k].force.c[d]);
            if (i < 0 || j < 0) continue;
            const double r = double(std::int64_t(std::uint64_t(x[d][j]) - std::uint64_t(x[d][i])))*box_.unit[d];
            d2 += r*r;
        }
        for (int c = 0; c < S; ++c)
            s.moment[3*std::size_t(k) + (D == 2 ? config_.axes[2] : c)] = (D == 2 ? spinSign() : 1)*double(force[k].bending.c[c]);
        s.gap.push_back(i < 0 || j < 0 ? 0 : std::sqrt(d2) - double(radius[i]) - double(radius[j]));
    }
    return s;
}

template<class Backend, int D, class P>
DemEnergy DemSolver<Backend, D, P>::energy()
{
    DemEnergy e;
    const DemClumpState c = clumps();
    const auto potential = [&](double m, const double* x)
    {
        double sum = 0;
        for (int d = 0; d < D; ++d) sum -= m*config_.gravity[config_.axes[d]]*x[config_.axes[d]];
        return sum;
    };
    SumEnergies<D, P> free{};
    setMotion(free);
    free.box = box_;
    free.half = real(config_.integrator == DemIntegratorKind::leapfrog ? 0.5*host_.dt : 0);
    const auto sums = sumOver<3>(context_, activeSolids(), free);
    e.translation = sums[0];
    e.rotation = sums[1];
    e.potential = sums[2];
    for (int k = 0; k < nClumps_; ++k)
    {
        if (c.left[k]) continue;
        const DemClump& in = input_.clumps[k];
        for (int d = 0; d < 3; ++d) e.translation += 0.5*in.mass*c.velocity[3*k + d]*c.velocity[3*k + d];
        Vec<3, double> w{{c.spin[3*k], c.spin[3*k + 1], c.spin[3*k + 2]}};
        if (D == 2) e.rotation += 0.5*in.inertia[2]*squaredNorm(w);
        else
        {
            w = rotated(&c.orientation[4*k], w, true);
            for (int d = 0; d < 3; ++d) e.rotation += 0.5*in.inertia[d]*w.c[d]*w.c[d];
        }
        if (input_.groups[in.group].gravity) e.potential += potential(in.mass, &c.position[3*k]);
    }
    e.spring = springEnergy();
    withLaw(laws_, [&](auto law)
    {
        SumContactEnergy<Backend, D, P, decltype(law)> sum;
        setModel(sum.probe);
        if (others_) sum.calm = fields().calm;
        e.contact = sumOver<1>(context_, activeSolids(), sum)[0];
    });
    const auto wall = wallMemory_.entries ? wallMemory_.force.download() : std::vector<real>();
    if (!others_) for (int k = 0; k < wallMemory_.entries; ++k) e.contact += double(wall[k*wallWords<D> + D + S]);
    for (int i = 0; others_ && wallMemory_.entries && i < activeSolids(); ++i)
        for (int k = wallMemory_.entryFirst.data()[i]; !ghost(i) && k < wallMemory_.entryFirst.data()[i + 1]; ++k)
            e.contact += double(wall[k*wallWords<D> + D + S]);
    if (!nBonds_) return e;
    const DemBondState b = bonds();
    const auto radius = field<real>(radiusField_);
    const auto history = bondHistory_.download();
    const auto types = bondTypes_.download();
    const auto slots = slotOf_.download();
    const auto ends = std::array<std::vector<std::int32_t>, 2>{bondIds_[0].download(), bondIds_[1].download()};
    for (int k = 0; k < nBonds_; ++k)
    {
        if (b.broken[k]) continue;
        e.bond += double(bondEnergy<D, real>
        (types[b.type[k]], radius[slots[ends[0][k]]], radius[slots[ends[1][k]]], real(b.gap[k] - b.restGap[k]), &history[std::size_t(k)*bondHistory<D>]));
    }
    return e;
}

template<class Backend, int D, class P>
double DemSolver<Backend, D, P>::deepestOverlap()
{
    double most = 0;
    withLaw(laws_, [&](auto law)
    {
        DeepestOverlap<Backend, D, P, decltype(law)> deepest;
        setModel(deepest.probe);
        most = largestOver(context_, activeSolids(), deepest);
    });
    if (!nWalls_ || !wallMemory_.entries) return most;
    const auto first = wallMemory_.entryFirst.download();
    const auto entry = wallMemory_.entry.download();
    const auto force = wallMemory_.force.download();
    const auto radius = field<real>(radiusField_);
    const auto material = field<std::int32_t>(materialField_);
    const auto gaps = gaps_.download();
    const int n = activeSolids(), m = int(input_.materials.size());
    for (int i = 0; i < n; ++i)
        for (int e = first[i]; e < first[i + 1] && !ghost(i); ++e)
        {
            const double gap = double(gaps[material[i]*m + input_.walls[entry[e].wall].material]);
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
    const std::vector<double> x = positions(n);
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
            for (int d = 0; d < D; ++d) b.c[config_.axes[d]] = local.c[d];
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
            for (int d = 0; d < D; ++d) f.c[config_.axes[d]] = -double(force[e*wallWords<D> + d]);
            for (int c = 0; c < S; ++c)
                m.c[D == 2 ? config_.axes[2] : c] = -(D == 2 ? spinSign() : 1)*double(force[e*wallWords<D> + D + c]);
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
    std::vector<real> all(std::size_t(n_)*(D + S), real(0));
    for (int i = 0; i < n_; ++i)
    {
        const std::size_t at = 3*std::size_t(ids_[i]);
        if (!force.empty() && at + 3 > force.size()) throw std::invalid_argument("external forces: too few for the ids");
        if (!moment.empty() && at + 3 > moment.size()) throw std::invalid_argument("external moments: too few for the ids");
        real* to = &all[std::size_t(i)*(D + S)];
        if (!force.empty()) for (int d = 0; d < D; ++d) to[d] = real(force[at + config_.axes[d]]);
        if (!moment.empty())
            for (int c = 0; c < S; ++c) to[D + c] = real(D == 2 ? spinSign()*moment[at + config_.axes[2]] : moment[at + c]);
    }
    if (sleeps()) wakeChanged(external_.download(), all);
    external_.upload(context_, all);
    gatherClumps(nullptr);
}

template<class Backend, int D, class P>
std::vector<ArrayInfo> DemSolver<Backend, D, P>::arrays() const
{
    std::vector<ArrayInfo> r;
    const std::size_t n = std::max(n_, 1);
    const auto put = [&](const char* set, const std::string& name, std::size_t bytes)
    { if (bytes) r.push_back(ArrayInfo{set, name, bytes/n, bytes}); };
    for (const auto& f : fields_.info()) put("solids", f.name, f.bytes);
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
    put("bonds", "bonds", bondIds_[0].bytes() + bondIds_[1].bytes() + bondType_.bytes() + bondBroken_.bytes() + bondRest_.bytes()
      + bondHistory_.bytes() + bondForce_.bytes() + bondFirst_.bytes() + bondReference_.bytes());
    put("clumps", "clumps", clumps_.bytes() + offset_.bytes() + memberFirst_.bytes() + member_.bytes() + constraints_.bytes() + springs_.bytes()
      + springFirst_.bytes());
    put("walls", "surfaces", walls_.bytes() + vertices_.bytes() + elements_.bytes() + sharedFirst_.bytes() + shared_.bytes()
      + cellFirst_.bytes() + cellElement_.bytes());
    put("walls", "contacts", wallMemory_.bytes() + oldWallMemory_.bytes());
    return r;
}

template<class Backend, int D, class P>
std::vector<KernelInfo> DemSolver<Backend, D, P>::kernels() const
{
    std::vector<KernelInfo> r;
    for (const auto& e : context_.profile.entries()) r.push_back(KernelInfo{e.name, e.launches, e.seconds});
    return r;
}

template<class Backend, int D, class P>
double DemSolver<Backend, D, P>::neighboursPerParticle()
{
    std::vector<int> count(std::size_t(list_.blocks())*list_.width);
    context_.toHost(count.data(), list_.count(), count.size()*sizeof(int));
    double sum = 0;
    const int n = activeSolids();
    for (int i = 0; i < n; ++i) sum += count[i];
    return n ? sum*(Backend::gpu ? 1 : 2)/n : 0;
}

template<class Backend, int D, class P>
double DemSolver<Backend, D, P>::contactsPerParticle()
{
    readClock();
    const int n = activeSolids();
    double contacts = 0;
    withLaw(laws_, [&](auto law)
    {
        SumContacts<Backend, D, P, decltype(law)> sum;
        setModel(sum.probe);
        contacts = sumOver<1>(context_, n, sum)[0];
    });
    return n ? 2*contacts/n : 0;
}

} // namespace riprap

/*  Rigid bodies of several particles, their constraints and springs.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/contact/restitution.hpp"
#include "dem/motion/clumpSums.hpp"
#include "dem/motion/push.hpp"
#include "solvers/dem/parts/particleFields.hpp"
#include "solvers/dem/parts/sharedClumps.hpp"
#include "solvers/dem/parts/solidGroups.hpp"

namespace riprap
{

//- slotOf: where the particle of a key is; -1: it has left
template<class Backend, int D, class P>
class Clumps
{
public:

    using real = typename P::real;

    Clumps(DemSetting<Backend, D, P>& set, ParticleFields<Backend, D, P>& particles,
        const SolidGroups<Backend, D, P>& groups)
        : set_(set), particles_(particles), groups_(groups)
    {}

    SharedClumps<D, P> share;

    void set(const DemParticles&);

    bool any() const { return total_ > 0; }     // on any rank
    int total() const { return total_; }
    int count() const { return count_; }        // that this rank moves
    ClumpData* data() { return clumps_.data(); }

    //- On several ranks (CPU): those that are here, of which this one moves so many, and members of
    //  these; or memory for all
    void setHere(const std::vector<ClumpData>&, int moved, const std::vector<int>& first,
        const std::vector<int>& member);
    void holdAll();

    // of members in their bodies, 3 a key
    Array<Backend, double>& offset() { return offset_; }
    const ClumpConstraint* constraints() const
    {
        return constraints_.size() ? constraints_.data() : nullptr;
    }
    ClumpMembers<D, P> members(const int* slotOf);
    ClumpKick<D, P> kick() const;

    //- Forces of their members on clumps; in a step of the clock's, or now
    void gather(const DemClockData* clock, const int* slotOf);

    //- What forces from outside do over dt at once
    void push(double dt, const int* slotOf)
    {
        if (count_)
            sumClumps(set_.context, count_, largest_,
                PushClumps<D, P>{members(slotOf), groups_.data(), constraints(), dt});
    }

    //- For the host: bodies as they are here, in order. Those that this rank does not report (of
    //  those that it knows: has not got) are as if they had left
    std::vector<ClumpData> reported() const { return onHost(false); }
    std::vector<ClumpData> known() const { return onHost(true); }

    //- Of all bodies; half: by how much velocities of now are ahead of those kept [s]
    DemClumpState state(const std::vector<ClumpData>&, double half) const;
    std::vector<DemSpringState> springs(const std::vector<ClumpData>&) const;
    double springEnergy(const std::vector<ClumpData>&) const;
    void addEnergies(const DemClumpState&, DemEnergy&) const;
    std::size_t bytes() const;

private:

    void gatherShared(const DemClockData* clock, const int* slotOf);
    std::vector<ClumpData> onHost(bool all) const;
    int leastSharing(int together) const;
    std::vector<ClumpData> bodies(const std::vector<int>& first) const;
    void placeMembers(
        const DemParticles&, const std::vector<ClumpData>&, const std::vector<int>& first);
    ClumpConstraint constraintOf(const DemGroup&) const;
    void setConstraints(std::vector<ClumpData>&);
    void setSprings(const std::vector<ClumpData>&);
    ClumpData kicked(ClumpData, double dt) const;

    DemSetting<Backend, D, P>& set_;
    ParticleFields<Backend, D, P>& particles_;
    const SolidGroups<Backend, D, P>& groups_;
    int count_ = 0, total_ = 0, largest_ = 0;
    Array<Backend, ClumpData> clumps_;
    Array<Backend, double> offset_;
    Array<Backend, int> memberFirst_, member_;
    Array<Backend, ClumpConstraint> constraints_;       // of groups; empty: none is constrained
    std::vector<ClumpConstraint> constraintOf_;         // the same
    Array<Backend, SpringData> springs_;
    Array<Backend, int> springFirst_;                   // of a clump
    std::vector<SpringData> allSprings_;                // of all in the order of clumps,
    std::vector<int> allSpringFirst_;
    // and of groups: the clump, and which of them
    std::vector<std::pair<int, int>> springOfGroups_;
};

//- Where a face lands flat while one member touches, each of its n members would damp as if it were
//  alone. Over a step, a fifth of that of the n springs, that takes 0.4 zeta sqrt(n/least) of the
//  speed: less than half with n zeta^2 at least
template<class Backend, int D, class P>
int Clumps<Backend, D, P>::leastSharing(int together) const
{
    double zeta = 0;
    for (const DemPair& p : set_.input.pairs)
        zeta = std::max(
            zeta, linearDampingRatio(p.properties.restitution, p.properties.attraction));
    return std::max(1, int(std::ceil(together*std::min(1.0, zeta*zeta))));
}

//- first: members of each
template<class Backend, int D, class P>
std::vector<ClumpData> Clumps<Backend, D, P>::bodies(const std::vector<int>& first) const
{
    std::vector<ClumpData> clumps(count_);
    for (int k = 0; k < count_; ++k)
    {
        const DemClump& in = set_.input.clumps[k];
        ClumpData& c = clumps[k];
        c = ClumpData{};
        c.q[0] = in.orientation[0];
        for (int d = 0; d < 3; ++d)
            c.q[1 + d] = (D == 2 ? set_.spinSign() : 1)*in.orientation[1 + set_.config.axes[d]];
        for (int d = 0; d < D; ++d)
        {
            c.x[d] = set_.box.toFixed(d, in.position[set_.config.axes[d]]);
            c.v[d] = in.velocity[set_.config.axes[d]];
        }
        c.mass = in.mass;
        for (int d = 0; d < 3; ++d) c.inertia[d] = in.inertia[d];
        c.group = in.group;
        c.together = set_.plan.together[k];
        c.least = leastSharing(c.together);
        c.left = first[k + 1] == first[k];
        if (D == 2) c.L[2] = in.inertia[2]*set_.spinSign()*in.spin[set_.config.axes[2]];
        else
        {
            Vec<3, double> w = rotated(
                c.q, Vec<3, double>{{in.spin[0], in.spin[1], in.spin[2]}}, true);
            for (int d = 0; d < 3; ++d) w.c[d] *= c.inertia[d];
            const Vec<3, double> L = rotated(c.q, w);
            for (int d = 0; d < 3; ++d) c.L[d] = L.c[d];
        }
    }
    return clumps;
}

//- Members of each body, and where they are in it
template<class Backend, int D, class P>
void Clumps<Backend, D, P>::placeMembers(const DemParticles& particles,
    const std::vector<ClumpData>& clumps, const std::vector<int>& first)
{
    const auto& of = particles.clump;
    std::vector<double> offset(3*std::size_t(particles_.n), 0.0);
    std::vector<int> member(std::max(1, first[count_]));
    std::vector<int> next(first.begin(), first.end() - 1);
    for (int i = 0; i < particles_.n && !of.empty(); ++i)
    {
        if (of[i] < 0) continue;
        member[next[of[i]]++] = i;
        Vec<3, double> arm{{0, 0, 0}};
        for (int d = 0; d < D; ++d)
        {
            const std::int64_t x = set_.box.toFixed(
                d, particles.position[3*std::size_t(i) + set_.config.axes[d]]);
            arm.c[d] = double(std::int64_t(std::uint64_t(x) - std::uint64_t(clumps[of[i]].x[d])))
                *set_.box.unit[d];
        }
        arm = rotated(clumps[of[i]].q, arm, true);
        for (int d = 0; d < 3; ++d) offset[3*std::size_t(i) + d] = arm.c[d];
    }
    offset_.upload(set_.context, offset);
    member_.upload(set_.context, member);
}

template<class Backend, int D, class P>
void Clumps<Backend, D, P>::set(const DemParticles& particles)
{
    count_ = total_ = int(set_.input.clumps.size());
    if (!count_) return;
    std::vector<int> first(count_ + 1, 0);
    const auto& of = particles.clump;
    for (int i = 0; i < particles_.n && !of.empty(); ++i) if (of[i] >= 0) ++first[of[i] + 1];
    for (int k = 0; k < count_; ++k)
    {
        largest_ = std::max(largest_, first[k + 1]);
        first[k + 1] += first[k];
    }
    std::vector<ClumpData> clumps = bodies(first);
    placeMembers(particles, clumps, first);
    setConstraints(clumps);
    clumps_.upload(set_.context, clumps);
    setSprings(clumps);
    memberFirst_.upload(set_.context, first);
    share.first = first;
}

//- In the solver's axes
template<class Backend, int D, class P>
ClumpConstraint Clumps<Backend, D, P>::constraintOf(const DemGroup& g) const
{
    const DemConstraint& in = g.constraint;
    ClumpConstraint s{};
    s.any = in.any();
    s.hinge = in.hinge;
    s.turn = in.rotation == RotationKind::free ? ClumpTurn::free
        : in.rotation == RotationKind::axis ? ClumpTurn::about
                                               : ClumpTurn::none;
    double n[3] = {}, length = 0, turn = 0;
    for (int d = 0; d < D; ++d)
    {
        const int axis = set_.config.axes[d];
        s.point[d] = in.point[axis];
        n[d] = in.direction[axis];
        length += n[d]*n[d];
        if (D == 3) s.axis[d] = in.axis[axis];
        turn += s.axis[d]*s.axis[d];
    }
    if (D == 2) s.axis[2] = 1;
    else for (double& a : s.axis) a /= std::sqrt(std::max(turn, 1e-300));
    const bool line = in.translation == TranslationKind::line,
               plane = in.translation == TranslationKind::plane;
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j)
        {
            const double nn = n[i]*n[j]/std::max(length, 1e-300);
            s.along[3*i + j] = line
                ? nn
                : (in.translation != TranslationKind::none)*(i == j) - plane*nn;
        }
    return s;
}

template<class Backend, int D, class P>
void Clumps<Backend, D, P>::setConstraints(std::vector<ClumpData>& clumps)
{
    bool any = false;
    for (const DemGroup& g : set_.input.groups)
    {
        constraintOf_.push_back(constraintOf(g));
        any = any || g.constraint.any();
    }
    for (ClumpData& c : clumps)
        if (constraintOf_[c.group].any) restrain(c, constraintOf_[c.group], set_.box);
    if (any) constraints_.upload(set_.context, constraintOf_);
}

//- Points on bodies are given for where these stood at first
template<class Backend, int D, class P>
void Clumps<Backend, D, P>::setSprings(const std::vector<ClumpData>& clumps)
{
    bool any = false;
    for (const DemGroup& g : set_.input.groups) any = any || !g.springs.empty();
    if (!any) return;
    std::vector<int> first(1, 0);
    for (int k = 0; k < count_; ++k)
    {
        const DemClump& body = set_.input.clumps[k];
        const DemPose start = body.moved ? body.start : DemPose{body.position, body.orientation};
        double q[4] = {start.orientation[0], 0, 0, 0};
        for (int d = 0; d < 3; ++d)
            q[1 + d] = (D == 2 ? set_.spinSign() : 1)*start.orientation[1 + set_.config.axes[d]];
        for (const DemSpring& in : set_.input.groups[body.group].springs)
        {
            SpringData s{};
            Vec<3, double> arm{{0, 0, 0}};
            for (int d = 0; d < D; ++d)
            {
                const int axis = set_.config.axes[d];
                s.anchor[d] = in.anchor[axis];
                arm.c[d] = in.point[axis] - start.position[axis];
            }
            arm = rotated(q, arm, true);
            for (int d = 0; d < 3; ++d) s.arm[d] = arm.c[d];
            s.stiffness = in.stiffness;
            s.damping = in.damping;
            s.length = in.length;
            s.slack = in.slack;
            allSprings_.push_back(s);
        }
        first.push_back(int(allSprings_.size()));
    }
    for (int g = 0; g < int(set_.input.groups.size()); ++g)
        for (int e = 0; e < int(set_.input.groups[g].springs.size()); ++e)
            for (int k = 0; k < count_; ++k)
                if (clumps[k].group == g) springOfGroups_.emplace_back(k, first[k] + e);
    springs_.upload(set_.context, allSprings_);
    springFirst_.upload(set_.context, first);
    allSpringFirst_ = first;
}

template<class Backend, int D, class P>
void Clumps<Backend, D, P>::setHere(const std::vector<ClumpData>& clumps, int moved,
    const std::vector<int>& first, const std::vector<int>& member)
{
    count_ = moved;
    std::vector<SpringData> springs;
    std::vector<int> springFirst(1, 0);
    for (int k = 0; k < moved && !allSprings_.empty(); ++k)
    {
        const int body = share.number[k];
        springs.insert(springs.end(), allSprings_.begin() + allSpringFirst_[body],
            allSprings_.begin() + allSpringFirst_[body + 1]);
        springFirst.push_back(int(springs.size()));
    }
    replaceBy(set_.context, clumps_, clumps);
    replaceBy(set_.context, memberFirst_, first);
    replaceBy(set_.context, member_, member);
    if (allSprings_.empty()) return;
    replaceBy(set_.context, springs_, springs);
    replaceBy(set_.context, springFirst_, springFirst);
}

template<class Backend, int D, class P>
void Clumps<Backend, D, P>::holdAll()
{
    share.some = share.leftActed = false;
    share.left.clear();
    count_ = total_;
    Array<Backend, ClumpData> all;
    all.upload(set_.context, std::vector<ClumpData>(total_, ClumpData{}));
    clumps_.swap(all);
}

template<class Backend, int D, class P>
ClumpMembers<D, P> Clumps<Backend, D, P>::members(const int* slotOf)
{
    return {clumps_.data(), set_.box, particles_.view(), memberFirst_.data(), member_.data(),
        slotOf, particles_.externalForces()};
}

template<class Backend, int D, class P>
ClumpKick<D, P> Clumps<Backend, D, P>::kick() const
{
    ClumpKick<D, P> kick{groups_.data(), {}, set_.box, constraints()};
    for (int d = 0; d < D; ++d) kick.gravity[d] = set_.config.gravity[set_.config.axes[d]];
    return kick;
}

template<class Backend, int D, class P>
void Clumps<Backend, D, P>::gather(const DemClockData* clock, const int* slotOf)
{
    if (!any()) return;
    if (share.some) return gatherShared(clock, slotOf);
    sumClumps(set_.context, count_, largest_,
        GatherClumps<D, P>{members(slotOf), {springs_.data(), springFirst_.data()}, clock});
}

//- Each rank that has members of a body adds up what acts on all of them, in their order
template<class Backend, int D, class P>
void Clumps<Backend, D, P>::gatherShared(
    [[maybe_unused]] const DemClockData* clock, [[maybe_unused]] const int* slotOf)
{
    if constexpr (!Backend::gpu)
    {
        if (clock && !clock->forcesDue()) return;
        for (auto& one : share.left)
        {
            if (!share.leftActed) break;
            for (int d = 0; d < 3; ++d) one.second.f[d] = one.second.m[d] = 0;
            one.second.touching = 0;
        }
        share.leftActed = false;
        share.bytes += share.members.share(*set_.config.ranks, particles_.view());
        GatherClumps<D, P> sum{members(slotOf), {springs_.data(), springFirst_.data()}, clock};
        sumClumps(set_.context, share.whole, largest_, sum);
        sum.members.clumps += share.whole;
        sum.members.first += share.whole;
        if (sum.springs.spring) sum.springs.first += share.whole;
        sum.members.fields = share.members.view();
        sum.members.slotOf = share.members.place.data();
        sumClumps(set_.context, count_ - share.whole, largest_, sum);
    }
}

//- A constrained clump half a step later: from numbers that the host has
template<class Backend, int D, class P>
ClumpData Clumps<Backend, D, P>::kicked(ClumpData c, double dt) const
{
    const GroupData<D, real> g = groups_.of(set_.input.groups[c.group]);
    const int group = c.group;
    c.group = 0;
    ClumpKick<D, P> kick = this->kick();
    kick.groups = &g;
    kick.constraints = &constraintOf_[group];
    kick(c, dt);
    c.group = group;
    return c;
}

template<class Backend, int D, class P>
std::vector<ClumpData> Clumps<Backend, D, P>::onHost(bool all) const
{
    if (!any()) return {};
    if (!share.some) return clumps_.download();
    std::vector<ClumpData> bodies(total_, ClumpData{});
    for (int k = 0; k < total_; ++k)
    {
        bodies[k].q[0] = 1;
        bodies[k].mass = set_.input.clumps[k].mass;
        bodies[k].group = set_.input.clumps[k].group;
        bodies[k].left = 1;
    }
    for (const auto& one : share.left) bodies[one.first] = one.second;
    for (int k = 0; k < count_; ++k)
        if (all || share.counts[k]) bodies[share.number[k]] = clumps_.data()[k];
    return bodies;
}

template<class Backend, int D, class P>
DemClumpState Clumps<Backend, D, P>::state(const std::vector<ClumpData>& all, double half) const
{
    DemClumpState s;
    for (const ClumpData& c : all)
    {
        const DemGroup& g = set_.input.groups[c.group];
        const bool constrained = g.constraint.any();
        const ClumpData later = kicked(c, half);
        const Vec<3, double> w = spinOf(later, c.q);
        double v[3] = {}, x[3] = {}, f[3] = {}, m[3] = {}, q[4] = {c.q[0], 0, 0, 0}, spin[3] = {};
        if (D == 2)
            x[set_.config.axes[2]] =
                set_.input.clumps[&c - all.data()].position[set_.config.axes[2]];
        for (int d = 0; d < 3; ++d)
        {
            const int axis = set_.config.axes[d];
            if (d < D)
            {
                x[axis] = set_.box.toMetres(d, c.x[d]);
                f[axis] = c.f[d] + (g.gravity ? c.mass*set_.config.gravity[axis] : 0)
                    + g.force[axis];
                const double damped = locallyDamped(f[axis], c.v[d], g.localDamping)
                    - g.viscousDamping*c.mass*c.v[d];
                v[axis] = constrained ? later.v[d]
                                      : c.v[d] + (g.held[axis] ? 0 : half*damped/c.mass);
            }
            const double sign = D == 2 ? set_.spinSign() : 1;
            m[axis] = sign*c.m[d] + g.moment[axis];
            spin[axis] = sign*w.c[d];
            q[1 + axis] = sign*c.q[1 + d];
        }
        for (int d = 0; d < 3; ++d)
        {
            s.position.push_back(x[d]);
            s.velocity.push_back(v[d]);
            s.spin.push_back(spin[d]);
            s.force.push_back(f[d]);
            s.moment.push_back(m[d]);
        }
        s.orientation.insert(s.orientation.end(), q, q + 4);
        s.left.push_back(c.left != 0);
    }
    return s;
}

template<class Backend, int D, class P>
std::vector<DemSpringState> Clumps<Backend, D, P>::springs(
    const std::vector<ClumpData>& clumps) const
{
    std::vector<DemSpringState> all;
    if (allSprings_.empty()) return all;
    for (const DemGroup& g : set_.input.groups)
        for (const DemSpring& s : g.springs) all.push_back(DemSpringState{g.name + "." + s.name});
    for (std::size_t i = 0; i < all.size(); ++i)
    {
        const ClumpData& c = clumps[springOfGroups_[i].first];
        all[i].left = c.left != 0;
        if (all[i].left) continue;
        const SpringPull pull = pullOf(allSprings_[springOfGroups_[i].second], c, set_.box);
        all[i].length = pull.length;
        all[i].tension = pull.tension;
        for (int d = 0; d < D; ++d)
        {
            const int axis = set_.config.axes[d];
            all[i].point[axis] = set_.box.toMetres(d, c.x[d]) + pull.arm.c[d];
            all[i].force[axis] = pull.force.c[d];
        }
    }
    return all;
}

//- Of what is stretched, or pressed together
template<class Backend, int D, class P>
double Clumps<Backend, D, P>::springEnergy(const std::vector<ClumpData>& clumps) const
{
    double sum = 0;
    const std::vector<DemSpringState> now = springs(clumps);
    for (std::size_t i = 0; i < now.size(); ++i)
    {
        const SpringData& s = allSprings_[springOfGroups_[i].second];
        if (now[i].left) continue;
        const double stretch = now[i].length - s.length;
        if (!s.slack || stretch > 0) sum += 0.5*s.stiffness*stretch*stretch;
    }
    return sum;
}

template<class Backend, int D, class P>
void Clumps<Backend, D, P>::addEnergies(const DemClumpState& c, DemEnergy& e) const
{
    const auto potential = [&](double m, const double* x)
    {
        double sum = 0;
        for (int d = 0; d < D; ++d)
            sum -= m*set_.config.gravity[set_.config.axes[d]]*x[set_.config.axes[d]];
        return sum;
    };
    for (int k = 0; k < total_; ++k)
    {
        if (c.left[k]) continue;
        const DemClump& in = set_.input.clumps[k];
        for (int d = 0; d < 3; ++d)
            e.translation += 0.5*in.mass*c.velocity[3*k + d]*c.velocity[3*k + d];
        Vec<3, double> w{{c.spin[3*k], c.spin[3*k + 1], c.spin[3*k + 2]}};
        if (D == 2) e.rotation += 0.5*in.inertia[2]*squaredNorm(w);
        else
        {
            w = rotated(&c.orientation[4*k], w, true);
            for (int d = 0; d < 3; ++d) e.rotation += 0.5*in.inertia[d]*w.c[d]*w.c[d];
        }
        if (set_.input.groups[in.group].gravity)
            e.potential += potential(in.mass, &c.position[3*k]);
    }
}

template<class Backend, int D, class P>
std::size_t Clumps<Backend, D, P>::bytes() const
{
    return clumps_.bytes() + offset_.bytes() + memberFirst_.bytes() + member_.bytes()
        + constraints_.bytes() + springs_.bytes() + springFirst_.bytes();
}

} // namespace riprap

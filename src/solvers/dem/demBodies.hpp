/*  DemSolver: rigid bodies, their constraints and springs.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/contact/restitution.hpp"
#include "solvers/dem/demSolver.hpp"

namespace riprap
{

//- Where a face lands flat while one member touches, each of its n members would damp as if it were alone. Over a step, a fifth of that of the n springs, that
//  takes 0.4 zeta sqrt(n/least) of the speed: less than half with n zeta^2 at least
template<class Backend, int D, class P>
int DemSolver<Backend, D, P>::leastSharing(int together) const
{
    double zeta = 0;
    for (const DemPair& p : input_.pairs) zeta = std::max(zeta, linearDampingRatio(p.properties.restitution, p.properties.attraction));
    return std::max(1, int(std::ceil(together*std::min(1.0, zeta*zeta))));
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::setClumps()
{
    nClumps_ = int(input_.clumps.size());
    if (!nClumps_) return;
    std::vector<int> first(nClumps_ + 1, 0), member;
    const auto& of = given_->particles.clump;
    for (int i = 0; i < n_ && !of.empty(); ++i) if (of[i] >= 0) ++first[of[i] + 1];
    for (int k = 0; k < nClumps_; ++k)
    {
        largestClump_ = std::max(largestClump_, first[k + 1]);
        first[k + 1] += first[k];
    }
    std::vector<ClumpData> clumps(nClumps_);
    for (int k = 0; k < nClumps_; ++k)
    {
        const DemClump& in = input_.clumps[k];
        ClumpData& c = clumps[k];
        c = ClumpData{};
        c.q[0] = in.orientation[0];
        for (int d = 0; d < 3; ++d) c.q[1 + d] = (D == 2 ? spinSign() : 1)*in.orientation[1 + config_.axes[d]];
        for (int d = 0; d < D; ++d)
        {
            c.x[d] = box_.toFixed(d, in.position[config_.axes[d]]);
            c.v[d] = in.velocity[config_.axes[d]];
        }
        c.mass = in.mass;
        for (int d = 0; d < 3; ++d) c.inertia[d] = in.inertia[d];
        c.group = in.group;
        c.together = plan_.together[k];
        c.least = leastSharing(c.together);
        c.left = first[k + 1] == first[k];
        if (D == 2) c.L[2] = in.inertia[2]*spinSign()*in.spin[config_.axes[2]];
        else
        {
            Vec<3, double> w = rotated(c.q, Vec<3, double>{{in.spin[0], in.spin[1], in.spin[2]}}, true);
            for (int d = 0; d < 3; ++d) w.c[d] *= c.inertia[d];
            const Vec<3, double> L = rotated(c.q, w);
            for (int d = 0; d < 3; ++d) c.L[d] = L.c[d];
        }
    }
    std::vector<double> offset(3*std::size_t(n_), 0.0);
    member.resize(std::max(1, first[nClumps_]));
    std::vector<int> next(first.begin(), first.end() - 1);
    for (int i = 0; i < n_ && !of.empty(); ++i)
    {
        if (of[i] < 0) continue;
        member[next[of[i]]++] = i;
        Vec<3, double> arm{{0, 0, 0}};
        for (int d = 0; d < D; ++d)
        {
            const std::int64_t x = box_.toFixed(d, given_->particles.position[3*std::size_t(i) + config_.axes[d]]);
            arm.c[d] = double(std::int64_t(std::uint64_t(x) - std::uint64_t(clumps[of[i]].x[d])))*box_.unit[d];
        }
        arm = rotated(clumps[of[i]].q, arm, true);
        for (int d = 0; d < 3; ++d) offset[3*std::size_t(i) + d] = arm.c[d];
    }
    setConstraints(clumps);
    clumps_.upload(context_, clumps);
    setSprings(clumps);
    offset_.upload(context_, offset);
    memberFirst_.upload(context_, first);
    member_.upload(context_, member);
}

//- In the solver's axes
template<class Backend, int D, class P>
ClumpConstraint DemSolver<Backend, D, P>::constraintOf(const DemGroup& g) const
{
    const DemConstraint& in = g.constraint;
    ClumpConstraint s{};
    s.any = in.any();
    s.hinge = in.hinge;
    s.turn = in.rotation == RotationKind::free ? ClumpTurn::free : in.rotation == RotationKind::axis ? ClumpTurn::about : ClumpTurn::none;
    double n[3] = {}, length = 0, turn = 0;
    for (int d = 0; d < D; ++d)
    {
        const int axis = config_.axes[d];
        s.point[d] = in.point[axis];
        n[d] = in.direction[axis];
        length += n[d]*n[d];
        if (D == 3) s.axis[d] = in.axis[axis];
        turn += s.axis[d]*s.axis[d];
    }
    if (D == 2) s.axis[2] = 1;
    else for (double& a : s.axis) a /= std::sqrt(std::max(turn, 1e-300));
    const bool line = in.translation == TranslationKind::line, plane = in.translation == TranslationKind::plane;
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j)
        {
            const double nn = n[i]*n[j]/std::max(length, 1e-300);
            s.along[3*i + j] = line ? nn : (in.translation != TranslationKind::none)*(i == j) - plane*nn;
        }
    return s;
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::setConstraints(std::vector<ClumpData>& clumps)
{
    bool any = false;
    for (const DemGroup& g : input_.groups)
    {
        constraintOfGroup_.push_back(constraintOf(g));
        any = any || g.constraint.any();
    }
    for (ClumpData& c : clumps) if (constraintOfGroup_[c.group].any) restrain(c, constraintOfGroup_[c.group], box_);
    if (any) constraints_.upload(context_, constraintOfGroup_);
}

//- Points on bodies are given for where these stood at first
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::setSprings(const std::vector<ClumpData>& clumps)
{
    bool any = false;
    for (const DemGroup& g : input_.groups) any = any || !g.springs.empty();
    if (!any) return;
    std::vector<int> first(1, 0);
    for (int k = 0; k < nClumps_; ++k)
    {
        const DemClump& body = input_.clumps[k];
        const DemPose start = body.moved ? body.start : DemPose{body.position, body.orientation};
        double q[4] = {start.orientation[0], 0, 0, 0};
        for (int d = 0; d < 3; ++d) q[1 + d] = (D == 2 ? spinSign() : 1)*start.orientation[1 + config_.axes[d]];
        for (const DemSpring& in : input_.groups[body.group].springs)
        {
            SpringData s{};
            Vec<3, double> arm{{0, 0, 0}};
            for (int d = 0; d < D; ++d)
            {
                const int axis = config_.axes[d];
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
    for (int g = 0; g < int(input_.groups.size()); ++g)
        for (int e = 0; e < int(input_.groups[g].springs.size()); ++e)
            for (int k = 0; k < nClumps_; ++k) if (clumps[k].group == g) springOfGroups_.push_back({k, first[k] + e});
    springs_.upload(context_, allSprings_);
    springFirst_.upload(context_, first);
}

//- A constrained clump half a step later: from numbers that the host has
template<class Backend, int D, class P>
ClumpData DemSolver<Backend, D, P>::kicked(ClumpData c, double dt) const
{
    const GroupData<D, real> g = groupData(input_.groups[c.group]);
    const int group = c.group;
    c.group = 0;
    ClumpKick<D, P> kick = clumpKick();
    kick.groups = &g;
    kick.constraints = &constraintOfGroup_[group];
    kick(c, dt);
    c.group = group;
    return c;
}

template<class Backend, int D, class P>
DemClumpState DemSolver<Backend, D, P>::clumps()
{
    readClock();
    DemClumpState s;
    const double half = config_.integrator == DemIntegratorKind::leapfrog ? 0.5*host_.dt : 0;
    std::vector<ClumpData> all;
    if (nClumps_) all = clumps_.download();
    for (ClumpData& c : all)
    {
        const DemGroup& g = input_.groups[c.group];
        const bool constrained = g.constraint.any();
        const ClumpData later = kicked(c, half);
        const Vec<3, double> w = spinOf(later, c.q);
        double v[3] = {}, x[3] = {}, f[3] = {}, m[3] = {}, q[4] = {c.q[0], 0, 0, 0}, spin[3] = {};
        if (D == 2) x[config_.axes[2]] = input_.clumps[&c - all.data()].position[config_.axes[2]];
        for (int d = 0; d < 3; ++d)
        {
            const int axis = config_.axes[d];
            if (d < D)
            {
                x[axis] = box_.toMetres(d, c.x[d]);
                f[axis] = c.f[d] + (g.gravity ? c.mass*config_.gravity[axis] : 0) + g.force[axis];
                const double damped = locallyDamped(f[axis], c.v[d], g.localDamping) - g.viscousDamping*c.mass*c.v[d];
                v[axis] = constrained ? later.v[d] : c.v[d] + (g.held[axis] ? 0 : half*damped/c.mass);
            }
            const double sign = D == 2 ? spinSign() : 1;
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
std::vector<DemSpringState> DemSolver<Backend, D, P>::springs()
{
    std::vector<DemSpringState> all;
    if (allSprings_.empty()) return all;
    const std::vector<ClumpData> clumps = clumps_.download();
    for (const DemGroup& g : input_.groups) for (const DemSpring& s : g.springs) all.push_back(DemSpringState{g.name + "." + s.name});
    for (std::size_t i = 0; i < all.size(); ++i)
    {
        const ClumpData& c = clumps[springOfGroups_[i].first];
        all[i].left = c.left != 0;
        if (all[i].left) continue;
        const SpringPull pull = pullOf(allSprings_[springOfGroups_[i].second], c, box_);
        all[i].length = pull.length;
        all[i].tension = pull.tension;
        for (int d = 0; d < D; ++d)
        {
            const int axis = config_.axes[d];
            all[i].point[axis] = box_.toMetres(d, c.x[d]) + pull.arm.c[d];
            all[i].force[axis] = pull.force.c[d];
        }
    }
    return all;
}

//- Of what is stretched, or pressed together
template<class Backend, int D, class P>
double DemSolver<Backend, D, P>::springEnergy()
{
    double sum = 0;
    const std::vector<DemSpringState> now = springs();
    for (std::size_t i = 0; i < now.size(); ++i)
    {
        const SpringData& s = allSprings_[springOfGroups_[i].second];
        if (now[i].left) continue;
        const double stretch = now[i].length - s.length;
        if (!s.slack || stretch > 0) sum += 0.5*s.stiffness*stretch*stretch;
    }
    return sum;
}

} // namespace riprap

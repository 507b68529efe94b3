/*  SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "solvers/pic/picBodyForces.hpp"
#include "pic/shapes/latticeVolume.hpp"
#include <cmath>

namespace riprap
{

namespace
{

//- R(q) about the axes of space
void rotation(const double* q, double r[3][3])
{
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    const double m[3][3] =
    {
        {1 - 2*(y*y + z*z), 2*(x*y - w*z), 2*(x*z + w*y)},
        {2*(x*y + w*z), 1 - 2*(x*x + z*z), 2*(y*z - w*x)},
        {2*(x*z - w*y), 2*(y*z + w*x), 1 - 2*(x*x + y*y)}
    };
    for (int a = 0; a < 3; ++a) for (int b = 0; b < 3; ++b) r[a][b] = m[a][b];
}

//- The same place, and no velocity, to the bit
template<int D, class Shape>
bool rests(const FreeBody<D, Shape>& a, const FreeBody<D, Shape>& b)
{
    const auto &p = a.shape.balls.balls, &q = b.shape.balls.balls;
    bool same = p.size() == q.size();
    for (std::size_t k = 0; same && k < p.size(); ++k)
        for (int d = 0; d < D; ++d) same = same && p[k].centre[d] == q[k].centre[d];
    for (int d = 0; d < D; ++d)
        for (int k = 0; k < D; ++k)
            same = same && a.shape.sampled.centre[d] == b.shape.sampled.centre[d]
                && a.shape.sampled.axis[d][k] == b.shape.sampled.axis[d][k];
    for (const auto* f : {&a, &b}) for (const double v : f->velocity) same = same && v == 0;
    return same;
}

} // namespace

template<int D>
PicBodies<D>::PicBodies(const PicConfig& config, const PicSolids& solids, DemScene& scene)
:
    scene_(scene),
    groups_(solids.input.groups.empty() ? std::vector<DemGroup>(1) : solids.input.groups),
    motion_(solids.input.groupMotion),
    verlet_(solids.config.integrator == DemIntegratorKind::velocityVerlet),
    clumps_(!solids.input.clumps.empty()),
    weak_(solids.weak),
    beta_(solids.contactVelocity),
    betaTime_(solids.contactVelocityTime),
    shapes_(solids.shapes),
    stir_(solids.config.sleepAfter > 0 ? solids.config.sleepSpeed/solids.config.sleepAfter : 0)
{
    for (int d = 0; d < 3; ++d) axes_[d] = config.axes[d];
    for (int d = 0; d < D; ++d) gravity_[d] = config.gravity[axes_[d]];
    const DemParticles& p = solids.input.particles;
    for (const DemClump& c : solids.input.clumps)
    {
        Body b;
        b.clump = int(all_.size());
        b.group = c.group;
        b.shape = c.shape;
        b.mass = c.mass;
        for (int d = 0; d < 3; ++d) b.inertia[d] = c.inertia[d];
        all_.push_back(b);
    }
    for (std::size_t i = 0; i < p.size(); ++i)
    {
        const int id = p.id.empty() ? int(i) : p.id[i];
        largestId_ = std::max(largestId_, id);
        if (!p.clump.empty() && p.clump[i] >= 0) { all_[p.clump[i]].ids.push_back(id); continue; }
        Body b;
        b.ids = {id};
        b.group = p.group.empty() ? 0 : p.group[i];
        b.mass = p.mass[i];
        const double inertia = p.inertia.empty()
            ? (D == 2 ? 0.5 : 0.4)*p.mass[i]*p.radius[i]*p.radius[i]
            : p.inertia[i];
        b.inertia = filled<3>(inertia);
        all_.push_back(b);
    }
    memory_.resize(all_.size());
    ballOfId_.resize(largestId_ + 1);
    for (auto* v : {&forces_, &moments_}) v->assign(3*std::size_t(largestId_ + 1), 0.0);
    for (PicShape& s : shapes_)
    {
        SampledShape<D> u{};
        for (int d = 0; d < D; ++d)
        {
            u.lattice.lower[d] = s.lower[axes_[d]];
            u.lattice.n[d] = s.n[axes_[d]];
        }
        u.lattice.step = s.step;
        u.lattice.distance = s.distance.data();
        if (s.volume > 0)
        {
            const double outward = outwardToVolume(u.lattice, s.volume);
            for (double& distance : s.distance) distance -= outward;
        }
        unplaced_.push_back(u);
        reachOf_.push_back(u.reach());
    }
}

template<int D>
SampledShape<D> PicBodies<D>::placed(int shape, const Vec<D, double>& centre, const double* q) const
{
    SampledShape<D> s = unplaced_[shape];
    double r[3][3];
    rotation(q, r);
    s.centre = centre;
    for (int d = 0; d < D; ++d) for (int k = 0; k < D; ++k) s.axis[d][k] = r[axes_[d]][axes_[k]];
    return s;
}

//- Of spins about axes in this order against those of space
template<int D>
double PicBodies<D>::spinSign() const { return (axes_[1] - axes_[0] + 3) % 3 == 1 ? 1 : -1; }

template<int D>
typename PicBodies<D>::Modes PicBodies<D>::modesOf(const double* vector, const double* turn) const
{
    Modes m{};
    for (int d = 0; d < D; ++d) m[d] = vector[axes_[d]];
    for (int s = D; s < modes; ++s) m[s] = spinSign()*turn[D == 2 ? axes_[2] : axes_[s - D]];
    return m;
}

template<int D>
typename PicBodies<D>::Modes PicBodies<D>::gravityOf(const Now& n) const
{
    Modes g{};
    const Body& b = all_[n.body];
    const DemGroup& group = groups_[b.group];
    if (!group.gravity || group.motion >= 0) return g;
    for (int d = 0; d < D; ++d)
        g[d] = group.constraint.any() ? b.mass*gravity_[d]
            : group.held[axes_[d]] ? 0
                                      : gravity_[d];
    return group.constraint.any() ? times(n, g) : g;
}

//- What is held does not give way
template<int D>
void PicBodies<D>::setInverse(Now& n, const double* q, const Vec<D, double>& centre) const
{
    const Body& b = all_[n.body];
    const DemGroup& g = groups_[b.group];
    n.inverse.fill(0);
    if (g.motion >= 0) return;
    if (g.constraint.hinge) return setHinge(n, q, centre);
    double along[D][D];
    directions(g, along);
    for (int d = 0; d < D; ++d)
        for (int e = 0; e < D; ++e) n.inverse[d*modes + e] = along[d][e]/b.mass;
    if (g.heldSpin || g.constraint.rotation == RotationKind::none) return;
    if (D == 2) { n.inverse[2*modes + 2] = 1/b.inertia[2]; return; }
    if (g.constraint.rotation == RotationKind::axis)
    {
        double about = 0;
        const Modes turn = axisOf(n, q, about);
        for (int s = D; s < modes; ++s)
            for (int t = D; t < modes; ++t) n.inverse[s*modes + t] = turn[s]*turn[t]/about;
        return;
    }
    double r[3][3];
    rotation(q, r);
    for (int s = 0; s < 3; ++s)
        for (int t = 0; t < 3; ++t)
        {
            double sum = 0;
            for (int k = 0; k < 3; ++k) sum += r[axes_[s]][k]*r[axes_[t]][k]/b.inertia[k];
            n.inverse[(D + s)*modes + D + t] = sum;
        }
}

//- What of a force moves a group's bodies
template<int D>
void PicBodies<D>::directions(const DemGroup& g, double along[D][D]) const
{
    const TranslationKind kind = g.constraint.translation;
    double n[D], length = 0;
    for (int d = 0; d < D; ++d)
    {
        n[d] = g.constraint.direction[axes_[d]];
        length += n[d]*n[d];
    }
    for (int d = 0; d < D; ++d)
        for (int e = 0; e < D; ++e)
        {
            const double own = d == e && kind != TranslationKind::none && !g.held[axes_[d]],
                         nn = n[d]*n[e]/std::max(length, 1e-300);
            along[d][e] = kind == TranslationKind::line
                ? nn
                : own - (kind == TranslationKind::plane ? nn : 0);
        }
}

//- Spin of 1 about a constraint's axis; and the inertia about it, through the centre
template<int D>
typename PicBodies<D>::Modes PicBodies<D>::axisOf(
    const Now& n, const double* q, double& about) const
{
    const Body& b = all_[n.body];
    Modes turn{};
    if (D == 2)
    {
        turn[2] = 1;
        about = b.inertia[2];
        return turn;
    }
    const Vector3& a = groups_[b.group].constraint.axis;
    const double length = std::sqrt(a[0]*a[0] + a[1]*a[1] + a[2]*a[2]);
    double r[3][3];
    rotation(q, r);
    about = 0;
    for (int k = 0; k < 3; ++k)
    {
        double own = 0;
        for (int d = 0; d < 3; ++d) own += r[d][k]*a[d]/length;
        about += b.inertia[k]*own*own;
        turn[D + k] = a[axes_[k]]/length;
    }
    return turn;
}

//- A hinged body has one way to move
template<int D>
void PicBodies<D>::setHinge(Now& n, const double* q, const Vec<D, double>& centre) const
{
    const Body& b = all_[n.body];
    double about = 0, swept = 0;
    Modes way = axisOf(n, q, about);
    Vec<D, double> arm;
    for (int d = 0; d < D; ++d) arm[d] = centre[d] - groups_[b.group].constraint.point[axes_[d]];
    for (int d = 0; d < D; ++d)
    {
        for (int s = D; s < modes; ++s) way[d] += way[s]*modeVelocity(s, d, arm);
        swept += way[d]*way[d];
    }
    for (int i = 0; i < modes; ++i)
        for (int k = 0; k < modes; ++k)
            n.inverse[i*modes + k] = way[i]*way[k]/(about + b.mass*swept);
}

template<int D>
typename PicBodies<D>::Modes PicBodies<D>::times(const Now& n, const Modes& force) const
{
    Modes a{};
    for (int i = 0; i < modes; ++i)
        for (int k = 0; k < modes; ++k) a[i] += n.inverse[i*modes + k]*force[k];
    return a;
}

template<int D>
bool PicBodies<D>::read()
{
    const std::vector<FreeBody<D, Shape>> before = std::move(bodies_);
    const DemState s = scene_.motion();
    const DemClumpState c = clumps_ ? scene_.clumps() : DemClumpState();
    std::vector<int> slot(largestId_ + 1, -1);
    for (int i = 0; i < int(s.id.size()); ++i) slot[s.id[i]] = i;
    now_.clear();
    bodies_.clear();
    static const double unturned[4] = {1, 0, 0, 0};
    for (int b = 0; b < int(all_.size()); ++b)
    {
        const Body& body = all_[b];
        const int carrier = body.ids.empty() ? -1 : slot[body.ids[0]];
        if (carrier < 0) continue;              // has left
        Now n;
        n.body = b;
        const bool clump = body.clump >= 0;
        const auto at = [&](const std::vector<double>& single, const std::vector<double>& whole)
        { return clump ? &whole[3*std::size_t(body.clump)] : &single[3*std::size_t(carrier)]; };
        const double* x = at(s.position, c.position);
        n.velocity = modesOf(at(s.velocity, c.velocity), at(s.spin, c.spin));
        n.total = modesOf(at(s.force, c.force), at(s.moment, c.moment));
        Vec<D, double> centre;
        for (int d = 0; d < D; ++d) centre[d] = x[axes_[d]];
        setInverse(n, clump ? &c.orientation[4*std::size_t(body.clump)] : unturned, centre);
        for (int d = 0; d < 3; ++d)
            n.arm[d] = clump ? s.position[3*std::size_t(carrier) + d] - x[d] : 0;
        FreeBody<D, Shape> f;
        f.centre = centre;
        for (const int id : body.ids)
        {
            if (slot[id] < 0) continue;
            Ball<D> ball;
            for (int d = 0; d < D; ++d)
                ball.centre[d] = s.position[3*std::size_t(slot[id]) + axes_[d]];
            ball.radius = s.radius[slot[id]];
            f.shape.balls.balls.push_back(ball);
            ballOfId_[id] = ball;
        }
        f.reach = f.shape.balls.reach(f.centre);
        if (body.shape >= 0)
        {
            f.shape.sampled = placed(
                body.shape, f.centre, &c.orientation[4*std::size_t(body.clump)]);
            f.reach = reachOf_[body.shape];
        }
        f.velocity.assign(n.velocity.begin(), n.velocity.end());
        // of a state that was loaded: hold() leaves it the force under which it sleeps
        n.asleep = sleeps(n);
        now_.push_back(n);
        bodies_.push_back(f);
    }
    return before.size() != bodies_.size()
        || !std::equal(before.begin(), before.end(), bodies_.begin(), rests<D, Shape>);
}

template<int D>
bool PicBodies<D>::yield() const
{
    for (const Now& n : now_) for (const double v : n.inverse) if (v != 0) return true;
    return false;
}

template<int D>
bool PicBodies<D>::sleeps(const Now& n) const
{
    bool still = stir_ > 0 && memory_[n.body].begun && all_[n.body].clump < 0
        && groups_[all_[n.body].group].motion < 0;
    for (const double v : n.velocity) still = still && v == 0;
    return still;
}

//- Does the water's force on a sleeper differ from what it got by more than it sleeps through?
template<int D>
bool PicBodies<D>::stirred(const Now& n) const
{
    const Body& b = all_[n.body];
    const Memory& m = memory_[n.body];
    const double radius = bodies_[&n - now_.data()].reach;
    double change = 0;
    for (int k = 0; k < modes; ++k)
        change += std::abs(m.force[k] - m.given[k])/(k < D ? 1 : radius);
    return change > stir_*b.mass;
}

template<int D>
double PicBodies<D>::fastest() const
{
    double most = 0;
    for (std::size_t i = 0; i < now_.size(); ++i)
    {
        double v2 = 0, w2 = 0;
        for (int d = 0; d < D; ++d) v2 += now_[i].velocity[d]*now_[i].velocity[d];
        for (int s = D; s < modes; ++s) w2 += now_[i].velocity[s]*now_[i].velocity[s];
        const double speed = std::sqrt(v2) + std::sqrt(w2)*bodies_[i].reach;
        if (!(speed <= most)) most = speed;         // no number stays
    }
    return most;
}

template<int D>
bool PicBodies<D>::acrossPeriodic(const UniformGrid<D>& grid) const
{
    for (const auto& b : bodies_)
        for (int d = 0; d < D; ++d)
        {
            const double low = b.centre[d] - b.reach - grid.origin[d],
                         high = grid.n[d]*grid.h - (b.centre[d] + b.reach - grid.origin[d]);
            if (grid.periodic[d] && (low < 0 || high < 0)) return true;
        }
    return false;
}

//- Where solids touch each other or walls, in the middle of what is left between them
template<int D>
std::vector<ContactArea<D>> PicBodies<D>::contacts(const UniformGrid<D>& grid) const
{
    const DemContacts all = scene_.contacts();
    std::vector<ContactArea<D>> areas;
    for (std::size_t k = 0; k < all.a.size(); ++k)
    {
        const Ball<D>& a = ballOfId_[all.a[k]];
        ContactArea<D> area;
        for (int d = 0; d < D; ++d) area.normal[d] = all.point[3*k + axes_[d]] - a.centre[d];
        double reach = std::sqrt(squaredNorm(area.normal));
        if (!(reach > 0)) continue;
        if (all.b[k] >= 0)
        {
            const Ball<D>& b = ballOfId_[all.b[k]];
            area.normal = b.centre - a.centre;
            const double distance = std::sqrt(squaredNorm(area.normal));
            if (!(distance > 0)) continue;
            reach = 0.5*(distance + a.radius - b.radius);
            area.normal = (1/distance)*area.normal;
        }
        else area.normal = (1/reach)*area.normal;
        for (int d = 0; d < D; ++d)
            area.point[d] = a.centre[d] + std::max(reach, a.radius)*area.normal[d]
                - grid.origin[d];
        areas.push_back(area);
    }
    return areas;
}

template<int D>
Vector3 PicBodies<D>::force() const
{
    Vector3 sum{{0, 0, 0}};
    for (const Now& n : now_) for (int d = 0; d < D; ++d) sum[axes_[d]] += memory_[n.body].force[d];
    return sum;
}

template<int D>
std::vector<FluidForce> PicBodies<D>::forces() const
{
    std::vector<FluidForce> all;
    for (const Now& n : now_)
    {
        const Memory& m = memory_[n.body];
        const Vec<D, double>& centre = bodies_[&n - now_.data()].centre;
        FluidForce f;
        f.part = all_[n.body].group;
        for (int d = 0; d < D; ++d)
        {
            f.place[axes_[d]] = centre[d];
            f.viscous[axes_[d]] = m.drag[d];
            f.pressure[axes_[d]] = m.force[d] - m.drag[d];
        }
        for (int s = D; s < modes; ++s)
        {
            const int axis = D == 2 ? axes_[2] : axes_[s - D];
            f.viscousMoment[axis] = spinSign()*m.drag[s];
            f.pressureMoment[axis] = spinSign()*(m.force[s] - m.drag[s]);
        }
        all.push_back(f);
    }
    return all;
}

//- Of balls that have left nobody knows in a scene that goes on
template<int D>
std::vector<double> PicBodies<D>::memory() const
{
    std::vector<char> there(largestId_ + 1, 0);
    for (const std::int32_t id : scene_.motion().id) there[id] = 1;
    std::vector<double> v;
    for (std::size_t b = 0; b < all_.size(); ++b)
    {
        if (all_[b].clump < 0 && !there[all_[b].ids[0]]) continue;
        const Memory& m = memory_[b];
        for (const Modes* a : {&m.force, &m.old, &m.start, &m.middle, &m.given, &m.ahead})
            v.insert(v.end(), a->begin(), a->end());
        v.push_back(m.begun);
    }
    for (const auto* a : {&forces_, &moments_})
        for (int id = 0; id <= largestId_; ++id)
            if (there[id])
                v.insert(v.end(), &(*a)[3*std::size_t(id)], &(*a)[3*std::size_t(id)] + 3);
    return v;
}

template<int D>
bool PicBodies<D>::setMemory(const std::vector<double>& v)
{
    constexpr std::size_t each = 6*modes + 1;
    std::vector<char> there(largestId_ + 1, 0);
    for (const Body& b : all_) for (const int id : b.ids) there[id] = 1;
    if (v.size()
        != each*memory_.size() + 6*std::size_t(std::count(there.begin(), there.end(), 1)))
        return false;
    for (std::size_t b = 0; b < memory_.size(); ++b)
    {
        const double* from = &v[b*each];
        Memory& m = memory_[b];
        for (Modes* a : {&m.force, &m.old, &m.start, &m.middle, &m.given, &m.ahead})
        {
            std::copy(from, from + modes, a->begin());
            from += modes;
        }
        m.begun = *from != 0;
    }
    const double* from = &v[each*memory_.size()];
    for (auto* a : {&forces_, &moments_})
        for (int id = 0; id <= largestId_; ++id)
            if (there[id])
            {
                std::copy(from, from + 3, &(*a)[3*std::size_t(id)]);
                from += 3;
            }
    // before the scene's own state is loaded, which knows who sleeps: forces that are new to it
    // would wake them
    send();
    return true;
}

template class PicBodies<2>;
template class PicBodies<3>;

} // namespace riprap

/*  SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "solvers/pic/bodies/bodyReader.hpp"
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
BodyReader<D>::BodyReader(
    const BodySetting<D>& set, BodyTable<D>& table, const std::vector<PicShape>& shapes)
    : set_(set), table_(table), shapes_(shapes)
{
    for (PicShape& s : shapes_)
    {
        SampledShape<D> u{};
        for (int d = 0; d < D; ++d)
        {
            u.lattice.lower[d] = s.lower[set.axes[d]];
            u.lattice.n[d] = s.n[set.axes[d]];
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
bool BodyReader<D>::read()
{
    const std::vector<FreeBody<D, Shape>> before = std::move(table_.bodies);
    const DemState s = set_.scene.motion();
    const DemClumpState c = set_.clumps ? set_.scene.clumps() : DemClumpState();
    std::vector<int> slot(table_.largestId + 1, -1);
    for (int i = 0; i < int(s.id.size()); ++i) slot[s.id[i]] = i;
    table_.now.clear();
    table_.bodies.clear();
    static const double unturned[4] = {1, 0, 0, 0};
    for (int b = 0; b < int(table_.all.size()); ++b)
    {
        const Body& body = table_.all[b];
        const int carrier = body.ids.empty() ? -1 : slot[body.ids[0]];
        if (carrier < 0) continue;              // has left
        Now n;
        n.body = b;
        const bool clump = body.clump >= 0;
        const auto at = [&](const std::vector<double>& single, const std::vector<double>& whole)
        { return clump ? &whole[3*std::size_t(body.clump)] : &single[3*std::size_t(carrier)]; };
        const double* x = at(s.position, c.position);
        n.velocity = set_.modesOf(at(s.velocity, c.velocity), at(s.spin, c.spin));
        n.total = set_.modesOf(at(s.force, c.force), at(s.moment, c.moment));
        Vec<D, double> centre;
        for (int d = 0; d < D; ++d) centre[d] = x[set_.axes[d]];
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
                ball.centre[d] = s.position[3*std::size_t(slot[id]) + set_.axes[d]];
            ball.radius = s.radius[slot[id]];
            f.shape.balls.balls.push_back(ball);
            table_.ballOfId[id] = ball;
        }
        f.reach = f.shape.balls.reach(f.centre);
        if (body.shape >= 0)
        {
            f.shape.sampled = placed(
                body.shape, f.centre, &c.orientation[4*std::size_t(body.clump)]);
            f.reach = reachOf_[body.shape];
        }
        f.velocity.assign(n.velocity.begin(), n.velocity.end());
        // of a state that was loaded: BodyForces::hold leaves it the force under which it sleeps
        n.asleep = table_.sleeps(n);
        table_.now.push_back(n);
        table_.bodies.push_back(f);
    }
    return before.size() != table_.bodies.size()
        || !std::equal(before.begin(), before.end(), table_.bodies.begin(), rests<D, Shape>);
}

template<int D>
SampledShape<D> BodyReader<D>::placed(
    int shape, const Vec<D, double>& centre, const double* q) const
{
    SampledShape<D> s = unplaced_[shape];
    double r[3][3];
    rotation(q, r);
    s.centre = centre;
    for (int d = 0; d < D; ++d)
        for (int k = 0; k < D; ++k) s.axis[d][k] = r[set_.axes[d]][set_.axes[k]];
    return s;
}

//- What is held does not give way
template<int D>
void BodyReader<D>::setInverse(Now& n, const double* q, const Vec<D, double>& centre) const
{
    const Body& b = table_.all[n.body];
    const DemGroup& g = set_.groups[b.group];
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
            for (int k = 0; k < 3; ++k) sum += r[set_.axes[s]][k]*r[set_.axes[t]][k]/b.inertia[k];
            n.inverse[(D + s)*modes + D + t] = sum;
        }
}

//- What of a force moves a group's bodies
template<int D>
void BodyReader<D>::directions(const DemGroup& g, double along[D][D]) const
{
    const TranslationKind kind = g.constraint.translation;
    double n[D], length = 0;
    for (int d = 0; d < D; ++d)
    {
        n[d] = g.constraint.direction[set_.axes[d]];
        length += n[d]*n[d];
    }
    for (int d = 0; d < D; ++d)
        for (int e = 0; e < D; ++e)
        {
            const double own = d == e && kind != TranslationKind::none && !g.held[set_.axes[d]],
                         nn = n[d]*n[e]/std::max(length, 1e-300);
            along[d][e] = kind == TranslationKind::line
                ? nn
                : own - (kind == TranslationKind::plane ? nn : 0);
        }
}

//- Spin of 1 about a constraint's axis; and the inertia about it, through the centre
template<int D>
typename BodyReader<D>::Modes BodyReader<D>::axisOf(
    const Now& n, const double* q, double& about) const
{
    const Body& b = table_.all[n.body];
    Modes turn{};
    if (D == 2)
    {
        turn[2] = 1;
        about = b.inertia[2];
        return turn;
    }
    const Vector3& a = set_.groups[b.group].constraint.axis;
    const double length = std::sqrt(a[0]*a[0] + a[1]*a[1] + a[2]*a[2]);
    double r[3][3];
    rotation(q, r);
    about = 0;
    for (int k = 0; k < 3; ++k)
    {
        double own = 0;
        for (int d = 0; d < 3; ++d) own += r[d][k]*a[d]/length;
        about += b.inertia[k]*own*own;
        turn[D + k] = a[set_.axes[k]]/length;
    }
    return turn;
}

//- A hinged body has one way to move
template<int D>
void BodyReader<D>::setHinge(Now& n, const double* q, const Vec<D, double>& centre) const
{
    const Body& b = table_.all[n.body];
    double about = 0, swept = 0;
    Modes way = axisOf(n, q, about);
    Vec<D, double> arm;
    for (int d = 0; d < D; ++d)
        arm[d] = centre[d] - set_.groups[b.group].constraint.point[set_.axes[d]];
    for (int d = 0; d < D; ++d)
    {
        for (int s = D; s < modes; ++s) way[d] += way[s]*modeVelocity(s, d, arm);
        swept += way[d]*way[d];
    }
    for (int i = 0; i < modes; ++i)
        for (int k = 0; k < modes; ++k)
            n.inverse[i*modes + k] = way[i]*way[k]/(about + b.mass*swept);
}

template class BodyReader<2>;
template class BodyReader<3>;

} // namespace riprap

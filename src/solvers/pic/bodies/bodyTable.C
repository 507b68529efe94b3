/*  SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "solvers/pic/bodies/bodyTable.hpp"
#include <cmath>

namespace riprap
{

template<int D>
BodyTable<D>::BodyTable(const BodySetting<D>& set, const DemInput& in)
:
    set_(set)
{
    const DemParticles& p = in.particles;
    for (const DemClump& c : in.clumps)
    {
        Body b;
        b.clump = int(all.size());
        b.group = c.group;
        b.shape = c.shape;
        b.mass = c.mass;
        for (int d = 0; d < 3; ++d) b.inertia[d] = c.inertia[d];
        all.push_back(b);
    }
    for (std::size_t i = 0; i < p.size(); ++i)
    {
        const int id = p.id.empty() ? int(i) : p.id[i];
        largestId = std::max(largestId, id);
        if (!p.clump.empty() && p.clump[i] >= 0) { all[p.clump[i]].ids.push_back(id); continue; }
        Body b;
        b.ids = {id};
        b.group = p.group.empty() ? 0 : p.group[i];
        b.mass = p.mass[i];
        const double inertia = p.inertia.empty()
            ? (D == 2 ? 0.5 : 0.4)*p.mass[i]*p.radius[i]*p.radius[i]
            : p.inertia[i];
        b.inertia = filled<3>(inertia);
        all.push_back(b);
    }
    memory.resize(all.size());
    ballOfId.resize(largestId + 1);
}

template<int D>
typename BodyTable<D>::Modes BodyTable<D>::gravityOf(const Now& n) const
{
    Modes g{};
    const Body& b = all[n.body];
    const DemGroup& group = set_.groups[b.group];
    if (!group.gravity || group.motion >= 0) return g;
    for (int d = 0; d < D; ++d)
        g[d] = group.constraint.any() ? b.mass*set_.gravity[d]
            : group.held[set_.axes[d]] ? 0
                                       : set_.gravity[d];
    return group.constraint.any() ? times(n, g) : g;
}

template<int D>
bool BodyTable<D>::sleeps(const Now& n) const
{
    bool still = set_.stir > 0 && memory[n.body].begun && all[n.body].clump < 0
        && set_.groups[all[n.body].group].motion < 0;
    for (const double v : n.velocity) still = still && v == 0;
    return still;
}

template<int D>
std::vector<FreeBody<D, BodyShape<D>>> BodyTable<D>::withVelocities(bool predicted) const
{
    std::vector<FreeBody<D, Shape>> all(bodies);
    for (std::size_t i = 0; i < all.size(); ++i)
    {
        const Memory& m = memory[now[i].body];
        const Modes& v = predicted ? now[i].predicted : (m.begun ? m.middle : now[i].velocity);
        all[i].velocity.assign(v.begin(), v.end());
    }
    return all;
}

template<int D>
std::vector<double> BodyTable<D>::velocities(bool predicted) const
{
    std::vector<double> all;
    all.reserve(now.size()*modes);
    for (const Now& n : now)
    {
        const Memory& m = memory[n.body];
        const Modes& v = predicted ? n.predicted : (m.begun ? m.middle : n.velocity);
        for (int k = 0; k < modes; ++k) all.push_back(v[k] - (predicted ? 0 : m.ahead[k]));
    }
    return all;
}

template<int D>
void BodyTable<D>::fill(std::vector<BodyTerm>& terms) const
{
    for (std::size_t i = 0; i < terms.size(); ++i)
    {
        terms[i].velocity.assign(now[i].predicted.begin(), now[i].predicted.end());
        terms[i].inverseMass.assign(now[i].inverse.begin(), now[i].inverse.end());
    }
}

template<int D>
std::vector<double> BodyTable<D>::roots() const
{
    std::vector<double> all(now.size()*modes*modes, 0.0);
    for (std::size_t i = 0; i < now.size(); ++i)
        rootOfInverseMass(modes, now[i].inverse.data(), &all[i*modes*modes]);
    return all;
}

template<int D>
bool BodyTable<D>::anyLighter(const std::vector<double>& volume, double density) const
{
    bool any = false;
    for (std::size_t i = 0; i < now.size(); ++i)
        any = any || isLighter(modes, now[i].inverse.data(), volume[i], density);
    return any;
}

template<int D>
bool BodyTable<D>::yield() const
{
    for (const Now& n : now) for (const double v : n.inverse) if (v != 0) return true;
    return false;
}

template<int D>
double BodyTable<D>::fastest() const
{
    double most = 0;
    for (std::size_t i = 0; i < now.size(); ++i)
    {
        double v2 = 0, w2 = 0;
        for (int d = 0; d < D; ++d) v2 += now[i].velocity[d]*now[i].velocity[d];
        for (int s = D; s < modes; ++s) w2 += now[i].velocity[s]*now[i].velocity[s];
        const double speed = std::sqrt(v2) + std::sqrt(w2)*bodies[i].reach;
        if (!(speed <= most)) most = speed;         // no number stays
    }
    return most;
}

template<int D>
bool BodyTable<D>::acrossPeriodic(const UniformGrid<D>& grid) const
{
    for (const auto& b : bodies)
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
std::vector<ContactArea<D>> BodyTable<D>::contacts(const UniformGrid<D>& grid) const
{
    const DemContacts all = set_.scene.contacts();
    std::vector<ContactArea<D>> areas;
    for (std::size_t k = 0; k < all.a.size(); ++k)
    {
        const Ball<D>& a = ballOfId[all.a[k]];
        ContactArea<D> area;
        for (int d = 0; d < D; ++d) area.normal[d] = all.point[3*k + set_.axes[d]] - a.centre[d];
        double reach = std::sqrt(squaredNorm(area.normal));
        if (!(reach > 0)) continue;
        if (all.b[k] >= 0)
        {
            const Ball<D>& b = ballOfId[all.b[k]];
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

template class BodyTable<2>;
template class BodyTable<3>;

} // namespace riprap

/*  SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "solvers/pic/bodies/bodyForces.hpp"
#include <cmath>

namespace riprap
{

namespace
{

//- The smaller of two that agree in direction, else nothing: components first .. last - 1
template<class V>
void agree(const V& a, const V& b, int first, int last, V& out)
{
    double dot = 0, a2 = 0, b2 = 0;
    for (int m = first; m < last; ++m) { dot += a[m]*b[m]; a2 += a[m]*a[m]; b2 += b[m]*b[m]; }
    for (int m = first; m < last; ++m) out[m] = dot > 0 ? (a2 < b2 ? a[m] : b[m]) : 0;
}

} // namespace

template<int D>
BodyForces<D>::BodyForces(const BodySetting<D>& set, BodyTable<D>& table)
:
    set_(set), table_(table)
{
    for (auto* v : {&forces_, &moments_}) v->assign(3*std::size_t(table.largestId + 1), 0.0);
}

template<int D>
void BodyForces<D>::predict(double dt, double before)
{
    const double kick = before > 0 ? 0.5*(before + dt) : 0.5*dt;
    for (Now& n : table_.now)
    {
        const Body& b = table_.all[n.body];
        const DemGroup& group = set_.groups[b.group];
        Memory& m = table_.memory[n.body];
        n.asleep = before > 0 && table_.sleeps(n);
        if (n.asleep)                           // a wall
        {
            n.inverse.fill(0);
            n.predicted.fill(0);
            continue;
        }
        if (group.motion >= 0 && set_.motion)
        {
            const RigidMotion r = set_.motion(group.motion, set_.scene.time() + 0.5*dt);
            n.predicted = set_.modesOf(r.velocity.data(), r.spin.data());
            const auto& f = table_.bodies[&n - table_.now.data()];
            Vec<D, double> arm;
            for (int d = 0; d < D; ++d) arm[d] = f.centre[d] - r.centre[set_.axes[d]];
            for (int d = 0; d < D; ++d)
                for (int s = D; s < modes; ++s)
                    n.predicted[d] += n.predicted[s]*modeVelocity(s, d, arm);
            continue;
        }
        const Modes g = table_.gravityOf(n), water = table_.times(n, m.force),
                    all = table_.times(n, n.total);
        Modes mean{}, last{}, lasting{};
        for (int k = 0; k < modes; ++k)
        {
            mean[k] = m.begun && before > 0
                ? (n.velocity[k] - m.start[k])/before - water[k] - g[k]
                : 0;
            last[k] = all[k] - water[k] - g[k];
        }
        agree(mean, last, 0, D, lasting);
        agree(mean, last, D, modes, lasting);
        for (int k = 0; k < modes; ++k)
            n.predicted[k] = n.velocity[k] - 0.5*before*water[k]
                + 0.5*dt*(g[k] + lasting[k]) + (set_.weak ? kick*water[k] : 0);
    }
}

template<int D>
void BodyForces<D>::foresee(const std::vector<double>& against)
{
    for (std::size_t i = 0; i < table_.now.size(); ++i)
    {
        Modes given{};
        if (!against.empty()) for (int k = 0; k < modes; ++k) given[k] = -against[i*modes + k];
        const Modes change = table_.memory[table_.now[i].body].ahead = table_.times(
            table_.now[i], given);
        for (int k = 0; k < modes; ++k) table_.now[i].predicted[k] += change[k];
    }
}

template<int D>
void BodyForces<D>::move(const std::vector<double>& against, double dt)
{
    for (std::size_t i = 0; i < table_.now.size(); ++i)
    {
        Now& n = table_.now[i];
        n.moved = n.predicted;
        if (set_.weak) continue;
        Modes given{};
        for (int k = 0; k < modes; ++k) given[k] = -dt*against[i*modes + k];
        const Modes change = table_.times(n, given);
        for (int k = 0; k < modes; ++k) n.moved[k] += change[k];
    }
}

template<int D>
void BodyForces<D>::act(const std::vector<double>& against)
{
    for (std::size_t i = 0; i < table_.now.size(); ++i)
    {
        Memory& m = table_.memory[table_.now[i].body];
        m.old = m.force;
        for (int k = 0; k < modes; ++k)
        {
            m.force[k] = -against[i*modes + k] + table_.now[i].drag[k];
            m.drag[k] = table_.now[i].drag[k];
            m.middle[k] = table_.now[i].moved[k];
            finite_ = finite_ && std::isfinite(m.force[k]);
        }
    }
}

template<int D>
void BodyForces<D>::startDrag() { for (Now& n : table_.now) n.drag.fill(0); }

template<int D>
void BodyForces<D>::drag(int body, int component, double force, const Vec<D, double>& at)
{
    const Vec<D, double> arm = at - table_.bodies[body].centre;
    for (int k = 0; k < modes; ++k)
        table_.now[body].drag[k] += force*modeVelocity(k, component, arm);
}

template<int D>
std::vector<double> BodyForces<D>::drags() const
{
    std::vector<double> sums;
    for (const Now& n : table_.now) sums.insert(sums.end(), n.drag.begin(), n.drag.end());
    return sums;
}

template<int D>
void BodyForces<D>::setDrags(const std::vector<double>& sums)
{
    for (std::size_t i = 0; i < table_.now.size(); ++i)
        std::copy_n(sums.begin() + std::ptrdiff_t(i*modes), modes, table_.now[i].drag.begin());
}

template<int D>
void BodyForces<D>::endDrag(double dt, double viscosity, const std::vector<double>& volume)
{
    for (std::size_t i = 0; i < table_.now.size(); ++i)
    {
        Now& n = table_.now[i];
        const Memory& m = table_.memory[n.body];
        const Modes& now = m.begun ? m.middle : n.velocity;
        for (int s = D; s < modes; ++s) n.drag[s] -= 2*viscosity*volume[i]*now[s];
        const Modes change = table_.times(n, n.drag);
        for (int k = 0; k < modes; ++k) n.predicted[k] += dt*change[k];
    }
}

template<int D>
void BodyForces<D>::push(double before, double lag, double kick)
{
    for (Now& n : table_.now)
    {
        Memory& m = table_.memory[n.body];
        if (n.asleep)
        {
            n.asleep = !stirred(n);
            m.start.fill(0);
            m.begun = n.asleep;
            put(n, n.asleep ? m.given : m.force);
            continue;
        }
        Modes change{}, force{};
        for (int k = 0; k < modes; ++k) change[k] = 0.5*before*(m.force[k] - m.old[k]);
        const Modes jump = table_.times(n, change);
        for (int k = 0; k < modes; ++k)
        {
            m.start[k] = n.velocity[k] + jump[k];
            force[k] = m.force[k] + 0.5*(before - lag)*(m.force[k] - m.old[k])/kick;
        }
        m.begun = true;
        put(n, force);
    }
    send();
}

template<int D>
void BodyForces<D>::hold()
{
    for (const Now& n : table_.now)
    {
        Memory& m = table_.memory[n.body];
        if (!n.asleep) m.given = m.force;
        put(n, m.given);
    }
    send();
}

template<int D>
void BodyForces<D>::put(const Now& n, const Modes& force)
{
    const int id = table_.all[n.body].ids[0];
    double f[3] = {0, 0, 0}, m[3] = {0, 0, 0};
    for (int d = 0; d < D; ++d) f[set_.axes[d]] = force[d];
    for (int s = D; s < modes; ++s)
        m[D == 2 ? set_.axes[2] : set_.axes[s - D]] = set_.spinSign()*force[s];
    for (int d = 0; d < 3; ++d)
    {
        const int a = (d + 1) % 3, b = (d + 2) % 3;
        forces_[3*std::size_t(id) + d] = f[d];
        moments_[3*std::size_t(id) + d] = m[d] - (n.arm[a]*f[b] - n.arm[b]*f[a]);
    }
}

template<int D>
void BodyForces<D>::send() { set_.scene.setExternalForces(forces_, moments_); }

//- Does the water's force on a sleeper differ from what it got by more than it sleeps through?
template<int D>
bool BodyForces<D>::stirred(const Now& n) const
{
    const Body& b = table_.all[n.body];
    const Memory& m = table_.memory[n.body];
    const double radius = table_.bodies[&n - table_.now.data()].reach;
    double change = 0;
    for (int k = 0; k < modes; ++k)
        change += std::abs(m.force[k] - m.given[k])/(k < D ? 1 : radius);
    return change > set_.stir*b.mass;
}

template<int D>
Vector3 BodyForces<D>::force() const
{
    Vector3 sum{{0, 0, 0}};
    for (const Now& n : table_.now)
        for (int d = 0; d < D; ++d) sum[set_.axes[d]] += table_.memory[n.body].force[d];
    return sum;
}

template<int D>
std::vector<FluidForce> BodyForces<D>::forces() const
{
    std::vector<FluidForce> all;
    for (const Now& n : table_.now)
    {
        const Memory& m = table_.memory[n.body];
        const Vec<D, double>& centre = table_.bodies[&n - table_.now.data()].centre;
        FluidForce f;
        f.part = table_.all[n.body].group;
        for (int d = 0; d < D; ++d)
        {
            f.place[set_.axes[d]] = centre[d];
            f.viscous[set_.axes[d]] = m.drag[d];
            f.pressure[set_.axes[d]] = m.force[d] - m.drag[d];
        }
        for (int s = D; s < modes; ++s)
        {
            const int axis = D == 2 ? set_.axes[2] : set_.axes[s - D];
            f.viscousMoment[axis] = set_.spinSign()*m.drag[s];
            f.pressureMoment[axis] = set_.spinSign()*(m.force[s] - m.drag[s]);
        }
        all.push_back(f);
    }
    return all;
}

//- Of balls that have left nobody knows in a scene that goes on
template<int D>
std::vector<double> BodyForces<D>::memory() const
{
    std::vector<char> there(table_.largestId + 1, 0);
    for (const std::int32_t id : set_.scene.motion().id) there[id] = 1;
    std::vector<double> v;
    for (std::size_t b = 0; b < table_.all.size(); ++b)
    {
        if (table_.all[b].clump < 0 && !there[table_.all[b].ids[0]]) continue;
        const Memory& m = table_.memory[b];
        for (const Modes* a : {&m.force, &m.old, &m.start, &m.middle, &m.given, &m.ahead})
            v.insert(v.end(), a->begin(), a->end());
        v.push_back(m.begun);
    }
    for (const auto* a : {&forces_, &moments_})
        for (int id = 0; id <= table_.largestId; ++id)
            if (there[id])
                v.insert(v.end(), &(*a)[3*std::size_t(id)], &(*a)[3*std::size_t(id)] + 3);
    return v;
}

template<int D>
bool BodyForces<D>::setMemory(const std::vector<double>& v)
{
    constexpr std::size_t each = 6*modes + 1;
    std::vector<char> there(table_.largestId + 1, 0);
    for (const Body& b : table_.all) for (const int id : b.ids) there[id] = 1;
    if (v.size()
        != each*table_.memory.size() + 6*std::size_t(std::count(there.begin(), there.end(), 1)))
        return false;
    for (std::size_t b = 0; b < table_.memory.size(); ++b)
    {
        const double* from = &v[b*each];
        Memory& m = table_.memory[b];
        for (Modes* a : {&m.force, &m.old, &m.start, &m.middle, &m.given, &m.ahead})
        {
            std::copy(from, from + modes, a->begin());
            from += modes;
        }
        m.begun = *from != 0;
    }
    const double* from = &v[each*table_.memory.size()];
    for (auto* a : {&forces_, &moments_})
        for (int id = 0; id <= table_.largestId; ++id)
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

template class BodyForces<2>;
template class BodyForces<3>;

} // namespace riprap

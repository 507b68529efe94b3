/*  PicBodies: how bodies are about to move, what the pressure does to them, and what of it is
    handed to the solids.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/pic/picBodies.hpp"

namespace riprap
{

//- The smaller of two that agree in direction, else nothing: components first .. last - 1
template<class V>
void agree(const V& a, const V& b, int first, int last, V& out)
{
    double dot = 0, a2 = 0, b2 = 0;
    for (int m = first; m < last; ++m) { dot += a[m]*b[m]; a2 += a[m]*a[m]; b2 += b[m]*b[m]; }
    for (int m = first; m < last; ++m) out[m] = dot > 0 ? (a2 < b2 ? a[m] : b[m]) : 0;
}

template<int D>
void PicBodies<D>::predict(double dt, double before)
{
    const double kick = before > 0 ? 0.5*(before + dt) : 0.5*dt;
    for (Now& n : now_)
    {
        const Body& b = all_[n.body];
        const DemGroup& group = groups_[b.group];
        Memory& m = memory_[n.body];
        n.asleep = before > 0 && sleeps(n);
        if (n.asleep)                           // a wall
        {
            n.inverse.fill(0);
            n.predicted.fill(0);
            continue;
        }
        if (group.motion >= 0 && motion_)
        {
            const RigidMotion r = motion_(group.motion, scene_.time() + 0.5*dt);
            n.predicted = modesOf(r.velocity.data(), r.spin.data());
            const auto& f = bodies_[&n - now_.data()];
            Vec<D, double> arm;
            for (int d = 0; d < D; ++d) arm[d] = f.centre[d] - r.centre[axes_[d]];
            for (int d = 0; d < D; ++d)
                for (int s = D; s < modes; ++s)
                    n.predicted[d] += n.predicted[s]*modeVelocity(s, d, arm);
            continue;
        }
        const Modes g = gravityOf(n), water = times(n, m.force), all = times(n, n.total);
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
                + 0.5*dt*(g[k] + lasting[k]) + (weak_ ? kick*water[k] : 0);
    }
}

template<int D>
std::vector<FreeBody<D, typename PicBodies<D>::Shape>> PicBodies<D>::withVelocities(
    bool predicted) const
{
    std::vector<FreeBody<D, Shape>> all(bodies_);
    for (std::size_t i = 0; i < all.size(); ++i)
    {
        const Memory& m = memory_[now_[i].body];
        const Modes& v = predicted ? now_[i].predicted : (m.begun ? m.middle : now_[i].velocity);
        all[i].velocity.assign(v.begin(), v.end());
    }
    return all;
}

template<int D>
void PicBodies<D>::fill(std::vector<BodyTerm>& terms) const
{
    for (std::size_t i = 0; i < terms.size(); ++i)
    {
        terms[i].velocity.assign(now_[i].predicted.begin(), now_[i].predicted.end());
        terms[i].inverseMass.assign(now_[i].inverse.begin(), now_[i].inverse.end());
    }
}

template<int D>
std::vector<double> PicBodies<D>::velocities(bool predicted) const
{
    std::vector<double> all;
    all.reserve(now_.size()*modes);
    for (const Now& n : now_)
    {
        const Memory& m = memory_[n.body];
        const Modes& v = predicted ? n.predicted : (m.begun ? m.middle : n.velocity);
        for (int k = 0; k < modes; ++k) all.push_back(v[k] - (predicted ? 0 : m.ahead[k]));
    }
    return all;
}

template<int D>
std::vector<double> PicBodies<D>::roots() const
{
    std::vector<double> all(now_.size()*modes*modes, 0.0);
    for (std::size_t i = 0; i < now_.size(); ++i)
        rootOfInverseMass(modes, now_[i].inverse.data(), &all[i*modes*modes]);
    return all;
}

template<int D>
bool PicBodies<D>::anyLighter(const std::vector<double>& volume, double density) const
{
    bool any = false;
    for (std::size_t i = 0; i < now_.size(); ++i)
        any = any || isLighter(modes, now_[i].inverse.data(), volume[i], density);
    return any;
}

template<int D>
void PicBodies<D>::foresee(const std::vector<double>& against)
{
    for (std::size_t i = 0; i < now_.size(); ++i)
    {
        Modes given{};
        if (!against.empty()) for (int k = 0; k < modes; ++k) given[k] = -against[i*modes + k];
        const Modes change = memory_[now_[i].body].ahead = times(now_[i], given);
        for (int k = 0; k < modes; ++k) now_[i].predicted[k] += change[k];
    }
}

template<int D>
void PicBodies<D>::move(const std::vector<double>& against, double dt)
{
    for (std::size_t i = 0; i < now_.size(); ++i)
    {
        Now& n = now_[i];
        n.moved = n.predicted;
        if (weak_) continue;
        Modes given{};
        for (int k = 0; k < modes; ++k) given[k] = -dt*against[i*modes + k];
        const Modes change = times(n, given);
        for (int k = 0; k < modes; ++k) n.moved[k] += change[k];
    }
}

template<int D>
void PicBodies<D>::act(const std::vector<double>& against)
{
    for (std::size_t i = 0; i < now_.size(); ++i)
    {
        Memory& m = memory_[now_[i].body];
        m.old = m.force;
        for (int k = 0; k < modes; ++k)
        {
            m.force[k] = -against[i*modes + k] + now_[i].drag[k];
            m.drag[k] = now_[i].drag[k];
            m.middle[k] = now_[i].moved[k];
            finite_ = finite_ && std::isfinite(m.force[k]);
        }
    }
}

template<int D>
void PicBodies<D>::startDrag() { for (Now& n : now_) n.drag.fill(0); }

template<int D>
void PicBodies<D>::drag(int body, int component, double force, const Vec<D, double>& at)
{
    const Vec<D, double> arm = at - bodies_[body].centre;
    for (int k = 0; k < modes; ++k) now_[body].drag[k] += force*modeVelocity(k, component, arm);
}

template<int D>
void PicBodies<D>::endDrag(double dt, double viscosity, const std::vector<double>& volume)
{
    for (std::size_t i = 0; i < now_.size(); ++i)
    {
        Now& n = now_[i];
        const Memory& m = memory_[n.body];
        const Modes& now = m.begun ? m.middle : n.velocity;
        for (int s = D; s < modes; ++s) n.drag[s] -= 2*viscosity*volume[i]*now[s];
        const Modes change = times(n, n.drag);
        for (int k = 0; k < modes; ++k) n.predicted[k] += dt*change[k];
    }
}

template<int D>
void PicBodies<D>::put(const Now& n, const Modes& force)
{
    const int id = all_[n.body].ids[0];
    double f[3] = {0, 0, 0}, m[3] = {0, 0, 0};
    for (int d = 0; d < D; ++d) f[axes_[d]] = force[d];
    for (int s = D; s < modes; ++s) m[D == 2 ? axes_[2] : axes_[s - D]] = spinSign()*force[s];
    for (int d = 0; d < 3; ++d)
    {
        const int a = (d + 1) % 3, b = (d + 2) % 3;
        forces_[3*std::size_t(id) + d] = f[d];
        moments_[3*std::size_t(id) + d] = m[d] - (n.arm[a]*f[b] - n.arm[b]*f[a]);
    }
}

template<int D>
void PicBodies<D>::send() { scene_.setExternalForces(forces_, moments_); }

template<int D>
void PicBodies<D>::push(double before, double lag, double kick)
{
    for (Now& n : now_)
    {
        Memory& m = memory_[n.body];
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
        const Modes jump = times(n, change);
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
void PicBodies<D>::hold()
{
    for (const Now& n : now_)
    {
        Memory& m = memory_[n.body];
        if (!n.asleep) m.given = m.force;
        put(n, m.given);
    }
    send();
}

} // namespace riprap

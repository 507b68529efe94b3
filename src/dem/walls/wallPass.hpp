/*  Forces between particles and walls, where they touch (wallTouching.hpp).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/walls/wallTouching.hpp"

namespace riprap
{

template<int D, class P, class Law>
struct WallPass : WallHistories<D, P, Law::template history<D>>
{
    using real = typename P::real;
    static constexpr const char* name = "walls";
    static constexpr int H = Law::template history<D>, S = spins<D>;

    const typename Law::template Parameters<real>* parameters;

    HD void operator()(int k) const
    {
        if (!this->clock.active() || (this->listed && k >= *this->listedCount)) return;
        const int i = this->listed ? this->listed[k] : k;
        if (i >= *this->active || (this->skipsAsleep && this->fields.asleep(i))) return;
        const int first = this->memory.entryFirst[i], last = this->memory.entryFirst[i + 1];
        if (first == last) return;
        int material;
        const ContactBody<D, real> body = this->solids.body(i, material);
        const bool fused = this->clock.turn == ForceTurn::ahead;
        const Vec<D, double> x = fused ? this->inMetres(this->state.place(i)) : this->position(i);
        Vec<D, real> force = filled<D>(real(0));
        Spin<D, real> moment = filled<S>(real(0));
        for (int e = first; e < last; ++e)
        {
            // the step's own
            if (fused && this->walls[this->memory.entry[e].wall].plane) continue;
            Vec<D, real> f = filled<D>(real(0));
            Spin<D, real> m = filled<S>(real(0));
            real energy = 0, overlap = 0;
            entryForce(e, i, body, material, x, f, m, energy, overlap);
            real* kept = this->memory.force + e*wallWords<D>;
            for (int d = 0; d < D; ++d) kept[d] = f.c[d];
            for (int c = 0; c < S; ++c) kept[D + c] = m.c[c];
            kept[D + S] = energy;
            kept[D + S + 1] = overlap;
            force = force + f;
            moment = moment + m;
        }
        if (this->adds) this->fields.addForce(i, force, moment);
    }

    //- A plane is touched in one place: what that remembers is in the entry's first slot
    HD void planeForce(int e, const WallData& w, const ContactBody<D, real>& body, int material,
        const Vec<D, double>& x, Vec<D, real>& force, Spin<D, real>& moment, real& energy,
        real& overlap) const
    {
        const int pair = material*this->materials + w.material, slot = e*wallTouches;
        const bool touched = this->memory.on[slot];
        real h[H + 1] = {};
        if (touched) for (int c = 0; c < H; ++c) h[c] = this->memory.history[slot*H + c];
        WallTouch<D> touch[1];
        const bool touches = this->findPlane(w, intoFrame<D>(w.frame.R, w.frame.T, x),
            double(body.radius) + double(this->gap[pair]), touch[0]);
        if (touches != touched)
        {
            this->memory.on[slot] = touches;
            for (int d = 0; d < D; ++d)
                this->memory.normal[slot*D + d] = real(touch[0].normal.c[d]);
        }
        if (!touches) return;
        touchForce(w, pair, body, x, touch[0], h, force, moment, energy, overlap);
        for (int c = 0; c < H; ++c) this->memory.history[slot*H + c] = h[c];
    }

private:

    HD void entryForce(int e, int i, const ContactBody<D, real>& body, int material,
        const Vec<D, double>& x, Vec<D, real>& force, Spin<D, real>& moment, real& energy,
        real& overlap) const
    {
        const WallEntry entry = this->memory.entry[e];
        const WallData& w = this->walls[entry.wall];
        if (w.plane) return planeForce(e, w, body, material, x, force, moment, energy, overlap);
        const int pair = material*this->materials + w.material;
        const Vec<D, double> X = intoFrame<D>(w.frame.R, w.frame.T, x);
        WallTouch<D> touch[wallTouches];
        const int touches = this->findTouches(
            entry, w, X, double(body.radius) + double(this->gap[pair]), touch);
        real h[wallTouches][H + 1];
        this->recall(e, touches, touch, h, i, body, double(this->gap[pair]), x);
        for (int k = 0; k < touches; ++k)
            touchForce(w, pair, body, x, touch[k], h[k], force, moment, energy, overlap);
        this->remember(e, touches, touch, h);
    }

    HD void touchForce(const WallData& w, int pair, const ContactBody<D, real>& body,
        const Vec<D, double>& x, const WallTouch<D>& touch, real* h, Vec<D, real>& force,
        Spin<D, real>& moment, real& energy, real& overlap) const
    {
        const Vec<D, double> n = outOfFrame<D>(w.frame.R, touch.normal);
        const real distance = real(touch.distance);
        const Vec<D, real> velocity = this->surfaceVelocity(w.frame, x + touch.distance*n);
        Spin<D, real> spin;
        for (int c = 0; c < S; ++c) spin.c[c] = real(w.frame.spin[D == 2 ? 2 : c]);
        real armA;
        auto g = wallGeometry<D, real>(body, velocity, spin, convert<real>(n), distance,
            this->gap[pair], real(this->clock.dt()), armA);
        // the difference of doubles, not of floats
        g.overlap = maximum(
            real(double(body.radius) + double(this->gap[pair]) - touch.distance), real(1e-12));
        NormalForce<real> fn;
        const auto f = Law::template evaluate<D, real>(parameters[pair], g, armA, real(0), h, fn);
        force = force + f.force;
        moment = moment + f.momentA;
        energy += Law::template energy<D, real>(parameters[pair], g, fn, h);
        overlap = maximum(overlap, g.overlap);
    }
};

//- What wall contacts remember, to the entries of after a sort; entries without a past are empty
template<int D, class R, int H>
struct HandOverWalls
{
    static constexpr const char* name = "handOverWalls";

    WallMemory<D, R> from, to;
    const std::uint32_t* order;
    const int* active;
    bool fresh;                 // there is no past at all

    HD void operator()(int i) const
    {
        if (i >= *active) return;
        const int before = fresh ? 0 : int(order[i]);
        for (int e = to.entryFirst[i]; e < to.entryFirst[i + 1]; ++e)
        {
            int past = -1;
            if (!fresh)
                for (int b = from.entryFirst[before]; b < from.entryFirst[before + 1]; ++b)
                    if (from.entry[b].wall == to.entry[e].wall) past = b;
            for (int c = 0; c < wallWords<D>; ++c)
                to.force[e*wallWords<D> + c] = past < 0 ? R(0)
                                                          : from.force[past*wallWords<D> + c];
            for (int s = 0; s < wallTouches; ++s)
            {
                const int t = e*wallTouches + s, b = past*wallTouches + s;
                to.on[t] = past < 0 ? 0 : from.on[b];
                if (!to.on[t]) continue;
                for (int d = 0; d < D; ++d) to.normal[t*D + d] = from.normal[b*D + d];
                for (int c = 0; c < H; ++c) to.history[t*H + c] = from.history[b*H + c];
            }
        }
    }
};

} // namespace riprap

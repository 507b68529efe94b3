/*  Forces between particles and walls.

    A particle may touch a wall in up to four places: one a direction. Faces come first; an edge or
    vertex counts only where it is the surface's closest point around there; touches whose normals
    differ by less than 15 degrees are one, the nearest: so faces of one plane are felt as that
    plane, and a polygonal drum as one surface. What a touch remembers goes with its normal (in the
    wall's frame), from element to element.

    A particle stays on its side: where its centre is pressed through a surface the touch keeps its
    normal, and its overlap grows on beyond the radius. It has passed the wall where not even that
    holds it, a radius behind; that is counted.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/loops/deterministicAtomics.hpp"
#include "dem/state/clock.hpp"
#include "dem/contact/contact.hpp"
#include "dem/motion/motionTable.hpp"
#include "dem/lists/stepState.hpp"
#include "dem/walls/wallSearch.hpp"

namespace riprap
{

static constexpr int wallTouches = 4;

//- What wall contacts remember: of each entry `wallTouches` slots
template<int D, class R>
struct WallMemory
{
    const int* entryFirst;      // of each particle
    const WallEntry* entry;
    const int* element;
    int* on;                    // slot in use
    R* normal;                  // D a slot, in the wall's frame
    R* history;
    // of an entry: on the particle (D + spins), elastic energy, largest overlap
    R* force;
};

template<int D> inline constexpr int wallWords = D + spins<D> + 2;

template<int D>
struct WallTouch
{
    Vec<D, double> normal;      // into the wall, in its frame
    double distance;
    int feature;
};

//- Particles that walls could not hold: how many, and the lowest of their keys
struct WallPassings { std::int64_t count; int key, padding; };

template<int D, class P, class Law>
struct WallPass : WallSearch<D, P>
{
    using real = typename P::real;
    static constexpr const char* name = "walls";
    static constexpr int H = Law::template history<D>, S = spins<D>;

    SolidRecords<D, P> solids;
    WallMemory<D, real> memory;
    const typename Law::template Parameters<real>* parameters;
    const real* gap;
    int materials;
    ForceClock clock;
    // those that are near walls, and how many; null: the kernel runs over all
    const int* listed;
    const int* listedCount;
    StepState<D, P> state;      // of fused steps, which add up the forces themselves
    bool adds;                  // to the fields' forces; else whoever sums them up finds them here
    bool skipsAsleep;           // sums that forces are added to are those of when it fell asleep
    WallPassings* passed;

    HD void operator()(int k) const
    {
        if (!clock.active() || (listed && k >= *listedCount)) return;
        const int i = listed ? listed[k] : k;
        if (i >= *this->active || (skipsAsleep && this->fields.asleep(i))) return;
        const int first = memory.entryFirst[i], last = memory.entryFirst[i + 1];
        if (first == last) return;
        int material;
        const ContactBody<D, real> body = solids.body(i, material);
        const bool fused = clock.turn == ForceTurn::ahead;
        const Vec<D, double> x = fused ? inMetres(state.place(i)) : this->position(i);
        Vec<D, real> force = filled<D>(real(0));
        Spin<D, real> moment = filled<S>(real(0));
        for (int e = first; e < last; ++e)
        {
            if (fused && this->walls[memory.entry[e].wall].plane) continue;     // the step's own
            Vec<D, real> f = filled<D>(real(0));
            Spin<D, real> m = filled<S>(real(0));
            real energy = 0, overlap = 0;
            entryForce(e, i, body, material, x, f, m, energy, overlap);
            real* kept = memory.force + e*wallWords<D>;
            for (int d = 0; d < D; ++d) kept[d] = f.c[d];
            for (int c = 0; c < S; ++c) kept[D + c] = m.c[c];
            kept[D + S] = energy;
            kept[D + S + 1] = overlap;
            force = force + f;
            moment = moment + m;
        }
        if (adds) this->fields.addForce(i, force, moment);
    }

    HD Vec<D, double> inMetres(const Vec<D, std::int64_t>& at) const
    {
        Vec<D, double> x;
        for (int d = 0; d < D; ++d) x.c[d] = this->box.toMetres(d, at.c[d]);
        return x;
    }

    //- A plane is touched in one place: what that remembers is in the entry's first slot
    HD void planeForce(int e, const WallData& w, const ContactBody<D, real>& body, int material,
        const Vec<D, double>& x, Vec<D, real>& force, Spin<D, real>& moment, real& energy,
        real& overlap) const
    {
        const int pair = material*materials + w.material, slot = e*wallTouches;
        const bool touched = memory.on[slot];
        real h[H + 1] = {};
        if (touched) for (int c = 0; c < H; ++c) h[c] = memory.history[slot*H + c];
        WallTouch<D> touch[1];
        const bool touches = findPlane(w, intoFrame<D>(w.frame.R, w.frame.T, x),
            double(body.radius) + double(gap[pair]), touch[0]);
        if (touches != touched)
        {
            memory.on[slot] = touches;
            for (int d = 0; d < D; ++d) memory.normal[slot*D + d] = real(touch[0].normal.c[d]);
        }
        if (!touches) return;
        touchForce(w, pair, body, x, touch[0], h, force, moment, energy, overlap);
        for (int c = 0; c < H; ++c) memory.history[slot*H + c] = h[c];
    }

    //- Where a particle touches a wall; returns how often
    HD int findTouches(const WallEntry& entry, const WallData& w, const Vec<D, double>& X,
        double within, WallTouch<D>* touch) const
    {
        int touches = 0;
        if (w.plane) return findPlane(w, X, within, touch[0]);
        for (int k = 0; k < entry.count; ++k)
        {
            const int e = memory.element[entry.first + k];
            Vec<D, double> v[D];
            for (int c = 0; c < D; ++c) v[c] = this->surface.at(this->surface.element[e*D + c]);
            int feature;
            const Vec<D, double> p = closestPoint(v, X, feature);
            Vec<D, double> n = p - X;
            double distance = sqrt(squaredNorm(n));
            if (distance >= within || (distance < 1e-300 && feature != insideElement)) continue;
            if (feature != insideElement)
            {
                if (!this->surface.closestThere(e, feature, p, X)) continue;
                n = (1/distance)*n;
            }
            else
            {
                // the element's own normal: all faces of one plane say the same, to the last digit
                n = elementNormal(v);
                const double height = dot(n, v[0] - X);
                if (height < 0) n = -1.0*n;
                distance = fabs(height);
            }
            add(WallTouch<D>{n, distance, feature}, touch, touches);
        }
        return touches;
    }

private:
    HD static bool findPlane(
        const WallData& w, const Vec<D, double>& X, double within, WallTouch<D>& touch)
    {
        Vec<D, double> n;
        for (int d = 0; d < D; ++d) n.c[d] = -w.normal[d];
        double height = 0;
        for (int d = 0; d < D; ++d) height += (X.c[d] - w.point[d])*w.normal[d];
        touch = WallTouch<D>{n, height, insideElement};
        return height < within;
    }

    //- One of them a direction: a face before an edge, the nearer before the farther
    HD static void add(const WallTouch<D>& t, WallTouch<D>* touch, int& touches)
    {
        int farthest = 0;
        for (int k = 0; k < touches; ++k)
        {
            if (touch[k].distance > touch[farthest].distance) farthest = k;
            if (dot(touch[k].normal, t.normal) < 0.9659) continue;
            const bool face = t.feature == insideElement, was = touch[k].feature == insideElement;
            if (face != was ? face && t.distance <= touch[k].distance*(1 + 1e-9)
                            : t.distance < touch[k].distance)
                touch[k] = t;
            return;
        }
        if (touches < wallTouches) touch[touches++] = t;
        else if (t.distance < touch[farthest].distance) touch[farthest] = t;
    }

    HD void entryForce(int e, int i, const ContactBody<D, real>& body, int material,
        const Vec<D, double>& x, Vec<D, real>& force, Spin<D, real>& moment, real& energy,
        real& overlap) const
    {
        const WallEntry entry = memory.entry[e];
        const WallData& w = this->walls[entry.wall];
        if (w.plane) return planeForce(e, w, body, material, x, force, moment, energy, overlap);
        const int pair = material*materials + w.material;
        const Vec<D, double> X = intoFrame<D>(w.frame.R, w.frame.T, x);
        WallTouch<D> touch[wallTouches];
        const int touches = findTouches(
            entry, w, X, double(body.radius) + double(gap[pair]), touch);
        real h[wallTouches][H + 1];
        recall(e, touches, touch, h, i, body, double(gap[pair]), x);
        for (int k = 0; k < touches; ++k)
            touchForce(w, pair, body, x, touch[k], h[k], force, moment, energy, overlap);
        remember(e, touches, touch, h);
    }

    HD void touchForce(const WallData& w, int pair, const ContactBody<D, real>& body,
        const Vec<D, double>& x, const WallTouch<D>& touch, real* h, Vec<D, real>& force,
        Spin<D, real>& moment, real& energy, real& overlap) const
    {
        const Vec<D, double> n = outOfFrame<D>(w.frame.R, touch.normal);
        const real distance = real(touch.distance);
        const Vec<D, real> velocity = surfaceVelocity(w.frame, x + touch.distance*n);
        Spin<D, real> spin;
        for (int c = 0; c < S; ++c) spin.c[c] = real(w.frame.spin[D == 2 ? 2 : c]);
        real armA;
        auto g = wallGeometry<D, real>(
            body, velocity, spin, convert<real>(n), distance, gap[pair], real(clock.dt()), armA);
        // the difference of doubles, not of floats
        g.overlap = maximum(
            real(double(body.radius) + double(gap[pair]) - touch.distance), real(1e-12));
        NormalForce<real> fn;
        const auto f = Law::template evaluate<D, real>(parameters[pair], g, armA, real(0), h, fn);
        force = force + f.force;
        moment = moment + f.momentA;
        energy += Law::template energy<D, real>(parameters[pair], g, fn, h);
        overlap = maximum(overlap, g.overlap);
    }

    HD Vec<D, real> surfaceVelocity(const WallFrame& f, const Vec<D, double>& x) const
    {
        Vec<3, double> arm{{0, 0, 0}};
        for (int d = 0; d < D; ++d) arm.c[d] = x.c[d] - f.T[d];
        const Vec<3, double> u = cross(Vec<3, double>{{f.spin[0], f.spin[1], f.spin[2]}}, arm);
        Vec<D, real> v;
        for (int d = 0; d < D; ++d) v.c[d] = real(f.velocity[d] + u.c[d]);
        return v;
    }

    //- Each touch takes the history of the slot whose normal was nearest to its own, if within 25
    //  degrees
    HD void recall(int e, int touches, WallTouch<D>* touch, real (*h)[H + 1], int i,
        const ContactBody<D, real>& body, double gap, const Vec<D, double>& x) const
    {
        bool taken[wallTouches] = {};
        int unknown = 0;
        for (int k = 0; k < touches; ++k)
        {
            for (int c = 0; c < H; ++c) h[k][c] = 0;
            int best = -1;
            double nearest = 0.9063;
            for (int s = 0; s < wallTouches; ++s)
            {
                const int slot = e*wallTouches + s;
                if (!memory.on[slot] || taken[s]) continue;
                double along = 0;
                for (int d = 0; d < D; ++d)
                    along += double(memory.normal[slot*D + d])*touch[k].normal.c[d];
                if (along > nearest) { nearest = along; best = s; }
            }
            if (best < 0) { unknown |= 1 << k; continue; }
            taken[best] = true;
            for (int c = 0; c < H; ++c) h[k][c] = memory.history[(e*wallTouches + best)*H + c];
        }
        for (int s = 0; s < wallTouches; ++s)
            if (memory.on[e*wallTouches + s] && !taken[s])
                keepSide(e, s, touches, unknown, touch, h, i, body, gap, x);
    }

    //- A touch that is gone: has its surface come to the other side of the centre, by no more than
    //  a step's way?
    HD void keepSide(int e, int s, int touches, int& unknown, WallTouch<D>* touch, real (*h)[H + 1],
        int i, const ContactBody<D, real>& body, double gap, const Vec<D, double>& x) const
    {
        const int slot = e*wallTouches + s;
        const WallFrame& frame = this->walls[memory.entry[e].wall].frame;
        const Vec<D, real> v = body.velocity - surfaceVelocity(frame, x);
        const double way = 1.25*double(squareRoot(squaredNorm(v)))*clock.dt()
            + 1e-3*double(body.radius);
        // in front of the surface before this step
        const double before = double(body.radius) + gap
            - double(memory.force[e*wallWords<D> + D + S + 1]);
        for (int k = 0; k < touches; ++k)
        {
            if (!(unknown >> k & 1)) continue;
            double along = 0;
            for (int d = 0; d < D; ++d)
                along += double(memory.normal[slot*D + d])*touch[k].normal.c[d];
            if (along > -0.5 || before + touch[k].distance > way) continue;
            touch[k].normal = -1.0*touch[k].normal;
            touch[k].distance = -touch[k].distance;
            for (int c = 0; c < H; ++c) h[k][c] = memory.history[slot*H + c];
            unknown &= ~(1 << k);
            return;
        }
        if (before >= 0) return;
        addShared(&passed->count, 1);
        atomicMinimum(&passed->key, this->fields.id[i]);
    }

    HD void remember(int e, int touches, const WallTouch<D>* touch, real (*h)[H + 1]) const
    {
        for (int s = 0; s < wallTouches; ++s)
        {
            const int slot = e*wallTouches + s;
            memory.on[slot] = s < touches;
            if (s >= touches) continue;
            for (int d = 0; d < D; ++d) memory.normal[slot*D + d] = real(touch[s].normal.c[d]);
            for (int c = 0; c < H; ++c) memory.history[slot*H + c] = h[s][c];
        }
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

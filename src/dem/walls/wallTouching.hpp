/*  Where particles touch walls, and what of it is remembered: the same for all contact laws.

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
#include "dem/contact/contact.hpp"
#include "dem/lists/stepState.hpp"
#include "dem/motion/motionTable.hpp"
#include "dem/state/clock.hpp"
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

//- Where particles touch walls: what does not depend on the law
template<int D, class P>
struct WallTouching : WallSearch<D, P>
{
    using real = typename P::real;
    static constexpr int S = spins<D>;

    SolidRecords<D, P> solids;
    WallMemory<D, real> memory;
    const real* gap;            // of materials a, b: [a*materials + b]
    int materials;
    ForceClock clock;
    // those that are near walls, and how many; null: the kernel runs over all
    const int* listed;
    const int* listedCount;
    StepState<D, P> state;      // of fused steps, which add up the forces themselves
    bool adds;                  // to the fields' forces; else whoever sums them up finds them here
    bool skipsAsleep;           // sums that forces are added to are those of when it fell asleep
    WallPassings* passed;

    HD Vec<D, double> inMetres(const Vec<D, std::int64_t>& at) const
    {
        Vec<D, double> x;
        for (int d = 0; d < D; ++d) x.c[d] = this->box.toMetres(d, at.c[d]);
        return x;
    }

    //- Where a particle touches a wall; returns how often
    HD_SHARED int findTouches(const WallEntry& entry, const WallData& w, const Vec<D, double>& X,
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

    HD Vec<D, real> surfaceVelocity(const WallFrame& f, const Vec<D, double>& x) const
    {
        Vec<3, double> arm{{0, 0, 0}};
        for (int d = 0; d < D; ++d) arm.c[d] = x.c[d] - f.T[d];
        const Vec<3, double> u = cross(Vec<3, double>{{f.spin[0], f.spin[1], f.spin[2]}}, arm);
        Vec<D, real> v;
        for (int d = 0; d < D; ++d) v.c[d] = real(f.velocity[d] + u.c[d]);
        return v;
    }

private:

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
};

//- With what touches remember: H numbers each
template<int D, class P, int H>
struct WallHistories : WallTouching<D, P>
{
    using real = typename P::real;
    static constexpr int S = spins<D>;

    //- Each touch takes the history of the slot whose normal was nearest to its own, if within 25
    //  degrees
    HD_SHARED void recall(int e, int touches, WallTouch<D>* touch, real (*h)[H + 1], int i,
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
                if (!this->memory.on[slot] || taken[s]) continue;
                double along = 0;
                for (int d = 0; d < D; ++d)
                    along += double(this->memory.normal[slot*D + d])*touch[k].normal.c[d];
                if (along > nearest) { nearest = along; best = s; }
            }
            if (best < 0) { unknown |= 1 << k; continue; }
            taken[best] = true;
            const int slot = e*wallTouches + best;
            for (int c = 0; c < H; ++c) h[k][c] = this->memory.history[slot*H + c];
        }
        for (int s = 0; s < wallTouches; ++s)
            if (this->memory.on[e*wallTouches + s] && !taken[s])
                keepSide(e, s, touches, unknown, touch, h, i, body, gap, x);
    }

    HD_SHARED void remember(int e, int touches, const WallTouch<D>* touch, real (*h)[H + 1]) const
    {
        for (int s = 0; s < wallTouches; ++s)
        {
            const int slot = e*wallTouches + s;
            this->memory.on[slot] = s < touches;
            if (s >= touches) continue;
            for (int d = 0; d < D; ++d)
                this->memory.normal[slot*D + d] = real(touch[s].normal.c[d]);
            for (int c = 0; c < H; ++c) this->memory.history[slot*H + c] = h[s][c];
        }
    }

private:

    //- A touch that is gone: has its surface come to the other side of the centre, by no more than
    //  a step's way?
    HD void keepSide(int e, int s, int touches, int& unknown, WallTouch<D>* touch, real (*h)[H + 1],
        int i, const ContactBody<D, real>& body, double gap, const Vec<D, double>& x) const
    {
        const int slot = e*wallTouches + s;
        const WallFrame& frame = this->walls[this->memory.entry[e].wall].frame;
        const Vec<D, real> v = body.velocity - this->surfaceVelocity(frame, x);
        const double way = 1.25*double(squareRoot(squaredNorm(v)))*this->clock.dt()
            + 1e-3*double(body.radius);
        // in front of the surface before this step
        const double before = double(body.radius) + gap
            - double(this->memory.force[e*wallWords<D> + D + S + 1]);
        for (int k = 0; k < touches; ++k)
        {
            if (!(unknown >> k & 1)) continue;
            double along = 0;
            for (int d = 0; d < D; ++d)
                along += double(this->memory.normal[slot*D + d])*touch[k].normal.c[d];
            if (along > -0.5 || before + touch[k].distance > way) continue;
            touch[k].normal = -1.0*touch[k].normal;
            touch[k].distance = -touch[k].distance;
            for (int c = 0; c < H; ++c) h[k][c] = this->memory.history[slot*H + c];
            unknown &= ~(1 << k);
            return;
        }
        if (before >= 0) return;
        addShared(&this->passed->count, 1);
        atomicMinimum(&this->passed->key, this->fields.id[i]);
    }
};

} // namespace riprap

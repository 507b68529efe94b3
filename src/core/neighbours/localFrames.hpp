/*  How far particles may go before those near them have to be sought anew, measured against what is
    around them.

    Lists of all pairs within R + s (the support and a skin) hold for as long as no pair has come
    nearer to each other by s. What moves together does not: the box is cut into blocks at least L
    wide, each with a velocity U, the middle of those in it at the search. With d the way of a
    particle since then, t the time, for two of one block or of blocks that touch

        |d_i - d_j| <= |d_i - U_a t| + |d_j - U_b t| + |U_a - U_b| t

    so that it suffices that each keeps |d - U t| + M t <= s/2, M being half of the largest |U - U'|
    to a block that touches its own. Two of other blocks were L apart: they stay beyond R while |d|
    <= (L - R)/2. Points at rest have no U: who may meet one must keep |d| within what
    the lists of such points allow.

    U and M are maxima, which do not depend on an order: equal input, equal bits.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cmath>
#include <cstring>
#include "core/backend/launch.hpp"
#include "core/simd/precision.hpp"
#include "core/loops/deterministicAtomics.hpp"

namespace riprap
{

template<int D, class R>
struct LocalFrame
{
    R velocity[D];
    R spread;                   // M [m/s]
    R limit;                    // of |d| [m]
};

//- The way of a particle since the search [m], and after a step more
template<class R>
struct WaySince { R relative, relativeNext, whole, wholeNext, limit; };

template<int D, class P>
struct LocalFrames
{
    using real = typename P::real;
    using position = typename P::position;
    static constexpr int unset = 0x7fffffff;

    int n[3];
    real inverse[D];
    // of each block: D lowest velocities, D highest, as ordered integers
    int* bounds;
    int* still;                 // blocks with points at rest
    LocalFrame<D, real>* frame; // null: there are no frames but the box itself

    HD int blockOf(const Box<D, P>& box, const Vec<D, position>& p) const
    {
        int block = 0;
        for (int d = D - 1; d >= 0; --d)
        {
            const int c = floorInt(box.pairRelative(d, p.c[d])*inverse[d]);
            block = block*n[d] + (c < 0 ? 0 : (c >= n[d] ? n[d] - 1 : c));
        }
        return block;
    }

    //- A particle of the search
    HD void include(const Box<D, P>& box, const Vec<D, position>& p, const Vec<D, real>& v) const
    {
        if (!frame) return;
        int* b = bounds + blockOf(box, p)*2*D;
        for (int d = 0; d < D; ++d)
        {
            const int k = ordered(float(v.c[d]));
            // most are within what others have said
            if (k < sharedRead(b + d)) atomicMinimum(b + d, k);
            if (~k < sharedRead(b + D + d)) atomicMinimum(b + D + d, ~k);
        }
    }

    HD void includeStill(const Box<D, P>& box, const Vec<D, position>& p) const
    {
        if (frame) raise(still + blockOf(box, p));
    }

    HD float lowest(int block, int d) const { return number(bounds[block*2*D + d]); }
    HD float highest(int block, int d) const { return number(~bounds[block*2*D + D + d]); }
    HD bool occupied(int block) const { return bounds[block*2*D] != unset; }

    //- Of a particle that was at `from` at the search, is at p now and goes on with u for up to dt
    HD WaySince<real> since(const Box<D, P>& box, const Vec<D, position>& from,
        const Vec<D, position>& p, const Vec<D, real>& u, real time, real dt) const
    {
        const LocalFrame<D, real>& f = frame[blockOf(box, from)];
        real relative2 = 0, whole2 = 0, relativeSpeed2 = 0, speed2 = 0;
        for (int d = 0; d < D; ++d)
        {
            const real way = box.template separation<real>(d, p.c[d], from.c[d]),
                       apart = way - f.velocity[d]*time;
            const real faster = u.c[d] - f.velocity[d];
            whole2 += way*way;
            relative2 += apart*apart;
            speed2 += u.c[d]*u.c[d];
            relativeSpeed2 += faster*faster;
        }
        const real relative = squareRoot(relative2) + f.spread*time, whole = squareRoot(whole2);
        return WaySince<real>{relative, relative + dt*(squareRoot(relativeSpeed2) + f.spread),
            whole, whole + dt*squareRoot(speed2), f.limit};
    }

private:

    //- Integers in the order of the numbers
    HD static int ordered(float v)
    {
        int bits;
        memcpy(&bits, &v, sizeof(bits));
        return bits < 0 ? bits ^ 0x7fffffff : bits;
    }

    HD static float number(int k)
    {
        const int bits = k < 0 ? k ^ 0x7fffffff : k;
        float v;
        memcpy(&v, &bits, sizeof(v));
        return v;
    }
};

//- Nobody has been met
template<int D, class P>
struct ClearFrames
{
    static constexpr const char* name = "clearFrames";
    LocalFrames<D, P> frames;
    HD void operator()(int b) const
    {
        for (int k = 0; k < 2*D; ++k) frames.bounds[b*2*D + k] = LocalFrames<D, P>::unset;
    }
};

struct ClearStill
{
    static constexpr const char* name = "clearStill";
    int* still;
    HD void operator()(int b) const { still[b] = 0; }
};

//- After all have been met: what holds in each block
template<int D, class P>
struct SettleFrames
{
    using real = typename P::real;
    static constexpr const char* name = "settleFrames";

    LocalFrames<D, P> frames;
    bool periodic[3];
    real far, nearStill;        // limits of |d| away from points at rest, and near them [m]

    HD void operator()(int b) const
    {
        if (!frames.occupied(b)) return;
        const int* n = frames.n;
        const int at[3] = {b % n[0], b/n[0] % n[1], b/n[0]/n[1]};
        Vec<D, real> u;
        for (int d = 0; d < D; ++d) u.c[d] = middle(b, d);
        real most = 0;
        bool still = false;
        for (int z = D == 3 ? -1 : 0; z <= (D == 3 ? 1 : 0); ++z)
            for (int y = -1; y <= 1; ++y)
                for (int x = -1; x <= 1; ++x)
                {
                    const int offset[3] = {x, y, z};
                    int other = 0;
                    for (int d = D - 1; d >= 0 && other >= 0; --d)
                    {
                        const int c = wrapped(at[d] + offset[d], d);
                        other = c < 0 ? -1 : other*n[d] + c;
                    }
                    if (other < 0) continue;
                    still = still || frames.still[other];
                    if (!frames.occupied(other)) continue;
                    real apart2 = 0;
                    for (int d = 0; d < D; ++d)
                    {
                        const real a = u.c[d] - middle(other, d);
                        apart2 += a*a;
                    }
                    most = maximum(most, apart2);
                }
        LocalFrame<D, real>& f = frames.frame[b];
        for (int d = 0; d < D; ++d) f.velocity[d] = u.c[d];
        f.spread = real(0.5)*squareRoot(most);
        f.limit = still ? nearStill : far;
    }

private:
    HD real middle(int block, int d) const
    {
        return real(0.5f*frames.lowest(block, d) + 0.5f*frames.highest(block, d));
    }

    HD int wrapped(int c, int d) const
    {
        if (c >= 0 && c < frames.n[d]) return c;
        return periodic[d] ? (c < 0 ? c + frames.n[d] : c - frames.n[d]) : -1;
    }
};

template<class Backend, int D, class P>
class LocalFrameMemory
{
public:
    using real = typename P::real;

    //- Blocks at least `width` wide; more of them than `most` are made larger
    void set(Context<Backend>& context, const Box<D, P>& box, double width, double most)
    {
        double volume = 1;
        for (int d = 0; d < D; ++d) volume *= std::max(1.0, box.length[d]/width);
        width_ = width*std::max(1.0, std::pow(volume/most, 1.0/D));
        frames_ = LocalFrames<D, P>{};
        blocks_ = 1;
        for (int d = 0; d < 3; ++d)
        {
            frames_.n[d] = 1;
            periodic_[d] = d < D && box.periodic[d];
            if (d >= D) continue;
            // a hair wider, so that rounding of a position costs nothing
            frames_.n[d] = std::max(1, int(box.length[d]/(1.001*width_)));
            frames_.inverse[d] = real(frames_.n[d]/box.length[d]);
            blocks_ *= frames_.n[d];
        }
        bounds_.allocate(context, std::size_t(blocks_)*2*D);
        immobile_.allocate(context, blocks_);
        frame_.allocate(context, blocks_);
    }

    bool on() const { return blocks_ > 0; }
    double width() const { return width_; }

    LocalFrames<D, P> view()
    {
        LocalFrames<D, P> f = frames_;
        f.bounds = bounds_.data();
        f.still = immobile_.data();
        f.frame = frame_.data();
        return f;
    }

    void clear(Context<Backend>& context)
    {
        if (on()) forEach(context, blocks_, ClearFrames<D, P>{view()});
    }
    void clearStill(Context<Backend>& context)
    {
        if (on()) forEach(context, blocks_, ClearStill{immobile_.data()});
    }

    void settle(Context<Backend>& context, double far, double nearStill)
    {
        if (!on()) return;
        SettleFrames<D, P> s{
            view(), {periodic_[0], periodic_[1], periodic_[2]}, real(far), real(nearStill)};
        forEach(context, blocks_, s);
    }

    //- As LocalFrames has them, for who joins those of several ranks
    std::vector<int> bounds() const { return bounds_.download(); }
    void setBounds(Context<Backend>& context, const std::vector<int>& bounds)
    {
        bounds_.upload(context, bounds);
    }

    std::size_t bytes() const { return bounds_.bytes() + immobile_.bytes() + frame_.bytes(); }

private:
    LocalFrames<D, P> frames_{};
    bool periodic_[3] = {};
    Array<Backend, int> bounds_, immobile_;
    Array<Backend, LocalFrame<D, real>> frame_;
    int blocks_ = 0;
    double width_ = 0;
};

} // namespace riprap

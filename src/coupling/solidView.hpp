/*  What the fluid's side of a coupled scene sees of its solids, and what it asks of them. Particles
    are named by keys, which sorting does not change.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <vector>
#include "core/backend/backend.hpp"
#include "dem/motion/clumpConstraint.hpp"
#include "dem/state/solidFields.hpp"

namespace riprap
{

template<int D, class P>
struct SolidView
{
    Box<D, P> box;              // in which the solids' positions are
    SolidFields<D, P> fields;
    const int* slotOf;          // of a key; -1: it has left
};

//- Its rigid bodies
template<int D, class P>
struct BodyView
{
    ClumpData* clumps;
    const GroupData<D, typename P::real>* groups;
    const ClumpConstraint* constraints;         // of groups; null: none is constrained
    Box<D, P> box;
    int count;
};

//- A scene of solids as the fluid drives it. Pointers hold until the next advanceTo
template<int D, class P>
class SolidSide
{
public:
    virtual ~SolidSide() = default;

    virtual int keys() const = 0;

    //- Nothing of them can move: steps of theirs are but time
    virtual bool still() const = 0;

    virtual SolidView<D, P> view() = 0;
    virtual BodyView<D, P> bodies() = 0;

    //- Keys of the particles that are there, in the order in which they are read back
    virtual std::vector<std::int32_t> order() = 0;

    //- Forces from outside, on the device: D forces, then moments, a key
    virtual typename P::real* external() = 0;

    //- Steps within one step of the fluid, by contacts and by the speeds at hand: to be asked just
    //  before advanceTo, after push; and the time over which they let a force from outside act
    virtual int subcycles(double dt) = 0;
    virtual double kickTime(double dt, int subcycles) = 0;

    //- On a GPU: begin to find the speeds that subcycles() will ask for, while the caller waits for
    //  something else. Nothing may push the solids in between
    virtual void measureSpeed() = 0;

    //- What external() holds acts over dt at once
    virtual void push(double dt) = 0;

    //- To time t, dt from now. \return false when a guard of the solids has fired
    virtual bool advanceTo(double t, double dt, int subcycles) = 0;

    //- An interval begins that is reported as one; it ends
    virtual void beginReport() = 0;
    virtual void endReport() = 0;
};

//- Two scenes on one device read and write the same memory: the one that follows launches in the
//  order of the other
template<class Backend>
class LaunchOrder
{
public:
    virtual ~LaunchOrder() = default;

    virtual void follow(const Context<Backend>&) = 0;
};

} // namespace riprap

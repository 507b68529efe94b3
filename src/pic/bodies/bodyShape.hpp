/*  A rigid body as the grid sees it: balls (a particle of the solids, or a clump of several), or a
    shape of its own.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/bodies/ballUnion.hpp"
#include "pic/shapes/sampledShape.hpp"

namespace riprap
{

//- As kernels see it
template<int D>
struct ShapeView
{
    BallSet<D> balls;
    const SampledShape<D>* own;         // null: balls

    HD double distance(const Vec<D, double>& x) const
    {
        return own ? own->distance(x) : balls.distance(x);
    }
    HD const Ball<D>* single() const { return own ? nullptr : balls.single(); }
    HD const SampledShape<D>* lattice() const { return own; }

    HD SolidPart<2> solidOfLine(const Vec<D, double>& x, int axis, double length) const
    { return own ? own->solidOfLine(x, axis, length) : balls.solidOfLine(x, axis, length); }

    HD double behindPole(const Vec<D, double>& x, int axis) const
    {
        return own ? own->behindPole(x, axis) : balls.behindPole(x, axis);
    }
};

//- On the host; a lattice without distances: none
template<int D>
struct BodyShape
{
    BallUnion<D> balls;
    SampledShape<D> sampled{};

    bool hasOwn() const { return sampled.lattice.distance; }
    ShapeView<D> view() const { return {balls.set(), hasOwn() ? &sampled : nullptr}; }
    double distance(const Vec<D, double>& x) const { return view().distance(x); }
    const Ball<D>* single() const { return view().single(); }
    const SampledShape<D>* lattice() const { return view().lattice(); }
    SolidPart<2> solidOfLine(const Vec<D, double>& x, int axis, double length) const
    {
        return view().solidOfLine(x, axis, length);
    }
    double behindPole(const Vec<D, double>& x, int axis) const
    {
        return view().behindPole(x, axis);
    }
};

} // namespace riprap

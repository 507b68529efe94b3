/*  Faces on the sides of the block through which water comes and goes, on the backend.

    Where the velocity w is given a face is closed and moves with w: that is how the pressure
    equation sees it (pressureFields.hpp). Where the level is given it is open, and the water beyond
    it presses with p_b = rho g (level - height): the equation knows ends with p = 0 alone, and the
    rest of the gradient that it would have, 2 p_b/h, is given to u* before it is solved: u* += +-2
    dt p_b/(rho h).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/simd/macros.hpp"

namespace riprap
{

//- What a step has settled for the listed faces of one direction
template<class R>
struct SetOpenFaces
{
    static constexpr const char* name = "setOpenFaces";
    const int* face;
    const R* open;              // 0: the velocity is given
    const R* given;             // [m/s] along the direction
    const unsigned char* leaves;
    R* aperture;
    R* wallVelocity;
    unsigned char* gate;        // may particles pass a closed face?

    HD void operator()(int k) const
    {
        const int i = face[k];
        aperture[i] = open[k];
        wallVelocity[i] = given[k];
        gate[i] = leaves[k];
    }
};

//- u += what the water beyond the face adds [m/s]
template<class R>
struct PushOpenFaces
{
    static constexpr const char* name = "pushOpenFaces";
    const int* face;
    const R* push;
    R* u;

    HD void operator()(int k) const { u[face[k]] += push[k]; }
};

template<class R>
struct CopyOpenFaces
{
    static constexpr const char* name = "copyOpenFaces";
    const int* face;
    const R* from;
    R* to;

    HD void operator()(int k) const { to[face[k]] = from[face[k]]; }
};

//- A field at the listed faces, or cells
template<class R>
struct ReadOpenFaces
{
    static constexpr const char* name = "readOpenFaces";
    const int* at;
    const R* field;
    R* result;

    HD void operator()(int k) const { result[k] = field[at[k]]; }
};

//- f for the particles from `first` on
template<class F>
struct FromParticle
{
    static constexpr const char* name = F::name;
    F f;
    int first;

    HD void operator()(int i) const { f(first + i); }
};

} // namespace riprap

/*  Which particles are of other ranks: kernels of steps leave them alone. On the CPU only;
    elsewhere, and on one rank, none is.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <vector>
#include "core/backend/launch.hpp"

namespace riprap
{

template<class Backend>
struct GhostMarks
{
    HD bool operator()(int) const { return false; }
};

#ifndef __CUDACC__

template<>
struct GhostMarks<Cpu>
{
    const char* mark = nullptr;
    bool operator()(int i) const { return mark && mark[i]; }
};

#endif

//- The marks of a vector that outlives them; none in an empty one
template<class Backend>
GhostMarks<Backend> ghostMarks([[maybe_unused]] const std::vector<char>& of)
{
    if constexpr (Backend::gpu) return {};
    else return {of.empty() ? nullptr : of.data()};
}

//- A sum or maximum over particles (F::add, F::value) without ghosts
template<class Backend, class F>
struct WithoutGhosts
{
    static constexpr const char* name = F::name;
    F f;
    GhostMarks<Backend> ghosts;

    HD void add(int i, double* sums) const { if (!ghosts(i)) f.add(i, sums); }
    HD double value(int i) const { return ghosts(i) ? 0 : f.value(i); }
};

template<class Backend, class F>
WithoutGhosts<Backend, F> withoutGhosts(const F& f, const GhostMarks<Backend>& ghosts)
{
    return {f, ghosts};
}

} // namespace riprap

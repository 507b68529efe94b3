/*  Which particles are of other ranks: kernels of steps leave them alone. On one rank none is.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/launch.hpp"

namespace riprap
{

//- As kernels see it
template<class Backend>
struct GhostMarks
{
    const char* mark = nullptr;
    HD bool operator()(int i) const { return mark && mark[i]; }
};

//- By slot, for kernels and for the host
template<class Backend>
class GhostMemory
{
public:

    void set(Context<Backend>& context, std::vector<char> marks)
    {
        marks_.swap(marks);
        device_.upload(context, marks_);
    }

    bool operator()(int i) const { return !marks_.empty() && marks_[i]; }
    GhostMarks<Backend> view() const
    {
        return {marks_.empty() ? nullptr : device_.data()};
    }

private:

    std::vector<char> marks_;
    Array<Backend, char> device_;
};

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

/*  What one part of a divided system (ReducedSystem::divided) asks of the others. All ranks call
    alike.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <vector>

namespace riprap
{

class Ranks
{
public:
    virtual ~Ranks() = default;

    //- Entry by entry over all ranks; the same bits on all of them
    virtual void sum(std::vector<double>& values) const = 0;
    virtual void least(std::vector<int>& values) const = 0;

    //- out[b] goes to the rank beyond border b; in[b], which has its size already, comes from there
    virtual void swap(const std::vector<std::vector<double>>& out,
        std::vector<std::vector<double>>& in) const = 0;
};

} // namespace riprap

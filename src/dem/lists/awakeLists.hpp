/*  Which particles are awake, are near walls, or may be woken by who is near: passes go over them
    alone. For the CPU.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <vector>

namespace riprap
{

struct AwakeLists
{
    //- Slots side by side of particles that are awake; so many at most, for threads to share
    struct Run { int begin, end; };
    static constexpr int longest = 64;

    bool some = false;                  // may anyone be asleep? Else passes go over all
    std::vector<Run> runs;
    std::vector<int> first;             // run of each block of contacts, and the end
    std::vector<int> looking;           // awake, or a half list of theirs has one who is
    std::vector<int> near;              // those, and who is in their lists
    std::vector<int> walls;             // awake, with entries of walls; of all scenes
    int wallCount = 0;

    void clear(bool anyAsleep)
    {
        some = anyAsleep;
        wallCount = 0;
        runs.clear();
        for (auto* list : {&first, &looking, &near, &walls}) list->clear();
    }

    //- A block begins
    void open() { first.push_back(int(runs.size())); }

    //- The next of the block that is awake
    void add(int i)
    {
        const bool follows = int(runs.size()) > first.back() && runs.back().end == i
            && i - runs.back().begin < longest;
        if (follows) ++runs.back().end;
        else runs.push_back(Run{i, i + 1});
    }

    //- After the last block
    template<class List>
    void close(int particles, const List& list)
    {
        open();
        std::vector<char> marked(particles, 0);
        for (const int i : looking)
        {
            marked[i] = 1;
            for (int e = list.base[i], end = e + list.count[i]; e < end; ++e)
                marked[List::other(list.entry[e])] = 1;
        }
        for (int i = 0; i < particles; ++i)
            if (marked[i]) near.push_back(i);
    }

    //- wallFirst: entries of a particle; null: there are no walls
    void setWalls(int particles, const int* wallFirst)
    {
        const auto near = [&](int i) { return wallFirst[i + 1] > wallFirst[i]; };
        const auto list = [&](int begin, int end)
        {
            for (int i = begin; i < end; ++i) if (near(i)) walls.push_back(i);
        };
        if (wallFirst && some) for (const Run& run : runs) list(run.begin, run.end);
        else if (wallFirst) list(0, particles);
        wallCount = int(walls.size());
    }
};

//- A kernel over those of a list
template<class Kernel>
struct OverList
{
    static constexpr const char* name = Kernel::name;

    Kernel kernel;
    const int* listed;

    void operator()(int k) const { kernel(listed[k]); }
};

//- A kernel over those that are awake, a run at a time
template<class Kernel>
struct OverRuns
{
    static constexpr const char* name = Kernel::name;
    static constexpr int few = 4;       // runs that one thread does

    Kernel kernel;
    const AwakeLists::Run* runs;

    void operator()(int r) const
    {
        for (int i = runs[r].begin, end = runs[r].end; i < end; ++i) kernel(i);
    }
};

} // namespace riprap

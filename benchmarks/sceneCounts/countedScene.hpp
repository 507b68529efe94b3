/*  Small scenes that have everything, and the same with one thing less: what sceneCounts counts.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>
#include "api/demScene.hpp"

namespace riprap
{

//- A scene of any solver, as far as it is counted
struct CountedScene
{
    std::function<void(int steps)> advance;
    std::function<void()> sample;           // what a function object asks for
    std::function<std::vector<KernelInfo>()> kernels;
    std::function<std::vector<ArrayInfo>()> arrays;
    std::size_t items = 0;                  // particles; of picDem: cells
    int before = 0;                         // steps that are taken first
    std::function<void()> ready;            // throws if they have not led where they should
    // samples after each step; comes back after each step, as for a line of the log
    bool sampling = false, logging = false;

    template<class Scene>
    static CountedScene of(std::shared_ptr<Scene> scene, std::size_t items)
    {
        CountedScene s;
        s.advance = [scene](int steps) { scene->advance(1e30, steps); };
        s.kernels = [scene] { return scene->kernels(); };
        s.arrays = [scene] { return scene->arrays(); };
        s.items = items;
        return s;
    }
};

//- One line of the table: a scene, and the same without something
struct Row
{
    std::string solver, without;            // without empty: the scene itself, named `scene`
    std::string scene;                      // which scene something is taken from
    std::set<std::string> has;              // what owns kernels and fields (kernelOwners.csv)
    std::function<CountedScene()> make;
};

std::vector<Row> sphRows();
std::vector<Row> picRows();
std::vector<Row> demRows();

//- A plane of a box, towards its inside
DemWall plane(int axis, double at, bool upper);

} // namespace riprap

/*  Times pressure steps on one backend: the velocities are put back before each.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <chrono>
#include <ctime>
#include "core/backend/device.hpp"
#include "pic/projection/pressureStep.hpp"
#include "pressureScene.hpp"

namespace riprap
{

template<class Backend, int D, class R>
SpeedRow timeStep(const SpeedCase& c)
{
    const PressureScene<D, R> scene(c);
    Context<Backend> context;
    Array<Backend, R> phi, aperture[D], u[D];
    Array<Backend, double> p;
    phi.upload(context, scene.phi);
    PressureFields<D, R> f{};
    f.grid = scene.grid;
    f.phi = phi.data();
    f.timeStep = 1e-3;
    f.density = 1000;
    for (int d = 0; d < D; ++d)
    {
        aperture[d].upload(context, scene.aperture[d]);
        f.aperture[d] = aperture[d].data();
    }
    PressureStep<Backend, D, R> step;
    step.allocate(context, scene.grid);
    MultigridLinear solver;
    solver.controls.tolerance = c.tolerance;

    SpeedRow row;
    row.device = deviceLabel(Backend{});
    row.cells = scene.grid.cells();
    std::vector<double> seconds, first;
    for (int k = -2; k < c.repeats; ++k)
    {
        for (int d = 0; d < D; ++d) { u[d].upload(context, scene.u[d]); f.u[d] = u[d].data(); }
        p.upload(context, std::vector<double>(scene.grid.cells(), 0.0));
        f.p = p.data();
        context.synchronise();
        context.profile.timing = c.phases && k >= 0;
        const std::clock_t busy = std::clock();
        const auto start = std::chrono::steady_clock::now();
        const PressureReport r = step.project(context, f, solver);
        context.synchronise();
        if (k >= 0)
            seconds.push_back(
                std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        const double processor = double(std::clock() - busy)/CLOCKS_PER_SEC;
        if (k == 0 || (k > 0 && processor < row.processor)) row.processor = processor;
        row.iterations = r.iterations;
        row.residual = r.finalResidual;
        row.wet = r.wetCells;
        row.pocketCells = step.pocketCells();
        const std::vector<double> now = p.download();
        if (first.empty()) first = now;
        row.repeats = row.repeats && first == now;
    }
    std::sort(seconds.begin(), seconds.end());
    row.best = seconds.front();
    row.median = seconds[seconds.size()/2];
    if (c.phases)
        for (const auto& e : context.profile.entries()) if (e.seconds > 0)
        {
            row.phases.emplace_back(e.name, e.seconds/c.repeats);
            row.launches.push_back(e.launches/(c.repeats + 2));
        }
    return row;
}

template<class Backend>
SpeedRow timeIn(const SpeedCase& c)
{
    if (c.dimensions == 2)
        return c.mixed ? timeStep<Backend, 2, float>(c) : timeStep<Backend, 2, double>(c);
    return c.mixed ? timeStep<Backend, 3, float>(c) : timeStep<Backend, 3, double>(c);
}

} // namespace riprap

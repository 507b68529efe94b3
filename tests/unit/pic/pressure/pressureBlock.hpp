/*  A block of water on the host, projected on the backend: for tests of the pressure.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <array>
#include "backendTest.hpp"
#include "pic/projection/pressureStep.hpp"

namespace riprap
{
namespace
{

using Point = std::array<double, 3>;

//- Fields of a block on the host, and their projection on the backend
template<int D, class R>
struct Block
{
    UniformGrid<D> grid;
    std::vector<R> phi, aperture[D], wall[D], u[D];
    std::vector<double> p;
    double timeStep = 1e-3, density = 1000;
    PressureReport report;
    int pocketCells = 0;

    Block(std::array<int, 3> n, double h, std::array<bool, 3> ring = {})
    {
        grid.h = h;
        for (int d = 0; d < D; ++d)
        {
            grid.origin[d] = 0;
            grid.n[d] = n[d];
            grid.periodic[d] = ring[d];
        }
        phi.assign(grid.cells(), R(-1));
        p.assign(grid.cells(), 0);
        for (int d = 0; d < D; ++d)
        {
            aperture[d].assign(grid.faces(d), R(1));
            wall[d].assign(grid.faces(d), R(0));
            u[d].assign(grid.faces(d), R(0));
            if (grid.periodic[d]) continue;
            eachFace(d,
                [&](int f, const auto& x)
                {
                    if (x.c[d] == 0 || x.c[d] == grid.n[d]) aperture[d][f] = 0;
                });
        }
    }

    template<class F> void eachFace(int d, const F& f) const
    {
        for (int i = 0; i < grid.faces(d); ++i) f(i, grid.faceIndex(d, i));
    }

    Point centre(int i) const
    {
        const auto x = grid.cellIndex(i);
        Point c{};
        for (int d = 0; d < D; ++d) c[d] = (x.c[d] + 0.5)*grid.h;
        return c;
    }

    Point faceCentre(int d, int i) const
    {
        const auto x = grid.faceIndex(d, i);
        Point c{};
        for (int e = 0; e < D; ++e) c[e] = (x.c[e] + (e == d ? 0 : 0.5))*grid.h;
        return c;
    }

    //- before: the same water with other velocities, projected first with the same coefficients
    void project(LinearSolver& solver, const Block* before = nullptr)
    {
        Context<Backend> context;
        Array<Backend, R> phiD, apertureD[D], wallD[D], uD[D];
        Array<Backend, double> pD;
        phiD.upload(context, phi);
        pD.upload(context, p);
        PressureFields<D, R> f{};
        f.grid = grid;
        f.phi = phiD.data();
        f.p = pD.data();
        f.timeStep = timeStep;
        f.density = density;
        for (int d = 0; d < D; ++d)
        {
            apertureD[d].upload(context, aperture[d]);
            wallD[d].upload(context, wall[d]);
            uD[d].upload(context, u[d]);
            f.aperture[d] = apertureD[d].data();
            f.wallVelocity[d] = wallD[d].data();
            f.u[d] = uD[d].data();
        }
        PressureStep<Backend, D, R> step;
        step.allocate(context, grid);
        if (before)
        {
            pD.upload(context, before->p);
            for (int d = 0; d < D; ++d) uD[d].upload(context, before->u[d]);
            f.timeStep = before->timeStep;
            step.project(context, f, solver);
            pD.upload(context, p);
            for (int d = 0; d < D; ++d) uD[d].upload(context, u[d]);
            f.timeStep = timeStep;
        }
        report = step.project(context, f, solver, nullptr, before != nullptr);
        pocketCells = step.pocketCells();
        context.synchronise();
        p = pD.download();
        for (int d = 0; d < D; ++d) u[d] = uD[d].download();
    }

    //- Fields as the functor isWet wants them, on the host
    bool wet(int i) const
    {
        PressureFields<D, R> f{};
        f.grid = grid;
        f.phi = phi.data();
        for (int d = 0; d < D; ++d) f.aperture[d] = aperture[d].data();
        return isWet(f, i, grid.cellIndex(i));
    }

    //- Sum of the fluxes out of a cell, of unit faces
    double imbalance(int i) const
    {
        double sum = 0;
        for (int d = 0; d < D; ++d)
            for (int side = 0; side < 2; ++side)
            {
                const int f = grid.faceOf(d, grid.cellIndex(i), side);
                const double a = aperture[d][f];
                sum += (side ? 1 : -1)*(a*double(u[d][f]) + (1 - a)*double(wall[d][f]));
            }
        return sum;
    }

    double largestImbalance() const
    {
        double worst = 0;
        for (int i = 0; i < grid.cells(); ++i)
            if (wet(i)) worst = std::max(worst, std::fabs(imbalance(i)));
        return worst;
    }

    double largestSpeed() const
    {
        double worst = 0;
        for (int d = 0; d < D; ++d)
            eachFace(d, [&](int f, const auto& x)
            {
                const int a = grid.cellOf(d, x, 0), b = grid.cellOf(d, x, 1);
                if (aperture[d][f] > 0 && ((a >= 0 && wet(a)) || (b >= 0 && wet(b))))
                    worst = std::max(worst, std::fabs(double(u[d][f])));
            });
        return worst;
    }
};

[[maybe_unused]] MultigridLinear tight(double tolerance = 1e-12)
{
    MultigridLinear solver;
    solver.controls.tolerance = tolerance;
    solver.controls.maxIter = 100;
    return solver;
}

} // namespace
} // namespace riprap

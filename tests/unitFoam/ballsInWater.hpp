/*  Balls in a tank, moved by one projection.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <string>
#include "../unit/pic/bodyReference.hpp"
#include "pic/projection/pressureStep.hpp"
#include "pic/shapes/shapes.hpp"

//- Entries of coupledPCG with GAMG
inline std::string coupled(double tolerance, const char* more = "")
{
    return "solver coupledPCG; preconditioner { preconditioner GAMG; smoother symGaussSeidel; "
           "nVcycles 1; nPreSweeps 1; nPostSweeps 1; nFinestSweeps 1;"
           " directSolveCoarsest true; nCellsInCoarsestLevel 20; tolerance 1e-2; relTol 0; } "
           "relTol 0; maxIter 200; tolerance "
        + std::to_string(tolerance*1e15) + "e-15; " + more;
}

template<int D>
struct BallsInWater
{
    using Ball = riprap::Ball<D>;
    riprap::UniformGrid<D> grid;
    std::vector<double> phi, p, u[D];
    riprap::BodyGrid<D> cut;
    std::vector<riprap::FreeBody<D, Ball>> bodies;
    double dt = 1e-3, g = 9.81, density = 1000;
    riprap::PressureReport report;

    BallsInWater(int n, double h)
    {
        grid.h = h;
        for (int d = 0; d < D; ++d) { grid.n[d] = n; grid.origin[d] = 0; }
        phi.assign(grid.cells(), -1);
        p.assign(grid.cells(), 0);
        for (int d = 0; d < D; ++d)
        {
            u[d].assign(grid.faces(d), d == D - 1 ? -g*dt : 0);
            for (int f = 0; f < grid.faces(d); ++f)
            {
                const auto x = grid.faceIndex(d, f);
                cut.aperture[d].push_back(x.c[d] == 0 || x.c[d] == grid.n[d] ? 0 : 1);
            }
        }
    }

    //- A round tank
    void roundTank(const riprap::Vec<D, double>& centre, double radius)
    {
        riprap::Context<riprap::Cpu> context;
        const riprap::NodeGrid<D> nodes{grid};
        std::vector<double> distance(nodes.count(), 1e30);
        const riprap::Complement<Ball> tank{{centre, radius}};
        riprap::forEach(context, nodes.count(),
            riprap::NodeDistances<D, riprap::Complement<Ball>>{nodes, tank, distance.data()});
        for (int d = 0; d < D; ++d)
            riprap::forEach(context, grid.faces(d),
                riprap::CloseFaces<D, double>{nodes, d, distance.data(), cut.aperture[d].data()});
    }

    void addBall(const riprap::Vec<D, double>& centre, double radius)
    {
        std::vector<double> falling(riprap::bodyModes<D>, 0.0);
        falling[D - 1] = -g*dt;
        bodies.push_back({{centre, radius}, centre, radius, falling});
    }

    //- Bodies of these densities, relative to the water's; their accelerations are then in
    //  cut.terms
    void project(const std::vector<double>& ratio, riprap::LinearSolver& solver, bool turns = true)
    {
        riprap::cutBodies(grid, bodies, D - 1, cut);
        for (std::size_t b = 0; b < bodies.size(); ++b)
        {
            riprap::BodyTerm& t = cut.terms[b];
            const double mass = ratio[b]*density*t.volume, radius = bodies[b].reach;
            t.inverseMass.assign(t.modes*t.modes, 0.0);
            for (int m = 0; m < t.modes; ++m)
                t.inverseMass[m*t.modes + m] = !turns && m >= D
                    ? 0
                    : 1/(m < D ? mass : mass*radius*radius*(D == 2 ? 0.5 : 0.4));
        }
        riprap::Context<riprap::Cpu> context;
        riprap::PressureStep<riprap::Cpu, D, double> step;
        step.allocate(context, grid);
        riprap::PressureFields<D, double> f{};
        f.grid = grid;
        f.phi = phi.data();
        for (int d = 0; d < D; ++d)
        {
            f.aperture[d] = cut.aperture[d].data();
            f.wallVelocity[d] = cut.wallVelocity[d].data();
            f.u[d] = u[d].data();
        }
        f.p = p.data();
        f.timeStep = dt;
        f.density = density;
        report = step.project(context, f, solver, &cut.terms);
    }

    double acceleration(int body, int mode = D - 1) const
    {
        return cut.terms[body].velocity[mode]/dt;
    }
};

//- n bodies of about five cells radius in a tank with a surface
inline void fillWith(BallsInWater<2>& s, int n)
{
    for (int i = 0; i < s.grid.cells(); ++i)
        s.phi[i] = (s.grid.cellIndex(i).c[1] + 0.5)*s.grid.h - 0.8;
    unsigned seed = 7;
    const auto random = [&] { seed = seed*1664525u + 1013904223u; return seed/4294967296.0; };
    const double h = s.grid.h;
    while (int(s.bodies.size()) < n)
    {
        const double r = (4.5 + random())*h;
        const riprap::Vec<2, double> c{{2*r + (1 - 4*r)*random(), 2*r + (0.85 - 2*r)*random()}};
        bool free = true;
        for (const auto& b : s.bodies)
            free = free && std::sqrt(riprap::squaredNorm(b.centre - c)) > b.reach + r + 0.5*h;
        if (free) s.addBall(c, r);
    }
}

/*  The pressure equation solved by OpenFOAM's solvers on the wet cells alone, against riprap's
    multigrid.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <sstream>
#include <gtest/gtest.h>
#include "pic/projection/pressureStep.hpp"
#include "pressureSolver.H"
#include "testTime.H"

namespace
{

using namespace Foam;

//- A tank with a sloping surface, a pillar, a drop of one cell and a closed pocket, driven by
//  velocities of any kind
template<int D>
struct Tank
{
    riprap::UniformGrid<D> grid;
    std::vector<double> phi, aperture[D], u[D], p;

    Tank(int n)
    {
        grid.h = 1.0/n;
        for (int d = 0; d < D; ++d) { grid.origin[d] = 0; grid.n[d] = n; }
        unsigned seed = 1;
        const auto random = [&]
        {
            seed = seed*1664525u + 1013904223u;
            return seed/4294967296.0 - 0.5;
        };
        p.assign(grid.cells(), 0);
        for (int i = 0; i < grid.cells(); ++i)
        {
            const auto c = grid.cellIndex(i);
            const double x = (c.c[0] + 0.5)*grid.h, y = (c.c[1] + 0.5)*grid.h;
            const bool drop = c.c[0] == n - 3 && c.c[1] == n - 2 && (D == 2 || c.c[2] == 1);
            phi.push_back(drop ? -0.1*grid.h : y - 0.6 + 0.2*x);
        }
        for (int d = 0; d < D; ++d)
            for (int f = 0; f < grid.faces(d); ++f)
            {
                const auto c = grid.faceIndex(d, f);
                const bool end = c.c[d] == 0 || c.c[d] == grid.n[d];
                const bool lid = d == 0 && c.c[1] < n/4 && (c.c[0] == n/3 || c.c[0] == n/2);
                const bool roof = d == 1 && c.c[1] == n/4 && c.c[0] >= n/3 && c.c[0] < n/2;
                aperture[d].push_back(end || lid || roof ? 0 : 0.6 + 0.8*random()*random());
                u[d].push_back(random());
            }
    }

    riprap::PressureReport project(riprap::LinearSolver& solver, int* pocketCells = nullptr)
    {
        riprap::Context<riprap::Cpu> context;
        riprap::PressureStep<riprap::Cpu, D, double> step;
        step.allocate(context, grid);
        riprap::PressureFields<D, double> f{};
        f.grid = grid;
        f.phi = phi.data();
        for (int d = 0; d < D; ++d) { f.aperture[d] = aperture[d].data(); f.u[d] = u[d].data(); }
        f.p = p.data();
        f.timeStep = 1e-3;
        f.density = 1000;
        const riprap::PressureReport r = step.project(context, f, solver);
        if (pocketCells) *pocketCells = step.pocketCells();
        return r;
    }
};

template<int D>
void compare(int n, const char* controls, const char* label)
{
    Tank<D> ours(n), theirs(n);
    riprap::MultigridLinear multigrid;
    multigrid.controls.tolerance = 1e-13;
    int pocketCells = 0;
    const auto a = ours.project(multigrid, &pocketCells);
    EXPECT_TRUE(a.converged) << a.finalResidual;
    EXPECT_GT(pocketCells, 0);

    pressureSolver solver(testTime(), "p", entries(controls));
    testing::internal::CaptureStdout();
    const auto b = theirs.project(solver);
    const std::string log = testing::internal::GetCapturedStdout();
    EXPECT_NE(
        log.find(std::string(label) + ":  Solving for p, Initial residual = "), std::string::npos)
        << log;
    EXPECT_NE(log.find(", No Iterations " + std::to_string(b.iterations)), std::string::npos)
        << log;
    EXPECT_TRUE(b.converged) << label << " " << b.finalResidual;
    EXPECT_EQ(a.wetCells, b.wetCells);
    double largest = 0, worst = 0;
    for (int i = 0; i < ours.grid.cells(); ++i)
    {
        largest = std::max(largest, std::fabs(ours.p[i]));
        worst = std::max(worst, std::fabs(ours.p[i] - theirs.p[i]));
    }
    EXPECT_LT(worst, 1e-8*largest) << label;
}

const char* const pcg = "solver PCG; preconditioner DIC; tolerance 1e-13; relTol 0;";
const char* const gamg = "solver GAMG; smoother symGaussSeidel; tolerance 1e-13; relTol 0;";
const char* const gamgPcg = "solver PCG; preconditioner { preconditioner GAMG; smoother "
                            "symGaussSeidel; tolerance 1e-2; relTol 0; nVcycles 1;"
                            " nPreSweeps 1; nPostSweeps 1; nFinestSweeps 1; directSolveCoarsest "
                            "true; nCellsInCoarsestLevel 20; } tolerance 1e-13; relTol 0;";
const char* const ownSolver = "solver cudaPCG; tolerance 1e-12; nSweeps 1;";

TEST(PressureSolver, OpenFOAMsSolversAgreeWithTheMultigridIn2D)
{
    compare<2>(40, pcg, "DICPCG");
    compare<2>(40, gamg, "GAMG");
    compare<2>(40, gamgPcg, "GAMGPCG");
    compare<2>(40, ownSolver, "cudaPCG");
}

TEST(PressureSolver, OpenFOAMsSolversAgreeWithTheMultigridIn3D)
{
    compare<3>(16, pcg, "DICPCG");
    compare<3>(16, gamg, "GAMG");
    compare<3>(16, gamgPcg, "GAMGPCG");
    compare<3>(16, ownSolver, "cudaPCG");
}

TEST(PressureSolver, FewRowsAreNotGivenToGAMG)
{
    compare<2>(9, gamg, "DICPCG");
}

//- What a wrong entry is answered by
std::string refusal(const char* controls)
{
    FatalIOError.throwExceptions();
    std::string message;
    try { pressureSolver solver(testTime(), "p", entries(controls)); }
    catch (const Foam::error& e) { message = e.message(); }
    FatalIOError.dontThrowExceptions();
    return message;
}

TEST(PressureSolver, WrongEntriesAreRefused)
{
    const auto says = [](const char* controls, const char* what)
    { EXPECT_NE(refusal(controls).find(what), std::string::npos) << refusal(controls); };
    says("solver PGC;", "unknown solver 'PGC'");
    says("solver PGC;", "cudaPCG");
    says("solver cudaPCG; smoother GaussSeidel;", "unknown entry 'smoother'");
    says("solver cudaPCG; maxIter 0;", "maxIter");
    says("solver cudaPCG; tolerance 0;", "tolerance");
    says("solver cudaPCG; nSweeps 0;", "nSweeps");
    says("solver cudaPCG; reflectionTolerance 1;", "reflectionTolerance");
    says("solver cudaPCG; gatheredCells -1;", "gatheredCells of solver cudaPCG for p must be 0 or");
    says("solver GAMG; agglomerator faceAreaPair; smoother GaussSeidel;", "algebraicPair");
    says("solver PCG; preconditioner GAMG;", "dictionary");
    EXPECT_EQ(refusal(ownSolver), "");
}

TEST(PressureSolver, CellsThatAreGathered)
{
    pressureSolver solver(testTime(), "p", entries(ownSolver));
    EXPECT_EQ(solver.gatheredCells(77), 77);
    EXPECT_TRUE(solver.read(entries("solver cudaPCG; gatheredCells 0;")));
    EXPECT_EQ(solver.gatheredCells(77), 0);
    EXPECT_TRUE(solver.read(entries("solver PCG; preconditioner DIC; tolerance 1e-8;")));
    EXPECT_EQ(solver.gatheredCells(77), 77);
}

} // namespace

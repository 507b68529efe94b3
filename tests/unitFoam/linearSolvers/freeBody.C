/*  Free bodies solved with the pressure: first step of a disk or sphere at rest in a closed tank,
    Archimedes, momentum, iterations.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <gtest/gtest.h>
#include "ballsInWater.hpp"
#include "pressureSolver.H"
#include "testTime.H"

namespace
{

using namespace Foam;

template<int D>
struct FreeStep : BallsInWater<D>
{
    using BallsInWater<D>::BallsInWater;

    //- Bodies of these densities, relative to the water's; their accelerations are then in
    //  cut.terms
    void solve(const std::vector<double>& ratio, const std::string& controls, bool turns = true)
    {
        pressureSolver solver(testTime(), "p", entries(controls));
        testing::internal::CaptureStdout();
        this->project(ratio, solver, turns);
        testing::internal::GetCapturedStdout();
        EXPECT_TRUE(this->report.converged) << this->report.finalResidual;
    }
};

//- Acceleration of a ball at rest in the middle of a round tank twice its size, against theory
template<int D>
double accelerationError(double cellsARadius, double ratio, int* iterations = nullptr,
    double x = 0.137, double y = -0.21)
{
    const double a = 1, tank = 2, h = a/cellsARadius;
    const int n = int(std::ceil(2*tank/h)) + 5;
    FreeStep<D> s(n, h);
    riprap::Vec<D, double> c;
    for (int d = 0; d < D; ++d) c[d] = 0.5*n*h + (d == 0 ? x : y)*h;
    s.roundTank(c, tank);
    s.addBall(c, a);
    s.solve({ratio}, coupled(1e-11));
    if (iterations) *iterations = s.report.iterations;
    const double added = D == 2
        ? (tank*tank + a*a)/(tank*tank - a*a)
        : 0.5*(std::pow(tank, 3) + 2*std::pow(a, 3))/(std::pow(tank, 3) - std::pow(a, 3));
    return s.acceleration(0)/(-s.g*(ratio - 1)/(ratio + added)) - 1;
}

TEST(FreeBody, AccelerationIn2D)
{
    for (const double ratio : {1e-3, 1e-2, 0.1, 0.5, 2.7, 1e3})
    {
        int iterations = 0;
        const double error = accelerationError<2>(10, ratio, &iterations);
        EXPECT_LT(std::fabs(error), 0.01) << "density ratio " << ratio;
        std::cout << "2D density ratio " << ratio << ": error " << 100*error << " %, iterations "
                  << iterations << "\n";
    }
}

//- Wherever the disk lies in the grid, and worst where planes of faces touch it (0 0): less than 1
//  % at 10 cells a radius, of second order
TEST(FreeBody, ConvergesWithSecondOrderIn2D)
{
    double rms[2] = {0, 0};
    for (int k = 0; k < 2; ++k)
        for (const double x : {0.0, 0.5, 0.137, 0.31})
            for (const double y : {0.0, -0.21})
            {
                const double error = accelerationError<2>(6 << (2*k), 0.001, nullptr, x, y);
                if (k) { EXPECT_LT(std::fabs(error), 0.002) << x << " " << y; }
                rms[k] += error*error/8;
            }
    EXPECT_GT(0.25*std::log2(rms[0]/rms[1]), 1.8)
        << "from " << std::sqrt(rms[0]) << " to " << std::sqrt(rms[1]);
}

TEST(FreeBody, AccelerationIn3D)
{
    for (const double ratio : {1e-3, 0.5, 1e3})
    {
        int iterations = 0;
        const double error = accelerationError<3>(6, ratio, &iterations);
        EXPECT_LT(std::fabs(error), 0.02) << "density ratio " << ratio;
        std::cout << "3D density ratio " << ratio << ": error " << 100*error << " %, iterations "
                  << iterations << "\n";
    }
}

TEST(FreeBody, ArchimedesToRoundOff)
{
    FreeStep<2> s(40, 0.05);
    for (int i = 0; i < s.grid.cells(); ++i)
        s.phi[i] = (s.grid.cellIndex(i).c[1] + 0.5)*s.grid.h - 1.613;
    s.addBall({{1.03, 0.71}}, 0.4);
    // held against turning: the centre of the volume that the grid sees is a second-order distance
    // off the disk's
    s.solve({1.0}, coupled(1e-15), false);
    for (int m = 0; m < 2; ++m) EXPECT_LT(std::fabs(s.acceleration(0, m)), 1e-12*s.g) << m;
    // the force itself: p of water at rest, by the faces that close
    std::vector<double> still(s.grid.cells());
    for (int i = 0; i < s.grid.cells(); ++i) still[i] = -s.density*s.g*s.phi[i];
    const std::vector<double> force = s.cut.terms[0].gather(still.data());
    EXPECT_NEAR(-force[1]/(s.density*s.g*s.cut.terms[0].volume), 1, 1e-12);
    EXPECT_NEAR(force[0]/(s.density*s.g*s.cut.terms[0].volume), 0, 1e-12);
}

int iterationsWith(int side, int n, const std::vector<double>& densities,
    const std::string& controls = coupled(1e-8))
{
    FreeStep<2> s(side, 1.0/side);
    fillWith(s, n);
    std::vector<double> ratio;
    for (int b = 0; b < n; ++b) ratio.push_back(densities[b % densities.size()]);
    s.solve(ratio, controls);
    return s.report.iterations;
}

//- Within a factor of 2 over all density ratios and numbers of bodies
TEST(FreeBody, IterationsOverDensitiesAndNumbers)
{
    int fewest = 1000, most = 0;
    for (const int n : {1, 9, 33})
        for (const auto& densities :
            {std::vector<double>{1e-3}, {1.0}, {1e3}, {1e-3, 1e3, 0.1, 10, 1}})
        {
            const int iterations = iterationsWith(128, n, densities);
            fewest = std::min(fewest, iterations);
            most = std::max(most, iterations);
            std::cout << n << " bodies, density ratio " << densities[0]
                      << (densities.size() > 1 ? " and others" : "") << ": " << iterations
                      << " iterations\n";
        }
    EXPECT_LE(most, 2*fewest);
}

const std::string own = "solver cudaPCG; tolerance 1e-8;";

TEST(FreeBody, IterationsOfOurMultigrid)
{
    int fewest = 1000, most = 0;
    for (const int n : {1, 33, 100})
        for (const auto& densities :
            {std::vector<double>{1e-3}, {1.0}, {2.7}, {1e3}, {1e-3, 1e3, 0.1, 10, 1}})
        {
            const int iterations = iterationsWith(n > 33 ? 256 : 128, n, densities, own);
            fewest = std::min(fewest, iterations);
            most = std::max(most, iterations);
            std::cout << n << " bodies, density ratio " << densities[0]
                      << (densities.size() > 1 ? " and others" : "") << ": " << iterations
                      << " iterations\n";
        }
    EXPECT_LE(most, 2*fewest);
}

TEST(FreeBody, OurMultigridMovesThemAlike)
{
    for (const bool full : {false, true})       // with a surface, and in a closed tank
    {
        FreeStep<2> a(64, 1.0/64), b(64, 1.0/64);
        for (FreeStep<2>* s : {&a, &b})
        {
            fillWith(*s, 9);
            if (full) s->phi.assign(s->grid.cells(), -1);
            s->solve({1e-3, 1e3, 0.1, 2.7, 1, 0.5, 20, 1e-2, 3},
                s == &a ? coupled(1e-11) : "solver cudaPCG; tolerance 1e-11;");
        }
        for (int body = 0; body < 9; ++body)
            for (int m = 0; m < 2; ++m)
                EXPECT_NEAR(a.acceleration(body, m), b.acceleration(body, m), 1e-6*a.g) << body;
    }
}

//- Water and bodies together get the weight and what the walls give
TEST(FreeBody, MomentumIsExchangedExactly)
{
    FreeStep<2> s(40, 0.05);
    for (int i = 0; i < s.grid.cells(); ++i)
        s.phi[i] = (s.grid.cellIndex(i).c[1] + 0.5)*s.grid.h - 1.613;
    s.addBall({{1.03, 0.71}}, 0.4);
    s.u[0][s.grid.face(0, {{9, 9, 0}})] = 0.3;
    const std::vector<double> before[2] = {s.u[0], s.u[1]};
    s.solve({0.3}, coupled(1e-13));
    // along x: change of the water in the open parts of faces, of the body, against p on the end
    // walls
    double sum = 0, walls = 0;
    for (int f = 0; f < s.grid.faces(0); ++f)
    {
        const auto x = s.grid.faceIndex(0, f);
        const double a = s.cut.aperture[0][f];
        sum += s.density*a*s.grid.volume()*(s.u[0][f] - before[0][f]);
        if (x.c[0] == 0) walls += s.p[s.grid.cellOf(0, x, 1)]*s.grid.area();
        if (x.c[0] == s.grid.n[0]) walls -= s.p[s.grid.cellOf(0, x, 0)]*s.grid.area();
    }
    const double mass = 1/s.cut.terms[0].inverseMass[0], body = mass*s.cut.terms[0].velocity[0];
    EXPECT_GT(std::fabs(body), 1e-6);
    EXPECT_NEAR(sum + body, walls*s.dt, 1e-8*std::fabs(body) + 1e-10);
}

TEST(FreeBody, OtherSolversAreRefused)
{
    FatalIOError.throwExceptions();
    std::string message;
    try
    {
        FreeStep<2> s(40, 0.05);
        s.addBall({{1.03, 0.71}}, 0.4);
        s.solve({0.3}, "solver PCG; preconditioner DIC; tolerance 1e-8;");
    }
    catch (const Foam::error& e) { message = e.message(); testing::internal::GetCapturedStdout(); }
    FatalIOError.dontThrowExceptions();
    EXPECT_NE(message.find("coupledPCG"), std::string::npos) << message;
}

} // namespace

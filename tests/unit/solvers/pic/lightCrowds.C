/*  Crowds of light bodies in closed water, solved with our multigrid and deflated
    (pic/bodies/deflation.hpp). The hats between the bodies sum to the constant there, which such
    water leaves free: E would be singular, and what round-off makes of its last pivot may be of
    either sign, so that each test has several crowds.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <gtest/gtest.h>
#include <functional>
#include "../../../unitFoam/ballsInWater.hpp"

namespace
{

using riprap::Vec;

//- Balls of a radius of `least` to least + 1 cells at random places, two cells apart
template<int D>
struct Crowd : BallsInWater<D>
{
    unsigned seed;
    double least;
    int fewest = 1000, most = 0;

    Crowd(int n, double leastRadius, unsigned s)
        : BallsInWater<D>(n, 0.001), seed(s), least(leastRadius)
    {}

    double random() { seed = seed*1664525u + 1013904223u; return seed/4294967296.0; }

    //- inside(x, r): does it hold a ball [cells]?
    void place(int count, const std::function<bool(const Vec<D, double>&, double)>& inside)
    {
        for (int placed = 0; placed < count; )
        {
            constexpr double gap = 2;
            const double r = least + random();
            Vec<D, double> x;
            for (int d = 0; d < D; ++d) x[d] = this->grid.n[d]*random();
            bool free = inside(x, r + gap);
            for (const auto& b : this->bodies)
                free = free
                    && std::sqrt(riprap::squaredNorm(b.centre - this->grid.h*x))
                        > b.reach + (r + gap)*this->grid.h;
            if (!free) continue;
            this->addBall(this->grid.h*x, r*this->grid.h);
            ++placed;
        }
    }

    //- Round tanks, all else is solid
    void tanks(const std::vector<Vec<D, double>>& middle, double radius)
    {
        riprap::Context<riprap::Cpu> context;
        const riprap::NodeGrid<D> nodes{this->grid};
        std::vector<double> distance(nodes.count(), -1e30);
        for (const Vec<D, double>& m : middle)
        {
            std::vector<double> of(nodes.count(), 1e30);
            const riprap::Complement<riprap::Ball<D>> tank{{this->grid.h*m, radius*this->grid.h}};
            riprap::forEach(context, nodes.count(),
                riprap::NodeDistances<D, riprap::Complement<riprap::Ball<D>>>{
                    nodes, tank, of.data()});
            for (std::size_t i = 0; i < of.size(); ++i) distance[i] = std::max(distance[i], of[i]);
        }
        for (int d = 0; d < D; ++d)
            riprap::forEach(context, this->grid.faces(d),
                riprap::CloseFaces<D, double>{
                    nodes, d, distance.data(), this->cut.aperture[d].data()});
    }

    //- From p = 0, and then as in a later step, from a pressure that is near
    void solve(double ratio)
    {
        const std::vector<double> before[3] = {this->u[0], this->u[1], this->u[D - 1]},
                                  walls[3] = {this->cut.aperture[0], this->cut.aperture[1],
                                      this->cut.aperture[D - 1]};
        for (const double pull : {1.0, 1.01})
        {
            for (int d = 0; d < D; ++d)
            {
                this->u[d] = before[d];
                this->cut.aperture[d] = walls[d];
                for (double& v : this->u[d]) v *= pull;
            }
            riprap::MultigridLinear solver;
            solver.controls.tolerance = 1e-10;
            this->project(std::vector<double>(this->bodies.size(), ratio), solver);
            EXPECT_TRUE(this->report.converged)
                << "density ratio " << ratio << ": " << this->report.finalResidual << " after "
                << this->report.iterations;
            most = std::max(most, this->report.iterations);
            if (pull == 1) fewest = std::min(fewest, this->report.iterations);
        }
    }
};

//- So many balls in each of some round tanks, within a factor over densities and places
template<int D>
void expectFewIn(int cells, const std::vector<Vec<D, double>>& tanks, double radius, int count,
    double least, int crowds)
{
    int fewest = 1000, most = 0;
    for (const double ratio : {1e-3, 0.5})
        for (int seed = 1; seed <= crowds; ++seed)
        {
            Crowd<D> c(cells, least, seed);
            c.tanks(tanks, radius);
            for (const Vec<D, double>& middle : tanks)
                c.place(count,
                    [&](const Vec<D, double>& x, double r)
                    { return std::sqrt(riprap::squaredNorm(x - middle)) + r < radius; });
            c.solve(ratio);
            fewest = std::min(fewest, c.fewest);
            most = std::max(most, c.most);
        }
    EXPECT_LE(most, 1.5*fewest);
    std::cout << fewest << " to " << most << " iterations\n";
}

TEST(LightCrowds, ClosedTankIn2D) { expectFewIn<2>(155, {{{77.5, 77.5}}}, 75.5, 60, 4.5, 3); }
TEST(LightCrowds, TwoClosedTanks)
{
    expectFewIn<2>(170, {{{41, 42}}, {{128, 127}}}, 38.6, 15, 4.5, 3);
}
TEST(LightCrowds, ClosedTankIn3D) { expectFewIn<3>(36, {{{18, 18, 18}}}, 16, 16, 2.5, 2); }

//- Two pockets of two cells: each its own, one by a body that moves water from one to the other,
//  two with a body whose parts move water within each, and one where the other is tied
TEST(LightCrowds, FreeConstants)
{
    riprap::ReducedSystem s;
    s.cell = {0, 1, 2, 3};
    s.owner = {0, 2};
    s.neighbour = {1, 3};
    s.offDiagonal = {-1, -1};
    s.diagonal = {1, 1, 1, 1};
    const auto left = [&]
    {
        std::vector<double> r{1, 2, 5, 9};
        riprap::FreeConstants(s).takeFrom(r.data());
        return r;
    };
    const std::vector<double> apart{-0.5, 0.5, -2, 2}, together{-3.25, -2.25, 0.75, 4.75},
        second{1, 2, -2, 2}, none{1, 2, 5, 9};
    EXPECT_EQ(left(), apart);
    s.bodies = {{1, true, {1, 2}, {1, -1}}};
    EXPECT_EQ(left(), together);
    s.bodies = {{1, true, {0, 1, 2, 3}, {1, -1, 2, -2}}};
    EXPECT_EQ(left(), apart);
    s.diagonal[0] = 2;
    EXPECT_EQ(left(), second);
    s.bodies = {{1, true, {1, 2}, {1, -1}}};
    EXPECT_EQ(left(), none);
}

} // namespace

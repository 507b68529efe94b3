/*  The surface that the fill of cells tells, and how far the carried one may be from it.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <cmath>
#include <vector>
#include <gtest/gtest.h>
#include "pic/surface/fillFraction.hpp"
#include "pic/grid/pressureFields.hpp"

namespace riprap
{
namespace
{

//- A pool of a level, n^2 particles a cell on a lattice, in a block of 6 x 8 cells of 0.1
struct Pool
{
    UniformGrid<2> grid{};
    std::vector<PlaceInCell<double>> place;
    std::vector<int> start;
    double particleCells;

    Pool(double level, int n) : particleCells(1.0/(n*n))
    {
        grid.h = 0.1;
        grid.n[0] = 6;
        grid.n[1] = 8;
        for (int i = 0; i < grid.cells(); ++i)
        {
            start.push_back(int(place.size()));
            const auto c = grid.cellIndex(i);
            for (int k = 0; k < n*n; ++k)
            {
                const int row = k/n;
                const double x = (k % n + 0.5)/n, y = (row + 0.5)/n;
                if ((c.c[1] + y)*grid.h < level) place.push_back(PlaceInCell<double>{{x, y, 0}, 0});
            }
        }
        start.push_back(int(place.size()));
    }

    PicParticles<2, double> particles() const
    {
        PicParticles<2, double> p{};
        p.count = int(place.size());
        p.place = place.data();
        p.start = start.data();
        return p;
    }

    std::vector<double> held(std::vector<double> phi) const
    {
        const HoldSurface<2, double> hold{
            grid, particles(), particleCells, nullptr, nullptr, phi.data(), 4*grid.h};
        for (int i = 0; i < grid.cells(); ++i) hold(i, grid.cellIndex(i));
        return phi;
    }

    double distance(int i, double level) const
    {
        return (grid.cellIndex(i).c[1] + 0.5)*grid.h - level;
    }
};

//- Of a flat surface: its distance, from the integral of the spline, to the width of a row of
//  particles; beyond half a cell that half
TEST(PicSurface, TheFillTellsTheDistance)
{
    for (const double level : {0.33, 0.35, 0.36, 0.40, 0.44})
    {
        const int n = 50;
        const Pool pool(level, n);
        for (int i = 0; i < pool.grid.cells(); ++i)
        {
            const double h = pool.grid.h,
                         own = surfaceOfFill(fillOf(pool.grid, pool.particles(),
                                   pool.grid.cellIndex(i), pool.particleCells))
                *h;
            EXPECT_NEAR(own, std::max(-0.5*h, std::min(pool.distance(i, level), 0.5*h)), h/n)
                << level;
        }
    }
}

//- Whatever was carried there, a cell in the water is wet, and one without any is dry
TEST(PicSurface, FullCellsAreWetAndEmptyOnesDry)
{
    const double level = 0.4;
    const Pool pool(level, 2);
    const double h = pool.grid.h, wet = -wetDepth*h;
    const std::vector<double> none = pool.held(std::vector<double>(pool.grid.cells(), 1.4*h)),
                              all = pool.held(std::vector<double>(pool.grid.cells(), -1.4*h));
    for (int i = 0; i < pool.grid.cells(); ++i)
    {
        const double d = pool.distance(i, level);
        if (d < -0.9*h) { EXPECT_LT(none[i], wet); }
        if (d > 0.9*h) { EXPECT_GT(all[i], wet); }
    }
}

//- A cell that is neither is what was carried there, to the bit: its fill hangs on how the
//  particles lie
TEST(PicSurface, PartlyFilledCellsAreLeftAlone)
{
    for (const double level : {0.39, 0.41, 0.43, 0.45})
        for (const double off : {-1.0, -0.5, 0.0, 0.5, 1.0})
        {
            const Pool pool(level, 50);
            std::vector<double> phi(pool.grid.cells());
            for (int i = 0; i < pool.grid.cells(); ++i)
                phi[i] = pool.distance(i, level) + off*pool.grid.h;
            const std::vector<double> held = pool.held(phi);
            for (int i = 0; i < pool.grid.cells(); ++i)
                if (std::abs(pool.distance(i, level)) < 0.42*pool.grid.h)
                {
                    EXPECT_EQ(held[i], phi[i]) << level << ' ' << off;
                }
        }
}

} // namespace
} // namespace riprap

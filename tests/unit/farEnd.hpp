/*  What a scene reduces on its device against the same of all its particles on the host.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include "api/fluidScene.hpp"

namespace riprap
{

//- Sums along a direction of the particles no more than reach behind the first, ascending
inline std::vector<double> endOnHost(const std::vector<double>& x, const Vector3& n, double reach)
{
    std::vector<double> all;
    for (std::size_t i = 0; i < x.size(); i += 3)
        all.push_back(x[i]*n[0] + x[i + 1]*n[1] + x[i + 2]*n[2]);
    std::sort(all.begin(), all.end());
    std::vector<double> end;
    for (const double s : all) if (s >= all.back() - reach) end.push_back(s);
    return end;
}

inline void expectFarEnds(FluidScene& scene, int dimensions, double density)
{
    const FluidState f = scene.fluid();
    std::vector<Vector3> directions{{{1, 0, 0}}, {{0, -1, 0}}, {{-0.6, 0.8, 0}}};
    if (dimensions == 3) directions.push_back({{0.36, 0.48, -0.8}});
    for (const Vector3& n : directions)
        for (const double reach : {0.0, 0.0371, 0.2113, 30.0})
        {
            const FluidEnd end = scene.farEnd(n, reach);
            EXPECT_EQ(end.particles, f.id.size());
            const std::vector<double> known = endOnHost(f.position, n, reach),
                                      found = endOnHost(end.position, n, 100);
            ASSERT_EQ(found.size(), known.size())
                << reach << " behind the first along " << n[0] << ' ' << n[1] << ' ' << n[2];
            for (std::size_t k = 0; k < known.size(); ++k) ASSERT_NEAR(found[k], known[k], 1e-13);
        }

    FluidExtremes host;
    for (std::size_t i = 0; i < f.id.size(); ++i)
    {
        host.speed = std::max(host.speed,
            std::hypot(
                std::hypot(f.velocity[3*i], f.velocity[3*i + 1]), f.velocity[3*i + 2]));
        host.densityDeviation = std::max(host.densityDeviation, std::abs(f.density[i]/density - 1));
    }
    const FluidExtremes device = scene.extremes();
    EXPECT_GT(host.speed, 0);
    EXPECT_NEAR(device.speed, host.speed, 1e-12*host.speed);
    EXPECT_NEAR(device.densityDeviation, host.densityDeviation, 1e-12);
}

} // namespace riprap

/*  What tests of DEM scenes share: they run on each device and in each precision; without a GPU
    those of the GPU are skipped.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cmath>
#include <random>
#include <gtest/gtest.h>
#include "core/backend/device.hpp"
#include "api/demScene.hpp"

namespace riprap
{
namespace
{

constexpr double pi = 3.14159265358979323846;

struct DemCase { DeviceKind device; PrecisionKind precision; };

class DemTest : public testing::TestWithParam<DemCase>
{
protected:
    void SetUp() override
    {
        std::string why;
        if (GetParam().device == DeviceKind::gpu && !gpuCount(why)) GTEST_SKIP() << why;
    }

    bool mixed() const { return GetParam().precision == PrecisionKind::mixed; }

    //- A box of side 1 about the origin, elastic linear contacts of stiffness 1e4 between spheres
    //  of one material
    DemConfig config(int dimensions) const
    {
        DemConfig c;
        c.dimensions = dimensions;
        c.device = GetParam().device;
        c.precision = GetParam().precision;
        c.domainMin = Vector3{{-0.5, -0.5, -0.5}};
        c.domainMax = Vector3{{0.5, 0.5, 0.5}};
        c.normal = "linear";
        c.tangential = "none";
        c.stepFraction = 0.02;
        return c;
    }
};

inline std::string demCaseName(const testing::TestParamInfo<DemCase>& info)
{
    return std::string(info.param.device == DeviceKind::gpu ? "Gpu" : "Cpu")
      + (info.param.precision == PrecisionKind::mixed ? "Mixed" : "Double");
}

inline DemInput oneMaterial(double stiffness = 1e4)
{
    DemInput in;
    in.materials.push_back(DemMaterial{"stone", 1e7, 0.25});
    DemPair p;
    p.properties.normalStiffness = stiffness;
    in.pairs.push_back(p);
    return in;
}

inline void addParticle(
    DemInput& in, Vector3 x, Vector3 v = {{0, 0, 0}}, double radius = 0.01, double mass = 0.01)
{
    DemParticles& p = in.particles;
    p.position.insert(p.position.end(), x.begin(), x.end());
    p.velocity.insert(p.velocity.end(), v.begin(), v.end());
    p.spin.insert(p.spin.end(), 3, 0.0);
    p.radius.push_back(radius);
    p.mass.push_back(mass);
}

inline DemWall planeWall(Vector3 point, Vector3 normal)
{
    DemWall w;
    w.name = "plane";
    w.plane = true;
    w.point = point;
    w.normal = normal;
    return w;
}

//- Where particle `id` is in a state
inline std::size_t find(const DemState& s, std::int32_t id)
{
    for (std::size_t i = 0; i < s.id.size(); ++i) if (s.id[i] == id) return i;
    throw std::runtime_error("no such particle");
}

inline Vector3 at(const std::vector<double>& v, std::size_t i)
{
    return Vector3{{v[3*i], v[3*i + 1], v[3*i + 2]}};
}

//- Six walls of the box of side 1 (four in 2D)
inline void addBox(DemInput& in, int dimensions, double half = 0.45)
{
    for (int d = 0; d < dimensions; ++d)
        for (const double side : {-1.0, 1.0})
        {
            Vector3 x{{0, 0, 0}}, n{{0, 0, 0}};
            x[d] = side*half;
            n[d] = -side;
            in.walls.push_back(planeWall(x, n));
        }
}

#define RIPRAP_DEM_CASES(suite) \
    INSTANTIATE_TEST_SUITE_P(Dem, suite, \
        testing::Values(DemCase{DeviceKind::cpu, PrecisionKind::mixed}, \
            DemCase{DeviceKind::cpu, PrecisionKind::doubled}, \
            DemCase{DeviceKind::gpu, PrecisionKind::mixed}, \
            DemCase{DeviceKind::gpu, PrecisionKind::doubled}), \
        demCaseName)

} // namespace
} // namespace riprap

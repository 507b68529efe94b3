/*  What tests through the facade share: one test for each device, dimension and precision, and
    small scenes to start from.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <numeric>
#include <random>
#include <string>
#include <gtest/gtest.h>
#include "core/backend/device.hpp"
#include "api/sphScene.hpp"

namespace riprap
{

struct Setup
{
    DeviceKind device;
    int dimensions;
    PrecisionKind precision;
    bool mixed() const { return precision == PrecisionKind::mixed; }
};

inline void PrintTo(const Setup& s, std::ostream* out)
{
    *out << (s.device == DeviceKind::gpu ? "Gpu" : "Cpu") << s.dimensions
        << (s.mixed() ? "Mixed" : "Double");
}

inline std::vector<Setup> setups(const std::vector<int>& dimensions)
{
    std::vector<Setup> r;
    for (const DeviceKind device : {DeviceKind::cpu, DeviceKind::gpu})
        for (const int d : dimensions)
            for (const PrecisionKind p : {PrecisionKind::mixed, PrecisionKind::doubled})
                r.push_back(Setup{device, d, p});
    return r;
}

inline std::string setupName(const testing::TestParamInfo<Setup>& info)
{
    return testing::PrintToString(info.param);
}

//- One particle of water
inline FluidInput oneParticle(int dimensions, const Vector3& x, const Vector3& v)
{
    FluidInput f;
    f.position.assign(x.begin(), x.end());
    f.velocity.assign(v.begin(), v.end());
    if (dimensions == 2) f.position[2] = f.velocity[2] = 0;
    f.density.push_back(1000);
    return f;
}

//- Every device, 2D and 3D (or 2D alone, where the third dimension adds nothing), both precisions
#define RIPRAP_ALL_SETUPS(suite) \
    INSTANTIATE_TEST_SUITE_P(, suite, testing::ValuesIn(setups({2, 3})), setupName)
#define RIPRAP_PLANE_SETUPS(suite) \
    INSTANTIATE_TEST_SUITE_P(, suite, testing::ValuesIn(setups({2})), setupName)

class SceneTest : public testing::TestWithParam<Setup>
{
protected:

    void SetUp() override
    {
        std::string why;
        if (GetParam().device == DeviceKind::gpu && !gpuCount(why)) GTEST_SKIP() << why;
    }

    int D() const { return GetParam().dimensions; }
    bool mixed() const { return GetParam().mixed(); }

    //- A unit box of inviscid fluid without gravity; 20 spacings a side
    SphConfig config() const
    {
        SphConfig c;
        c.dimensions = D();
        c.device = GetParam().device;
        c.precision = GetParam().precision;
        c.spacing = 0.05;
        c.soundSpeed = 20;
        c.maxVelocity = 2;
        c.integrator = "leapfrog";
        c.viscosityModel = "none";
        c.diffusion = "none";
        return c;
    }

    std::unique_ptr<SphScene> scene(
        const SphConfig& c, const FluidInput& f, const WallInput& w = {}, WallMotion m = {}) const
    { return createSphScene(c, f, w, std::move(m)); }

    //- Half a unit in the last place of what pairs are computed in
    double epsilon() const { return mixed() ? 6e-8 : 1.1e-16; }
};

//- A square (cubic) lattice of particles at rest, each in the centre of its own dp^D, filling
//  [lower, upper]
inline FluidInput lattice(const SphConfig& c, const Vector3& lower, const Vector3& upper)
{
    FluidInput f;
    int n[3] = {1, 1, 1};
    for (int d = 0; d < c.dimensions; ++d)
        n[c.axes[d]] = int(std::lround((upper[c.axes[d]] - lower[c.axes[d]])/c.spacing));
    for (int k = 0; k < n[2]; ++k)
        for (int j = 0; j < n[1]; ++j)
            for (int i = 0; i < n[0]; ++i)
            {
                const int index[3] = {i, j, k};
                for (int d = 0; d < 3; ++d)
                    f.position.push_back(
                        n[d] == 1 ? lower[d] : lower[d] + (index[d] + 0.5)*c.spacing);
                f.density.push_back(c.density);
            }
    f.velocity.assign(f.position.size(), 0.0);
    return f;
}

inline double uniform(std::mt19937& engine, double low, double high)
{
    return low + (high - low)*(engine()/4294967296.0);
}

//- Particles off their lattice points by up to `shift` spacings, with random velocities and
//  densities
inline void disturb(const SphConfig& c, FluidInput& f, double shift, double speed, double deviation,
    unsigned seed = 1)
{
    std::mt19937 engine(seed);
    for (std::size_t i = 0; i < f.size(); ++i)
    {
        for (int d = 0; d < c.dimensions; ++d)
        {
            f.position[3*i + c.axes[d]] += c.spacing*uniform(engine, -shift, shift);
            f.velocity[3*i + c.axes[d]] = uniform(engine, -speed, speed);
        }
        f.density[i] = c.density*(1 + uniform(engine, -deviation, deviation));
    }
}

//- Layers of wall points under the plane x_axis = level, normal along +axis
inline WallInput floorOf(const SphConfig& c, int axis, double level, int layers)
{
    SphConfig points = c;
    points.spacing = c.wallSpacing;
    Vector3 lower = c.domainMin, upper = c.domainMax;
    if (c.dimensions == 2) lower[c.axes[2]] = upper[c.axes[2]] = 0;
    upper[axis] = level;
    lower[axis] = level - layers*c.wallSpacing;
    WallInput w;
    w.position = lattice(points, lower, upper).position;
    w.normal.assign(w.position.size(), 0.0);
    for (std::size_t i = 0; i < w.size(); ++i) w.normal[3*i + axis] = 1;
    return w;
}

inline void append(WallInput& w, const WallInput& more)
{
    w.position.insert(w.position.end(), more.position.begin(), more.position.end());
    w.normal.insert(w.normal.end(), more.normal.begin(), more.normal.end());
}

//- Largest magnitude of a component: what differences are relative to
inline double largest(const std::vector<Vector3>& v)
{
    double m = 0;
    for (const Vector3& a : v) for (const double x : a) m = std::max(m, std::abs(x));
    return m;
}

inline double largest(const std::vector<double>& v)
{
    double m = 0;
    for (const double x : v) m = std::max(m, std::abs(x));
    return m;
}

//- Order of the particles of a state by id
inline std::vector<std::size_t> byId(const FluidState& s)
{
    std::vector<std::size_t> order(s.id.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
        [&](std::size_t a, std::size_t b) { return s.id[a] < s.id[b]; });
    return order;
}

//- Every number equal, bit for bit
inline void expectSameBits(const FluidState& a, const FluidState& b)
{
    EXPECT_EQ(a.id, b.id);
    const auto same = [](const std::vector<double>& x, const std::vector<double>& y)
    {
        return x.size() == y.size()
            && (x.empty() || !std::memcmp(x.data(), y.data(), x.size()*sizeof(double)));
    };
    EXPECT_TRUE(same(a.position, b.position));
    EXPECT_TRUE(same(a.velocity, b.velocity));
    EXPECT_TRUE(same(a.density, b.density));
    EXPECT_TRUE(same(a.pressure, b.pressure));
    EXPECT_TRUE(same(a.smoothingLength, b.smoothingLength));
}

//- What the last pass over the pairs gave, by id. Read from the end of the saved state: the fields
//  that arrays() lists (each there twice, as a double buffer), those of walls if they move, one
//  word of checksum
struct Derivatives
{
    std::vector<Vector3> acceleration, drift;
    std::vector<double> rate;               // drho/dt [kg/m3/s]
};

inline Derivatives derivatives(SphScene& scene, const SphConfig& c)
{
    const std::vector<std::int32_t> words = scene.saveState();
    const std::size_t n = scene.fluid().id.size();
    std::map<std::string, std::vector<double>> field;
    std::vector<ArrayInfo> fields = scene.arrays();
    const auto end = std::find_if(
        fields.begin(), fields.end(), [](const ArrayInfo& a) { return a.name == "records"; });
    std::size_t at = words.size() - 1;
    const bool moving = std::any_of(
        end, fields.end(), [](const ArrayInfo& a) { return a.name == "velocity.0"; });
    for (auto a = end; moving && a != fields.end(); ++a)
        if (a->set == "wall" && a->name != "records" && a->name != "cells" && a->name != "motion")
            at -= a->bytes/8;
    fields.erase(end, fields.end());
    for (const ArrayInfo& a : fields) at -= n*a.bytesPerParticle/8;
    for (const ArrayInfo& a : fields)
    {
        const std::size_t bytes = a.bytesPerParticle/2;
        std::vector<double>& v = field[a.name];
        for (std::size_t i = 0; i < n; ++i)
        {
            const char* p = reinterpret_cast<const char*>(&words[at]) + i*bytes;
            double value = 0;
            if (a.name == "id") { std::int32_t id; std::memcpy(&id, p, 4); value = id; }
            else if (bytes == 4) { float f; std::memcpy(&f, p, 4); value = f; }
            else std::memcpy(&value, p, 8);
            v.push_back(value);
        }
        at += n*bytes/4;
    }
    Derivatives r;
    r.acceleration.assign(n, Vector3{{0, 0, 0}});
    r.drift = r.acceleration;
    r.rate.assign(n, 0.0);
    const char* names[3] = {".x", ".y", ".z"};
    for (std::size_t i = 0; i < n; ++i)
    {
        const std::size_t id = std::size_t(field["id"][i]);
        for (int d = 0; d < c.dimensions; ++d)
        {
            r.acceleration[id][c.axes[d]] = field[std::string("acceleration") + names[d]][i];
            if (field.count(std::string("drift") + names[d]))
                r.drift[id][c.axes[d]] = field[std::string("drift") + names[d]][i];
        }
        r.rate[id] = c.density*field["densityRate"][i];
    }
    return r;
}

} // namespace riprap

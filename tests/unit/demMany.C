/*  DEM scenes of many particles: contacts against brute force (sizes from 1 to 10 as well), momentum and energy, the same bits for any
    number of threads, restart, settling.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <map>
#include <set>
#include <omp.h>
#include "demTest.hpp"

namespace riprap
{
namespace
{

using DemMany = DemTest;

//- n particles anywhere in a cube, radii between `small` and `large`, overlapping as they fall
DemInput cloud(int n, int dimensions, double small, double large, unsigned seed, double half = 0.4)
{
    DemInput in = oneMaterial();
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> u(-1, 1);
    for (int i = 0; i < n; ++i)
    {
        const double r = small*std::pow(large/small, 0.5*(u(engine) + 1));
        Vector3 x{{half*u(engine), half*u(engine), dimensions == 3 ? half*u(engine) : 0}};
        Vector3 v{{0.2*u(engine), 0.2*u(engine), dimensions == 3 ? 0.2*u(engine) : 0}};
        addParticle(in, x, v, r, 1e4*r*r*r);
    }
    return in;
}

std::set<std::pair<int, int>> touching(const DemConfig& c, const DemState& s)
{
    std::set<std::pair<int, int>> r;
    for (std::size_t i = 0; i < s.id.size(); ++i)
        for (std::size_t j = i + 1; j < s.id.size(); ++j)
        {
            double d2 = 0;
            for (int d = 0; d < c.dimensions; ++d)
            {
                double dx = s.position[3*i + d] - s.position[3*j + d];
                const double length = c.domainMax[d] - c.domainMin[d];
                if (c.periodic[d]) dx -= length*std::round(dx/length);
                d2 += dx*dx;
            }
            const double reach = s.radius[i] + s.radius[j];
            // what touches by less than rounding may be seen either way
            if (std::sqrt(d2) < reach - 1e-6) r.insert(std::minmax(s.id[i], s.id[j]));
        }
    return r;
}

TEST_P(DemMany, FindsEveryContact)
{
    for (const int D : {2, 3})
        for (const double ratio : {1.0, 3.0, 10.0})
            for (const bool periodic : {false, true})
            {
                DemConfig c = config(D);
                c.stepFraction = 0.01;
                for (int d = 0; d < D; ++d) c.periodic[d] = periodic;
                const double large = D == 2 ? 0.05 : 0.09;
                DemInput in = cloud(D == 2 ? 300 : 400, D, large/ratio, large, 11, periodic ? 0.5 : 0.4);
                auto scene = createDemScene(c, in);
                for (int k = 0; k < 3; ++k)
                {
                    const DemReport r = scene->advance(1e9, 40);
                    ASSERT_EQ(r.stop, DemStop::none) << r.stopMessage;
                    const DemState s = scene->particles();
                    const DemContacts found = scene->contacts();
                    std::set<std::pair<int, int>> pairs;
                    for (std::size_t q = 0; q < found.a.size(); ++q)
                        EXPECT_TRUE(pairs.insert(std::minmax(found.a[q], found.b[q])).second) << "twice";
                    const auto expected = touching(c, s);
                    EXPECT_GT(expected.size(), 20u);
                    for (const auto& p : expected) EXPECT_TRUE(pairs.count(p)) << D << " " << ratio << " " << periodic;
                    EXPECT_LE(pairs.size(), expected.size() + 2);
                }
            }
}

//- Nothing from outside: linear momentum stays, with friction and damping; an elastic cloud keeps its energy
TEST_P(DemMany, MomentumAndEnergy)
{
    for (const int D : {2, 3})
        for (const bool rough : {false, true})
        {
            DemConfig c = config(D);
            for (int d = 0; d < D; ++d) c.periodic[d] = true;
            c.stepFraction = 0.01;
            DemInput in = cloud(200, D, 0.03, 0.03, 5, 0.5);
            if (rough)
            {
                c.tangential = TangentialKind::history;
                c.rolling = RollingKind::spring;
                in.pairs[0].properties.friction = 0.5;
                in.pairs[0].properties.restitution = 0.6;
                in.pairs[0].properties.rollingFriction = 0.1;
            }
            auto scene = createDemScene(c, in);
            const auto momentum = [&]
            {
                const DemState s = scene->particles();
                Vector3 p{{0, 0, 0}};
                for (std::size_t i = 0; i < s.id.size(); ++i) for (int d = 0; d < D; ++d) p[d] += s.mass[i]*s.velocity[3*i + d];
                return p;
            };
            const Vector3 before = momentum();
            const DemEnergy first = scene->energy();
            scene->advance(1e9, 500);
            const DemEnergy last = scene->energy();
            const double scale = std::sqrt(2*last.total()*200*0.27);
            for (int d = 0; d < D; ++d) EXPECT_NEAR(momentum()[d], before[d], (mixed() ? 1e-5 : 1e-13)*scale);
            if (!rough) EXPECT_NEAR(last.total(), first.total(), 1e-4*first.total());
            else EXPECT_LT(last.total(), first.total());
        }
}

//- A scene with everything: walls, friction, rolling, bonds, a clump, prescribed particles
DemInput everything(DemConfig& c, int D)
{
    c.gravity = Vector3{{0, -9.81, 0}};
    c.normal = NormalKind::hertz;
    c.tangential = TangentialKind::history;
    c.rolling = RollingKind::spring;
    c.orientation = true;
    DemInput in = cloud(120, D, 0.02, 0.04, 3, 0.3);
    in.materials[0].young = 1e6;
    PairProperties& p = in.pairs[0].properties;
    p.friction = 0.4;
    p.restitution = 0.4;
    p.rollingFriction = 0.05;
    addBox(in, D, 0.38);
    in.walls[2].motion = 0;
    in.wallMotion = [](int, double t)
    {
        WallPose w;
        w.translation[1] = 0.02*std::sin(20*t);
        return w;
    };
    in.groups.resize(2);
    in.groups[1].motion = 0;
    in.groupMotion = [](int, double) { RigidMotion m; m.spin[2] = 3; return m; };
    in.particles.group.assign(120, 0);
    in.particles.group[7] = 1;
    DemBondType t;
    t.normalStiffness = t.shearStiffness = 1e7;
    t.tensileStrength = 2e4;
    in.bondTypes.push_back(t);
    in.bonds.a = {1, 2, 3};
    in.bonds.b = {2, 3, 4};
    for (int k = 1; k < 5; ++k)
        for (int d = 0; d < 3; ++d) in.particles.position[3*k + d] = d == 0 ? -0.2 + 0.07*k : (d == 1 ? 0.3 : 0);
    DemClump body;
    body.position = Vector3{{0.1, 0.25, 0}};
    body.mass = 0.3;
    body.inertia = Vector3{{1e-4, 3e-4, 2e-4}};
    in.clumps.push_back(body);
    in.particles.clump.assign(120, -1);
    for (const int k : {10, 11})
    {
        in.particles.clump[k] = 0;
        for (int d = 0; d < 3; ++d) in.particles.position[3*k + d] = body.position[d] + (d == 0 ? 0.02*(2*k - 21) : 0);
    }
    return in;
}

std::vector<double> fingerprint(DemScene& scene)
{
    const DemState s = scene.particles();
    std::vector<double> r;
    std::map<std::int32_t, std::size_t> order;
    for (std::size_t i = 0; i < s.id.size(); ++i) order[s.id[i]] = i;
    for (const auto& o : order)
    {
        for (int d = 0; d < 3; ++d)
        {
            r.push_back(s.position[3*o.second + d]);
            r.push_back(s.velocity[3*o.second + d]);
            r.push_back(s.spin[3*o.second + d]);
            r.push_back(s.force[3*o.second + d]);
        }
        for (int k = 0; k < 4; ++k) r.push_back(s.orientation[4*o.second + k]);
    }
    return r;
}

//- A run that is saved and loaded goes on as the one that was not, bit for bit
TEST_P(DemMany, RestartIsExact)
{
    for (const int D : {2, 3})
    {
        DemConfig c = config(D);
        c.stepFraction = 0.1;
        DemInput in = everything(c, D);
        auto scene = createDemScene(c, in);
        DemReport r = scene->advance(1e9, 333);
        ASSERT_EQ(r.stop, DemStop::none) << r.stopMessage;
        const std::vector<std::int32_t> saved = scene->saveState();
        auto other = createDemScene(c, in);
        other->loadState(saved);
        EXPECT_EQ(fingerprint(*scene), fingerprint(*other));
        for (int k = 0; k < 2; ++k)
        {
            r = scene->advance(1e9, 400);
            ASSERT_EQ(r.stop, DemStop::none) << r.stopMessage;
            other->advance(1e9, 400);
            EXPECT_EQ(scene->time(), other->time());
            ASSERT_EQ(fingerprint(*scene), fingerprint(*other)) << D << "D, part " << k;
            EXPECT_EQ(scene->bonds().broken, other->bonds().broken);
        }
        std::vector<std::int32_t> bad = saved;
        bad[bad.size()/2] ^= 1;
        EXPECT_THROW(other->loadState(bad), std::invalid_argument);
    }
}

//- As many threads as one likes, the same bits: enough particles for several blocks
TEST_P(DemMany, ThreadsDoNotMatter)
{
    if (GetParam().device == DeviceKind::gpu) GTEST_SKIP() << "threads are the CPU's";
    DemConfig c = config(3);
    c.tangential = TangentialKind::history;
    for (int d = 0; d < 3; ++d) c.periodic[d] = true;
    DemInput in = cloud(9000, 3, 0.022, 0.022, 9, 0.5);
    in.pairs[0].properties.friction = 0.5;
    in.pairs[0].properties.restitution = 0.8;
    std::vector<std::vector<double>> v;
    const int before = omp_get_max_threads();
    for (int threads = 1; threads <= 3; ++threads)
    {
        omp_set_num_threads(threads);
        auto scene = createDemScene(c, in);
        scene->advance(1e9, 60);
        v.push_back(scene->particles().position);
    }
    omp_set_num_threads(before);
    EXPECT_EQ(v[0], v[1]);
    EXPECT_EQ(v[0], v[2]);
}

RIPRAP_DEM_CASES(DemMany);

} // namespace
} // namespace riprap

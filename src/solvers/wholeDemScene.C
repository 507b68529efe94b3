/*  wholeDemScene: a scene on several processes, seen as one.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "core/ranks/joinRanks.hpp"
#include "api/wholeDemScene.hpp"

namespace riprap
{

namespace
{

class WholeDemScene : public DemScene
{
public:

    WholeDemScene(DemScene& part, Transport& ranks) : part_(part), ranks_(ranks) {}

    DemReport advance(double t, std::int64_t maxSteps) override
    {
        report_ = part_.advance(t, maxSteps);
        join(ranks_, report_.escapedId);
        join(ranks_, report_.escaped);
        const auto byId = orderBy(report_.escapedId.size(),
            [&](std::size_t a, std::size_t b)
            { return report_.escapedId[a] < report_.escapedId[b]; });
        arrange(report_.escapedId, 1, byId);
        arrange(report_.escaped, 1, byId);
        std::vector<std::int64_t> passed(1, std::int64_t(report_.passedWalls));
        ranks_.sum(passed);
        std::vector<double> one(1, report_.passedId);
        ranks_.largest(one);
        report_.passedWalls = std::size_t(passed[0]);
        report_.passedId = std::int32_t(one[0]);
        return report_;
    }

    void interrupt() override { part_.interrupt(); }
    double time() const override { return part_.time(); }
    const DemReport& lastReport() const override { return report_; }

    DemState particles() override { return whole(part_.particles()); }
    DemState motion() override { return whole(part_.motion()); }

    DemContacts contacts() override
    {
        DemContacts c = part_.contacts();
        for (auto* v : {&c.a, &c.b}) join(ranks_, *v);
        for (auto* v : {&c.point, &c.force, &c.overlap}) join(ranks_, *v);
        // the order of pairs that have two is that of the rank that has them
        const auto order = orderBy(c.a.size(),
            [&](std::size_t k, std::size_t l) {
                return c.a[k] != c.a[l] ? c.a[k] < c.a[l]
                    : c.b[k] != c.b[l] ? c.b[k] < c.b[l]
                                        : k < l;
            });
        for (auto* v : {&c.a, &c.b}) arrange(*v, 1, order);
        for (auto* v : {&c.point, &c.force}) arrange(*v, 3, order);
        arrange(c.overlap, 1, order);
        return c;
    }

    DemBondState bonds() override
    {
        DemBondState s = part_.bonds();
        join(ranks_, s.number);
        const auto order = orderBy(s.number.size(),
            [&](std::size_t k, std::size_t l) { return s.number[k] < s.number[l]; });
        arrange(s.number, 1, order);
        const auto whole = [&](auto& values, std::size_t each)
        {
            join(ranks_, values);
            arrange(values, each, order);
        };
        for (auto* v : {&s.a, &s.b, &s.type, &s.broken}) whole(*v, 1);
        for (auto* v : {&s.force, &s.moment}) whole(*v, 3);
        for (auto* v : {&s.gap, &s.restGap}) whole(*v, 1);
        return s;
    }

    DemClumpState clumps() override { return part_.clumps(); }
    std::vector<DemSpringState> springs() override { return part_.springs(); }

    DemEnergy energy() override
    {
        const DemEnergy here = part_.energy();
        std::vector<double> v{
            here.translation, here.rotation, here.potential, here.contact, here.bond, here.spring};
        addByRank(ranks_, v);
        return DemEnergy{v[0], v[1], v[2], v[3], v[4], v[5]};
    }

    DemGroupSums groupSums(int group) override
    {
        const DemGroupSums here = part_.groupSums(group);
        std::vector<double> sums{here.particles, here.mass}, most;
        for (const Vector3& v : {here.massPosition, here.momentum})
            sums.insert(sums.end(), v.begin(), v.end());
        // a rank without any of them says nothing
        for (int d = 0; d < 3; ++d) most.push_back(here.particles ? here.max[d] : -1e300);
        for (int d = 0; d < 3; ++d) most.push_back(here.particles ? -here.min[d] : -1e300);
        addByRank(ranks_, sums);
        ranks_.largest(most);
        DemGroupSums r;
        r.particles = sums[0];
        r.mass = sums[1];
        for (int d = 0; d < 3; ++d)
        {
            r.massPosition[d] = sums[2 + d];
            r.momentum[d] = sums[5 + d];
            if (!r.particles) continue;
            r.max[d] = most[d];
            r.min[d] = -most[3 + d];
        }
        return r;
    }

    DemMomentum momentum() override
    {
        const DemMomentum here = part_.momentum();
        std::vector<double> v(here.linear.begin(), here.linear.end());
        v.insert(v.end(), here.angular.begin(), here.angular.end());
        addByRank(ranks_, v);
        return DemMomentum{{{v[0], v[1], v[2]}}, {{v[3], v[4], v[5]}}};
    }

    double deepestOverlap() override
    {
        std::vector<double> v(1, part_.deepestOverlap());
        ranks_.largest(v);
        return v[0];
    }

    std::vector<DemWallForce> wallForces() override
    {
        std::vector<DemWallForce> walls = part_.wallForces();
        std::vector<double> v;
        const auto each = [&](const auto& f)
        {
            for (DemWallForce& w : walls)
                for (Vector3* x : {&w.force, &w.moment, &w.normal, &w.normalMoment})
                    for (double& c : *x) f(c);
        };
        each([&](double& c) { v.push_back(c); });
        addByRank(ranks_, v);
        std::size_t k = 0;
        each([&](double& c) { c = v[k++]; });
        return walls;
    }

    void setExternalForces(
        const std::vector<double>& force, const std::vector<double>& moment) override
    {
        part_.setExternalForces(force, moment);
    }
    Later<std::vector<std::int32_t>> savedState(bool later) override
    {
        return part_.savedState(later);
    }
    void loadState(const std::vector<std::int32_t>& words) override { part_.loadState(words); }
    DemPlan plan() const override { return part_.plan(); }
    std::vector<ArrayInfo> arrays() const override { return part_.arrays(); }
    std::vector<KernelInfo> kernels() const override { return part_.kernels(); }
    void timeKernels(bool on) override { part_.timeKernels(on); }
    double neighboursPerParticle() override { return mean(part_.neighboursPerParticle()); }
    double contactsPerParticle() override { return mean(part_.contactsPerParticle()); }
    std::string deviceName() const override { return part_.deviceName(); }
    DeviceKind device() const override { return part_.device(); }

private:

    //- Of values of ranks, by their numbers of particles
    double mean(double value)
    {
        const double n = double(part_.motion().id.size());
        std::vector<double> v{n*value, n};
        addByRank(ranks_, v);
        return v[1] > 0 ? v[0]/v[1] : 0;
    }

    DemState whole(DemState s)
    {
        std::vector<std::vector<double>*> vectors{
            &s.position, &s.velocity, &s.spin, &s.force, &s.moment},
            scalars{&s.radius, &s.mass};
        std::vector<std::vector<std::int32_t>*> labels{
            &s.material, &s.group, &s.clump, &s.contacts, &s.brokenBonds};
        join(ranks_, s.id);
        const auto order = orderBy(
            s.id.size(), [&](std::size_t a, std::size_t b) { return s.id[a] < s.id[b]; });
        arrange(s.id, 1, order);
        for (auto* v : vectors) { join(ranks_, *v); arrange(*v, 3, order); }
        for (auto* v : scalars) { join(ranks_, *v); arrange(*v, 1, order); }
        for (auto* v : labels) { join(ranks_, *v); arrange(*v, 1, order); }
        join(ranks_, s.orientation);
        arrange(s.orientation, 4, order);
        return s;
    }

    DemScene& part_;
    Transport& ranks_;
    DemReport report_;
};

} // namespace

std::unique_ptr<DemScene> wholeDemScene(DemScene& part, Transport& ranks)
{
    return std::make_unique<WholeDemScene>(part, ranks);
}

} // namespace riprap

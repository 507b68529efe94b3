/*  wholeSphScene: a scene on several processes, seen as one.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "core/ranks/joinRanks.hpp"
#include "api/sphDemScene.hpp"
#include "api/wholeSphScene.hpp"

namespace riprap
{

namespace
{

class WholeSphScene : public SphScene
{
public:

    WholeSphScene(SphScene& part, Transport& ranks) : part_(part), ranks_(ranks) {}

    SphReport advance(double t, std::int64_t maxSteps) override
    {
        SphReport r = part_.advance(t, maxSteps);
        join(ranks_, r.escapedId);
        join(ranks_, r.escaped);
        join(ranks_, r.wild);
        const auto byId = orderBy(r.escapedId.size(),
            [&](std::size_t a, std::size_t b) { return r.escapedId[a] < r.escapedId[b]; });
        arrange(r.escapedId, 1, byId);
        arrange(r.escaped, 1, byId);
        std::sort(r.wild.begin(), r.wild.end(),
            [](const WildParticle& a, const WildParticle& b) { return a.id < b.id; });
        return r;
    }

    void interrupt() override { part_.interrupt(); }
    double time() const override { return part_.time(); }

    FluidState fluid() override
    {
        FluidState s = part_.fluid();
        join(ranks_, s.id);
        const auto byId = orderBy(
            s.id.size(), [&](std::size_t a, std::size_t b) { return s.id[a] < s.id[b]; });
        arrange(s.id, 1, byId);
        for (auto* v : {&s.position, &s.velocity}) { join(ranks_, *v); arrange(*v, 3, byId); }
        for (auto* v : {&s.density, &s.pressure, &s.smoothingLength})
        {
            join(ranks_, *v);
            arrange(*v, 1, byId);
        }
        return s;
    }

    WallState walls() override
    {
        WallState s = part_.walls();
        addByRank(ranks_, s.pressure);
        return s;
    }

    SphEnergy energy() override
    {
        const SphEnergy e = part_.energy();
        std::vector<double> v{e.kinetic, e.potential, e.elastic, e.wallWork, e.wallPressureWork,
            e.faceWork, e.stiffening};
        addByRank(ranks_, v);
        return SphEnergy{v[0], v[1], v[2], v[3], v[4], v[5], v[6]};
    }

    FluidExtremes extremes() override
    {
        const FluidExtremes e = part_.extremes();
        return FluidExtremes{
            largestOfRanks(ranks_, e.speed), largestOfRanks(ranks_, e.densityDeviation)};
    }

    FluidEnd farEnd(const Vector3& direction, double reach) override
    {
        FluidEnd end = part_.farEnd(direction, reach);
        end.particles = std::size_t(sum({std::int64_t(end.particles)})[0]);
        join(ranks_, end.position);
        return end;
    }

    std::vector<Vector3> wallForces() override
    {
        std::vector<Vector3> forces = part_.wallForces();
        std::vector<double> v;
        for (const Vector3& f : forces) v.insert(v.end(), f.begin(), f.end());
        addByRank(ranks_, v);
        for (std::size_t b = 0; b < forces.size(); ++b) std::copy_n(&v[3*b], 3, forces[b].begin());
        return forces;
    }

    std::vector<FluidForce> forcesOnWalls() override
    {
        std::vector<FluidForce> all = part_.forcesOnWalls();
        join(ranks_, all);
        return all;
    }

    std::vector<FluidForce> forcesOnSolids() override { return part_.forcesOnSolids(); }

    FaceContacts faceContacts() override
    {
        FaceContacts c = part_.faceContacts();
        const std::vector<std::int64_t> counts = sum({c.count, c.atBodies});
        std::vector<double> impulse(c.impulse.begin(), c.impulse.end());
        addByRank(ranks_, impulse);
        c.count = counts[0];
        c.atBodies = counts[1];
        std::copy_n(impulse.begin(), 3, c.impulse.begin());
        return c;
    }

    using FluidScene::sample;
    SampleResult sample(const std::vector<double>& points, const SightPlanes& planes) override
    {
        // each process may ask for places of its own: the cells that it has
        std::vector<double> all(points);
        join(ranks_, all);
        SightPlanes sight(planes);
        joinPlanes(sight, points.size()/3);
        SampleResult r = part_.sample(all, sight);
        std::vector<std::int64_t> before(ranks_.size() + 1, 0);
        for (int rank = ranks_.rank(); rank < ranks_.size(); ++rank)
            before[rank + 1] = std::int64_t(points.size()/3);
        const std::size_t first = std::size_t(sum(before)[ranks_.rank()]);
        for (auto* v : {&r.volumeFraction, &r.pressure, &r.velocity, &r.centroid})
        {
            addByRank(ranks_, *v);
            const std::size_t each = all.empty() ? 0 : 3*v->size()/all.size();
            *v = std::vector<double>(
                v->begin() + each*first, v->begin() + each*(first + points.size()/3));
        }
        return r;
    }

    Later<std::vector<std::int32_t>> savedState(bool later) override
    {
        return part_.savedState(later);
    }
    void loadState(const std::vector<std::int32_t>& words) override { part_.loadState(words); }

    std::array<std::size_t, speedClasses> fasterThan(
        const std::array<double, speedClasses>& speeds) override
    {
        std::array<std::size_t, speedClasses> counts = part_.fasterThan(speeds);
        const std::vector<std::int64_t> all = sum(
            std::vector<std::int64_t>(counts.begin(), counts.end()));
        std::copy(all.begin(), all.end(), counts.begin());
        return counts;
    }

    void setMaxVelocity(double maxVelocity, double soundSpeed) override
    {
        part_.setMaxVelocity(maxVelocity, soundSpeed);
    }
    double estimateTimeStep(std::string& limit) override { return part_.estimateTimeStep(limit); }
    std::vector<ArrayInfo> arrays() const override { return part_.arrays(); }
    std::vector<KernelInfo> kernels() const override { return part_.kernels(); }
    void timeKernels(bool on) override { part_.timeKernels(on); }

    NeighbourCounts countNeighbours() override
    {
        const NeighbourCounts c = part_.countNeighbours();
        const std::vector<std::int64_t> v = sum(
            {c.particles, c.fluid, c.walls, c.solids, c.aboutWalls, c.aboutSolids});
        return NeighbourCounts{v[0], v[1], v[2], v[3], v[4], v[5]};
    }

    double neighboursPerParticle() override
    {
        const NeighbourCounts c = countNeighbours();
        return c.particles ? double(c.fluid + c.walls)/double(c.particles) : 0;
    }

    std::string deviceName() const override { return part_.deviceName(); }
    DeviceKind device() const override { return part_.device(); }
    // each process has all of them
    DemScene* solids() override { return part_.solids(); }
    CouplingState coupling() override { return part_.coupling(); }

private:

    std::vector<std::int64_t> sum(std::vector<std::int64_t> v)
    {
        ranks_.sum(v);
        return v;
    }

    //- Those of all processes, if any has some
    void joinPlanes(SightPlanes& p, std::size_t points)
    {
        std::vector<std::int32_t> counts(points, 0);
        for (std::size_t i = 0; i + 1 < p.first.size(); ++i)
            counts[i] = p.first[i + 1] - p.first[i];
        join(ranks_, counts);
        join(ranks_, p.normal);
        join(ranks_, p.depth);
        p.first.assign(p.depth.empty() ? 0 : 1, 0);
        if (!p.depth.empty())
            for (const std::int32_t n : counts) p.first.push_back(p.first.back() + n);
    }

    SphScene& part_;
    Transport& ranks_;
};

} // namespace

std::unique_ptr<SphScene> wholeSphScene(SphScene& part, Transport& ranks)
{
    return std::make_unique<WholeSphScene>(part, ranks);
}

} // namespace riprap

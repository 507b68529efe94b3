/*  wholePicScene: a scene on several processes, seen as one.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "core/ranks/joinRanks.hpp"
#include "api/wholePicScene.hpp"

namespace riprap
{

namespace
{

//- Reports, energies, extremes, the grid and samples are those of all processes in the part already
class WholePicScene : public PicScene
{
public:

    WholePicScene(PicScene& part, Transport& ranks) : part_(part), ranks_(ranks) {}

    PicReport advance(double t, std::int64_t maxSteps) override
    {
        return part_.advance(t, maxSteps);
    }
    void interrupt() override { part_.interrupt(); }
    double time() const override { return part_.time(); }

    FluidState fluid() override
    {
        FluidState s = part_.fluid();
        join(ranks_, s.id);
        const auto order = orderBy(
            s.id.size(), [&](std::size_t a, std::size_t b) { return s.id[a] < s.id[b]; });
        arrange(s.id, 1, order);
        for (auto* v : {&s.position, &s.velocity}) { join(ranks_, *v); arrange(*v, 3, order); }
        for (auto* v : {&s.density, &s.pressure, &s.smoothingLength})
        {
            join(ranks_, *v);
            arrange(*v, 1, order);
        }
        return s;
    }

    PicGridState grid() override { return part_.grid(); }
    FluidEnergy energy() override { return part_.energy(); }
    FluidExtremes extremes() override { return part_.extremes(); }

    FluidEnd farEnd(const Vector3& direction, double reach) override
    {
        FluidEnd end = part_.farEnd(direction, reach);
        std::vector<std::int64_t> particles{std::int64_t(end.particles)};
        ranks_.sum(particles);
        end.particles = std::size_t(particles[0]);
        join(ranks_, end.position);
        return end;
    }

    std::vector<FluidForce> forcesOnWalls() override { return part_.forcesOnWallsOfAll(); }
    std::vector<FluidForce> forcesOnWallsOfAll() override { return part_.forcesOnWallsOfAll(); }
    //- Each process has all solids
    DemScene* solids() override { return part_.solids(); }
    Coupling coupling() override { return part_.coupling(); }
    std::vector<FluidForce> forcesOnSolids() override { return part_.forcesOnSolids(); }

    using FluidScene::sample;
    SampleResult sample(const std::vector<double>& points, const SightPlanes& planes) override
    {
        return part_.sample(points, planes);
    }

    void watchMomentum(bool on) override { part_.watchMomentum(on); }
    PicMomentum momentum() override { return part_.momentum(); }
    double particleSpacing() const override { return part_.particleSpacing(); }
    Later<std::vector<std::int32_t>> savedState(bool later) override
    {
        return part_.savedState(later);
    }
    void loadState(const std::vector<std::int32_t>& words) override { part_.loadState(words); }
    double estimateTimeStep(std::string& limit) override { return part_.estimateTimeStep(limit); }
    std::vector<ArrayInfo> arrays() const override { return part_.arrays(); }
    std::vector<KernelInfo> kernels() const override { return part_.kernels(); }
    void timeKernels(bool on) override { part_.timeKernels(on); }
    std::string deviceName() const override { return part_.deviceName(); }
    DeviceKind device() const override { return part_.device(); }

private:

    PicScene& part_;
    Transport& ranks_;
};

} // namespace

std::unique_ptr<PicScene> wholePicScene(PicScene& part, Transport& ranks)
{
    return std::make_unique<WholePicScene>(part, ranks);
}

} // namespace riprap

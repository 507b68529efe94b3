/*  The DEM scene on one backend, in one dimension and precision. Declarations; the parts are in demSetup.hpp (construction), demBodies.hpp (rigid bodies),
    demStep.hpp (steps), demRanks.hpp (several processes), demSkin.hpp (how far neighbours are sought), demLists.hpp (rebuilds), demAdvance.hpp (the loop over steps), demWindow.hpp (prescribed motions), demSleep.hpp (who sleeps), demCoupling.hpp (driven by a fluid), demOutput.hpp (what is
    read back)
    and demState.hpp (save and load).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "coupling/solidView.hpp"
#include "solvers/dem/parts/demParts.hpp"
#include "solvers/dem/parts/demRebuild.hpp"
#include "solvers/dem/driver/contactForces.hpp"
#include "solvers/dem/driver/rankedSolids.hpp"
#include "solvers/dem/driver/neighbours.hpp"
#include "solvers/dem/driver/sleepers.hpp"
#include "solvers/dem/driver/solidStepper.hpp"
#include "solvers/dem/driver/sceneReports.hpp"
#include "solvers/dem/driver/sceneReadings.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class DemSolver : public DemScene, public SolidSide<D, P>, public LaunchOrder<Backend>
{
public:

    using real = typename P::real;
    using position = typename P::position;
    static constexpr int S = spins<D>;

    DemSolver(const DemConfig&, const DemInput&, const DemPlan&);

    DemReport advance(double t, std::int64_t maxSteps) override;
    void interrupt() override { p_.interrupted = true; }
    double time() const override { return p_.clock.now.time; }
    const DemReport& lastReport() const override { return reports_.last; }
    DemState particles() override { return readings_.particles(); }
    DemState motion() override { return readings_.motion(); }
    DemContacts contacts() override { return readings_.contacts(); }
    DemBondState bonds() override { return p_.bonds.state(p_.order.slotOf); }
    DemClumpState clumps() override { return readings_.clumps(); }
    std::vector<DemSpringState> springs() override { return p_.clumps.springs(); }
    DemEnergy energy() override { return readings_.energy(); }
    double deepestOverlap() override { return readings_.deepestOverlap(); }
    std::vector<DemWallForce> wallForces() override { return readings_.wallForces(); }
    void setExternalForces(const std::vector<double>& force, const std::vector<double>& moment) override;
    std::vector<std::int32_t> saveState() override;
    void loadState(const std::vector<std::int32_t>&) override;
    DemPlan plan() const override { return p_.set.plan; }
    std::vector<ArrayInfo> arrays() const override { return readings_.arrays(); }
    std::vector<KernelInfo> kernels() const override { return readings_.kernels(); }
    void timeKernels(bool on) override { p_.set.context.profile.timing = on; }
    double neighboursPerParticle() override { return readings_.neighboursPerParticle(); }
    double contactsPerParticle() override { return readings_.contactsPerParticle(); }
    std::string deviceName() const override;
    DeviceKind device() const override { return Backend::gpu ? DeviceKind::gpu : DeviceKind::cpu; }

    // demCoupling.hpp: what a fluid asks of its solids
    void follow(const Context<Backend>& fluid) override { p_.set.context.follow(fluid); }
    int keys() const override { return p_.particles.n; }
    SolidView<D, P> view() override { return SolidView<D, P>{p_.set.box, p_.particles.view(), p_.order.slotOf.data()}; }
    BodyView<D, P> bodies() override { return BodyView<D, P>{p_.clumps.data(), p_.groups.data(), p_.clumps.constraints(), p_.set.box, p_.clumps.count()}; }
    std::vector<std::int32_t> order() override;
    real* external() override;
    void measureSpeed() override;
    int subcycles(double dt) override;
    bool still() const override { return p_.still; }
    double kickTime(double dt, int subcycles) override;
    void push(double dt) override;
    bool advanceTo(double t, double dt, int subcycles) override;
    void beginReport() override;
    void endReport() override;

private:

    // demSetup.hpp
    void prime();

    // demCoupling.hpp
    double speedAtHand();

    // demStep.hpp

    // demFused.hpp

    // demSkin.hpp

    // demLists.hpp

    // demSleep.hpp

    // demRanks.hpp

    // demState.hpp
    bool isSaved(int field) const;
    int savedFields() const;
    std::vector<std::int32_t> stateWords();
    void takeState(const std::vector<std::int32_t>& words);
    std::vector<std::int32_t> wordsOfFirst(const std::vector<std::int32_t>& words) const;
    void collectAll();
    template<class F> void forEachMemory(F f);
    std::size_t historyTogether() const;
    std::size_t historyRows() const;
    void clearUnused(std::vector<std::int32_t>& words, std::size_t at, int n) const;
    void restoreSearch(const DemSearchState&);
    void restoreIds(const std::vector<std::int32_t>& ids);
    template<class Reader> void restoreNeighbours(Reader&, int entries, int wallEntries);

    // demAdvance.hpp

    // demOutput.hpp

    DemParts<Backend, D, P> p_;
    ContactForces<Backend, D, P> forces_{p_};
    RankedSolids<Backend, D, P> ranks_{p_};
    Neighbours<Backend, D, P> neighbours_{p_, forces_, ranks_};
    Sleepers<Backend, D, P> sleepers_{p_, forces_, neighbours_};
    SolidStepper<Backend, D, P> stepper_{p_, forces_, ranks_, neighbours_, sleepers_};
    SceneReports<Backend, D, P> reports_{p_, ranks_, neighbours_, sleepers_};
    SceneReadings<Backend, D, P> readings_{p_, forces_, ranks_};
    std::int64_t reportFrom_ = 0;           // step at which a coupled interval began
};

} // namespace riprap

/*  The DEM scene on one backend, in one dimension and precision. Declarations; the parts are in demSetup.hpp (construction), demBodies.hpp (rigid bodies),
    demStep.hpp (steps), demRanks.hpp (several processes), demSkin.hpp (how far neighbours are sought), demLists.hpp (rebuilds), demAdvance.hpp (the loop over steps), demWindow.hpp (prescribed motions), demSleep.hpp (who sleeps), demCoupling.hpp (driven by a fluid), demOutput.hpp (what is
    read back)
    and demState.hpp (save and load).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <atomic>
#include <map>
#include "core/neighbours/cellSort.hpp"
#include "core/ranks/particleExchange.hpp"
#include "core/backend/glances.hpp"
#include "core/backend/graph.hpp"
#include "core/loops/largest.hpp"
#include "coupling/solidView.hpp"
#include "dem/passes/fusedStep.hpp"
#include "dem/lists/likeWithLike.hpp"
#include "dem/passes/collectPass.hpp"
#include "dem/passes/sleep.hpp"
#include "dem/walls/moveWalls.hpp"
#include "dem/walls/wallPass.hpp"
#include "solvers/dem/parts/demBlockSteps.hpp"
#include "solvers/dem/parts/bonds.hpp"
#include "solvers/dem/parts/clumps.hpp"
#include "solvers/dem/parts/demRebuild.hpp"
#include "solvers/dem/parts/pairTable.hpp"
#include "solvers/dem/parts/particleFields.hpp"
#include "solvers/dem/parts/prescribedMotion.hpp"

namespace riprap
{

//- What only one backend has: for GPUs what fused steps and their rebuilds need
template<class Backend, int D, class P>
struct DemParts
{
    using real = typename P::real;

    SolidRecordMemory<Backend, D, P> records;       // the second ones
    Array<Backend, LowWords<P>> low;
    Array<Backend, OwnWords<real>> own;
    Array<Backend, int> place, found, foundNear, foundWalls, foundElements, cost;        // of particles in the order of cells
    Array<Backend, std::uint32_t> order;
    Array<Backend, int> nearCount, keptFirst, keptPartner, wallListFirst, wallList, totals;
    Array<Backend, real> keptHistory;
    LocalFrameMemory<Backend, D, P> frames;         // of fused steps
    int current = 0;                                // records and clock that the next step begins with
    Glances<Backend, DemClockData> glances;
    bool moved = false;                             // forces are not yet those of the positions at hand

#ifdef __CUDACC__
    LargestAhead speed;
    std::map<std::vector<const void*>, Graph> graphs;
#endif
};

#ifndef __CUDACC__
template<int D, class P>
struct DemParts<Cpu, D, P>
{
    DeferredForces<D, typename P::real> deferred;
    Array<Cpu, typename P::real> sums;
    bool uncollected = false;                       // forces are not yet in the fields
};
#endif

//- Memory of wall contacts
template<class Backend, class R>
struct WallMemoryArrays
{
    Array<Backend, int> entryFirst, elementFirst;
    Array<Backend, WallEntry> entry;
    Array<Backend, int> element, on;
    Array<Backend, R> normal, history, force;
    int entries = 0;

    std::size_t bytes() const
    {
        return entryFirst.bytes() + elementFirst.bytes() + entry.bytes() + element.bytes() + on.bytes() + normal.bytes()
          + history.bytes() + force.bytes();
    }
};

//- Of a saved state: in which cells particles were sought, and where
struct DemSearchState
{
    RadiusClasses radii;
    double skin = 0;                        // [m]
    double lower[3] = {}, length[3] = {};   // of the box [m]
};

template<class Backend, int D, class P>
class DemSolver : public DemScene, public SolidSide<D, P>, public LaunchOrder<Backend>
{
public:

    using real = typename P::real;
    using position = typename P::position;
    static constexpr int S = spins<D>;

    DemSolver(const DemConfig&, const DemInput&, const DemPlan&);

    DemReport advance(double t, std::int64_t maxSteps) override;
    void interrupt() override { interrupted_ = true; }
    double time() const override { return clock_.now.time; }
    const DemReport& lastReport() const override { return lastReport_; }
    DemState particles() override;
    DemState motion() override;
    DemContacts contacts() override;
    DemBondState bonds() override { return bonds_.state(slotOf_); }
    DemClumpState clumps() override;
    std::vector<DemSpringState> springs() override { return clumps_.springs(); }
    DemEnergy energy() override;
    double deepestOverlap() override;
    std::vector<DemWallForce> wallForces() override;
    void setExternalForces(const std::vector<double>& force, const std::vector<double>& moment) override;
    std::vector<std::int32_t> saveState() override;
    void loadState(const std::vector<std::int32_t>&) override;
    DemPlan plan() const override { return set_.plan; }
    std::vector<ArrayInfo> arrays() const override;
    std::vector<KernelInfo> kernels() const override;
    void timeKernels(bool on) override { set_.context.profile.timing = on; }
    double neighboursPerParticle() override;
    double contactsPerParticle() override;
    std::string deviceName() const override;
    DeviceKind device() const override { return Backend::gpu ? DeviceKind::gpu : DeviceKind::cpu; }

    // demCoupling.hpp: what a fluid asks of its solids
    void follow(const Context<Backend>& fluid) override { set_.context.follow(fluid); }
    int keys() const override { return particles_.n; }
    SolidView<D, P> view() override { return SolidView<D, P>{set_.box, particles_.view(), slotOf_.data()}; }
    BodyView<D, P> bodies() override { return BodyView<D, P>{clumps_.data(), groups_.data(), clumps_.constraints(), set_.box, clumps_.count()}; }
    std::vector<std::int32_t> order() override;
    real* external() override;
    void measureSpeed() override;
    int subcycles(double dt) override;
    bool still() const override { return still_; }
    double kickTime(double dt, int subcycles) override;
    void push(double dt) override;
    bool advanceTo(double t, double dt, int subcycles) override;
    void beginReport() override;
    void endReport() override;

private:

    // demSetup.hpp
    double leastSkin() const;
    void setReach(double skin);
    void setFrames();
    void setBox();
    void setDomain();
    void setOrder();
    void setWalls();
    void prime();

    // demCoupling.hpp
    double speedAtHand();

    // demStep.hpp
    WallMemory<D, real> wallMemory(WallMemoryArrays<Backend, real>&);
    SurfaceView<D> surface();
    template<class M> void setMotion(M&);
    MoveSolids<D, P> mover();
    template<class Law> void setModel(PairModel<Backend, D, P, Law>&);
    ForceClock forceClock(ForceTurn);
    template<class Law> void contactPass(ForceTurn);
    template<class Law> WallPass<D, P, Law> wallKernel(ForceTurn);
    template<class Law> void wallPass(ForceTurn);
    void bondPass(ForceTurn);
    void forces(ForceTurn = ForceTurn::inStep);
    bool movesAtOnce() const;
#ifndef __CUDACC__
    CollectedForce<D, P> collected();
#endif
    void collectForces();
    void moveParticles();
    MoveWalls wallMover(DemClockData*);
    void step();
    void finishStep();
    void searchWithin();
    void finishLate();
    int stepsLeft() const;
    bool fitsBlock() const;
    template<class Law> BlockSteps<Backend, D, P, Law> blockSteps(int count);
    void steps(int count);

    // demFused.hpp
    bool fuses() const;
    StepState<D, P> stepState();
    void openSteps();
    void closeSteps();
    template<class Law> void fusedStep();
    void fusedSteps(int count);
    void runAhead(std::int64_t count);
    void searchMoved();
    void forgetSearch() { clock_.now.search(); stepsSince_ = 0; }
    std::vector<const void*> graphKey(int count);
    void runFused(std::int64_t& rebuilds);

    // demSkin.hpp
    void setSkin(double skin);
    double mostSkin() const;
    double wallCell() const;
    double largestWallSpeed();
    void adaptSkin();

    // demLists.hpp
    void rebuild(bool fresh = false, bool inPlace = false);
    void findPlaces(bool fresh, bool inPlace);
    const std::uint32_t* newOrder() const;
    ContactSearch<Backend, D, P> search(const int* place = nullptr);
    void buildContacts(bool fresh);
    void buildFullLists(bool fresh);
    WallSearch<D, P> wallSearch();
    double wallReach() const;
    void settleFrames();
    void countWalls();
    void writeWalls(bool fresh, int elements);
    void buildWalls(bool fresh);
    void blockContacts();
    void setRanges();

    // demSleep.hpp
    bool sleeps() const { return set_.config.sleepSpeed > 0; }
    SleepState<D, P> sleepState(bool fused);
    void takeHistories(const SleepState<D, P>&);
    void checkSleep(bool fused);
    void wakeChanged(const std::vector<real>& before, const std::vector<real>& after);
    std::size_t asleepNow();

    // demRanks.hpp
    void setRanks();
    void setPieces();
    void setCapacity(int n);
    void takeKey(int slot, std::int32_t id);
    void packParticle(int slot, bool whole, RankBytes& to);
    void unpackParticle(int slot, bool whole, const unsigned char*& from);
    void packContacts(int slot, RankBytes& to);
    void packWalls(int slot, RankBytes& to);
    void regroup();
    void takeContacts();
    void takeWallContacts();
    std::vector<int> blockCuts();
    void settleRanks();
    void shareStep();
    bool ghost(int i) { return others_ && others_->kind(i) == ParticleExchange::ghost; }
    bool stopped() const { return others_ ? stopAgreed_ : bool(interrupted_); }
    double largestOfRanks(double) const;
    void findOffenderOfRanks(DemReport&);
    template<class T> void dropGhosts(std::vector<T>& v, int each);
    void requireAlone(const char* what) const;

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
    bool finished() const;
    void runToTarget(std::int64_t& rebuilds);
    void finishReport(DemReport&, std::int64_t before);
    void collectEscaped(DemReport&);
    void collectPassed(DemReport&);
    void findOffender(DemReport&);
    void describeOffender(DemReport&, int worst, double offence);
    std::vector<double> offences(int n);
    double largestSpeed();
    void clearPassed();

    // demOutput.hpp
    int activeSolids();
    double halfStep() const;
    std::vector<int> wallContacts();
    std::vector<std::int32_t> contactCounts(int n);

    DemSetting<Backend, D, P> set_;
    SceneClock<Backend> clock_{set_.context};
    ParticleFields<Backend, D, P> particles_;
    PairTable<Backend, D, P> pairs_{set_};
    SolidGroups<Backend, D, P> groups_{set_};
    PrescribedMotion<Backend, D, P> motion_{set_};
    Bonds<Backend, D, P> bonds_{set_, particles_};
    Clumps<Backend, D, P> clumps_{set_, particles_, groups_};
    bool still_ = false;        // nothing can move
    const DemInput* given_ = nullptr;       // while the scene is made

    RadiusClasses radii_;
    SizeClasses<D, P> classes_;
    std::int64_t domainMin_[D], domainMax_[D];
    real halfSkin_ = 0, suddenWay_ = 0;
    double skin_ = 0, reach_ = 0;
    bool driven_ = false;       // by a fluid, whose coupling chooses steps by the skin

    int reported_ = 0;          // of them known to be in the scene
    SolidRecordMemory<Backend, D, P> records_;
    Array<Backend, position> reference_;
    CellSort<Backend> sort_;
    SortScratch<Backend> scan_;
    Array<Backend, int> inverse_, slotOf_;
    ContactList<Backend, real> list_, oldList_;


    int nWalls_ = 0;
    bool surfaces_ = false;     // are there walls that are no planes?
    Array<Backend, WallData> walls_;
    Array<Backend, double> vertices_;
    Array<Backend, int> elements_, sharedFirst_, shared_, cellFirst_, cellElement_;
    WallMemoryArrays<Backend, real> wallMemory_, oldWallMemory_;
    Array<Backend, WallPassings> passed_;

    DemReport lastReport_;
    std::int64_t reportFrom_ = 0;           // step at which a coupled interval began
    DemParts<Backend, D, P> parts_;
    std::int64_t searchedAt_ = 0;           // step of the last search
    std::int64_t searchesWithin_ = 0;       // steps
    int stepsPerBatch_ = 16;
    std::int64_t stepsExpected_ = 16, stepsSince_ = 0;  // fused: between the last two searches, since the last one
    static constexpr int stepsTogether = 8;         // recorded
    static constexpr int stepsPerCheck = 8;         // of who sleeps and wakes
    static constexpr double wallSkins = 5;          // skins within which walls are listed where steps are fused
    Array<Backend, std::int32_t> wakes_, waits_;
    std::atomic<bool> interrupted_{false};

    // Of a scene on several ranks; null: there is one
    std::unique_ptr<ParticleExchange> others_;
    std::vector<std::vector<std::size_t>> touchingOf_;  // entries of each slot, where they are asked for
    struct RankContact { std::int64_t a, b; };          // owner and other: numbers of the order before, then slots of then
    std::vector<RankContact> arrivedContacts_;
    std::vector<real> arrivedHistories_;
    struct RankWall { int particle, wall, on[wallTouches]; };
    std::vector<RankWall> arrivedWalls_;
    std::vector<real> arrivedWallNumbers_;              // of each: normals, histories, force
    std::vector<Vector3> escaped_;
    std::vector<std::int32_t> escapedId_;
    std::int64_t passedBefore_ = 0;
    std::int32_t passedIdBefore_ = -1;
    bool stopAgreed_ = false;
};

} // namespace riprap

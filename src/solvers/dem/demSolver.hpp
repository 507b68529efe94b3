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
#include "dem/bond/bondPass.hpp"
#include "dem/passes/fusedStep.hpp"
#include "dem/lists/likeWithLike.hpp"
#include "dem/passes/collectPass.hpp"
#include "dem/motion/clumpSums.hpp"
#include "dem/passes/sleep.hpp"
#include "dem/walls/moveWalls.hpp"
#include "dem/walls/wallPass.hpp"
#include "solvers/dem/demBlockSteps.hpp"
#include "solvers/dem/demFamilies.hpp"
#include "solvers/dem/demRebuild.hpp"

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
    double time() const override { return host_.time; }
    const DemReport& lastReport() const override { return lastReport_; }
    DemState particles() override;
    DemState motion() override;
    DemContacts contacts() override;
    DemBondState bonds() override;
    DemClumpState clumps() override;
    std::vector<DemSpringState> springs() override;
    DemEnergy energy() override;
    double deepestOverlap() override;
    std::vector<DemWallForce> wallForces() override;
    void setExternalForces(const std::vector<double>& force, const std::vector<double>& moment) override;
    std::vector<std::int32_t> saveState() override;
    void loadState(const std::vector<std::int32_t>&) override;
    DemPlan plan() const override { return plan_; }
    std::vector<ArrayInfo> arrays() const override;
    std::vector<KernelInfo> kernels() const override;
    void timeKernels(bool on) override { context_.profile.timing = on; }
    double neighboursPerParticle() override;
    double contactsPerParticle() override;
    std::string deviceName() const override;
    DeviceKind device() const override { return Backend::gpu ? DeviceKind::gpu : DeviceKind::cpu; }

    // demCoupling.hpp: what a fluid asks of its solids
    void follow(const Context<Backend>& fluid) override { context_.follow(fluid); }
    int keys() const override { return n_; }
    SolidView<D, P> view() override { return SolidView<D, P>{box_, fields(), slotOf_.data()}; }
    BodyView<D, P> bodies() override { return BodyView<D, P>{clumps_.data(), groups_.data(), constraints(), box_, nClumps_}; }
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
    void setFields();
    void setGroups();
    void setPairs();
    void setBonds();
    int leastSharing(int together) const;
    void setClumps();
    ClumpConstraint constraintOf(const DemGroup&) const;
    void setConstraints(std::vector<ClumpData>&);
    void setSprings(const std::vector<ClumpData>&);
    ClumpData kicked(ClumpData, double dt) const;
    double springEnergy();
    GroupData<D, real> groupData(const DemGroup&) const;
    void setWalls();
    void prime();
    template<class T, class Values> void uploadField(int field, const Values& values);
    template<class T> void uploadVector(int field, int components, const std::vector<double>& from, bool spin);

    // demCoupling.hpp
    double speedAtHand();

    // demStep.hpp
    SolidFields<D, P> fields();
    BondFields<D, P> bondFields();
    BondTable bondTable();
    WallMemory<D, real> wallMemory(WallMemoryArrays<Backend, real>&);
    SurfaceView<D> surface();
    MotionTable groupMotions() const;
    MotionTable wallPoses() const;
    template<class M> void setMotion(M&);
    MoveSolids<D, P> mover();
    template<class Law> void setModel(PairModel<Backend, D, P, Law>&);
    ForceClock forceClock(ForceTurn);
    template<class Law> void contactPass(ForceTurn);
    template<class Law> WallPass<D, P, Law> wallKernel(ForceTurn);
    template<class Law> void wallPass(ForceTurn);
    void bondPass(ForceTurn);
    void gatherClumps(const DemClockData* clock);
    ClumpMembers<D, P> clumpMembers();
    ClumpKick<D, P> clumpKick() const;
    const ClumpConstraint* constraints() const { return constraints_.size() ? constraints_.data() : nullptr; }
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
    void forgetSearch() { host_.search(); stepsSince_ = 0; }
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
    bool sleeps() const { return config_.sleepSpeed > 0; }
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
    std::vector<int> keptBonds();
    template<class F> void forEachMemory(F f);
    template<class F> void forEachBondMemory(const std::vector<int>& kept, F f);
    std::size_t historyTogether() const;
    std::size_t historyRows() const;
    void clearUnused(std::vector<std::int32_t>& words, std::size_t at, int n) const;
    void restoreSearch(const DemSearchState&);
    void restoreIds(const std::vector<std::int32_t>& ids);
    template<class Reader> void restoreNeighbours(Reader&, int entries, int wallEntries);

    // demAdvance.hpp
    void readClock(int which = 0) { context_.toHost(&host_, clock_.data() + which, sizeof(DemClockData)); }
    void writeClock() { forEach(context_, 2, SetDemClock{host_, clock_.data()}); }
    bool finished() const;
    void setWindow();           // these three: demWindow.hpp
    void sampleGroups(double end);
    void samplePoses(double end);
    void runToTarget(std::int64_t& rebuilds);
    void finishReport(DemReport&, std::int64_t before);
    void collectEscaped(DemReport&);
    void collectPassed(DemReport&);
    void findOffender(DemReport&);
    void describeOffender(DemReport&, int worst, double offence);
    std::vector<double> offences(int n);
    double largestSpeed();
    std::size_t brokenBonds();
    void clearPassed();

    // demOutput.hpp
    int activeSolids();
    std::vector<double> positions(int n);
    std::vector<int> wallContacts();
    std::vector<std::int32_t> contactCounts(int n);
    template<class T> std::vector<T> field(int f) { return fields_.template download<T>(context_, f); }
    template<class T> void putVector(int n, int field, int components, bool spin, std::vector<double>& out);

    //- Sign of a spin about axes[2] when axes[0], axes[1] are the plane
    double spinSign() const
    {
        const int* a = config_.axes;
        return (a[1] - a[0] + 3) % 3 == 1 ? 1 : -1;
    }

    DemConfig config_;
    const LawChoice laws_;
    DemInput input_;            // without particles and bonds
    DemPlan plan_;
    bool still_ = false;        // nothing can move
    const DemInput* given_ = nullptr;       // while the scene is made
    Context<Backend> context_;

    Box<D, P> box_;
    RadiusClasses radii_;
    SizeClasses<D, P> classes_;
    std::int64_t domainMin_[D], domainMax_[D];
    real halfSkin_ = 0, suddenWay_ = 0;
    double skin_ = 0, reach_ = 0, largestGap_ = 0;
    bool driven_ = false;       // by a fluid, whose coupling chooses steps by the skin
    std::vector<double> emptyCoordinate_;

    int n_ = 0;                 // particles with memory
    int reported_ = 0;          // of them known to be in the scene
    std::vector<std::int32_t> ids_;         // of keys
    FieldSet<Backend> fields_;
    int xField_ = 0, vField_ = 0, wField_ = 0, fField_ = 0, mField_ = 0, radiusField_ = 0, massField_ = 0, inertiaField_ = 0;
    int materialField_ = 0, groupField_ = 0, clumpField_ = -1, turnField_ = -1, idField_ = 0, calmField_ = -1;
    SolidRecordMemory<Backend, D, P> records_;
    Array<Backend, position> reference_;
    CellSort<Backend> sort_;
    SortScratch<Backend> scan_;
    Array<Backend, int> inverse_, slotOf_;
    ContactList<Backend, real> list_, oldList_;
    int histories_ = 0;

    Array<Backend, GroupData<D, real>> groups_;
    Array<Backend, real> parameters_, gaps_;
    std::vector<real> reaches_; // what of the gaps is the law's reach
    std::vector<real> sole_;    // numbers of the first material with itself, its gap behind them
    Array<Backend, real> external_;
    std::vector<double> motionSamples_, poseSamples_;
    Array<Backend, double> motions_, poses_;
    double windowBegin_ = 0, windowStep_ = 1;
    int groupMotions_ = 0, wallMotions_ = 0;
    static constexpr int windowSteps = 64, samples = 2*windowSteps + 3;

    int nBonds_ = 0;
    Array<Backend, std::int32_t> bondIds_[2], bondType_, bondBroken_;
    Array<Backend, double> bondRest_;
    Array<Backend, real> bondHistory_;
    Array<Backend, BondForce<D, real>> bondForce_;
    Array<Backend, BondParameters<real>> bondTypes_;
    Array<Backend, int> bondFirst_, bondReference_;

    int nClumps_ = 0, largestClump_ = 0;
    Array<Backend, ClumpData> clumps_;
    Array<Backend, double> offset_;
    Array<Backend, int> memberFirst_, member_;
    Array<Backend, ClumpConstraint> constraints_;       // of groups; empty: none is constrained
    std::vector<ClumpConstraint> constraintOfGroup_;    // the same
    Array<Backend, SpringData> springs_;
    Array<Backend, int> springFirst_;                   // of a clump
    std::vector<SpringData> allSprings_;                // the same in the order of clumps,
    std::vector<std::pair<int, int>> springOfGroups_;   // and of groups: the clump, and which of them

    int nWalls_ = 0;
    bool surfaces_ = false;     // are there walls that are no planes?
    Array<Backend, WallData> walls_;
    Array<Backend, double> vertices_;
    Array<Backend, int> elements_, sharedFirst_, shared_, cellFirst_, cellElement_;
    WallMemoryArrays<Backend, real> wallMemory_, oldWallMemory_;
    Array<Backend, WallPassings> passed_;

    Array<Backend, DemClockData> clock_;
    DemClockData host_;
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

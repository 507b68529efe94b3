/*  The SPH scene on one backend, in one dimension and precision. Declarations; the parts are in
    sphSetup.hpp (construction), sphNeighbours.hpp (sorting, lists), sphStep.hpp (the parts of a
    step), sphAdvance.hpp (the loop over steps), sphFaces.hpp (faces of walls), sphForces.hpp (on
    walls and solids), sphSolids.hpp (solids in the fluid), sphStiffness.hpp (another speed of
    sound), sphOutput.hpp (everything read back), sphState.hpp (save and load). Several processes:
    fluidRanks.hpp.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <atomic>
#include "core/neighbours/cellSort.hpp"
#include "core/neighbours/searchReach.hpp"
#include "core/neighbours/pairLoop.hpp"
#ifdef __CUDACC__
    #include "core/backend/graph.hpp"
    #include "core/neighbours/neighbourList.hpp"
#endif
#include "coupling/bodyFaces.hpp"
#include "coupling/solidPasses.hpp"
#include "solvers/sph/fluidRanks.hpp"
#include "solvers/sph/sphFamilies.hpp"
#include "solvers/sph/sphInstances.hpp"
#include "solvers/sph/sphRebuild.hpp"
#include "sph/boundary/faceTables.hpp"
#include "sph/boundary/movingWall.hpp"
#include "sph/boundary/stationaryWall.hpp"
#include "sph/time/symplectic.hpp"

namespace riprap
{

//- Tables of the walls' faces on the device
template<class Backend, int D>
struct FaceArrays
{
    Array<Backend, double> vertex, normal, half, plane;
    Array<Backend, int> part, cellFirst, cellElement, cellFirstPlane;
    Array<Backend, FaceGrid<D>> grid;
    Array<Backend, FacePose<D>> pose;
    double tiny = 0;
    Array<Backend, int> groupOfKey;         // of solids
    Array<Backend, FaceBlow> blow;          // of bodies
    double reach = 0;                       // [m] from a face of a body to a point of it

    std::size_t bytes() const
    {
        return vertex.bytes() + normal.bytes() + half.bytes() + part.bytes() + cellFirst.bytes()
            + cellElement.bytes() + cellFirstPlane.bytes() + plane.bytes() + grid.bytes()
            + pose.bytes() + groupOfKey.bytes() + blow.bytes();
    }
};

//- GPU: steps launched between two rebuilds
struct CycleLength
{
    int steps = 8;
    bool fitted = false;        // it was too long once: lengthen in small strides
    int full = 0;               // since it was, pairs of cycles all of whose steps were wanted
};

//- What only one backend has
template<class Backend, int D, class P> struct BackendParts { };

#ifdef __CUDACC__
//- Recorded launches, for either half of the double-buffered fields
struct StepGraphs
{
    static constexpr int together = 4;
    Graph rebuild[2], step[2], steps[2];
    bool recorded = false;      // and as things are now
};

template<int D, class P>
struct BackendParts<Gpu, D, P>
{
    using real = typename P::real;

    NeighbourList<D, P> fluidFluid, fluidWall, wallFluid, fluidSolid, solidFluid;
    LocalFrameMemory<Gpu, D, P> frames;
    // lists of walls and about walls reach farther than the grid's: fluid slides along them
    real wallRadius = 0;
    StepGraphs graphs;
    int solidShift = 0;         // log2 of the lanes a solid
};
#endif

//- How far pairs reach, in h
template<class R>
R reachOfH(const SphConfig& c) { return R(kernelOf(c.kernel).support); }

template<class Backend, int D, class P>
class SphSolver : public SphScene
{
public:

    using real = typename P::real;
    using position = typename P::position;

    SphSolver(const SphConfig&, const FluidInput&, const WallInput&, WallMotion, SolidPart);

    SphReport advance(double t, std::int64_t maxSteps) override;
    void interrupt() override { interrupted_ = true; }
    double time() const override { return host_.time; }
    FluidState fluid() override;
    WallState walls() override;
    SphEnergy energy() override;
    FluidExtremes extremes() override;
    FluidEnd farEnd(const Vector3& direction, double reach) override;
    std::vector<Vector3> wallForces() override;
    std::vector<FluidForce> forcesOnWalls() override;
    std::vector<FluidForce> forcesOnSolids() override;
    FaceContacts faceContacts() override;
    using FluidScene::sample;
    SampleResult sample(const std::vector<double>& points, const SightPlanes&) override;
    std::vector<std::int32_t> saveState() override;
    void loadState(const std::vector<std::int32_t>&) override;
    std::array<std::size_t, SphScene::speedClasses> fasterThan(
        const std::array<double, SphScene::speedClasses>&) override;
    void setMaxVelocity(double maxVelocity, double soundSpeed) override;
    double estimateTimeStep(std::string& limit) override;
    std::vector<ArrayInfo> arrays() const override;
    std::vector<KernelInfo> kernels() const override;
    void timeKernels(bool on) override { context_.profile.timing = on; }
    double neighboursPerParticle() override;
    NeighbourCounts countNeighbours() override;
    DemScene* solids() override { return solidScene_.get(); }
    CouplingState coupling() override;
    std::string deviceName() const override;
    DeviceKind device() const override { return Backend::gpu ? DeviceKind::gpu : DeviceKind::cpu; }

private:

    // sphSetup.hpp
    void setModel();
    void setBox();
    void setFluid(const FluidInput&);
    void setWalls(const WallInput&);
    void prime();
    void setFrames();
    //- From a particle to those it must find, whose h and own are at most `h` [m]
    real pairReach(float h) const
    {
        return grid_.radius - reachOfH<real>(config_)*(model_.hMax - h);
    }
    SearchReach<real> fluidReach() const;

    // GPU: what lists of walls reach beyond the support, of it
    static constexpr double wallSkin = D == 2 ? 0.5 : 0.2;

    // sphNeighbours.hpp
    void rebuild();
    void settleFrames();
    void sortNow();
    void rebuildWalls();
    void buildLists();
    void allocateLists();
    void growLists();

    // sphStep.hpp
    FluidFields<D, P> fluidFields();
    WallFields<D, P> wallFields();
    Source<Backend, D, P> fluidSource(bool forWalls);
    Source<Backend, D, P> wallSource();
    template<class Kernel> KernelConstants<D, real> kernelConstants() const;
    template<class M> M mover();
    template<class Pass> void run(const Pass&, int targets);
    void moveWalls(bool half);
    void wallPass(bool inStep);
    void wallForcePass(real* force, bool viscous = true);
    template<Part part> void fluidPass(Finish);
    void step();
    Tick tick() const;

    // sphFaces.hpp
    void setFaces(const WallFaceInput&, const SolidPart&);
    void setBodies(const SolidPart&);
    FaceContact<D, P> faceContact();
    void moveFaces();
    void blowBodies();

    // sphSolids.hpp
    void setSolids(SolidPart);
    void allocateAction();
    void loadSolids(const std::vector<std::int32_t>& words, std::size_t at);
    std::vector<std::int32_t> solidIds(std::vector<int>& there);
    SolidPoints<D, P> solidPoints();
    SolidAction<D, real> solidAction();
    void meetFluid();
    void pushSolids();
    template<class F> void withSolidTerms(bool viscous, const F&) const;
    Source<Backend, D, P> solidSource();
    Source<Backend, D, P> fluidAboutSolids();
    void sortSolids();
    void advanceSolids();
    void showForces();
    void moveSolids(bool half);
    void solidPressurePass(bool inStep);
    template<Part part> void solidPass();
    void solidForcePass(real* pressureForce = nullptr);
    template<class Pass> void runOverSolids(const Pass&);

    // sphAdvance.hpp
    void setPoses(double begin, double end);
    void runToTarget(std::int64_t& rebuilds);
    int stepsAhead() const;
    void runCycles(int steps, bool graphs);
    void fitCycle(int taken);
    bool finished() const;
    void readClock();
    void writeClock();
    void collectEscaped(SphReport&);
    void findOffender(SphReport&);
    double findWorst(SphReport&);
    std::vector<double> suspicion(int n);

    // sphForces.hpp
    std::vector<real> wallPointForces(bool viscous);

    // sphSetup.hpp; of several ranks
    void setCapacity(int n);
    void fitCapacity();
    GhostMarks<Backend> ghosts() const { return ranks_ ? ranks_->marks() : GhostMarks<Backend>(); }
    bool stopAsked() const { return ranks_ ? ranks_->stopAgreed() : bool(interrupted_); }

    // sphOutput.hpp
    void refreshRecords();
    int activeFluid();
    void toMetres(
        const std::vector<std::int64_t>* x, std::size_t n, std::vector<double>& out) const;

    SphConfig config_;
    WallMotion motion_;
    Context<Backend> context_;

    Box<D, P> box_;
    CellGrid<D, P> grid_;
    FluidModel<D, P> model_;
    StepLimits limits_;
    TermParameters<D, real> terms_;
    // [m] way of a particle (GPU: against those near it) for which neighbours hold
    real allowedWay_ = 0;
    real wallWay_ = 0;          // of a wall that moves
    double emptyCoordinate_ = 0;
    double stiffening_ = 0;     // [J] that changes of the speed of sound have added

    int n_ = 0;                 // fluid particles with memory
    int reported_ = 0;          // of them known to be in the scene
    FieldSet<Backend> fluid_;
    int xField_ = 0, vField_ = 0, deviationField_ = 0, aField_ = 0, rateField_ = 0,
        driftField_ = -1, idField_ = 0;
    Records<Backend, D, P> fluidRecords_;
    Array<Backend, position> fluidReference_;
    CellSort<Backend> fluidSort_;

    int nWalls_ = 0, nBodies_ = 0;
    FieldSet<Backend> wall_;
    int wallXField_ = 0, wallIdField_ = 0, wallBodyField_ = -1, wallVField_ = -1, wallAField_ = -1,
        wallWorkField_ = -1, wallPressureWorkField_ = -1;
    Records<Backend, D, P> wallRecords_;
    Array<Backend, position> wallReference_;
    CellSort<Backend> wallSort_;
    Array<Backend, double> wallRest_;
    std::vector<double> wallInput_;             // positions as given
    std::vector<std::int32_t> wallBodies_, wallParts_;
    Array<Backend, PoseSample> poses_;
    double poseBegin_ = 0, poseStep_ = 1;
    static constexpr int poseIntervals = 32;

    FaceArrays<Backend, D> faces_;

    std::unique_ptr<DemScene> solidScene_;
    SolidSide<D, P>* solids_ = nullptr;         // the same; null: there are none
    bool solidsMeet_ = false;                   // is there fluid near any solid?
    Array<Backend, int> meets_;
    CouplingConfig coupling_;
    int nSolids_ = 0, subcycles_ = 0;
    Records<Backend, D, P> solidRecords_;
    CellSort<Backend> solidSort_;
    Array<Backend, position> solidReference_;
    Array<Backend, std::int64_t> solidLast_;
    Array<Backend, real> solidOwn_[D], solidMass_, solidMassOfKey_, solidAddedOfKey_,
        solidVelocity_, solidAcceleration_, solidForce_, solidForceBefore_;
    Array<Backend, real> actionA_[D], actionRate_, actionDrift_[D];

    Array<Backend, ClockData> clock_;
    ClockData host_;

    BackendParts<Backend, D, P> parts_;
    int shift_ = 0;             // log2 of the lanes a particle
    CycleLength cycle_;
    std::atomic<bool> interrupted_{false};      // until a call of advance has heeded it

    std::unique_ptr<FluidRanks<Backend, D, P>> ranks_;  // null: there is one
};

} // namespace riprap

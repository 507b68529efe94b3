/*  The PIC scene on one backend, in one dimension and precision. Declarations; the parts are in
    picSetup.hpp (construction), picOpenings.hpp (where water comes and goes), picCut.hpp (solids
    inside the domain), picSolids.hpp (those that move with the water), picStep.hpp (the parts of a
    step), picViscosity.hpp, picMomentum.hpp, picForces.hpp (on walls), picAdvance.hpp (the loop
    over steps), picOutput.hpp (everything read back) and picState.hpp (save and load).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <atomic>
#include <initializer_list>
#include "core/neighbours/cellSort.hpp"
#include "core/loops/reduceMax.hpp"
#include "pic/grid/activeRows.hpp"
#include "pic/cutCells/extendSurface.hpp"
#include "pic/cutCells/pushOut.hpp"
#include "pic/grid/extrapolate.hpp"
#include "pic/terms/forces.hpp"
#include "pic/openings/inflow.hpp"
#include "pic/openings/openFaces.hpp"
#include "pic/transfer/positionCorrection.hpp"
#include "pic/projection/pressureStep.hpp"
#include "pic/grid/speed.hpp"
#include "pic/terms/viscosity.hpp"
#include "pic/surface/advectLevelSet.hpp"
#include "pic/surface/fillFraction.hpp"
#include "pic/surface/redistance.hpp"
#include "pic/surface/waterVolume.hpp"
#include "pic/transfer/cellLanes.hpp"
#include "pic/transfer/moveParticles.hpp"
#include "pic/transfer/particleToGrid.hpp"
#include "pic/grid/wetCells.hpp"
#include "coupling/solidView.hpp"
#include "solvers/pic/transfer/gridToParticles.hpp"
#include "solvers/pic/picBodies.hpp"
#include "solvers/pic/picObstacles.hpp"
#include "api/picScene.hpp"
#include "solvers/pic/transfer/picSplines.hpp"

namespace riprap
{

//- Part of a saved state, as bytes: no pointers, no padding
struct PicClock
{
    double time = 0, lastStep = 0, lastKick = 0;
    double particleVolume = 0;              // [m^D]
    double drift = 0;                       // of the volume, put right so far, relative
    std::int64_t steps = 0;
    std::int64_t initial = 0;               // particles at the very start
    std::int64_t nextId = 0;                // of the next one that comes in
};

template<class Backend, int D, class P>
class PicSolver : public PicScene
{
public:

    using real = typename P::real;

    PicSolver(const PicConfig&, const FluidInput&, const PicWalls&, LinearSolver*, PicInside&&);

    PicReport advance(double t, std::int64_t maxSteps) override;
    void interrupt() override
    {
        interrupted_ = true;
        if (inside_.scene) inside_.scene->interrupt();
    }
    double time() const override { return clock_.time; }
    FluidState fluid() override;
    PicGridState grid() override;
    DemScene* solids() override { return inside_.scene.get(); }
    Coupling coupling() override
    {
        return bodies_ ? Coupling{bodies_->force(), subcycles_} : Coupling();
    }
    void watchMomentum(bool on) override { watches_ = on; }
    PicMomentum momentum() override { return momentum_; }
    std::vector<FluidForce> forcesOnWalls() override;
    std::vector<FluidForce> forcesOnSolids() override
    {
        return bodies_ ? bodies_->forces() : std::vector<FluidForce>();
    }
    FluidEnergy energy() override;
    FluidExtremes extremes() override;
    FluidEnd farEnd(const Vector3& direction, double reach) override;
    double particleSpacing() const override { return std::pow(clock_.particleVolume, 1.0/D); }
    using FluidScene::sample;
    SampleResult sample(const std::vector<double>& points, const SightPlanes&) override;
    std::vector<std::int32_t> saveState() override;
    void loadState(const std::vector<std::int32_t>&) override;
    double estimateTimeStep(std::string& limit) override;
    std::vector<ArrayInfo> arrays() const override;
    std::vector<KernelInfo> kernels() const override;
    void timeKernels(bool on) override { context_.profile.timing = on; }
    std::string deviceName() const override;
    DeviceKind device() const override { return Backend::gpu ? DeviceKind::gpu : DeviceKind::cpu; }

private:

    //- Layers of faces beyond the water that get a velocity: a particle's way in a step, its
    //  stencil, and a corner
    static constexpr int extrapolationPasses = 5;
    static constexpr double bandCells = 4;      // of phi on either side of the surface
    static constexpr double wallMargin = 1e-3;  // of a cell: particles stay that far inside
    static constexpr double nearSolid = 1.9;    // cells: distances are known a little farther

    // picSetup.hpp
    void setGrid();
    void setAbsorbers();
    void setWalls(const PicWalls&);
    void setSides();
    void setFluid(const FluidInput&);
    void leaveDry();
    void setParticles(const std::vector<double>& x, const std::vector<double>& v,
        const std::vector<double>& gradient, const std::vector<std::int32_t>& id);
    std::vector<double> velocitiesAt(const std::vector<double>& seeds, const std::vector<double>& x,
        const std::vector<double>& v, std::vector<double>& gradient) const;
    std::vector<double> solved(const std::vector<double>& xyz, bool position) const;
    int steepest() const;
    void dropInside(std::vector<double>& x);

    // picOpenings.hpp
    bool opens() const { return !openings_.faces.empty(); }
    void setOpenings(PicWalls&);
    void keepOpenParts(int d, const std::vector<real>& aperture);
    void keepOpenParts();
    void openFully();
    std::vector<double> atOpenings(
        Array<Backend, real>* ofFaces, const Array<Backend, real>* ofCells);
    void startOpenings();
    void takeUpPending();
    void setOpenFaces(double t);
    void writeOpenFaces();
    void pushOpenFaces(double dt);
    void letIn(double dt);
    void append(
        const std::vector<Vec<D, double>>& places, const std::vector<Vec<D, double>>& velocities);
    void reserve(std::size_t particles);
    template<class T> void enlarge(Array<Backend, T>&, std::size_t room);
    int leftThrough(const Vec<D, double>& x) const;
    double openingSpeed(double t) const;
    std::size_t openingMemorySize() const
    {
        return 2*openings_.faces.size() + 4*openings_.in.size();
    }
    double openBalance(int opening = -1) const;
    std::vector<double> openingMemory() const;
    void setOpeningMemory(const double*);

    // picCut.hpp
    bool cuts() const { return !inside_.empty(); }
    bool sticksInside() const { return cuts() && config_.noSlip && config_.viscosity > 0; }
    void allocateCut();
    void cutGrid(double t, double dt);
    void measureOpenings(bool all);
    void keepBase();
    bool moveInside(double dt, double before);
    SolidField<D, real> solidField();
    void extendSurface(Array<Backend, real>& phi);
    std::vector<char> clearCells(double clear);

    // picSolids.hpp
    void setSolids(bool inWater);
    CutFields<D, real> cutFields();
    void cutByBodies();
    void cutToWater();
    void useBodyVelocities(bool predicted);
    bool bodiesYield() const;
    PressureReport solveWithBodies(
        const PressureFields<D, real>& fields, bool sameWater, double tolerance = 0);
    void projectWithBodies(double dt, bool sameWater);
    void slowBetweenSolids(double dt);
    void setSolidVelocity();
    void dragBodies(double dt);
    bool advanceSolids(double dt, double before);

    // picStep.hpp
    template<class F> void withWindows(const F&);
    template<int N, class F> std::array<double, N> sumOverWater(const F&);
    PicParticles<D, real> particles(bool spare = false);
    PressureFields<D, real> pressureFields(double dt, bool reflected = false);
    void sortParticles(PicReport* report = nullptr, bool keysKnown = false);
    void markWater();
    void toGrid();
    void project(double dt, double drift);
    void extrapolate(std::initializer_list<Array<Backend, real>*> fields, int passes);
    Array<Backend, double>& wholePressure() { return config_.reflection > 0 ? whole_ : pressure_; }
    Array<Backend, real>* carrier() { return config_.reflection > 0 ? carrier_ : u_; }
    GridVelocities<D, real> gridVelocities(double dt);
    void toParticles(double dt);
    void moveParticles(double dt);
    void moveSurface(double dt, PicReport&);
    void redistance();
    void holdVolume();
    double waterVolume(double* sums);
    double kick(double dt) const;
    void step(double dt, PicReport&);

    // picMomentum.hpp
    Vec<D, double> particleMomentum();
    void keepForced();
    void weighMomentum(double dt);

    // picForces.hpp
    void setWallParts();
    void addPressureForces(std::vector<FluidForce>&);
    void addSideStress(std::vector<FluidForce>&);
    void addObstacleStress(std::vector<FluidForce>&);
    void keepSheared();
    int nearestObstacle(int component, const typename UniformGrid<D>::Index& face) const;
    FluidForce shearOn(int part, int component, double force, const Vec<D, double>& place) const;

    // picViscosity.hpp
    bool diffusesImplicitly(double dt) const;
    ViscousFaces<D, real> viscousFaces(int d, bool homogeneous = false);
    void diffuse(double dt);
    void diffuseImplicitly(double dt, double number);
    void solveViscous(real k);

    // picOutput.hpp
    void velocitiesNow(int d, Array<Backend, real>&);
    PicParticles<D, real> particlesNow(Array<Backend, real> (&v)[D]);
    std::vector<real> velocities(int d);

    // picState.hpp
    template<class F> void forEachSaved(const F&);

    // picAdvance.hpp
    double fastest();
    double fastestCarried(double of);
    double timeStep(double speed, std::string& limit);
    PicReport advanceDry(double t, std::int64_t maxSteps);
    void findOffender(PicReport&, double courant);
    void stopAtSolids(PicReport&, const std::string& why);
    double speedLimit(double now);
    void stopTooFast(PicReport&, double speed);

    PicConfig config_;
    Context<Backend> context_;
    UniformGrid<D> grid_;
    double gravity_[D];
    double emptyCoordinate_ = 0;

    int n_ = 0;                                 // particles in the scene
    FieldSet<Backend> set_;
    int xField_ = 0, vField_ = 0, affineField_ = -1, idField_ = 0, memoryField_ = 0;
    CellSort<Backend> sort_;
    ParticleToGrid<Backend, D, real> toFaces_;
    GridToParticles<Backend, D, real> fromFaces_;
    ActiveRows<Backend, D> rows_;               // of the step
    Array<Backend, PlaceInCell<real>> place_;   // of particles, from one sort to the next
    Array<Backend, real> shift_[D];             // of position correction

    Array<Backend, real> phi_, carried_, spare_;
    Array<Backend, unsigned char> wet_, near_;
    Array<Backend, real> u_[D], before_[D], change_[D], mass_[D], aperture_[D], wallVelocity_[D];
    double speedLimit_ = 0;                         // [m/s] above it a guard fires
    // with reflection: of particles after the step, and what carries them
    Array<Backend, real> after_[D], carrier_[D];
    // rates of zones that absorb waves; empty: there are none
    Array<Backend, real> absorb_[D];
    Array<Backend, unsigned char> layer_[D];
    // that of the step, and what takes away the divergence that drift brings
    Array<Backend, double> pressure_, reflected_;
    // with reflection: impulse by which particles are ahead [Pa s]; pressure with that
    Array<Backend, double> ahead_, whole_;
    // of the implicit one
    struct ViscousArrays
    {
        Array<Backend, real> force[D], source[D], r[D], p[D], q[D];
        Array<Backend, double> pressure;
    } viscous_;
    bool viscousConverged_ = true;
    bool wallsMove_ = false;

    //- Of the sides: faces, in the order of their directions, what is given at each in this step,
    //  and what has passed through each opening
    struct OpeningFaces
    {
        std::vector<OpenFace<D>> faces;
        std::vector<int> number[D];             // of a face's opening, -1: none
        std::vector<real> open, given;
        std::vector<unsigned char> leaves;
        // of openings: velocity inward that the flow makes [m/s]
        std::vector<double> rate;
        // volume that has gone out but not as particles [m^D]
        std::vector<double> owed;
        std::vector<std::int64_t> in, out;      // particles
        std::vector<double> volume;             // that they stand for, in less out [m^D]
        Array<Backend, int> face[D], cell[D];
        Array<Backend, unsigned char> gate[D], flags;
        Array<Backend, real> buffer, second;
    } openings_;

    PicWalls sides_;
    PicInside inside_;
    SolidSide<D, P>* solidSide_ = nullptr;
    std::unique_ptr<PicBodies<D>> bodies_;      // null: there are none
    PicCut base_;                               // by what does not belong to the solids
    BodyCut<Backend, D> bodyCut_;
    Array<Backend, real> baseAperture_[D], baseVelocity_[D];    // of the grid without bodies
    Array<Backend, double> baseDistance_;
    int subcycles_ = 0;
    // are they where a loaded state has them, and the grid cut elsewhere?
    bool bodiesLoaded_ = false;
    // have faces that bodies close no velocity, to the bit?
    bool bodiesRest_ = false;
    Array<Backend, int> contactBoxes_;
    Array<Backend, ContactArea<D>> contactAreas_;
    // is the grid cut where solids now are, with velocities of a step?
    bool insideMoves_ = false, cutForStep_ = false;
    Array<Backend, double> nodeDistance_;       // to solids
    Array<Backend, real> open_, openWeight_;    // parts of cells
    Array<Backend, real> faceDistance_[D], solidVelocity_[D];     // where water sticks to solids
    Array<Backend, unsigned char> cellLayer_, sealed_[D];

    PressureStep<Backend, D, real> pressureStep_;
    MultigridLinear ownSolver_;
    LinearSolver& linearSolver_;                // the caller's, else ownSolver_

    PicClock clock_;
    PressureReport lastPressure_;
    bool watches_ = false;
    std::vector<real> forced_[D];               // while somebody watches
    PicMomentum momentum_;
    std::unique_ptr<WallParts<D>> wallParts_;   // once somebody has asked for forces on walls
    double wallPartsTime_ = 0;
    bool shearAsked_ = false;
    // once it was: of the last step, what drags obstacles
    Array<Backend, real> shearedU_[D];
    Array<Backend, unsigned char> shearedLayer_[D];
    // of water without flying particles [cells]; flying particles
    double volume_ = 0, flying_ = 0;
    std::atomic<bool> interrupted_{false};
};

} // namespace riprap

/*  SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "pressureSolver.H"
#include <algorithm>
#include "lduMatrix.H"
#include "solverEntries.H"
#include "wetMesh.H"

const Foam::word Foam::pressureSolver::deviceSolver(riprap::ownSolver);

namespace
{

//- Fewer rows than this are no work for GAMG, which stops when it cannot make a coarse level
constexpr int fewRows = 200;

void copy(const std::vector<double>& from, Foam::scalarField& to)
{
    std::copy(from.begin(), from.end(), to.begin());
}
}

Foam::pressureSolver::pressureSolver(
    const Time& time, const word& field, const dictionary& controls)
    : time_(time), field_(field)
{
    read(controls);
}


bool Foam::pressureSolver::read(const dictionary& controls)
{
    const SHA1Digest now(controls.digest());
    // The digest of no entries is that of none given
    if (now == given_ && !controls.empty()) return false;
    given_ = now;
    controls_ = controls;
    gatheredCells_ = -1;
    onDevice_ = controls_.get<word>("solver") == deviceSolver;
    if (onDevice_) readDevice(); else checkHost();
    return true;
}


void Foam::pressureSolver::print(const solverPerformance& solution, label comm)
{
    if (!quiet) solution.print(Info.masterStream(comm));
    if (solutions_.size() < 2) solutions_.append(solution); else solutions_.last() = solution;
}


Foam::List<Foam::solverPerformance> Foam::pressureSolver::takeSolutions()
{
    List<solverPerformance> taken;
    taken.transfer(solutions_);
    return taken;
}


void Foam::pressureSolver::readDevice()
{
    for (const entry& e : controls_)
    {
        const word& key = e.keyword();
        const wordList known({"solver", "tolerance", "relTol", "maxIter", "minIter", "nSweeps",
            "reflectionTolerance", "gatheredCells"});
        if (!known.found(key))
        {
            FatalIOErrorInFunction(controls_)
                << "unknown entry '" << key << "' of solver " << deviceSolver << " for " << field_
                << ". Valid: " << known << exit(FatalIOError);
        }
    }
    multigrid_ = riprap::MultigridControls();
    multigrid_.tolerance = controls_.lookupOrDefault<scalar>("tolerance", multigrid_.tolerance);
    multigrid_.relTol = controls_.lookupOrDefault<scalar>("relTol", multigrid_.relTol);
    multigrid_.maxIter = controls_.lookupOrDefault<label>("maxIter", multigrid_.maxIter);
    multigrid_.minIter = controls_.lookupOrDefault<label>("minIter", multigrid_.minIter);
    multigrid_.reflectionTolerance = controls_.lookupOrDefault<scalar>("reflectionTolerance", 0);
    multigrid_.sweeps = controls_.lookupOrDefault<label>("nSweeps", multigrid_.sweeps);
    gatheredCells_ = controls_.lookupOrDefault<label>("gatheredCells", -1);
    const auto require = [&](bool good, const char* key, const char* range)
    {
        if (good) return;
        FatalIOErrorInFunction(controls_) << key << " of solver " << deviceSolver << " for "
                                          << field_ << " must be " << range << exit(FatalIOError);
    };
    require(multigrid_.tolerance >= 0, "tolerance", "0 or more");
    require(multigrid_.reflectionTolerance >= 0 && multigrid_.reflectionTolerance < 1,
        "reflectionTolerance", "in 0 .. 1");
    require(multigrid_.relTol >= 0 && multigrid_.relTol < 1, "relTol", "in 0 .. 1");
    require(multigrid_.tolerance > 0 || multigrid_.relTol > 0, "tolerance",
        "positive where relTol is 0");
    require(multigrid_.maxIter > 0, "maxIter", "1 or more");
    require(multigrid_.minIter >= 0 && multigrid_.minIter <= multigrid_.maxIter, "minIter",
        "in 0 .. maxIter");
    require(multigrid_.sweeps > 0 && multigrid_.sweeps <= 10, "nSweeps", "in 1 .. 10");
    require(gatheredCells_ >= 0 || !controls_.found("gatheredCells"), "gatheredCells", "0 or more");
}


void Foam::pressureSolver::checkAgglomerator(dictionary& dict) const
{
    const word agglomerator = dict.lookupOrDefault<word>("agglomerator", "algebraicPair");
    if (agglomerator != "algebraicPair")
    {
        FatalIOErrorInFunction(controls_)
            << "agglomerator " << agglomerator
            << " needs the geometry of a mesh, and the wet cells have none here."
            << " Valid: algebraicPair" << exit(FatalIOError);
    }
    dict.set("agglomerator", agglomerator);
}


void Foam::pressureSolver::checkHost()
{
    const word name = controls_.get<word>("solver");
    if (!lduMatrix::solver::symMatrixConstructorTablePtr_->found(name))
    {
        wordList valid = lduMatrix::solver::symMatrixConstructorTablePtr_->sortedToc();
        valid.append(deviceSolver);
        FatalIOErrorInFunction(controls_) << "unknown solver '" << name << "' for " << field_
                                          << ". Valid: " << valid << exit(FatalIOError);
    }
    checkSolverEntries(controls_, field_);
    // Else it would pass while few cells are wet, which DIC serves
    const auto& known = *lduMatrix::preconditioner::symMatrixConstructorTablePtr_;
    const word preconditioner = !controls_.found("preconditioner") ? word::null
        : controls_.isDict("preconditioner")
        ? controls_.subDict("preconditioner").get<word>("preconditioner")
        : controls_.get<word>("preconditioner");
    if (preconditioner.size() && !known.found(preconditioner))
    {
        FatalIOErrorInFunction(controls_)
            << "unknown preconditioner '" << preconditioner << "' for " << field_
            << ". Valid: " << known.sortedToc() << exit(FatalIOError);
    }
    if (name == "GAMG") checkAgglomerator(controls_);
    if (controls_.isDict("preconditioner"))
    {
        if (preconditioner == "GAMG") checkAgglomerator(controls_.subDict("preconditioner"));
    }
    else if (preconditioner == "GAMG")
    {
        FatalIOErrorInFunction(controls_)
            << "preconditioner GAMG of " << field_
            << " needs entries of its own (smoother ...): write it as a dictionary,"
            << " preconditioner { preconditioner GAMG; smoother symGaussSeidel; ... }"
            << exit(FatalIOError);
    }
}


riprap::PressureReport Foam::pressureSolver::solve(riprap::ReducedSystem& system)
{
    riprap::PressureReport report;
    report.solver = "";
    const bool divided = UPstream::parRun();
    if (divided && !system.divided)
        FatalErrorInFunction << "the equations of " << field_
                            << " are not divided over the processes" << exit(FatalError);
    const label rows = divided ? returnReduce(label(system.rows()), sumOp<label>()) : system.rows();
    if (!rows) return report;

    const wetMesh mesh(time_, system);
    lduMatrix matrix(mesh);
    copy(system.diagonal, matrix.diag());
    if (!system.owner.empty() || divided) copy(system.offDiagonal, matrix.upper());
    scalarField x(system.rows()), rhs(system.rows());
    copy(system.x, x);
    copy(system.rhs, rhs);

    dictionary controls(controls_);
    const bool coupled = controls.get<word>("solver") == "coupledPCG";
    const bool moves = std::any_of(system.bodies.begin(), system.bodies.end(),
        [](const riprap::BodyRows& b) { return b.modes > 0; });
    if (moves && !coupled)
    {
        FatalIOErrorInFunction(controls_)
            << "solver " << controls.get<word>("solver") << " of " << field_
            << " cannot move free bodies with the water. Valid: coupledPCG, " << deviceSolver
            << exit(FatalIOError);
    }
    if (rows < (divided ? UPstream::nProcs(mesh.comm())*fewRows : fewRows))
    {
        if (!coupled) controls.set("solver", "PCG");
        controls.remove("preconditioner");
        controls.set("preconditioner", "DIC");
    }
    const solverPerformance performance = lduMatrix::solver::New(
        field_, matrix, mesh.borderCoeffs(), mesh.borderCoeffs(), mesh.borderFields(), controls)
                                              ->solve(x, rhs);
    print(performance, mesh.comm());
    std::copy(x.begin(), x.end(), system.x.begin());

    report.initialResidual = performance.initialResidual();
    report.finalResidual = performance.finalResidual();
    report.iterations = performance.nIterations();
    report.converged = performance.converged()
        || performance.finalResidual() < controls.lookupOrDefault<scalar>("tolerance", 1e-6);
    return report;
}


void Foam::pressureSolver::report(const riprap::PressureReport& r)
{
    if (!onDevice_) return;     // OpenFOAM's solvers have printed theirs
    print(solverPerformance(
              deviceSolver, field_, r.initialResidual, r.finalResidual, r.iterations, r.converged),
        UPstream::worldComm);
}

/*  SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "coupledPCG.H"
#include "PrecisionAdaptor.H"
#include "processRanks.H"
#include "wetMesh.H"

namespace Foam
{
    defineTypeNameAndDebug(coupledPCG, 0);

    lduMatrix::solver::addsymMatrixConstructorToTable<coupledPCG>
        addcoupledPCGSymMatrixConstructorToTable_;


    //- The bodies that come with the mesh of the wet cells; any other mesh has none
    struct meshBodies
    {
        autoPtr<processRanks> ranks;
        autoPtr<riprap::BodyDeflation> deflation;

        meshBodies(const lduMesh& any, const riprap::DeflationControls& controls)
        {
            const wetMesh* mesh = dynamic_cast<const wetMesh*>(&any);
            if (!mesh) return;
            const riprap::ReducedSystem& system = mesh->system();
            if (system.divided && UPstream::nProcs(any.comm()) > 1)
                ranks.reset(new processRanks(system, any.comm()));
            if (!system.bodies.empty())
                deflation.reset(new riprap::BodyDeflation(system, controls, ranks.get()));
        }
    };


    static bool deflates(const riprap::BodyDeflation* bodies)
    {
        return bodies && bodies->columns() > 0;
    }
}


Foam::coupledPCG::coupledPCG(const word& fieldName, const lduMatrix& matrix,
    const FieldField<Field, scalar>& interfaceBouCoeffs,
    const FieldField<Field, scalar>& interfaceIntCoeffs,
    const lduInterfaceFieldPtrsList& interfaces, const dictionary& solverControls)
    : lduMatrix::solver(
        fieldName, matrix, interfaceBouCoeffs, interfaceIntCoeffs, interfaces, solverControls)
{
    deflation_.heavyHats = true;
    const dictionary& entries = solverControls.subOrEmptyDict("deflation");
    bool wrong = false;
    if (entries.found("localIterations"))
        wrong = (deflation_.localIterations = entries.get<label>("localIterations")) < 1;
    if (entries.found("margin"))
        wrong = (deflation_.margin = entries.get<scalar>("margin")) < 0 || wrong;
    if (entries.found("hats")) wrong = (deflation_.hats = entries.get<scalar>("hats")) < 0 || wrong;
    if (wrong)
    {
        FatalIOErrorInFunction(entries)
            << "deflation of " << fieldName
            << " needs localIterations of 1 or more, a margin of 0 or more and hats of 0 or more"
            << exit(FatalIOError);
    }
}


void Foam::coupledPCG::product(solveScalarField& ax, const solveScalarField& x,
    const riprap::BodyDeflation* bodies, direction cmpt) const
{
    matrix_.Amul(ax, x, interfaceBouCoeffs_, interfaces_, cmpt);
    if (bodies) bodies->addBodies(x.begin(), ax.begin());
}


void Foam::coupledPCG::residual
(
    solveScalarField& r,
    const solveScalarField& psi,
    const solveScalarField& source,
    solveScalarField& q,
    const riprap::BodyDeflation* bodies,
    direction cmpt
) const
{
    product(q, psi, bodies, cmpt);
    r = source - q;
}


void Foam::coupledPCG::precondition
(
    solveScalarField& z,
    const solveScalarField& r,
    const lduMatrix::preconditioner& preconditioner,
    solveScalarField& q,
    const riprap::BodyDeflation* bodies,
    direction cmpt
) const
{
    preconditioner.precondition(z, r, cmpt);
    if (!deflates(bodies)) return;
    residual(q, z, r, q, bodies, cmpt);
    bodies->correct(q.begin(), z.begin());
}


Foam::solverPerformance Foam::coupledPCG::scalarSolve(
    solveScalarField& psi, const solveScalarField& source, const direction cmpt) const
{
    solverPerformance performance(
        lduMatrix::preconditioner::getName(controlDict_) + typeName, fieldName_);
    const label comm = matrix().mesh().comm();
    const label n = psi.size();

    const meshBodies ofMesh(matrix().mesh(), deflation_);
    const riprap::BodyDeflation* bodies = ofMesh.deflation.get();

    solveScalarField z(n), p(n, Zero), q(n), r(n), old(n, Zero);
    residual(r, psi, source, q, bodies, cmpt);
    const solveScalar normFactor = this->normFactor(psi, source, q, p);
    performance.initialResidual() = gSumMag(r, comm)/normFactor;
    performance.finalResidual() = performance.initialResidual();
    if (minIter_ <= 0 && performance.checkConvergence(tolerance_, relTol_)) return performance;

    if (deflates(bodies))       // the residual has then nothing in the span of Z
    {
        bodies->correct(r.begin(), psi.begin());
        residual(r, psi, source, q, bodies, cmpt);
        performance.finalResidual() = gSumMag(r, comm)/normFactor;
        if (minIter_ <= 0 && performance.checkConvergence(tolerance_, relTol_)) return performance;
    }

    autoPtr<lduMatrix::preconditioner> preconditioner = lduMatrix::preconditioner::New(
        *this, controlDict_);
    p = Zero;
    solveScalar rz = 0;
    do
    {
        precondition(z, r, *preconditioner, q, bodies, cmpt);
        const solveScalar rzOld = rz;
        const solveScalar change = gSumProd(z, r, comm) - gSumProd(z, old, comm);
        rz = gSumProd(z, r, comm);
        const solveScalar beta = rzOld != 0 ? change/rzOld : 0;
        forAll(p, i) p[i] = z[i] + beta*p[i];

        product(q, p, bodies, cmpt);
        const solveScalar pq = gSumProd(p, q, comm);
        if (performance.checkSingularity(mag(pq)/normFactor)) break;
        const solveScalar alpha = rz/pq;
        old = r;
        forAll(p, i)
        {
            psi[i] += alpha*p[i];
            r[i] -= alpha*q[i];
        }
        performance.finalResidual() = gSumMag(r, comm)/normFactor;
    }
    while ((++performance.nIterations() < maxIter_
               && !performance.checkConvergence(tolerance_, relTol_))
        || performance.nIterations() < minIter_);
    return performance;
}


Foam::solverPerformance Foam::coupledPCG::solve(
    scalarField& psi_s, const scalarField& source, const direction cmpt) const
{
    PrecisionAdaptor<solveScalar, scalar> psi(psi_s);
    return scalarSolve(psi.ref(), ConstPrecisionAdaptor<solveScalar, scalar>(source)(), cmpt);
}

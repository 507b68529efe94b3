/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    What the log says of solids in a fluid.
\*---------------------------------------------------------------------------*/

#include "coupledSolids.H"
#include "bodyLog.H"
#include "listed.H"
#include "moduleLog.H"
#include "touchingStart.H"
#include "solvers/dem/demStill.hpp"

// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::coupledSolids::stepsIn(scalar fluidStep) const
{
    const riprap::DemPlan plan(solids_->plan());

    const scalar most = 1e6;
    const scalar steps = riprap::isStill(input_)
        ? 1
        : std::ceil(fluidStep/plan.timeStep*(1 - 1e-9));
    if (steps > most)
    {
        FatalIOErrorInFunction(dict())
            << "Solids would take " << steps << " steps of " << plan.timeStep << " s ("
            << plan.cause.c_str() << ") in a step of the fluid, which is " << fluidStep
            << " s; at most " << most
            << " are taken. Is an entry stiffness or E of pairs, materials or bonds in the right "
               "unit?"
            << exit(FatalIOError);
    }
    return steps;
}


void Foam::coupledSolids::logSolids
(
    scalar fluidStep,
    const std::string& limit
) const
{
    const riprap::DemConfig& c = settings_.config;
    const riprap::DemPlan plan(solids_->plan());

    logItem("particles") << label(plan.particles) << ", clumps "
        << label(plan.clumps) << ", bonds " << label(plan.bonds)
        << ", wall elements " << label(plan.wallElements) << nl;
    logBodies(c, input_);
    logItem("contact") << c.normal.c_str() << ", "
        << c.tangential.c_str() << ", rolling "
        << c.rolling.c_str() << nl;
    for (const demGroup& g : settings_.groups)
    {
        label held = 0;
        for (const bool h : g.group.held) held += h;
        logItem("group " + g.group.name)
            << (g.moves ? "moved, " : held == 3 ? "fixed, " : held ? "held along some axes, " : "")
            << "localDamping " << g.group.localDamping
            << ", viscousDamping " << g.group.viscousDamping << nl;
    }
    for (const riprap::DemBondType& b : input_.bondTypes)
    {
        logItem("bonds") << "normalStiffness " << b.normalStiffness
            << " Pa/m, shearStiffness " << b.shearStiffness
            << " Pa/m, radiusFactor " << b.radiusFactor
            << ", dampingRatio " << b.dampingRatio << nl;
    }

    const scalar steps = stepsIn(fluidStep);
    logItem("timeIntegration") << c.integrator.c_str()
        << ", step " << plan.timeStep << " s (" << plan.cause.c_str() << "): "
        << label(steps)
        << " a step of the fluid, which is " << fluidStep << " s (" << limit.c_str() << ')' << nl;
    for (const std::string& warning : plan.warnings)
    {
        logItem("") << warning.c_str() << nl;
    }
    if (settings_.unused.size())
    {
        logItem("not used") << listed(settings_.unused).c_str() << nl;
    }
    Info<< endl;
    if (!run_.steps) warnOfTouchingStart(*solids_, c, input_);
}


void Foam::coupledSolids::logSteps
(
    label subcycles,
    const riprap::Vector3& force
) const
{
    Info<< "Solids: steps = " << report_.steps << " (" << run_.steps << "), "
        << subcycles << " a step of the fluid, max(mag(U)) = "
        << report_.maxSpeed << " m/s, force of the fluid = ("
        << force[0] << ' ' << force[1] << ' ' << force[2] << ") N";
    if (input_.bonds.size())
    {
        Info<< ", broken bonds = "
            << int64_t(report_.brokenBonds) + run_.brokenBefore;
    }
    Info<< endl;
    if (report_.escaped.size())
    {
        escaped_.log(report_.escaped.size(), run_.escaped, run_.outflow);
    }
}


// ************************************************************************* //

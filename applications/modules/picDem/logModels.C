/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Every model in use, once, and what is off.
\*---------------------------------------------------------------------------*/

#include "picDem.H"
#include "deviceChoice.H"
#include "listed.H"
#include "logPrecision.H"
#include "modelReader.H"
#include "moduleLog.H"
#include "sphNames.H"
#include "solvers/pic/transfer/picTransfers.hpp"
#include "api/sphScene.hpp"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static void logTransfer(const riprap::PicConfig& c)
{
    for (const riprap::SplineCard& card : riprap::splines())
    {
        if (card.order == c.splineOrder) logItem("spline") << card.word << nl;
    }
    const riprap::TransferCard card(riprap::transferOf(c));
    const auto& numbers = c.transferNumbers;
    logItem("transfer") << card.word;
    for (const riprap::TransferEntry& e : card.entries)
    {
        if (isShown(e, numbers))
        {
            printEntry(Info<< ", ", e, numbers, c.dimensions == 2);
        }
    }
    Info<< (keepsGradient(card, numbers) ? ", affine" : "") << nl;
}


static void logGrid(const riprap::PicConfig& c)
{
    logItem("grid") << c.dimensions << "D: ";
    for (int d = 0; d < c.dimensions; ++d)
    {
        Info<< (d ? " x " : "") << c.cells[c.axes[d]];
    }
    Info<< " cells of " << c.cellSize << " m along "
        << axesText(c, false).c_str() << "; periodic: "
        << axesText(c, true).c_str() << nl;
}


//- Where water is calmed, comes and goes
static void logZones(const riprap::PicConfig& c)
{
    for (const riprap::PicAbsorber& zone : c.absorbers)
    {
        logItem("absorb") << zone.name.c_str() << ", " << zone.rate << " 1/s"
            << nl;
    }
    for (const riprap::PicOpening& opening : c.openings)
    {
        logItem("opening") << opening.name.c_str() << ", "
            << opening.kind.c_str() << nl;
    }
}


static void logTimeStep(const riprap::PicConfig& c)
{
    logItem("time step");
    if (c.adjustTimeStep)
    {
        Info<< "maxCo " << c.maxCourant << ", of flying particles "
            << c.maxFlyingCourant;
    }
    else
    {
        Info<< "fixed deltaT " << c.fixedTimeStep << " s";
    }
    Info<< nl;
}

} // End namespace Foam


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

Foam::wordList Foam::solverModules::picDem::modelsOff() const
{
    const riprap::PicConfig& c = settings_.config;

    DynamicList<word> off;
    if (c.viscosity == 0) off.append("viscosity");
    if (c.reflection == 0) off.append("reflection");
    if (c.absorbers.empty()) off.append("absorb");
    if (c.openings.empty()) off.append("openings");
    if (c.positionCorrection == 0) off.append("positionCorrection");
    if (c.slowInterval == 1) off.append("multirate");
    if (!c.adjustTimeStep) off.append("adjustTimeStep");

    return wordList(off);
}


void Foam::solverModules::picDem::logModels() const
{
    const logPrecision digits;

    const riprap::PicConfig& c = settings_.config;
    const riprap::DeviceChoice choice =
        riprap::chooseDevice(c.device, run_.particles, c.dimensions);

    Info<< nl << "Particles in cells" << nl;
    logItem("particles") << run_.particles << ", spacing " << run_.spacing
        << " m; given with spacing " << run_.given << " m" << nl;
    logGrid(c);
    logDevice
    (
        scene_->deviceName(),
        choice.reason,
        scene_->device(),
        arraysTogether(*scene_)
    );
    logItem("precision") << sphNames::precision[c.precision] << nl;
    logTransfer(c);
    logItem("advection") << picNames::advection[c.advectionOrder]
        << (c.reflection > 0 ? ", reflection" : "") << nl;
    if (c.positionCorrection > 0)
    {
        logItem("positionCorrection") << c.positionCorrection << nl;
    }
    if (c.slowInterval > 1)
    {
        logItem("multirate") << "slow particles once in " << c.slowInterval
            << " steps, path of " << c.slowCourant << " cells at most" << nl;
    }
    logItem("fluid") << "rho " << c.density << " kg/m3, mu " << c.viscosity
        << " Pa s, nu " << c.viscosity/c.density << " m2/s" << nl;
    if (c.viscosity > 0)
    {
        logItem("viscosity") << c.viscousScheme.c_str() << nl;
    }
    ranks_.logPressure(c, bool(solids_));
    logItem("walls") << (c.noSlip ? "noSlip" : "freeSlip") << nl;
    logZones(c);
    if (obstacles_.valid())
    {
        logItem("obstacles") << listed(obstacles_->names()).c_str() << ", moving: "
            << bodies_.size() << nl;
    }

    logTimeStep(c);
    logItem("guards") << "Courant " << c.maxCourantEver << ", "
        << settings_.guards << nl;
    logUnused(settings_.unused, ": other transfers'");
    logItem("off") << listed(modelsOff()).c_str() << nl << endl;

    if (solids_)
    {
        solids_->logModels();
    }
}


// ************************************************************************* //

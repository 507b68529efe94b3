/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Every model in use, once, and what is off.
\*---------------------------------------------------------------------------*/

#include "sphDem.H"
#include "deviceChoice.H"
#include "logPrecision.H"
#include "moduleLog.H"
#include "listed.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

Foam::wordList Foam::solverModules::sphDem::modelsOff() const
{
    const riprap::SphConfig& c = settings_.config;
    using namespace riprap;

    const bool laminar =
        c.viscosityModel == ViscosityKind::laminar
     || c.viscosityModel == ViscosityKind::laminarAndArtificial;
    const bool artificial =
        c.viscosityModel == ViscosityKind::artificial
     || c.viscosityModel == ViscosityKind::laminarAndArtificial;

    DynamicList<word> off;
    if (!c.variableSmoothing) off.append("variableSmoothingLength");
    if (!laminar) off.append("laminarViscosity");
    if (!artificial) off.append("artificialViscosity");
    if (c.antiClump == 0) off.append("antiClump");
    if (c.xsph == 0) off.append("XSPH");
    if (c.diffusion == DiffusionKind::none) off.append("densityDiffusion");
    if (c.shifting == ShiftingKind::none) off.append("shifting");
    if (walls_.size() == 0) off.append("walls");
    if (bodies_.size() == 0) off.append("movingWalls");
    if (!solids_) off.append("solids");
    if (!c.adjustTimeStep) off.append("adjustTimeStep");

    return wordList(off);
}


void Foam::solverModules::sphDem::logTerms() const
{
    const riprap::SphConfig& c = settings_.config;
    using namespace riprap;

    logItem("viscosity")
        << sphNames::viscosity[c.viscosityModel]
        << ", mu " << c.viscosity << " Pa s, nu " << c.viscosity/c.density
        << " m2/s";
    if
    (
        c.viscosityModel == ViscosityKind::laminar
     || c.viscosityModel == ViscosityKind::laminarAndArtificial
    )
    {
        Info<< ", softening " << c.viscositySoftening;
    }
    if (c.viscosityModel >= ViscosityKind::artificial)
    {
        Info<< ", alpha " << c.artificialAlpha;
    }
    Info<< nl;

    if (c.antiClump > 0)
    {
        logItem("antiClump") << c.antiClump << nl;
    }
    if (c.xsph > 0)
    {
        logItem("XSPH") << c.xsph << nl;
    }
    if (c.diffusion != DiffusionKind::none)
    {
        logItem("densityDiffusion")
            << sphNames::densityDiffusion[c.diffusion]
            << ", delta " << c.diffusionDelta << nl;
    }
    if (c.shifting != ShiftingKind::none)
    {
        logItem("shifting")
            << sphNames::shifting[c.shifting] << ", A "
            << c.shiftingCoefficient << ", surfaceThreshold "
            << c.shiftingSurfaceThreshold << nl;
    }
}


void Foam::solverModules::sphDem::logModels() const
{
    const logPrecision digits;

    const riprap::SphConfig& c = settings_.config;
    const riprap::DeviceChoice choice =
        riprap::chooseDevice(c.device, run_.particles, c.dimensions);

    Info<< nl << "Smoothed particle hydrodynamics" << nl;
    logItem("particles") << "fluid " << run_.particles << ", walls "
        << walls_.size() << nl;
    logItem("space") << c.dimensions << "D: " << axesText(c, false).c_str()
        << "; periodic: " << axesText(c, true).c_str() << nl;
    logDevice
    (
        scene_->deviceName(),
        choice.reason,
        scene_->device(),
        arraysTogether(*scene_)
    );
    logItem("precision") << sphNames::precision[c.precision] << nl;

    logItem("kernel") << sphNames::kernel[c.kernel] << nl;
    logItem("smoothingLength") << (c.variableSmoothing ? "variable" : "constant")
        << ", h0 " << c.smoothingRatio*c.spacing << " m = "
        << c.smoothingRatio << " x spacing " << c.spacing << " m";
    if (c.variableSmoothing)
    {
        Info<< ", growth up to " << c.maxSmoothingGrowth;
    }
    Info<< nl;

    logItem("equationOfState") << sphNames::equationOfState[c.eos];
    if (c.eos == riprap::EosKind::Tait)
    {
        Info<< ", gamma " << c.gamma;
    }
    Info<< ", rho " << c.density << " kg/m3, c0 " << c.soundSpeed << " m/s = "
        << settings_.soundSpeedRatio << " x maxVelocity " << c.maxVelocity
        << " m/s" << (settings_.autoMaxVelocity ? " (auto)" : "") << nl;

    logTerms();

    if (walls_.size())
    {
        logItem("walls") << sphNames::wallModel[c.wallModel] << ", "
            << (c.noSlip ? "noSlip" : "freeSlip") << ", " << walls_.layers
            << " layers of spacing " << walls_.spacing << " m, "
            << (settings_.walls.impermeable ? "impermeable" : "permeable")
            << nl;
    }
    for (const string& note : walls_.notes)
    {
        logItem("") << note.c_str() << nl;
    }
    for (label i = 0; i < bodies_.size(); ++i)
    {
        logItem("moving walls") << bodies_.name(i) << ": " << bodies_.function(i)
            << nl;
    }

    logItem("timeIntegration") << sphNames::timeIntegration[c.integrator];
    if (c.adjustTimeStep)
    {
        Info<< ", acousticCourant " << c.acousticCourant << ", forceCourant "
            << c.forceCourant << ", viscousCourant " << c.viscousCourant;
    }
    else
    {
        Info<< ", fixed deltaT " << c.fixedTimeStep << " s";
    }
    Info<< nl;

    logItem("guards") << "densityDeviation " << c.maxDensityDeviation
        << ", speedRatio " << c.maxSpeedRatio << ", wild "
        << (c.removeWild ? "remove" : "stop") << ", maxWild "
        << settings_.maxWild << " 1/s, escape "
        << (settings_.guards.stopAtEscape ? "stop" : "warn")
        << ", maxEscaped " << settings_.guards.maxEscaped << nl;
    logItem("off") << listed(modelsOff()).c_str() << nl << endl;

    if (solids_)
    {
        solids_->logModels();
    }
}


// ************************************************************************* //

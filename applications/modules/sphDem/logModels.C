/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Every model in use, once, and what is off.
\*---------------------------------------------------------------------------*/

#include "sphDem.H"
#include "logPrecision.H"
#include "listed.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static std::string axesOf(const riprap::SphConfig& config, bool periodic)
{
    std::string text;
    for (int i = 0; i < config.dimensions; ++i)
    {
        const int axis = config.axes[i];
        if (!periodic || config.periodic[axis])
        {
            text += std::string(text.empty() ? "" : " ") + "xyz"[axis];
        }
    }
    return text.empty() ? "none" : text;
}


static Ostream& item(std::string what)
{
    what.resize(16, ' ');
    return static_cast<OSstream&>(Info) << "    " << what.c_str() << ' ';
}

} // End namespace Foam


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
    if (!c.adjustTimeStep) off.append("adjustTimeStep");

    return wordList(off);
}


void Foam::solverModules::sphDem::logTerms() const
{
    const riprap::SphConfig& c = settings_.config;
    using namespace riprap;

    item("viscosity")
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
        item("antiClump") << c.antiClump << nl;
    }
    if (c.xsph > 0)
    {
        item("XSPH") << c.xsph << nl;
    }
    if (c.diffusion != DiffusionKind::none)
    {
        item("densityDiffusion")
            << sphNames::densityDiffusion[c.diffusion]
            << ", delta " << c.diffusionDelta << nl;
    }
    if (c.shifting != ShiftingKind::none)
    {
        item("shifting")
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
    item("particles") << "fluid " << run_.particles << ", walls "
        << walls_.size() << nl;
    item("space") << c.dimensions << "D: " << axesOf(c, false).c_str()
        << "; periodic: " << axesOf(c, true).c_str() << nl;
    item("device") << scene_->deviceName().c_str() << " ("
        << choice.reason.c_str() << ')' << nl;
    item("precision") << sphNames::precision[c.precision] << nl;

    item("kernel") << sphNames::kernel[c.kernel] << nl;
    item("smoothingLength") << (c.variableSmoothing ? "variable" : "constant")
        << ", h0 " << c.smoothingRatio*c.spacing << " m = "
        << c.smoothingRatio << " x spacing " << c.spacing << " m";
    if (c.variableSmoothing)
    {
        Info<< ", growth up to " << c.maxSmoothingGrowth;
    }
    Info<< nl;

    item("equationOfState") << sphNames::equationOfState[c.eos];
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
        item("walls") << sphNames::wallModel[c.wallModel] << ", "
            << (c.noSlip ? "noSlip" : "freeSlip") << ", " << walls_.layers
            << " layers of spacing " << walls_.spacing << " m" << nl;
    }
    for (const string& note : walls_.notes)
    {
        item("") << note.c_str() << nl;
    }
    for (label i = 0; i < bodies_.size(); ++i)
    {
        item("moving walls") << bodies_.name(i) << ": " << bodies_.function(i)
            << nl;
    }

    item("timeIntegration") << sphNames::timeIntegration[c.integrator];
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

    item("guards") << "densityDeviation " << c.maxDensityDeviation
        << ", speedRatio " << c.maxSpeedRatio << ", escape "
        << (settings_.guards.stopAtEscape ? "stop" : "warn")
        << ", maxEscaped " << settings_.guards.maxEscaped << nl;
    item("off") << listed(modelsOff()).c_str() << nl << endl;
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The log of an OpenFOAM time step. Courant numbers are those of the
    particle steps, of what water carries: mean, |U|max dt/h of the mean step,
    not above max, since |U|max may be that of a drop; max, of the worst step.
\*---------------------------------------------------------------------------*/

#include "picDem.H"
#include "foamVersions/foamVersions.H"
#include "logPrecision.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static void logOpenings
(
    const riprap::PicReport& report,
    const riprap::PicConfig& config
)
{
    for (std::size_t k = 0; k < report.passed.size(); ++k)
    {
        const riprap::PicPassage& p = report.passed[k];
        Info<< "Opening " << config.openings[k].name.c_str()
            << ": particles in = " << label(p.in) << ", out = " << label(p.out)
            << ", volume in all = " << p.volume << endl;
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solverModules::picDem::report()
{
    for (const solverPerformance& solution : pressure_.takeSolutions())
    {
        recordSolution(mesh_, solution);
    }

    const logPrecision digits;

    const scalar h = settings_.config.cellSize;
    const scalar meanStep =
        runTime_.deltaTValue()/max(report_.steps, std::int64_t(1));

    Info<< "Courant Number mean: "
        << min(report_.maxSpeed*meanStep/h, report_.maxCourant)
        << " max: " << report_.maxCourant << nl
        << "Particle steps = " << report_.steps << " (" << run_.steps
        << "), deltaT = " << report_.minTimeStep << " to "
        << report_.maxTimeStep << " s, limit: " << report_.limit.c_str() << nl
        << "max(mag(U)) = " << report_.maxSpeed << " m/s, particles = "
        << run_.particles << ", flying = " << label(report_.flying);
    if (settings_.config.slowInterval > 1)
    {
        Info<< ", slow = " << label(report_.slow) << " ("
            << 100*scalar(report_.slow)/max(run_.particles, label(1)) << " %)";
    }
    Info<< nl
        << "Volume = " << report_.volume << ", error = "
        << report_.volumeError << ", put right so far = "
        << report_.volumeDrift << endl;

    logOpenings(report_, settings_.config);

    if (!report_.pressureConverged)
    {
        WarningInFunction
            << "The pressure equation was not solved to its tolerance; largest"
            << " residual " << report_.largestResidual << endl;
    }

    if (!report_.viscosityConverged)
    {
        WarningInFunction
            << "The implicit viscosity was not solved to its tolerance"
            << endl;
    }

    if (solids_)
    {
        solids_->logStep();
    }
    ranks_.log(report_.rank);
    logEscaped(report_.escaped.size(), run_);
    logProgress();
}


// ************************************************************************* //

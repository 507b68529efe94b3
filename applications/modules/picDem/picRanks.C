/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "picRanks.H"
#include "logRanks.H"
#include "moduleLog.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Where a case says something, for messages
struct caseEntry
{
    std::string what;
    dictionary dict;
};


static caseEntry subEntry
(
    const dictionary& dict,
    const word& name,
    const std::string& what
)
{
    caseEntry sub{what, dict.subOrEmptyDict(name)};
    sub.dict.name() = dict.name() + '.' + name;
    return sub;
}


static caseEntry entryOf
(
    const Time& time,
    const dictionary& dict,
    riprap::PicInput input
)
{
    using riprap::PicInput;

    switch (input)
    {
        case PicInput::device: return {"Entry device", dict};
        case PicInput::guards: return subEntry(dict, "guards", "Entry Courant");
        case PicInput::multirate: return {"Entry multirate", dict};
        case PicInput::solver: break;
    }
    caseEntry solver{"Entry solver of p", dictionary()};
    solver.dict.name() = time.globalPath()/time.system()/"fvSolution";
    return solver;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::picRanks::picRanks(const Time& time)
:
    time_(time)
{
    if (Pstream::parRun()) transport_ = std::make_unique<pstreamTransport>();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::picRanks::check
(
    const picSettings& settings,
    const pressureSolver& pressure
) const
{
    if (!transport()) return;

    riprap::PicConfig config(settings.config);
    config.ranks = transport();
    try
    {
        riprap::checkPicRanks(config, &pressure);
    }
    catch (const riprap::PicRefusal& e)
    {
        refuse(settings, e);
    }
}


//- What they cannot have is said by the core; where the case says it, here
void Foam::picRanks::refuse
(
    const picSettings& settings,
    const riprap::PicRefusal& e
) const
{
    const caseEntry entry(entryOf(time_, settings.dict, e.input));
    FatalIOErrorInFunction(entry.dict)
        << entry.what.c_str() << ", with -parallel: " << e.what()
        << ". There are " << Pstream::nProcs() << "; one uses all cores of a"
        << " machine (OMP_NUM_THREADS)" << exit(FatalIOError);
}


void Foam::picRanks::join(std::unique_ptr<riprap::PicScene>& scene)
{
    if (!transport()) return;

    part_ = std::move(scene);
    scene = riprap::wholePicScene(*part_, *transport_);
}


void Foam::picRanks::logPressure(const riprap::PicConfig& c, bool solids) const
{
    if (!transport()) return;

    scalar cells = 1;
    for (int d = 0; d < c.dimensions; ++d) cells *= c.cells[c.axes[d]];
    logItem("pressure");
    if (solids)
    {
        Info<< "divided over the processes, as there are solids" << nl;
        return;
    }
    if (cells <= c.gatheredCells)
    {
        Info<< "gathered: each process solves for all "
            << std::to_string(int64_t(cells)).c_str() << " cells";
    }
    else
    {
        Info<< "divided over the processes";
    }
    Info<< " (gatheredCells " << c.gatheredCells << ')' << nl;
}


//- The memory of either way to solve is taken when a scene is made
void Foam::picRanks::warnOfEdits
(
    const picSettings& asRead,
    const picSettings& used,
    const pressureSolver& pressure,
    bool solids
) const
{
    // With solids it has no meaning
    if (solids) return;

    const label now = used.config.gatheredCells;
    const label then = pressure.gatheredCells(asRead.config.gatheredCells);
    if (!transport() || then == now) return;

    WarningInFunction
        << "Entry gatheredCells of p in system/fvSolution is read when a run"
        << " begins: this one goes on with " << now << ", the next takes "
        << then << endl;
}


void Foam::picRanks::log(const riprap::RankReport& here)
{
    if (!transport()) return;
    logRanks(*transport_, here);
}


// ************************************************************************* //

/*  SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "solverEntries.H"
#include <map>
#include "lduMatrix.H"
#include "Switch.H"

namespace Foam
{

namespace
{

enum class holds { name, nameOrDictionary, whole, number, onOff, anything };

//- Of OpenFOAM v1912 to v2512: one that another solver uses may stand there, so that one word
//  changes the solver
const std::map<std::string, holds> entries({{"solver", holds::name},
    {"preconditioner", holds::nameOrDictionary}, {"smoother", holds::nameOrDictionary},
    {"norm", holds::name}, {"tolerance", holds::number}, {"relTol", holds::number},
    {"maxIter", holds::whole}, {"minIter", holds::whole}, {"log", holds::whole},
    {"nSweeps", holds::whole}, {"nVcycles", holds::whole}, {"cacheAgglomeration", holds::onOff},
    {"nPreSweeps", holds::whole}, {"preSweepsLevelMultiplier", holds::whole},
    {"maxPreSweeps", holds::whole}, {"nPostSweeps", holds::whole},
    {"postSweepsLevelMultiplier", holds::whole}, {"maxPostSweeps", holds::whole},
    {"nFinestSweeps", holds::whole}, {"interpolateCorrection", holds::onOff},
    {"scaleCorrection", holds::onOff}, {"directSolveCoarsest", holds::onOff},
    {"agglomerator", holds::name}, {"nCellsInCoarsestLevel", holds::whole},
    {"mergeLevels", holds::whole}, {"updateInterval", holds::anything},
    {"processorAgglomerator", holds::name}, {"nAgglomeratingCells", holds::whole},
    {"processorAgglomeration", holds::anything}, {"nProcessorsPerMaster", holds::whole},
    {"nCellsInMasterLevel", holds::anything}, {"nMasters", holds::whole}, {"nLevels", holds::whole},
    {"coarsestLevelCorr", holds::anything}, {"deflation", holds::anything}});

const wordList ofOpenFOAM({"PCG", "FPCG", "PPCG", "PPCR", "PBiCG", "PBiCGStab", "smoothSolver",
    "GAMG", "diagonal", "coupledPCG"});


[[noreturn]] void stop(
    const dictionary& dict, const word& entry, const word& field, const char* what)
{
    FatalIOErrorInFunction(dict) << "Entry " << entry << " of the solver of " << field << ' '
                                << what << exit(FatalIOError);
    std::abort();
}


void checkNumber(const dictionary& dict, const word& entry, const word& field)
{
    const scalar value = dict.get<scalar>(entry);
    if (!(value >= 0)) stop(dict, entry, field, "must be 0 or more");
    if (entry == "relTol" && value >= 1)
        stop(dict, entry, field, "must be less than 1: nothing would be solved");
}


void checkName(const dictionary& dict, const word& entry, const word& field)
{
    const word name(dict.get<word>(entry));
    const auto& smoothers = *lduMatrix::smoother::symMatrixConstructorTablePtr_;
    if (entry != "smoother" || smoothers.found(name)) return;
    FatalIOErrorInFunction(dict) << "unknown smoother '" << name << "' for " << field
                                << ". Valid: " << smoothers.sortedToc() << exit(FatalIOError);
}


void checkEntry(const dictionary& dict, const word& entry, holds kind, const word& field)
{
    const bool isDictionary = dict.isDict(entry);
    if (kind == holds::anything) return;
    if (kind == holds::nameOrDictionary && isDictionary)
    {
        checkName(dict.subDict(entry), entry, field);
        checkSolverEntries(dict.subDict(entry), field);
        return;
    }
    if (isDictionary) stop(dict, entry, field, "must be a value, not a dictionary");
    if (kind == holds::number) checkNumber(dict, entry, field);
    else if (kind == holds::onOff) dict.get<Switch>(entry);
    else if (kind != holds::whole) checkName(dict, entry, field);
    else if (dict.get<label>(entry) < 0) stop(dict, entry, field, "must be 0 or more");
}


wordList validEntries()
{
    wordList valid(label(entries.size()));
    label i = 0;
    for (const auto& known : entries) valid[i++] = known.first;
    return valid;
}

}


void checkSolverEntries(const dictionary& controls, const word& field)
{
    const bool foreign = controls.found("solver")
        && !ofOpenFOAM.found(controls.get<word>("solver"));
    for (const entry& e : controls)
    {
        const auto known = entries.find(e.keyword());
        if (known != entries.end()) checkEntry(controls, e.keyword(), known->second, field);
        else if (!foreign)
        {
            FatalIOErrorInFunction(controls)
                << "unknown entry '" << e.keyword() << "' of the solver of " << field
                << ". Valid: " << validEntries() << exit(FatalIOError);
        }
    }
}

} // End namespace Foam

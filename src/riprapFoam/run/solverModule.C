/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solverModule.H"
#include "Time.H"
#include "OSspecific.H"
#include "didYouMean.H"
#include "Pstream.H"

namespace Foam
{
    defineTypeNameAndDebug(solverModule, 0);
    defineRunTimeSelectionTable(solverModule, fvMesh);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Those loaded, and the libraries of riprap and of the user
static wordList availableModules()
{
    wordHashSet names;

    if (solverModule::fvMeshConstructorTablePtr_)
    {
        names.insert(solverModule::fvMeshConstructorTablePtr_->toc());
    }

    const std::string head("lib");
    const std::string tail("Solver.so");
    for (const char* folder : {"RIPRAP_LIBBIN", "FOAM_USER_LIBBIN"})
    {
        for (const fileName& file : readDir(getEnv(folder)))
        {
            if
            (
                file.size() > head.size() + tail.size()
             && file.starts_with(head)
             && file.ends_with(tail)
            )
            {
                names.insert
                (
                    file.substr
                    (
                        head.size(),
                        file.size() - head.size() - tail.size()
                    )
                );
            }
        }
    }

    return names.sortedToc();
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::wordHashSet& Foam::solverModule::divided()
{
    static wordHashSet names;
    return names;
}



Foam::autoPtr<Foam::solverModule> Foam::solverModule::New
(
    const word& name,
    Time& runTime,
    fvMesh& mesh
)
{
    const fileName library("lib" + name + "Solver.so");

    // Not verbose: what is missing is said once, below
    runTime.libs().open(library, false);

    // The table does not exist before the first module is loaded
    if (fvMeshConstructorTablePtr_)
    {
        const auto constructor = fvMeshConstructorTablePtr_->cfind(name);
        if (constructor.found())
        {
            if (Pstream::parRun() && !divided().found(name))
            {
                FatalIOErrorInFunction(runTime.controlDict())
                    << "Entry solver is " << name << ", which runs on one"
                    << " process, and there are " << Pstream::nProcs()
                    << ": without -parallel it uses all cores"
                    << " (OMP_NUM_THREADS) or one GPU; on several processes"
                    << " run solvers dem, sphDem and picDem" << exit(FatalIOError);
            }
            return constructor()(runTime, mesh);
        }
    }

    FatalIOErrorInFunction(runTime.controlDict())
        << "Unknown solver " << name << " (entry solver, or option -solver):"
        << " library " << library << " cannot be loaded or has none of that"
        << " name; available are " << listedFor(name, availableModules()).c_str()
        << exit(FatalIOError);

    return nullptr;
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readMesh.H"
#include "inputFile.H"
#include "OSspecific.H"
#include "Time.H"

Foam::autoPtr<Foam::fvMesh> Foam::readMesh(const Time& time)
{
    const fileName system(time.globalPath()/time.system());
    const bool schemes =
        isFile(system/"fvSchemes") && isFile(system/"fvSolution");

    for (const char* file : {"fvSchemes", "fvSolution"}) checkInputFile(system/file);

    // The mesh itself is read in any case
    return autoPtr<fvMesh>::New
    (
        IOobject
        (
            fvMesh::defaultRegion,
            time.timeName(),
            time,
            schemes ? IOobject::MUST_READ : IOobject::NO_READ
        )
    );
}


// ************************************************************************* //

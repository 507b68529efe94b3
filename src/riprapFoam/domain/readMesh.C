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
    const bool schemes = isFile(system/"fvSchemes");
    const bool solution = isFile(system/"fvSolution");

    for (const char* file : {"fvSchemes", "fvSolution"}) checkInputFile(system/file);

    // The mesh itself is read in any case
    auto mesh = autoPtr<fvMesh>::New
    (
        IOobject
        (
            fvMesh::defaultRegion,
            time.timeName(),
            time,
            schemes && solution ? IOobject::MUST_READ : IOobject::NO_READ
        )
    );

    // OpenFOAM's mesh reads both or neither, but no scheme is needed here
    if (solution && !schemes)
    {
        fvSolution& alone = *mesh;
        alone.readOpt() = IOobject::MUST_READ_IF_MODIFIED;
        alone.read();
    }
    return mesh;
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "buildInfo.H"
#include "error.H"
#include "foamVersions/foamVersions.H"

#if __has_include("riprapBuild.H")
    #include "riprapBuild.H"
#else
    #define RIPRAP_VERSION "unknown"
    #define RIPRAP_BUILD_FLAGS ""
    #define RIPRAP_BUILD_GPU "unknown"
#endif

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::writeBuildInfo(Ostream& os)
{
    #if defined(__clang__)
    const char* compiler = "clang " __clang_version__;
    #else
    const char* compiler = "g++ " __VERSION__;
    #endif

    os  << "riprap : " << RIPRAP_VERSION << ", for OpenFOAM v" << OPENFOAM << nl
        << "Flags  : " << compiler << ' ' << RIPRAP_BUILD_FLAGS << nl
        << "GPU    : " << RIPRAP_BUILD_GPU << nl << endl;

    if (foamVersion::api != OPENFOAM)
    {
        FatalErrorInFunction
            << "riprap was built for OpenFOAM v" << OPENFOAM << ", but the"
            << " libraries that are loaded are those of v" << foamVersion::api
            << ": source riprap's etc/bashrc in a new shell, or build riprap"
            << " again (./Allwmake)" << exit(FatalError);
    }
}


// ************************************************************************* //

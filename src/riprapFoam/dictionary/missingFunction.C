/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "missingFunction.H"
#include "etcFiles.H"
#include "functionObjectList.H"
#include "listed.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::string Foam::missingFunction(const std::string& nameAndArguments)
{
    const word name(nameAndArguments.substr(0, nameAndArguments.find('(')));
    if (functionObjectList::findDict(name).size()) return "";

    return
        "Function object " + name + " has no file: neither system/" + name
      + " nor one below caseDicts/postProcessing in "
      + listed(etcDirs()) + ". riprap's own are found after its"
        " etc/bashrc was sourced, where WM_PROJECT_SITE is not set to a folder"
        " of yours";
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "checkFunctionObjects.H"
#include "checkedDictionary.H"
#include "etcFiles.H"
#include "functionObjectList.H"
#include "listed.H"
#include "sceneFunctionObject.H"
#include "Switch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Function objects that write as soon as they are there do not after this
class notWriting
{
    const bool before_;

public:

    notWriting()
    :
        before_(functionObject::postProcess)
    {
        functionObject::postProcess = true;
    }

    ~notWriting()
    {
        functionObject::postProcess = before_;
    }
};


static bool isOfRiprap(const dictionary& dict)
{
    for (const char* entry : {"libs", "functionObjectLibs"})
    {
        if (!dict.found(entry)) continue;
        for (const fileName& library : dict.get<fileNameList>(entry))
        {
            if (library.find("riprap") != std::string::npos) return true;
        }
    }
    return false;
}


static void check(const word& name, const dictionary& dict, Time& time)
{
    checkedDictionary entries(dict);
    for (const char* entry : {"type", "libs", "functionObjectLibs"}) entries.found(entry);
    for (const char* entry : {"libs", "functionObjectLibs"}) time.libs().open(dict, entry);

    const word type(dict.get<word>("type"));
    if (!isOfRiprap(dict)) return;

    wordList valid;
    if (functionObject::dictionaryConstructorTablePtr_)
    {
        valid = functionObject::dictionaryConstructorTablePtr_->sortedToc();
    }
    if (!valid.found(type)) entries.unknownWord("type", type, valid);
    functionObject::New(name, time, dict);
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::checkFunctionObjects(Time& time)
{
    const notWriting quiet;
    const dictionary& control = time.controlDict();
    if (!control.found("functions")) return;

    for (const entry& e : checkedDictionary(control).subDict("functions"))
    {
        if (e.isDict() && e.dict().lookupOrDefault<Switch>("enabled", true)) check(e.keyword(), e.dict(), time);
    }
}


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

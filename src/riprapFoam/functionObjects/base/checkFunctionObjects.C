/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "checkFunctionObjects.H"
#include "checkedDictionary.H"
#include "functionObjectList.H"
#include "listed.H"
#include "macroUse.H"
#include "sceneFunctionObject.H"
#include "Switch.H"
#include "timeWriter.H"

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


//- Its library is loaded
static bool check(const dictionary& dict, Time& time)
{
    checkedDictionary entries(dict);
    for (const char* entry : {"type", "libs", "functionObjectLibs"}) entries.found(entry);
    for (const char* entry : {"libs", "functionObjectLibs"}) time.libs().open(dict, entry);

    const word type(dict.get<word>("type"));
    if (!isOfRiprap(dict)) return false;

    wordList valid;
    if (functionObject::dictionaryConstructorTablePtr_)
    {
        valid = functionObject::dictionaryConstructorTablePtr_->sortedToc();
    }
    if (!valid.found(type)) entries.unknownWord("type", type, valid);
    return true;
}

//- Values among the functions: OpenFOAM passes over them with a warning
static void requireDictionary(const entry& e, const dictionary& functions, const Time& time)
{
    const wordList known({"libs", "errors", "useNamePrefix"});
    if (known.found(e.keyword())
        || !heldForNothing(time.globalPath()/"system"/Time::controlDictName, e.keyword()))
        return;
    FatalIOErrorInFunction(functions)
        << "Entry " << e.keyword() << " of functions must be a dictionary: "
        << e.keyword() << " { type ..; }. A value may stand there where the"
        << " file uses it as $" << e.keyword() << exit(FatalIOError);
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::vector<Foam::functionDict> Foam::functionDicts(Time& time)
{
    std::vector<functionDict> all;
    const dictionary& control = time.controlDict();
    if (!control.found("functions")) return all;

    const dictionary& functions = checkedDictionary(control).subDict("functions");
    for (const entry& e : functions)
    {
        if (!e.isDict()) requireDictionary(e, functions, time);
        if (e.isDict() && e.dict().lookupOrDefault<Switch>("enabled", true))
        {
            all.push_back({e.keyword(), e.dict(), check(e.dict(), time)});
        }
    }
    return all;
}


Foam::autoPtr<Foam::functionObject> Foam::makeFunctionObject
(
    const functionDict& f,
    const Time& time
)
{
    const notWriting quiet;
    const timeWriter::trial nothingIsWritten;
    dictionary dict(f.dict);
    dict.set("log", false);
    return functionObject::New(f.name, time, dict);
}


void Foam::checkFunctionObjects(Time& time)
{
    for (const functionDict& f : functionDicts(time))
    {
        if (f.ofRiprap) makeFunctionObject(f, time);
    }
}


// ************************************************************************* //

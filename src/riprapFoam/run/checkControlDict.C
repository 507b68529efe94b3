/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "checkControlDict.H"
#include "checkedDictionary.H"
#include "didYouMean.H"
#include "IFstream.H"
#include "inputFile.H"
#include "OSspecific.H"
#include "timePlan.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static void checkNames(const dictionary& control)
{
    static const wordList known({"application", "solver", "startFrom", "startTime", "stopAt",
        "endTime", "deltaT", "adjustTimeStep", "maxDeltaT", "maxCo", "maxFlyingCo",
        "sampleInterval", "writeControl", "writeInterval", "writeFrequency", "purgeWrite",
        "writeFormat", "writePrecision", "writeCompression", "stateInterval", "pictureFields",
        "writeVersion", "writeAsynchronously", "timeFormat", "timePrecision", "runTimeModifiable",
        "graphFormat", "functions", "libs", "profiling", "DebugSwitches", "InfoSwitches",
        "OptimisationSwitches", "DimensionedConstants", "DimensionSets"});
    for (const entry& e : control)
    {
        const word& name = e.keyword();
        if (known.found(name) || e.keyword().isPattern()) continue;
        for (const word& right : known)
        {
            if (slips(name, right) <= (right.size() < 5 ? 1 : 2))
            {
                FatalIOErrorInFunction(control) << "Unknown entry " << name << ": is " << right
                                                << " meant?" << exit(FatalIOError);
            }
        }
    }
}


static void checkWord(checkedDictionary& control, const word& entry, const wordList& valid)
{
    if (!control.found(entry)) return;
    const word typed(control.dict().get<word>(entry));
    if (!valid.found(typed)) control.unknownWord(entry, typed, valid);
}


//- 0 and 1 are switches for OpenFOAM, as any number is
static void checkSwitch(checkedDictionary& control, const word& entry, const wordList& valid)
{
    if (!control.found(entry)) return;
    const token typed(control.dict().lookup(entry));
    if (typed.isLabel() && (typed.labelToken() == 0 || typed.labelToken() == 1))
        control.dict().get<label>(entry);
    else checkWord(control, entry, valid);
}


//- Times that are rounded to 12 digits
static void checkInterval(checkedDictionary& control, const word& entry, bool zero)
{
    if (!control.found(entry)) return;
    const scalar interval = control.number(entry);
    control.require
    (
        (zero && interval == 0) || interval >= 1e-12,
        entry,
        interval,
        zero ? "zero (every particle step) or positive, at least 1e-12" : "positive, at least 1e-12"
    );
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::checkControlDict(const fileName& file)
{
    if (!isFile(file)) return;

    checkInputFile(file);
    IFstream is(file);
    dictionary dict(is);
    dict.remove("FoamFile");
    checkNames(dict);

    checkedDictionary control(dict);
    const wordList onOff({"on", "off", "yes", "no", "true", "false"});
    wordList compression(onOff);
    compression.append(wordList({"compressed", "uncompressed"}));
    checkWord(control, "writeFormat", {"ascii", "binary"});
    checkWord(control, "writeCompression", compression);
    checkWord(control, "writeAsynchronously", onOff);
    checkSwitch(control, "runTimeModifiable",
        {"on", "off", "yes", "no", "true", "false", "y", "n", "t", "f", "none"});
    checkWord(control, "timeFormat", {"general", "fixed", "scientific"});

    control.whole("stateInterval", 1, 1, labelMax);
    if (control.found("pictureFields"))
    {
        control.dict().get<wordList>("pictureFields");
        if (control.whole("stateInterval", 1, 1, labelMax) == 1)
        {
            FatalIOErrorInFunction(dict)
                << "Entry pictureFields without stateInterval: every written"
                << " time holds the state and all fields" << exit(FatalIOError);
        }
    }
    control.whole("purgeWrite", 0, 0, labelMax);
    control.whole("writePrecision", 6, 1, 100);
    control.whole("timePrecision", 6, 1, 100);
    checkInterval(control, "sampleInterval", true);
    if (control.found("endTime")) control.dict().get<scalar>("endTime");

    requireWriteIntervals(file);
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "timePlan.H"
#include "checkedDictionary.H"
#include "IFstream.H"
#include "OSspecific.H"
#include <cstdio>
#include <cstdlib>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Nearest number of 12 digits: 3*0.1 and 0.2 + 0.1 become the same 0.3
static scalar rounded(scalar value)
{
    char text[32];
    std::snprintf(text, sizeof(text), "%.12g", double(value));
    return std::strtod(text, nullptr);
}


static bool isAdjustable(const word& control)
{
    return control == "adjustableRunTime" || control == "adjustable";
}


//- Of what = write or execute
static void requireInterval(const dictionary& dict, const word& what)
{
    const word control(dict.getOrDefault<word>(what + "Control", word::null));
    if (control.empty() || control == "none" || control == "timeStep")
    {
        return;
    }
    for (const word& entry : wordList({what + "Interval", what + "Frequency"}))
    {
        checkedDictionary entries(dict);
        if (entries.found(entry)) entries.positive(entry);
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::requireWriteIntervals(const fileName& controlDict)
{
    if (!isFile(controlDict))
    {
        return;
    }
    IFstream file(controlDict);
    const dictionary dict(file);

    requireInterval(dict, "write");
    if (const dictionary* functions = dict.findDict("functions"))
    {
        for (const entry& e : *functions)
        {
            if (!e.isDict()) continue;
            requireInterval(e.dict(), "write");
            requireInterval(e.dict(), "execute");
        }
    }
}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

Foam::scalar Foam::timePlan::nextMultiple
(
    scalar now,
    scalar origin,
    scalar interval
)
{
    const scalar count = floor((now - origin)/interval + 1e-6) + 1;
    return rounded(origin + count*interval);
}


Foam::scalar Foam::timePlan::nextWrite(const dictionary& dict) const
{
    // It may have been edited during the run
    requireInterval(dict, "write");
    scalar interval = 0;

    if
    (
        isAdjustable(dict.getOrDefault<word>("writeControl", word::null))
     && (
            dict.readIfPresent("writeInterval", interval)
         || dict.readIfPresent("writeFrequency", interval)
        )
     && interval > 0
    )
    {
        return nextMultiple
        (
            runTime_.value(),
            runTime_.startTime().value(),
            interval
        );
    }

    return VGREAT;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::timePlan::timePlan(Time& runTime)
:
    runTime_(runTime)
{
    const scalar end = runTime_.endTime().value();
    const scalar now = runTime_.value();
    if (end < now - 1e-9*mag(now))
    {
        FatalIOErrorInFunction(runTime_.controlDict())
            << "Entry endTime is " << end << ", before time " << now
            << " at which the run starts" << exit(FatalIOError);
    }

    // What controlDict calls deltaT is the particles' step: it says nothing
    // about the first time step of OpenFOAM, on which Time::run() would go
    const scalar first = target() - runTime_.value();
    if (first > 0)
    {
        runTime_.setDeltaT(first, false);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::timePlan::sampleInterval() const
{
    const dictionary& dict = runTime_.controlDict();

    scalar interval = 0;
    if (dict.readIfPresent("sampleInterval", interval))
    {
        if (!(interval >= 0))
        {
            FatalIOErrorInFunction(dict)
                << "Entry sampleInterval is " << interval
                << ": it must be zero (every particle step) or positive"
                << exit(FatalIOError);
        }
        return interval;
    }

    const word control(dict.getOrDefault<word>("writeControl", word::null));
    if (isAdjustable(control) || control == "runTime")
    {
        if
        (
            dict.readIfPresent("writeInterval", interval)
         || dict.readIfPresent("writeFrequency", interval)
        )
        {
            return interval/10;
        }
    }

    const scalar end = dict.getOrDefault<scalar>("endTime", 0);
    return max(end - runTime_.startTime().value(), SMALL)/100;
}


bool Foam::timePlan::run()
{
    const scalar left = runTime_.endTime().value() - runTime_.value();
    const scalar step = runTime_.deltaTValue();

    if (left > 1e-6*step && left < 0.6*step)
    {
        runTime_.setDeltaT(left, false);
    }

    return runTime_.run();
}


Foam::scalar Foam::timePlan::target() const
{
    const scalar now = runTime_.value();
    const dictionary& dict = runTime_.controlDict();

    scalar write = nextWrite(dict);
    if (const dictionary* functions = dict.findDict("functions"))
    {
        for (const entry& e : *functions)
        {
            if (e.isDict())
            {
                write = min(write, nextWrite(e.dict()));
            }
        }
    }

    const scalar end = rounded(runTime_.endTime().value());
    const scalar interval = sampleInterval();

    scalar next = write;
    if (interval > 0)
    {
        // Equal steps up to a write: Time and function objects write at the
        // first step that ends less than half of it before the time asked
        // for. Without one, multiples of the interval
        next =
        (
            write < GREAT
          ? rounded(now + (write - now)/ceil((write - now)/interval - 1e-6))
          : nextMultiple(now, 0, interval)
        );
    }

    // No sliver of a step before the end
    return next < end - 1e-6*(next - now) ? next : end;
}


void Foam::timePlan::advanceTo(scalar time)
{
    runTime_.setDeltaT(time - runTime_.value(), false);
    ++runTime_;

    // Round-off of the sum: the particles' clock is the one that counts
    runTime_.setTime(time, runTime_.timeIndex());
}


// ************************************************************************* //

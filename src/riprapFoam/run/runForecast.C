/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "runForecast.H"
#include "checkFunctionObjects.H"
#include "clockTime.H"
#include "listed.H"
#include "moduleLog.H"
#include "timeWriter.H"
#include "wallTimes.H"
#include <cmath>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Of the solver's time: what takes more is named
static const scalar worthNaming = 0.1;

//- Samples of each function object, of which the fastest counts
static const int repeats = 3;

//- Between samples: fewer are named
static const scalar fewSteps = 5;


//- One of riprap's own, what each call takes and how often it is called
struct timedObject
{
    word name;
    autoPtr<functionObject> object;
    scalar begin = 0, execute = 0, write = 0;       // [s]
    scalar executes = 0, writes = 0;

    scalar seconds() const
    {
        return begin + executes*execute + writes*write;
    }
};


//- What a written time takes
struct timedWrite
{
    scalar handOver = 0, format = 0;                // [s]
    scalar bytes = 0;
};


static scalar seconds(const std::function<void()>& f)
{
    const auto from = std::chrono::steady_clock::now();
    f();
    const std::chrono::duration<double> took =
        std::chrono::steady_clock::now() - from;
    return took.count();
}


//- Of [now, end] what is within timeStart and timeEnd
static scalar activeLength(const dictionary& dict, scalar now, scalar end)
{
    const scalar from = max(now, dict.getOrDefault<scalar>("timeStart", now));
    const scalar to = min(end, dict.getOrDefault<scalar>("timeEnd", end));
    return max(to - from, scalar(0));
}


static timedObject start
(
    const functionDict& f,
    const Time& time,
    scalar samples,
    scalar written
)
{
    const scalar now = time.value(), end = time.endTime().value();
    const scalar length = activeLength(f.dict, now, end);
    const scalar share = length/(end - now);

    timedObject timed;
    timed.name = f.name;
    timed.executes =
        timesOf(f.dict, "execute", length, share*samples, share*written);
    // And a row at the start
    timed.writes =
        1 + timesOf(f.dict, "write", length, share*samples, share*written);
    timed.begin = seconds([&]() { timed.object = makeFunctionObject(f, time); });
    return timed;
}


static void sample(timedObject& f)
{
    f.execute = seconds([&]() { f.object->execute(); });
    f.write = seconds([&]() { f.object->write(); });
}


static timedWrite timeWrite(solverModule& module, bool asynchronous)
{
    timedWrite timed;
    const timeWriter::trial trial;
    const scalar all = seconds([&]() { module.writeTrial(); });
    timed.format = trial.seconds();
    timed.handOver = all - (asynchronous ? timed.format : 0);
    timed.bytes = trial.bytes();
    return timed;
}


static std::string numberText(scalar value)
{
    char text[32];
    std::snprintf(text, sizeof(text), "%.3g", double(value));
    return text;
}


static std::string timesSolver(scalar cost, scalar solver)
{
    return cost > 0.995*solver
      ? numberText(cost/solver) + " times the solver's time"
      : numberText(100*cost/solver) + " % of the solver's time";
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::timesOf
(
    const dictionary& dict,
    const word& what,
    scalar length,
    scalar samples,
    scalar written
)
{
    word control(what + "Control");
    word interval(what + "Interval");
    if (what == "write" && !dict.found(control) && dict.found("outputControl"))
    {
        control = "outputControl";
        interval = "outputInterval";
    }
    const word how(dict.getOrDefault<word>(control, "timeStep"));

    scalar every = 0;
    if (!dict.readIfPresent(interval, every))
    {
        dict.readIfPresent(what + "Frequency", every);
    }

    if (how == "timeStep")
    {
        return std::floor(samples/max(every, scalar(1)) + 1e-6);
    }
    if (how == "writeTime" || how == "outputTime")
    {
        return std::floor(written/max(every, scalar(1)) + 1e-6);
    }
    if (how == "adjustableRunTime" || how == "adjustable" || how == "runTime")
    {
        return every > 0 ? std::floor(length/every + 1e-6) : 0;
    }
    if (how == "onEnd")
    {
        return 1;
    }

    // none; by the clock or the processor's time nobody knows
    return 0;
}


void Foam::foretellRun
(
    Time& time,
    solverModule& module,
    const runEffort& effort,
    scalar sampleInterval,
    scalar startSeconds,
    bool fieldsAreRead
)
{
    if (!(effort.secondsPerStep > 0 && effort.steps > 0)) return;

    const dictionary& control = time.controlDict();
    const scalar length = time.endTime().value() - time.value();
    const scalar samples = sampleInterval > 0
      ? std::ceil(length/sampleInterval - 1e-6)
      : effort.steps;
    const scalar written = timesOf(control, "write", length, samples, 0);
    const bool asynchronous =
        control.getOrDefault<bool>("writeAsynchronously", true);
    const scalar solver = effort.secondsPerStep*effort.steps;

    // The first sample sets up what later ones use
    std::vector<timedObject> objects;
    DynamicList<word> others;
    const timeWriter::trial nothingIsWritten;
    for (const functionDict& f : functionDicts(time))
    {
        if (f.ofRiprap) objects.push_back(start(f, time, samples, written));
        else others.append(f.name);
    }
    for (timedObject& f : objects)
    {
        sample(f);
    }
    for (int k = 0; k < repeats && module.trialStep(); ++k)
    {
        for (timedObject& f : objects)
        {
            const scalar execute = f.execute, write = f.write;
            if (k == 0) f.begin += execute + write;
            sample(f);
            if (k > 0)
            {
                f.execute = min(f.execute, execute);
                f.write = min(f.write, write);
            }
        }
    }
    module.updateFields();
    const scalar field = seconds([&]() { module.updateFields(); });
    const scalar fields = field*(fieldsAreRead ? max(samples, written) : written);
    const timedWrite write
    (
        written > 0 ? timeWrite(module, asynchronous) : timedWrite()
    );

    scalar inObjects = 0;
    for (const timedObject& f : objects)
    {
        inObjects += f.seconds();
    }
    // The last time, and those that the run makes faster than they are written
    const scalar between =
        written > 0 ? (solver + inObjects + fields)/written : 0;
    const scalar waiting = !asynchronous || written < 1 ? 0
      : write.format
      + (written - 1)*max(write.format - between, scalar(0));
    const scalar writing = written*write.handOver;
    const scalar all =
        startSeconds + solver + fields + inObjects + writing + waiting;

    Info<< nl << "Expected wall time [s], as the log will end" << nl;
    const auto put = [&](const std::string& name, scalar s, scalar n, int indent)
    {
        Info<< wallTimes::row(name, s, all, int64_t(n), indent).c_str() << nl;
    };
    put("start", startSeconds, 1, 4);
    put("solver", solver, samples, 4);
    if (module.hasFields()) put("fields", fields, fieldsAreRead ? samples : written, 4);
    put("function objects", inObjects, samples, 4);
    for (const timedObject& f : objects)
    {
        put(f.name, f.seconds(), f.writes, 8);
    }
    put("writing", writing, written, 4);
    put("waiting for writing", waiting, written, 4);
    put("all", all, 1, 4);
    put("written meanwhile", asynchronous ? written*write.format : 0, 1, 4);
    Info<< "Files: " << int64_t(written) << " times "
        << bytesText(write.bytes).c_str() << ", formatted but not on disk" << nl;
    if (others.size())
    {
        Info<< "Not timed, since they may write: "
            << listed(wordList(others)).c_str() << nl;
    }

    const auto tooMuch = [&](const std::string& what)
    {
        Info<< "Costs much: " << what.c_str() << nl;
    };
    const scalar stepsASample = effort.steps/max(samples, scalar(1));
    if (sampleInterval > 0 && stepsASample < fewSteps)
    {
        tooMuch
        (
            "sampleInterval " + numberText(sampleInterval) + " s of system/"
            "controlDict is " + numberText(stepsASample) + " steps; the solver"
            " is fastest where samples are farther apart"
        );
    }
    for (const timedObject& f : objects)
    {
        if (f.seconds() < worthNaming*solver) continue;
        const scalar one = f.write + f.executes/max(f.writes, scalar(1))*f.execute;
        tooMuch
        (
            "function object " + f.name + " takes "
          + timesSolver(f.seconds(), solver) + ", "
          + numberText(1000*one) + " ms a sample, as long as "
          + numberText(one/effort.secondsPerStep) + " steps: sample less often"
            " by its writeInterval, or by sampleInterval"
        );
    }
    if (fields > worthNaming*solver)
    {
        tooMuch
        (
            "fields take " + timesSolver(fields, solver) + ": they are brought"
            " to OpenFOAM "
          + std::string(fieldsAreRead ? "at each sample, for a function object"
            " of another library" : "at each written time")
        );
    }
    if (writing + waiting > worthNaming*solver)
    {
        tooMuch
        (
            "writing takes " + timesSolver(writing + waiting, solver) + ", "
          + numberText(write.handOver + write.format) + " s a time: write less"
            " often by writeInterval, or pictures between the states by"
            " stateInterval and pictureFields"
        );
    }
    Info<< endl;
}


// ************************************************************************* //

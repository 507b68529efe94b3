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


//- What a run takes
struct runForecast
{
    scalar samples = 0, written = 0;                // how many
    bool asynchronous = true;
    bool fieldsAreRead = false;                     // at each sample
    scalar start = 0, solver = 0;                   // [s]
    scalar field = 0;                               // of a time [s]
    timedWrite write;                               // of a time
    std::vector<timedObject> objects;
    DynamicList<word> others;                       // that are not timed

    scalar fields() const
    {
        return field*(fieldsAreRead ? max(samples, written) : written);
    }

    scalar inObjects() const
    {
        scalar sum = 0;
        for (const timedObject& f : objects)
        {
            sum += f.seconds();
        }
        return sum;
    }

    scalar writing() const
    {
        return written*write.handOver;
    }

    //- The last time, and those that the run makes faster than they are written
    scalar waiting() const
    {
        if (!asynchronous || written < 1) return 0;
        const scalar between = (solver + inObjects() + fields())/written;
        return write.format
          + (written - 1)*max(write.format - between, scalar(0));
    }

    scalar all() const
    {
        return start + solver + fields() + inObjects() + writing() + waiting();
    }
};


static void startObjects(Time& time, runForecast& run)
{
    for (const functionDict& f : functionDicts(time))
    {
        if (f.ofRiprap)
        {
            run.objects.push_back(start(f, time, run.samples, run.written));
        }
        else
        {
            run.others.append(f.name);
        }
    }
}


//- The first sample sets up what later ones use
static void timeObjects
(
    solverModule& module,
    std::vector<timedObject>& objects
)
{
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
}


//- The second time
static scalar timeFields(solverModule& module)
{
    module.updateFields();
    return seconds([&]() { module.updateFields(); });
}


static void logWallTimes(const runForecast& run, bool hasFields)
{
    const scalar samples = run.samples, written = run.written, all = run.all();

    Info<< nl << "Expected wall time [s], as the log will end" << nl;
    const auto put = [&](const std::string& name, scalar s, scalar n, int indent)
    {
        Info<< wallTimes::row(name, s, all, int64_t(n), indent).c_str() << nl;
    };
    put("start", run.start, 1, 4);
    put("solver", run.solver, samples, 4);
    if (hasFields) put("fields", run.fields(), run.fieldsAreRead ? samples : written, 4);
    put("function objects", run.inObjects(), samples, 4);
    for (const timedObject& f : run.objects)
    {
        put(f.name, f.seconds(), f.writes, 8);
    }
    put("writing", run.writing(), written, 4);
    put("waiting for writing", run.waiting(), written, 4);
    put("all", all, 1, 4);
    put("written meanwhile", run.asynchronous ? written*run.write.format : 0, 1, 4);
    Info<< "Files: " << int64_t(written) << " times "
        << bytesText(run.write.bytes).c_str() << ", formatted but not on disk" << nl;
    if (run.others.size())
    {
        Info<< "Not timed, since they may write: "
            << listed(wordList(run.others)).c_str() << nl;
    }
}


static void logCost(const std::string& what)
{
    Info<< "Costs much: " << what.c_str() << nl;
}


static void logObjectCosts(const runForecast& run, const runEffort& effort)
{
    for (const timedObject& f : run.objects)
    {
        if (f.seconds() < worthNaming*run.solver) continue;
        const scalar one = f.write + f.executes/max(f.writes, scalar(1))*f.execute;
        logCost
        (
            "function object " + f.name + " takes "
          + timesSolver(f.seconds(), run.solver) + ", "
          + numberText(1000*one) + " ms a sample, as long as "
          + numberText(one/effort.secondsPerStep) + " steps: sample less often"
            " by its writeInterval, or by sampleInterval"
        );
    }
}


//- Of what takes more than it should
static void logCosts
(
    const runForecast& run,
    const runEffort& effort,
    scalar sampleInterval
)
{
    const scalar stepsASample = effort.steps/max(run.samples, scalar(1));
    if (sampleInterval > 0 && stepsASample < fewSteps)
    {
        logCost
        (
            "sampleInterval " + numberText(sampleInterval) + " s of system/"
            "controlDict is " + numberText(stepsASample) + " steps; the solver"
            " is fastest where samples are farther apart"
        );
    }
    logObjectCosts(run, effort);
    if (run.fields() > worthNaming*run.solver)
    {
        logCost
        (
            "fields take " + timesSolver(run.fields(), run.solver) + ": they are"
            " brought to OpenFOAM "
          + std::string(run.fieldsAreRead ? "at each sample, for a function"
            " object of another library" : "at each written time")
        );
    }
    const scalar writing = run.writing() + run.waiting();
    if (writing > worthNaming*run.solver)
    {
        logCost
        (
            "writing takes " + timesSolver(writing, run.solver) + ", "
          + numberText(run.write.handOver + run.write.format) + " s a time: write"
            " less often by writeInterval, or pictures between the states by"
            " stateInterval and pictureFields"
        );
    }
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

    runForecast run;
    run.samples = sampleInterval > 0
      ? std::ceil(length/sampleInterval - 1e-6)
      : effort.steps;
    run.written = timesOf(control, "write", length, run.samples, 0);
    run.asynchronous = control.getOrDefault<bool>("writeAsynchronously", true);
    run.fieldsAreRead = fieldsAreRead;
    run.start = startSeconds;
    run.solver = effort.secondsPerStep*effort.steps;

    const timeWriter::trial nothingIsWritten;
    startObjects(time, run);
    timeObjects(module, run.objects);
    run.field = timeFields(module);
    if (run.written > 0)
    {
        run.write = timeWrite(module, run.asynchronous);
    }

    logWallTimes(run, module.hasFields());
    logCosts(run, effort, sampleInterval);
    Info<< endl;
}


// ************************************************************************* //

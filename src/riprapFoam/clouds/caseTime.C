/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "caseTime.H"
#include "allRanks.H"
#include "IFstream.H"
#include "OSspecific.H"
#include "pictures.H"
#include "polyMesh.H"
#include "sceneCloud.H"
#include "timeManifest.H"
#include "timeWriter.H"
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Of several processes: those that the first has
static instantList timesOfMaster(const fileName& casePath)
{
    if (!Pstream::parRun()) return Time::findTimes(casePath, "constant");

    std::string names;
    if (Pstream::master())
    {
        for (const instant& t : Time::findTimes(casePath, "constant"))
        {
            names += t.name() + '\n';
        }
    }
    DynamicList<instant> times;
    std::istringstream all(textOfMaster(names));
    for (std::string name; std::getline(all, name);)
    {
        scalar value = 0;
        readScalar(name, value);
        times.append(instant(value, word(name, false)));
    }
    return instantList(std::move(times));
}


//- Make controlDict start at a whole time. \return true if that is another
//  one than Time would take
static bool startAtWholeTime(const fileName& casePath, dictionary& controlDict)
{
    instantList times(timesOfMaster(casePath));
    if (times.size() && times[0].name() == "constant")
    {
        times = instantList(SubList<instant>(times, times.size() - 1, 1));
    }
    if (times.empty()) return false;

    const word from(controlDict.getOrDefault<word>("startFrom", "latestTime"));
    if (from != "latestTime")
    {
        scalar start = times.first().value();
        if (from == "startTime" && !controlDict.readIfPresent("startTime", start))
        {
            return false;
        }
        for (const instant& t : times)
        {
            if (mag(t.value() - start) <= 1e-9*mag(start))
            {
                requireWholeTime(controlDict, casePath/t.name());
            }
        }
        return false;
    }

    instant latest;
    if (!latestWholeTime(casePath, times, latest))
    {
        // Says why. Without any particles their reader does
        requireWholeTime(controlDict, casePath/times.last().name());
        return false;
    }
    requireWholeTime(controlDict, casePath/latest.name());

    controlDict.set("startFrom", "startTime");
    controlDict.set("startTime", latest.value());

    // A processor without particles may not have the time
    return Pstream::parRun() || latest.name() != times.last().name();
}


//- Of a time's directory: where the particles are, and the states of scenes
static fileNameList requiredFiles(const Time& time, bool picture)
{
    DynamicList<fileName> files;
    const HashTable<const polyMesh*> meshes(time.lookupClass<polyMesh>());
    forAllConstIters(meshes, mesh)
    {
        const HashTable<const sceneCloud*> clouds(mesh.val()->lookupClass<sceneCloud>());
        forAllConstIters(clouds, c)
        {
            const sceneCloud& one = *c.val();
            files.append(cloud::prefix/one.name()/"positions");
            if (picture) continue;
            for (const word& file : one.stateFiles())
            {
                files.append(fileName("uniform/riprap")/file);
            }
        }
    }
    return fileNameList(std::move(files));
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::caseTime::caseTime(const argList& args)
:
    writesItself<Time>(Time::controlDictName, args)
{}


Foam::caseTime::caseTime(const argList& args, const dictionary& controlDict)
:
    writesItself<Time>
    (
        controlDict,
        args.rootPath(),
        args.caseName(),
        "system",
        "constant",
        !args.found("noFunctionObjects"),
        !args.found("no-libs")
    )
{
    // What Time does for a file that it reads itself
    auto& dict = dynamic_cast<regIOobject&>(const_cast<dictionary&>(this->controlDict()));
    if (controlDict.getOrDefault<bool>("runTimeModifiable", false))
    {
        fileHandler().addWatches(dict, fileNameList(1, dict.objectPath()));
    }
}


Foam::autoPtr<Foam::caseTime> Foam::caseTime::New
(
    const argList& args,
    bool anyTime
)
{
    const fileName file(args.globalPath()/"system"/Time::controlDictName);
    if (!anyTime && isFile(file))
    {
        IFstream is(file);
        dictionary controlDict(is);
        controlDict.remove("FoamFile");
        if (startAtWholeTime(args.path(), controlDict))
        {
            return autoPtr<caseTime>(new caseTime(args, controlDict));
        }
    }
    return autoPtr<caseTime>(new caseTime(args));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::caseTime::writeAs(const IOstreamOption& how, bool valid) const
{
    if (!writeTime())
    {
        return writeAsBase(how, valid);
    }

    pictures::ofRun().next(*this, lastWrite());
    const_cast<caseTime&>(*this).settle();
    timeWriter::ofRun().begin
    (
        timePath(),
        controlDict().getOrDefault<bool>("writeAsynchronously", true)
    );
    writing_ = timePath();

    // Older times go when this one is whole
    label& keep = const_cast<caseTime&>(*this).purgeWrite_;
    const label asked = keep;
    keep = 0;
    const bool written = writeAsBase(how, valid);
    keep = asked;
    required_ = requiredFiles(*this, pictures::ofRun().now());

    if (!written)
    {
        FatalErrorInFunction
            << "Time " << timePath() << " cannot be written: is the disk full?"
            << " It is not whole, earlier ones are" << exit(FatalError);
    }
    return written;
}


Foam::fileNameList Foam::caseTime::old()
{
    DynamicList<fileName> paths;
    if (purgeWrite_ <= 0) return fileNameList();

    const bool picture = pictures::ofRun().now();
    const word name(writing_.name(), false);
    if (previousWriteTimes_.empty() || previousWriteTimes_.top() != name)
    {
        previousWriteTimes_.push(name);
    }
    while (previousWriteTimes_.size() > purgeWrite_)
    {
        // Of pictures alone no run starts
        const word oldest(previousWriteTimes_.pop());
        if (oldest == lastState_ && picture) heldState_ = oldest;
        else paths.append(path()/oldest);
    }
    if (!picture)
    {
        if (heldState_.size()) paths.append(path()/heldState_);
        heldState_.clear();
        lastState_ = name;
    }
    return fileNameList(std::move(paths));
}


bool Foam::caseTime::lastWrite() const
{
    scalar interval = 0;
    if (writeControl_ == wcTimeStep)
    {
        interval = writeInterval_*deltaTValue();
    }
    else if (writeControl_ == wcRunTime || writeControl_ == wcAdjustableRunTime)
    {
        interval = writeInterval_;
    }
    const scalar roundOff = 1e-6*max(interval, deltaTValue());
    return
        value() + interval > endTime().value() + roundOff
     || value() > endTime().value() - 0.5*deltaTValue();
}


void Foam::caseTime::requireWritten() const
{
    if (!writeTime() || writing_ == timePath()) return;

    FatalErrorInFunction
        << "Time " << timeName() << " was due to be written, but OpenFOAM v"
        << foamVersion::api << " has not asked for its files: riprap was built"
        << " for v" << OPENFOAM << exit(FatalError);
}


void Foam::caseTime::finishAtStop()
{
    if (writing_.empty()) return;

    timeWriter::ofRun().finish(fileNameList(), pictures::ofRun().now(), required_);
    writing_.clear();
    const std::string failure(firstTextOfRanks(timeWriter::ofRun().settled()));
    if (!failure.empty())
    {
        WarningInFunction
            << "The state at the stop is not whole. " << failure.c_str() << endl;
    }
}


void Foam::caseTime::finishWrite()
{
    if (writing_.empty()) return;

    const fileNameList older(old());
    timeWriter& writer = timeWriter::ofRun();
    writing_.clear();
    if (!Pstream::parRun())
    {
        writer.finish(older, pictures::ofRun().now(), required_);
        return;
    }

    writer.finish(fileNameList(), pictures::ofRun().now(), required_);
    retired_.append(older);
    if (!controlDict().getOrDefault<bool>("writeAsynchronously", true)) settle();
}


void Foam::caseTime::settle()
{
    if (!Pstream::parRun())
    {
        timeWriter::ofRun().wait();
        return;
    }
    stopIfAny(timeWriter::ofRun().settled());
    for (const fileName& path : retired_) rmDir(path, true);
    retired_.clear();
}


void Foam::caseTime::checkWriting() const
{
    if (!Pstream::parRun())
    {
        timeWriter::ofRun().check();
        return;
    }
    timeWriter::ofRun().logTold();
    stopIfAny(timeWriter::ofRun().fault());
}


// ************************************************************************* //

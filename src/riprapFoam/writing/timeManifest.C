/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "timeManifest.H"
#include "allRanks.H"
#include "Hasher.H"
#include "HashSet.H"
#include "IFstream.H"
#include "listed.H"
#include "OSspecific.H"
#include "Time.H"
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static fileName folder(const fileName& timePath)
{
    return timePath/"uniform"/"riprap";
}


static fileName partOf(const fileName& timePath)
{
    return folder(timePath)/"manifest.part";
}


static fileName manifestOf(const fileName& timePath)
{
    return folder(timePath)/"manifest";
}


static fileSum sumOf(const fileName& file)
{
    fileSum found;
    if (!isFile(file)) return found;

    IFstream is(file, IOstream::BINARY);
    std::istream& in = is.stdStream();
    const std::size_t tail = 8;
    std::string block(fileSum::block, '\0');
    std::string end;
    bool first = false;
    found.bytes = 0;
    for (;;)
    {
        in.read(&block[0], block.size());
        const std::size_t n = in.gcount();
        if (n == 0) break;

        if (found.bytes == 0) first = block.compare(0, 4, "/*--") == 0;
        found.sum = Hasher(block.data(), n, found.sum);
        found.bytes += n;
        end += block.substr(n > tail ? n - tail : 0, n > tail ? tail : n);
        if (end.size() > tail) end.erase(0, end.size() - tail);
    }
    found.foam = first && end == "**** //\n";
    return found;
}


//- In the manifest of one
static const char* const pictureLine = "# A picture, without the state\n";


//- All below a directory but the manifest itself, relative to it
static void listFiles
(
    const fileName& top,
    const fileName& below,
    DynamicList<fileName>& files
)
{
    const fileName here(below.empty() ? top : top/below);
    for (const fileName& file : readDir(here, fileName::FILE))
    {
        const fileName name(below.empty() ? file : below/file);
        if (top/name != manifestOf(top) && top/name != partOf(top))
        {
            files.append(name);
        }
    }
    for (const fileName& dir : readDir(here, fileName::DIRECTORY))
    {
        listFiles(top, below.empty() ? dir : below/dir, files);
    }
}


//- Of particles, or of what a run must know beside them
static bool isState(const fileName& file)
{
    return file.starts_with("lagrangian/") || file.starts_with("uniform/");
}


//- In the manifest of one of several processes
static const std::string processLine = "# Of processes: ";


//- Of clouds
static bool isCloud(const fileName& file)
{
    return
        file.starts_with("lagrangian/")
     || file.starts_with("uniform/lagrangian/");
}


//- Have OpenFOAM's tools divided this time, or put it together, since it was
//  written by so many processes?
static bool isRedistributed
(
    const fileName& timePath,
    label processes,
    const DynamicList<fileName>& listed
)
{
    if (processes != Pstream::nProcs()) return true;

    // decomposePar leaves coordinates, or nothing where no particle is
    for (const fileName& file : listed)
    {
        const bool gone =
            Pstream::parRun() && file.name() == "positions" && isCloud(file)
         && !isFile(timePath/file);
        if (gone) return true;
    }
    return false;
}


//- One line of a manifest against the file that is there now
static void compare
(
    const fileName& timePath,
    const fileSum& then,
    const fileName& name,
    timeManifest& manifest
)
{
    const fileSum now(sumOf(timePath/name));
    std::string lacks;

    if (now.bytes == then.bytes && now.sum == then.sum)
    {
        return;
    }
    if (now.bytes < 0)
    {
        const bool moved =
            name.name() == "positions"
         && isFile(timePath/name.path()/"coordinates");
        if (moved)
        {
            manifest.changed.append(name);
        }
        else if (isState(name))
        {
            lacks = " is missing";
        }
    }
    else if (then.foam && !now.foam && now.bytes <= then.bytes)
    {
        lacks = " is cut short: " + std::to_string(now.bytes) + " of "
          + std::to_string(then.bytes) + " bytes";
    }
    else if (name.starts_with("uniform/riprap/"))
    {
        lacks = " is not what was written: its check sum is wrong";
    }
    else
    {
        manifest.changed.append(name);
    }

    if (!lacks.empty() && manifest.why.empty())
    {
        manifest.is = timeManifest::kind::damaged;
        manifest.why = name + lacks;
    }
}


static timeManifest readManifest(const fileName& timePath)
{
    timeManifest manifest;
    if (isFile(partOf(timePath)))
    {
        manifest.is = timeManifest::kind::unfinished;
        manifest.why = "the run that wrote it was stopped before the last file";
        return manifest;
    }
    if (!isFile(manifestOf(timePath)))
    {
        return manifest;
    }

    manifest.is = timeManifest::kind::whole;
    std::ifstream in(manifestOf(timePath));
    std::string line;
    label processes = 1;
    DynamicList<fileSum> sums;
    DynamicList<fileName> names;
    while (std::getline(in, line))
    {
        if (line + '\n' == pictureLine)
        {
            manifest.is = timeManifest::kind::picture;
            manifest.why = "it is a picture, without the state to start from";
            return manifest;
        }
        if (line.compare(0, processLine.size(), processLine) == 0)
        {
            std::istringstream(line.substr(processLine.size())) >> processes;
        }
        if (line.empty() || line[0] == '#') continue;

        fileSum then;
        std::string kind, name;
        std::istringstream words(line);
        words >> then.bytes >> then.sum >> kind >> std::ws;
        std::getline(words, name);
        if (!words && name.empty())
        {
            manifest.is = timeManifest::kind::damaged;
            manifest.why = "uniform/riprap/manifest has the line " + line;
            break;
        }
        then.foam = kind == "foam";
        sums.append(then);
        names.append(fileName(name));
    }

    manifest.redistributed = isRedistributed(timePath, processes, names);
    forAll(names, i)
    {
        if (manifest.redistributed && isCloud(names[i])) continue;
        compare(timePath, sums[i], names[i], manifest);
    }
    return manifest;
}


//- The last time that was compared
static fileName comparedPath;
static timeManifest compared;


//- What the processes have, each in its own directory, as one
static timeManifest ofAllRanks(timeManifest own)
{
    typedef timeManifest::kind kind;
    const auto any = [&](kind k) { return onAnyRank(own.is == k); };

    own.redistributed = onAnyRank(own.redistributed);
    const bool some = any(kind::whole) || any(kind::picture);
    if (some && own.is == kind::none && !own.redistributed)
    {
        own.is = kind::damaged;
        own.why = "it has no manifest";
    }
    const std::string where = "processor" + std::to_string(Pstream::myProcNo());
    own.why = firstTextOfRanks(own.why.empty() ? own.why : where + ": " + own.why);
    std::string changed;
    for (const fileName& file : own.changed) changed += file + '\n';
    own.changed.clear();
    for (const std::string& text : textsOfRanks(changed))
    {
        std::istringstream files(text);
        for (std::string file; std::getline(files, file);)
        {
            if (!own.changed.found(file)) own.changed.append(fileName(file));
        }
    }
    for (const kind k : {kind::damaged, kind::unfinished, kind::picture, kind::whole})
    {
        if (any(k))
        {
            own.is = k;
            break;
        }
    }
    return own;
}


static void requireFiles
(
    const fileName& timePath,
    const DynamicList<fileName>& written,
    const fileNameList& required
)
{
    for (const fileName& file : required)
    {
        if (written.found(file)) continue;
        throw std::runtime_error
        (
            "Time " + timePath.name() + " has been written without its file "
          + file + ": no run could go on from it. Earlier times are whole"
        );
    }
}


//- Known, or of the file as it is; the end of a state must be there
static fileSum wholeSum
(
    const fileName& timePath,
    const fileName& file,
    const fileSums& known
)
{
    const auto written = known.find(timePath/file);
    const fileSum now
    (
        written == known.end() ? sumOf(timePath/file) : written->second
    );
    if (isState(file) && !now.foam && file.ext() != "vtp")
    {
        throw std::runtime_error
        (
            "File " + timePath/file + " was not written to its end, but"
            " for " + std::to_string(now.bytes) + " bytes: is the disk"
            " full? This time is not whole, earlier ones are"
        );
    }
    return now;
}


static std::string reasonOf(const timeManifest& manifest)
{
    return manifest.is == timeManifest::kind::none
      ? std::string("it holds no particles") : manifest.why;
}


static bool usable(const fileName& timePath, const timeManifest& manifest)
{
    return manifest.is == timeManifest::kind::whole
     || (manifest.is == timeManifest::kind::none && hasParticles(timePath));
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::timeManifest& Foam::timeManifest::of(const fileName& timePath)
{
    if (comparedPath != timePath)
    {
        compared = readManifest(timePath);
        if (Pstream::parRun()) compared = ofAllRanks(compared);
        comparedPath = timePath;
    }
    return compared;
}


void Foam::timeManifest::begin(const fileName& timePath)
{
    comparedPath.clear();
    // decomposePar leaves a link to the case's own
    const fileName uniform(timePath/"uniform");
    if (uniform.type(false) == fileName::LINK) rm(uniform);
    mkDir(folder(timePath));
    std::ofstream part(partOf(timePath));
    part << "# riprapFoam is writing this time, or was stopped while it did\n"
         << std::flush;
    if (!part)
    {
        FatalErrorInFunction
            << "Cannot write " << partOf(timePath) << exit(FatalError);
    }

    // What another run has left there would be taken for this one's
    for (const fileName& file : readDir(folder(timePath), fileName::FILE))
    {
        if (folder(timePath)/file != partOf(timePath)) rm(folder(timePath)/file);
    }
    for (const word cloud : {"fluid", "solids"})
    {
        rmDir(timePath/"lagrangian"/cloud, true);
        rmDir(timePath/"uniform"/"lagrangian"/cloud, true);
    }
}


void Foam::timeManifest::finish
(
    const fileName& timePath,
    const fileSums& known,
    bool picture,
    const fileNameList& required
)
{
    DynamicList<fileName> files;
    listFiles(timePath, "", files);
    sort(files);
    requireFiles(timePath, files, required);

    std::ostringstream lines;
    lines << "# As riprapFoam wrote them (compressed ones: what they hold):"
        << " bytes, check sum, foam or other, name\n"
        << (picture ? pictureLine : "");
    if (Pstream::parRun())
    {
        lines << processLine << Pstream::nProcs() << ", this is "
            << Pstream::myProcNo() << '\n';
    }
    for (const fileName& file : files)
    {
        const fileSum now(wholeSum(timePath, file, known));
        lines << now.bytes << ' ' << now.sum << (now.foam ? " foam " : " other ")
            << file << '\n';
    }

    std::ofstream part(partOf(timePath));
    part << lines.str() << std::flush;
    part.close();
    if (!part || !mv(partOf(timePath), manifestOf(timePath)))
    {
        throw std::runtime_error
        (
            "Cannot write " + manifestOf(timePath) + ": is the disk full?"
            " This time is not whole, earlier ones are"
        );
    }
}


std::string Foam::timeManifest::changedSince(const word& cloud) const
{
    // Written for others: what a fluid's p and h follow from is read
    static const wordHashSet unread({"p", "h", "force", "moment", "turned"});

    std::string names;
    for (const fileName& file : changed)
    {
        const bool field = file.path() == "lagrangian/" + cloud;
        if
        (
            (field && !unread.found(file.name()))
         || file.starts_with("uniform/lagrangian/" + cloud + '/')
        )
        {
            names += (names.empty() ? "" : " ") + file.name();
        }
    }
    return names;
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool Foam::hasParticles(const fileName& timePath)
{
    bool has = false;
    const fileName clouds(timePath/"lagrangian");
    for (const fileName& cloud : readDir(clouds, fileName::DIRECTORY))
    {
        for (const char* file : {"positions", "coordinates"})
        {
            has = has || isFile(clouds/cloud/file);
        }
    }
    return onAnyRank(has);
}


bool Foam::latestWholeTime
(
    const fileName& casePath,
    const instantList& times,
    instant& latest
)
{
    for (label i = times.size() - 1; i >= 0; --i)
    {
        const fileName timePath(casePath/times[i].name());
        const timeManifest& manifest(timeManifest::of(timePath));
        if (usable(timePath, manifest))
        {
            latest = times[i];
            return true;
        }
        Warning
            << "Time " << times[i].name() << " is passed over: "
            << reasonOf(manifest).c_str() << nl << endl;
    }
    return false;
}


void Foam::requireWholeTime(const dictionary& controlDict, const fileName& timePath)
{
    const timeManifest& manifest(timeManifest::of(timePath));
    const word name(timePath.name(), false);

    if (manifest.is == timeManifest::kind::unfinished)
    {
        FatalIOErrorInFunction(controlDict)
            << "Time " << name << " is not whole: " << manifest.why.c_str()
            << ". Remove the directory " << timePath << ", or start from"
            << " another time: startFrom latestTime takes the latest whole one"
            << exit(FatalIOError);
    }
    if (manifest.is == timeManifest::kind::picture)
    {
        FatalIOErrorInFunction(controlDict)
            << "Time " << name << " is a picture, without the state to start"
            << " from (stateInterval): start from another time, startFrom"
            << " latestTime takes the latest that has it" << exit(FatalIOError);
    }
    if (manifest.is == timeManifest::kind::damaged)
    {
        FatalIOErrorInFunction(controlDict)
            << "Time " << name << " is damaged (" << manifest.why.c_str()
            << "): remove the folder " << folder(timePath) << " to continue"
            << " from the fields of the cloud where these are good, or start"
            << " from another time: startFrom latestTime takes the latest"
            << " whole one" << exit(FatalIOError);
    }
    if (manifest.changed.size())
    {
        Info<< "Changed since riprapFoam wrote time " << name << ": "
            << listed(manifest.changed).c_str() << nl << endl;
    }
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallTimes.H"
#include "OFstream.H"
#include "OSspecific.H"
#include <cstdio>

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

double Foam::wallTimes::since(clock::time_point then)
{
    return std::chrono::duration<double>(clock::now() - then).count();
}


void Foam::wallTimes::add
(
    std::vector<entry>& entries,
    const std::string& name,
    double seconds
)
{
    for (entry& e : entries)
    {
        if (e.name == name)
        {
            e.seconds += seconds;
            ++e.count;
            return;
        }
    }
    entries.push_back(entry{name, seconds, 1});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wallTimes& Foam::wallTimes::ofRun()
{
    static wallTimes times;
    return times;
}


std::string Foam::wallTimes::row
(
    const std::string& name,
    double seconds,
    double whole,
    int64_t count,
    int indent
)
{
    char text[256];
    std::snprintf
    (
        text,
        sizeof(text),
        "%*s%-*s %10.2f %7.1f %%",
        indent, "", 32 - indent, name.c_str(), seconds, 100*seconds/whole
    );
    return count > 1 ? text + ("  " + std::to_string(count) + " times") : text;
}


void Foam::wallTimes::started()
{
    // What has a part of its own within the start is of the start
    parts_.clear();
    functionObjects_.clear();
    add(parts_, "start", since(begin_));
    for (const char* name :
        {"solver", "fields", "function objects", "writing", "waiting for writing"})
    {
        parts_.push_back(entry{name, 0, 0});
    }
}


void Foam::wallTimes::write(const Time& time, double meanwhile) const
{
    const double whole = since(begin_);
    double other = whole;
    for (const entry& e : parts_)
    {
        other -= e.seconds;
    }

    const fileName folder
    (
        time.globalPath()/"postProcessing"/"wallTimes"
       /Time::timeName(time.startTime().value())
    );
    // Those of the main process
    if (!Pstream::master()) return;
    mkDir(folder);
    OFstream file(folder/"wallTimes.dat");
    file<< "# part\tseconds\ttimes" << nl;

    Info<< "Wall time [s]" << nl;
    const auto put = [&](const std::string& name, double s, int64_t n, int indent)
    {
        Info<< row(name, s, whole, n, indent).c_str() << nl;
        file<< name.c_str() << tab << s << tab << label(n) << nl;
    };
    for (const entry& e : parts_)
    {
        if (!e.count) continue;
        put(e.name, e.seconds, e.count, 4);
        if (e.name != "function objects") continue;
        for (const entry& f : functionObjects_)
        {
            put(f.name, f.seconds, f.count, 8);
        }
    }
    put("other", max(other, 0.0), 1, 4);
    put("all", whole, 1, 4);
    if (meanwhile > 0) put("written meanwhile", meanwhile, 1, 4);
    Info<< endl;
}


// * * * * * * * * * * * * * * * * A part  * * * * * * * * * * * * * * * * * //

Foam::wallTimes::part::part(const char* name)
:
    name_(name),
    functionObject_(false)
{}


Foam::wallTimes::part::part(const word& functionObject)
:
    name_(functionObject),
    functionObject_(true)
{}


Foam::wallTimes::part::~part()
{
    wallTimes& run = ofRun();
    add
    (
        functionObject_ ? run.functionObjects_ : run.parts_,
        name_,
        since(from_)
    );
}


// ************************************************************************* //

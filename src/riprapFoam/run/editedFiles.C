/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "editedFiles.H"
#include "listed.H"
#include "OSspecific.H"
#include "OStringStream.H"
#include "Time.H"

#include <set>

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

std::map<std::string, std::string> Foam::editedFiles::readOnce() const
{
    std::map<std::string, std::string> texts;
    for (const char* name :
        {"solver", "adjustTimeStep", "deltaT", "maxDeltaT", "maxCo", "maxFlyingCo"})
    {
        const entry* e = time_.controlDict().findEntry(name, keyType::LITERAL);
        if (!e) continue;
        OStringStream text;
        text<< *e;
        texts[name] = text.str();
    }
    return texts;
}


bool Foam::editedFiles::isEdited(const fileName& file, double& then)
{
    const double now = highResLastModified(file);
    if (now == 0 || now == then) return false;
    then = now;
    return true;
}


void Foam::editedFiles::warnOfEntries()
{
    const auto now = readOnce();
    std::set<std::pair<std::string, std::string>> all(now.begin(), now.end());
    all.insert(entries_.begin(), entries_.end());
    std::set<std::string> names;
    for (const auto& e : all)
    {
        const bool same = now.count(e.first) && entries_.count(e.first)
            && now.at(e.first) == entries_.at(e.first);
        if (!same) names.insert(e.first);
    }

    const wordList before(edited_);
    edited_.clear();
    for (const std::string& name : names) edited_.append(word(name));
    if (edited_.empty() || edited_ == before) return;

    WarningInFunction
        << "system/controlDict has been edited. Of " << listed(edited_).c_str()
        << " the run goes on with what it read at its start; a run that begins"
        << " or continues reads them again" << endl;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::editedFiles::editedFiles(const Time& time)
:
    time_(time),
    lastLook_(clock::now()),
    entries_(readOnce())
{
    for (const fileName& file : readDir(time_.constantPath()))
    {
        changed_[time_.constantPath()/file] = highResLastModified(time_.constantPath()/file);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::editedFiles::warn()
{
    const std::chrono::duration<double> sinceLook(clock::now() - lastLook_);
    if (!time_.runTimeModifiable() || sinceLook.count() < 1) return;
    lastLook_ = clock::now();

    warnOfEntries();
    for (auto& file : changed_)
    {
        if (!isEdited(file.first, file.second)) continue;
        WarningInFunction
            << "constant/" << file.first.name().c_str() << " has been edited. It"
            << " is read once: the run goes on with what it read at its start;"
            << " a run that begins or continues reads it again" << endl;
    }
}


// ************************************************************************* //

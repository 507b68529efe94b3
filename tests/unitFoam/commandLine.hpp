// SPDX-License-Identifier: GPL-3.0-or-later
/*  OpenFOAM's arguments of a program that runs in a case. */
#pragma once

#include "JobInfo.H"
#include "argList.H"
#include "sigFpe.H"
#include "sigInt.H"
#include "sigQuit.H"
#include "sigSegv.H"

#include <memory>
#include <string>
#include <vector>

//- They stay: their end would be that of the program
inline const Foam::argList& arguments(
    const Foam::fileName& casePath, const std::vector<std::string>& options = {})
{
    static std::vector<std::unique_ptr<std::string>> words;
    static std::vector<std::unique_ptr<std::vector<char*>>> lists;
    static std::vector<Foam::argList*> all;
    lists.emplace_back(new std::vector<char*>);
    const auto put = [&](const std::string& w)
    {
        words.emplace_back(new std::string(w));
        lists.back()->push_back(&(*words.back())[0]);
    };
    for (const char* w : {"unitTests", "-case"}) put(w);
    put(casePath);
    for (const std::string& w : options) put(w);
    int n = int(lists.back()->size());
    lists.back()->push_back(nullptr);
    char** list = lists.back()->data();
    Foam::argList::noBanner();
    Foam::argList::noJobInfo();
    Foam::jobInfo.clear();
    all.push_back(new Foam::argList(n, list, false, false));
    // What it does to the program is taken back
    Foam::sigFpe::unset(false);
    Foam::sigInt::unset(false);
    Foam::sigQuit::unset(false);
    Foam::sigSegv::unset(false);
    return *all.back();
}

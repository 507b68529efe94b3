// SPDX-License-Identifier: GPL-3.0-or-later
/*  A case in a folder of its own, which goes with it; and the messages of errors. */
#pragma once

#include "testTime.H"
#include "OSspecific.H"

#include <cstdlib>
#include <fstream>
#include <functional>

//- An error that no test expects fails that test, and does not end the program
inline const bool errorsAreThrown =
    (Foam::FatalError.throwExceptions(), Foam::FatalIOError.throwExceptions(), true);

//- A Time sets the digits of all streams by its writePrecision: back to OpenFOAM's own
inline void defaultDigits()
{
    const int digits = 6;
    Foam::IOstream::defaultPrecision(digits);
    Foam::Sout.precision(digits);
    Foam::FatalError().precision(digits);
    Foam::FatalIOError.error::operator()().precision(digits);
}

//- The message of the error that f ends with; empty: it ends with none
inline std::string messageOf(const std::function<void()>& f)
{
    const bool before = Foam::FatalError.throwExceptions();
    const bool ioBefore = Foam::FatalIOError.throwExceptions();
    std::string said;
    try { f(); }
    catch (const Foam::error& e) { said = e.message(); }
    Foam::FatalError.throwExceptions(before);
    Foam::FatalIOError.throwExceptions(ioBefore);
    return said;
}

//- Of a message that is too long to be compared as a whole: does it hold this text?
inline bool holds(const std::string& said, const std::string& text)
{
    return said.find(text) != std::string::npos;
}

class ScratchCase
{
    Foam::fileName root_;
    Foam::autoPtr<Foam::Time> time_;

    static Foam::fileName made()
    {
        char name[] = "/tmp/riprapCaseXXXXXX";
        return mkdtemp(name);
    }

public:

    //- More entries of controlDict, as formats
    explicit ScratchCase(const std::string& more = "")
    :
        root_(made()),
        time_(new Foam::Time(entries("startFrom startTime; startTime 0; stopAt endTime; "
                                     "writeControl timeStep; writeInterval 1; "
                                     + (more.find("endTime ") == std::string::npos
                                             ? "endTime 1; "
                                             : std::string())
                                     + (more.find("deltaT ") == std::string::npos
                                             ? "deltaT 1; "
                                             : std::string())
                                     + more),
            root_, "case", "system", "constant", false))
    {}

    ~ScratchCase()
    {
        time_.clear();
        Foam::rmDir(root_);
        defaultDigits();
    }

    ScratchCase(const ScratchCase&) = delete;
    void operator=(const ScratchCase&) = delete;

    Foam::Time& time() { return *time_; }
    Foam::fileName path() const { return root_/"case"; }

    //- Name within the case
    void write(const std::string& name, const std::string& text) const
    {
        const Foam::fileName file(path()/name);
        Foam::mkDir(file.path());
        std::ofstream(file, std::ios::binary) << text;
    }

    //- A dictionary there, with OpenFOAM's header
    void writeDict(const std::string& name, const std::string& text) const
    {
        write(name,
            "FoamFile { version 2.0; format ascii; class dictionary; object "
                + Foam::fileName(name).name() + "; }\n" + text + '\n');
    }

    std::string read(const std::string& name) const
    {
        std::ifstream in(path()/name, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    }
};

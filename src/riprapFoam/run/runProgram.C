/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "runProgram.H"
#include "error.H"
#include "IOstreams.H"
#include "Pstream.H"
#include <chrono>
#include <cstdlib>
#include <new>
#include <thread>

//- What all processes have met is said by the first, which ends the others
static void waitForMaster()
{
    if (!Foam::Pstream::parRun() || Foam::Pstream::master()) return;

    const auto turn = std::chrono::milliseconds(500 + 100*Foam::Pstream::myProcNo());
    std::this_thread::sleep_for(turn);
}


void Foam::runProgram(const std::function<void()>& body)
{
    FatalError.throwExceptions();
    FatalIOError.throwExceptions();

    try
    {
        body();
        return;
    }
    catch (const error& e)              // and IOerror
    {
        waitForMaster();
        Perr<< nl;
        if (const auto* io = dynamic_cast<const IOerror*>(&e)) io->write(Perr);
        else e.write(Perr);
        Perr<< nl;
    }
    catch (const std::bad_alloc&)
    {
        waitForMaster();
        Perr<< nl << FatalError.title().c_str() << nl
            << "More memory is needed than this machine has free" << nl;
    }
    catch (const std::exception& e)
    {
        waitForMaster();
        Perr<< nl << FatalError.title().c_str() << nl << e.what() << nl;
    }
    Perr<< nl << "FOAM exiting" << nl << endl;
    // Not by return: argList's end is exit(0). Others would wait for this one
    if (Pstream::parRun()) Pstream::exit(1);
    std::exit(1);
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "runProgram.H"
#include "error.H"
#include "IOstreams.H"
#include <cstdlib>
#include <new>

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
        Perr<< nl;
        if (const auto* io = dynamic_cast<const IOerror*>(&e)) io->write(Perr);
        else e.write(Perr);
        Perr<< nl;
    }
    catch (const std::bad_alloc&)
    {
        Perr<< nl << FatalError.title().c_str() << nl
            << "More memory is needed than this machine has free" << nl;
    }
    catch (const std::exception& e)
    {
        Perr<< nl << FatalError.title().c_str() << nl << e.what() << nl;
    }
    Perr<< nl << "FOAM exiting" << nl << endl;
    // Not by return: argList's end is exit(0)
    std::exit(1);
}


// ************************************************************************* //

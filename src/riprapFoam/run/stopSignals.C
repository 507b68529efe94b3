/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stopSignals.H"
#include "PstreamReduceOps.H"

namespace
{
    // All that a signal handler can reach
    volatile std::sig_atomic_t receivedSignal = 0;
    Foam::solverModule* volatile module = nullptr;
}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::stopSignals::handle(int signal)
{
    receivedSignal = signal;

    // The second one finds the usual action
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);

    if (module)
    {
        module->interrupt();
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::stopSignals::stopSignals(solverModule& running)
{
    receivedSignal = 0;
    module = &running;

    struct sigaction action = {};
    action.sa_handler = handle;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);

    sigaction(SIGINT, &action, &oldInterrupt_);
    sigaction(SIGTERM, &action, &oldTerminate_);
}


Foam::stopSignals::~stopSignals()
{
    module = nullptr;
    sigaction(SIGINT, &oldInterrupt_, nullptr);
    sigaction(SIGTERM, &oldTerminate_, nullptr);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const char* Foam::stopSignals::received() const
{
    // Of several processes: what any of them has got
    int received = receivedSignal;
    reduce(received, maxOp<int>());
    switch (received)
    {
        case SIGINT: return "SIGINT";
        case SIGTERM: return "SIGTERM";
        default: return nullptr;
    }
}


// ************************************************************************* //

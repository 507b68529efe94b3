/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "progressClock.H"
#include "messageStream.H"
#include "IOstreams.H"
#include <ctime>

namespace
{

double secondsSince(std::chrono::steady_clock::time_point then)
{
    return std::chrono::duration<double>
    (
        std::chrono::steady_clock::now() - then
    ).count();
}


std::string timeOfDay(double secondsFromNow)
{
    const std::time_t then = std::time(nullptr) + std::time_t(secondsFromNow);
    const bool soon = secondsFromNow < 43200;

    char text[64];
    std::strftime
    (
        text,
        sizeof(text),
        soon ? "%H:%M:%S" : "%Y-%m-%d %H:%M",
        std::localtime(&then)
    );
    return text;
}

} // End namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::progressClock::progressClock()
:
    started_(clock::now()),
    lastLog_(started_),
    stepStart_(started_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::progressClock::start()
{
    stepStart_ = clock::now();
    if (!running_)
    {
        running_ = true;
        started_ = lastLog_ = stepStart_;
    }
}


void Foam::progressClock::stop(int64_t steps, int64_t particleSteps)
{
    seconds_ += secondsSince(stepStart_);
    steps_ += steps;
    particleSteps_ += particleSteps;
}


void Foam::progressClock::log(scalar time, scalar startTime, scalar endTime)
{
    const bool atEnd = time >= endTime - 1e-9*mag(endTime);

    if (steps_ == 0 || (!atEnd && secondsSince(lastLog_) < interval))
    {
        return;
    }

    Info<< "Progress = ";
    if (endTime < GREAT && endTime > startTime)
    {
        Info<< 100*(time - startTime)/(endTime - startTime) << " %, ";
    }
    Info<< steps_/seconds_ << " steps/s, " << particleSteps_/seconds_
        << " particle-steps/s";

    if (endTime < GREAT && time > startTime && !atEnd)
    {
        const double left =
            secondsSince(started_)*(endTime - time)/(time - startTime);
        Info<< ", expected end " << timeOfDay(left).c_str() << " (in "
            << label(left) << " s)";
    }
    Info<< endl;

    lastLog_ = clock::now();
    seconds_ = 0;
    steps_ = particleSteps_ = 0;
}


// ************************************************************************* //

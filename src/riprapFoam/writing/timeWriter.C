/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "timeWriter.H"
#include "OSspecific.H"
#include <chrono>
#include <fcntl.h>
#include <unistd.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A quarter of the cores: the others work on
static int severalThreads()
{
    return Foam::max(1, Foam::min(8, int(std::thread::hardware_concurrency())/4));
}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

//- The thread's life
void Foam::timeWriter::work()
{
    std::unique_lock<std::mutex> locked(lock_);
    for (;;)
    {
        changed_.wait(locked, [&]() { return stop_ || !jobs_.empty(); });
        if (jobs_.empty()) return;

        const job next(std::move(jobs_.front()));
        jobs_.pop_front();
        busy_ = true;
        const bool failed = !failure_.empty();
        locked.unlock();

        const auto from = std::chrono::steady_clock::now();
        std::string failure;
        try
        {
            if (!failed) next();
        }
        catch (const Foam::error& e)
        {
            failure = e.message();
        }
        catch (const std::bad_alloc&)
        {
            failure = "More memory is needed than this machine has free, to"
                " write time " + timePath_;
        }
        catch (const std::exception& e)
        {
            failure = e.what();
        }
        const std::chrono::duration<double> took =
            std::chrono::steady_clock::now() - from;

        locked.lock();
        seconds_ += took.count();
        if (failure_.empty()) failure_ = failure;
        busy_ = false;
        changed_.notify_all();
    }
}


void Foam::timeWriter::formatOnly(const writtenFile& file)
{
    const auto from = std::chrono::steady_clock::now();
    trialBytes_ += file.formatOnly(freeCores_ ? severalThreads() : 1).bytes;
    const std::chrono::duration<double> took =
        std::chrono::steady_clock::now() - from;
    trialSeconds_ += took.count();
}


void Foam::timeWriter::add(job next)
{
    if (!asynchronous_)
    {
        try
        {
            next();
        }
        catch (const std::runtime_error& e)
        {
            FatalErrorInFunction << e.what() << exit(FatalError);
        }
        return;
    }
    {
        const std::lock_guard<std::mutex> locked(lock_);
        jobs_.push_back(std::move(next));
    }
    changed_.notify_all();
}


Foam::timeWriter::~timeWriter()
{
    if (!thread_.joinable()) return;
    {
        const std::lock_guard<std::mutex> locked(lock_);
        stop_ = true;
    }
    changed_.notify_all();
    thread_.join();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::timeWriter& Foam::timeWriter::ofRun()
{
    static timeWriter writer;
    return writer;
}


int Foam::timeWriter::coresTaken()
{
    return severalThreads();
}


void Foam::timeWriter::begin(const fileName& timePath, bool asynchronous)
{
    wait();
    timeManifest::begin(timePath);
    timePath_ = timePath;
    sums_.clear();
    open_ = true;
    asynchronous_ = asynchronous;
    if (asynchronous_ && !thread_.joinable())
    {
        thread_ = std::thread([this]() { work(); });
    }
}


void Foam::timeWriter::put(writtenFile&& file)
{
    if (onTrial())
    {
        formatOnly(file);
        return;
    }
    const auto kept = std::make_shared<const writtenFile>(std::move(file));
    mkDir(kept->path().path());
    const bool counted = open_, later = asynchronous_;
    add
    (
        [this, kept, counted, later]()
        {
            const bool several = !later || freeCores_;
            const fileSum sum(kept->write(several ? severalThreads() : 1));
            if (counted && sum.bytes >= 0) sums_[kept->path()] = sum;
        }
    );
}


void Foam::timeWriter::put(job next)
{
    if (onTrial()) return;

    add(std::move(next));
}


void Foam::timeWriter::finish
(
    const fileNameList& old,
    bool picture,
    const fileNameList& required
)
{
    add
    (
        [this, old, picture, required]()
        {
            timeManifest::finish(timePath_, sums_, picture, required);
            if (old.empty()) return;

            // Not before the new time would survive a loss of power
            const int there = ::open(timePath_.c_str(), O_RDONLY);
            if (there >= 0)
            {
                ::syncfs(there);
                ::close(there);
            }
            for (const fileName& path : old)
            {
                rmDir(path, true);
            }
        }
    );
    open_ = false;
    asynchronous_ = false;
}


//- What failed, once
std::string Foam::timeWriter::fault()
{
    std::string failure;
    const std::lock_guard<std::mutex> locked(lock_);
    failure.swap(failure_);
    if (!failure.empty()) jobs_.clear();
    return failure;
}


void Foam::timeWriter::check()
{
    const std::string failure(fault());
    if (!failure.empty())
    {
        FatalErrorInFunction << failure.c_str() << exit(FatalError);
    }
}


void Foam::timeWriter::idle()
{
    std::unique_lock<std::mutex> locked(lock_);
    changed_.wait(locked, [&]() { return jobs_.empty() && !busy_; });
}


void Foam::timeWriter::wait()
{
    idle();
    check();
}


std::string Foam::timeWriter::settled()
{
    idle();
    return fault();
}


double Foam::timeWriter::seconds()
{
    const std::lock_guard<std::mutex> locked(lock_);
    return seconds_;
}


Foam::timeWriter::session::~session()
{
    // Another error may end the run: this one is told beside it
    const std::string failure(ofRun().settled());
    if (!failure.empty())
    {
        WarningInFunction << failure.c_str() << endl;
    }
}


// * * * * * * * * * * * * * * * * A trial * * * * * * * * * * * * * * * * * //

Foam::timeWriter::trial::trial()
:
    secondsBefore_(ofRun().trialSeconds_),
    bytesBefore_(ofRun().trialBytes_)
{
    ++ofRun().trials_;
}


Foam::timeWriter::trial::~trial()
{
    --ofRun().trials_;
}


double Foam::timeWriter::trial::seconds() const
{
    return ofRun().trialSeconds_ - secondsBefore_;
}


int64_t Foam::timeWriter::trial::bytes() const
{
    return ofRun().trialBytes_ - bytesBefore_;
}


// ************************************************************************* //

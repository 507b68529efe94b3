/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "timeWriter.H"
#include "OSspecific.H"
#include <algorithm>
#include <chrono>
#include <fcntl.h>
#include <omp.h>
#include <unistd.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static int cores()
{
    return std::max(1u, std::thread::hardware_concurrency());
}


//- At once: nobody else works
static int severalThreads()
{
    return std::min(8, cores());
}


// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

int Foam::timeWriter::threadsBeside = std::max(1, std::min(8, cores()/4));


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

//- A thread's life
void Foam::timeWriter::work()
{
    // Where cores are free, what is written is made by some of them at once
    omp_set_num_threads(threadsBeside);
    std::unique_lock<std::mutex> locked(lock_);
    for (;;)
    {
        changed_.wait(locked, [&]() { return mayBegin() || (stop_ && tasks_.empty()); });
        if (tasks_.empty()) return;

        const task next(std::move(tasks_.front()));
        tasks_.pop_front();
        begun(next);
        const bool failed = !failure_.empty();
        locked.unlock();

        const std::string failure(failed ? std::string() : tried(next.work));

        locked.lock();
        ended(next, failure);
        changed_.notify_all();
    }
}


bool Foam::timeWriter::mayBegin() const
{
    if (tasks_.empty() || oneAlone_) return false;
    return running_ == 0 || (freeCores_ && !tasks_.front().alone);
}


void Foam::timeWriter::begun(const task& next)
{
    if (running_++ == 0) since_ = std::chrono::steady_clock::now();
    oneAlone_ = next.alone;
}


void Foam::timeWriter::ended(const task& last, const std::string& failure)
{
    if (last.alone) oneAlone_ = false;
    if (failure_.empty()) failure_ = failure;
    if (--running_ == 0)
    {
        const std::chrono::duration<double> took =
            std::chrono::steady_clock::now() - since_;
        seconds_ += took.count();
    }
}


//- What failed, or nothing
std::string Foam::timeWriter::tried(const job& work) const
{
    try
    {
        work();
    }
    catch (const Foam::error& e)
    {
        return e.message();
    }
    catch (const std::bad_alloc&)
    {
        return "More memory is needed than this machine has free, to write time " + timePath_;
    }
    catch (const std::exception& e)
    {
        return e.what();
    }
    return std::string();
}


//- The last file of a time is formatted by those that have nothing else to do; one thread beside
//  another adds up what it writes
int Foam::timeWriter::threadsOfFile()
{
    if (!freeCores_) return 1;

    const std::lock_guard<std::mutex> locked(lock_);
    const bool last = running_ == 1 && (tasks_.empty() || tasks_.front().alone);
    return last ? threadsBeside : std::min(2, threadsBeside);
}


void Foam::timeWriter::formatOnly(const writtenFile& file)
{
    const auto from = std::chrono::steady_clock::now();
    trialBytes_ += file.formatOnly(freeCores_ ? severalThreads() : 1).bytes;
    const std::chrono::duration<double> took =
        std::chrono::steady_clock::now() - from;
    trialSeconds_ += took.count();
}


void Foam::timeWriter::add(job next, bool alone)
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
        tasks_.push_back({std::move(next), alone});
    }
    changed_.notify_all();
}


Foam::timeWriter::~timeWriter()
{
    {
        const std::lock_guard<std::mutex> locked(lock_);
        stop_ = true;
    }
    changed_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::timeWriter& Foam::timeWriter::ofRun()
{
    static timeWriter writer;
    return writer;
}


void Foam::timeWriter::begin(const fileName& timePath, bool asynchronous)
{
    wait();
    timeManifest::begin(timePath);
    timePath_ = timePath;
    sums_.clear();
    open_ = true;
    asynchronous_ = asynchronous;
    const std::size_t threads = asynchronous_ ? (freeCores_ ? threadsBeside : 1) : 0;
    while (threads_.size() < threads)
    {
        threads_.emplace_back([this]() { work(); });
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
            const fileSum sum(kept->write(later ? threadsOfFile() : severalThreads()));
            if (!counted || sum.bytes < 0) return;
            const std::lock_guard<std::mutex> locked(lock_);
            sums_[kept->path()] = sum;
        },
        false
    );
}


void Foam::timeWriter::put(job next)
{
    if (onTrial()) return;

    add(std::move(next), true);
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
        },
        true
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
    if (!failure.empty()) tasks_.clear();
    return failure;
}


void Foam::timeWriter::tell(const std::string& what)
{
    if (onTrial()) return;

    const std::lock_guard<std::mutex> locked(lock_);
    told_.push_back(what);
}


void Foam::timeWriter::logTold()
{
    std::vector<std::string> told;
    {
        const std::lock_guard<std::mutex> locked(lock_);
        told.swap(told_);
    }
    for (const std::string& what : told) Info<< what.c_str() << nl << endl;
}


void Foam::timeWriter::check()
{
    logTold();
    const std::string failure(fault());
    if (!failure.empty())
    {
        FatalErrorInFunction << failure.c_str() << exit(FatalError);
    }
}


void Foam::timeWriter::idle()
{
    std::unique_lock<std::mutex> locked(lock_);
    changed_.wait(locked, [&]() { return tasks_.empty() && running_ == 0; });
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
    ofRun().logTold();
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

/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "allRanks.H"
#include "OSspecific.H"
#include "pstreamTransport.H"
#include "PstreamReduceOps.H"
#include <algorithm>
#include <cstdlib>
#include <omp.h>
#include <sched.h>
#include <set>
#include <sstream>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool Foam::onAnyRank(bool own)
{
    return returnReduce(own, orOp<bool>());
}


bool Foam::onAllRanks(bool own)
{
    return returnReduce(own, andOp<bool>());
}


int64_t Foam::sumOfRanks(int64_t own)
{
    if (!Pstream::parRun()) return own;

    std::vector<std::int64_t> sum(1, own);
    pstreamTransport().sum(sum);
    return sum[0];
}


std::vector<std::string> Foam::textsOfRanks(const std::string& own)
{
    if (!Pstream::parRun()) return {own};

    pstreamTransport ranks;
    const riprap::RankBytes text(own.begin(), own.end());
    std::vector<riprap::RankBytes> in;
    ranks.exchange(std::vector<riprap::RankBytes>(ranks.size(), text), in);
    std::vector<std::string> texts;
    texts.reserve(in.size());
    for (const riprap::RankBytes& bytes : in)
    {
        texts.emplace_back(bytes.begin(), bytes.end());
    }
    return texts;
}


std::string Foam::firstTextOfRanks(const std::string& own)
{
    for (const std::string& text : textsOfRanks(own))
    {
        if (!text.empty()) return text;
    }
    return std::string();
}


std::string Foam::textOfMaster(const std::string& own)
{
    return textsOfRanks(Pstream::master() ? own : std::string()).front();
}


Foam::fileName Foam::constantOfCase(const Time& time)
{
    return
        Pstream::parRun()
      ? time.globalPath()/time.constant()
      : fileName(time.constant());
}


void Foam::stopIfAny(const std::string& failure)
{
    const std::string first(firstTextOfRanks(failure));
    if (!first.empty())
    {
        FatalErrorInFunction << first.c_str() << exit(FatalError);
    }
}


void Foam::shareThreads()
{
    if (!Pstream::parRun() || std::getenv("OMP_NUM_THREADS")) return;

    // Cores that the processes of this machine may use, together
    const std::string host(hostName() + ':');
    std::string own(host);
    cpu_set_t cores;
    CPU_ZERO(&cores);
    sched_getaffinity(0, sizeof(cores), &cores);
    for (int core = 0; core < CPU_SETSIZE; ++core)
    {
        if (CPU_ISSET(core, &cores)) own += ' ' + std::to_string(core);
    }
    int here = 0;
    std::set<int> all;
    for (const std::string& text : textsOfRanks(own))
    {
        if (text.compare(0, host.size(), host) != 0) continue;
        ++here;
        std::istringstream numbers(text.substr(host.size()));
        for (int core; numbers >> core;) all.insert(core);
    }
    omp_set_num_threads(std::max(1, int(all.size())/here));
}


// ************************************************************************* //

// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/ranks/peerMemory.hpp"
#include <unistd.h>
#include <algorithm>
#include <fstream>
#include "core/ranks/joinRanks.hpp"

namespace riprap
{

namespace
{

//- What tells machines, processes and GPUs apart
struct Identity
{
    char machine[64] = {};
    std::int64_t process = 0;
    char gpu[16] = {};
};

Identity identity()
{
    Identity me;
    // processes of one kernel: names of machines may be alike
    std::ifstream file("/proc/sys/kernel/random/boot_id");
    std::string boot;
    if (file >> boot) boot.copy(me.machine, sizeof(me.machine) - 1);
    else gethostname(me.machine, sizeof(me.machine) - 1);
    me.process = getpid();
    int device = 0;
    cudaDeviceProp p;
    checkCuda(cudaGetDevice(&device), "device");
    checkCuda(cudaGetDeviceProperties(&p, device), "device");
    std::memcpy(me.gpu, p.uuid.bytes, sizeof(me.gpu));
    return me;
}

template<class T>
bool alike(const T& a, const T& b) { return std::memcmp(&a, &b, sizeof(T)) == 0; }

//- Can the GPU in use reach that one?
bool reaches(const Identity& other)
{
    int here = 0, count = 0;
    checkCuda(cudaGetDevice(&here), "device");
    checkCuda(cudaGetDeviceCount(&count), "device");
    for (int k = 0; k < count; ++k)
    {
        cudaDeviceProp p;
        int can = 0;
        checkCuda(cudaGetDeviceProperties(&p, k), "device");
        if (std::memcmp(other.gpu, p.uuid.bytes, sizeof(other.gpu)) != 0) continue;
        checkCuda(cudaDeviceCanAccessPeer(&can, here, k), "device");
        return can;
    }
    return false;
}

//- What each rank tells the others of its memory
struct Export
{
    cudaIpcMemHandle_t handle = {};
    std::array<std::int64_t, 2> words = {};
    std::int64_t isNew = 0;
};

// CUDA shares whole pieces of this size
constexpr std::size_t piece = std::size_t(2) << 20;

}


std::string PeerMemory::whyNot(Transport& ranks)
{
    std::vector<Identity> all(1, identity());
    join(ranks, all);
    for (std::size_t a = 0; a < all.size(); ++a)
    {
        if (!alike(all[a].machine, all[0].machine)) return "processes are on several machines";
        for (std::size_t b = 0; b < a; ++b)
        {
            if (all[a].process == all[b].process) return "ranks are threads of one process";
            if (alike(all[a].gpu, all[b].gpu)) return "processes share a GPU";
        }
    }
    bool can = true;
    for (int r = 0; r < ranks.size(); ++r) if (r != ranks.rank()) can = can && reaches(all[r]);
    if (largestOfRanks(ranks, double(!can)) > 0) return "a GPU does not reach another";

    // drivers and containers may forbid it all the same
    bool failed = false;
    PeerMemory trial;
    Words words(ranks.size());
    try { trial.fit(ranks, 1, words); }
    catch (const std::runtime_error&) { failed = true; }
    trial.closeOthers();
    largestOfRanks(ranks, 0);               // nobody has it open any more
    cudaFree(trial.own_);
    cudaGetLastError();
    return largestOfRanks(ranks, double(failed)) > 0 ? "CUDA does not share memory here" : "";
}


//- Others may have this rank's memory open, and end at another time: it goes with the process
PeerMemory::~PeerMemory() { closeOthers(); }


void PeerMemory::closeOthers()
{
    for (unsigned char*& other : of_)
    {
        if (other) cudaIpcCloseMemHandle(other);
        other = nullptr;
    }
}


//- Memory of room_ bytes, and its handle. Errors are told once all ranks have sent theirs
cudaError_t PeerMemory::exportNew(cudaIpcMemHandle_t& handle)
{
    try { own_ = static_cast<unsigned char*>(allocateOnDevice(room_)); }
    catch (const std::runtime_error&) { return cudaErrorMemoryAllocation; }
    cudaError_t failed = cudaMemset(own_, 0, room_);
    if (failed == cudaSuccess) failed = cudaDeviceSynchronize();
    return failed == cudaSuccess ? cudaIpcGetMemHandle(&handle, own_) : failed;
}


void PeerMemory::fit(Transport& ranks, std::size_t bytes, Words& words)
{
    const int n = ranks.size(), me = ranks.rank();
    of_.resize(n, nullptr);
    unsigned char* old = nullptr;
    Export mine;
    cudaError_t failed = cudaSuccess;
    if (bytes > room_ || !own_)
    {
        old = own_;
        room_ = (bytes + bytes/4 + piece - 1)/piece*piece;
        mine.isNew = 1;
        own_ = nullptr;
        failed = exportNew(mine.handle);
    }
    std::vector<RankBytes> out(n), in;
    for (int r = 0; r < n; ++r)
    {
        mine.words = words[r];
        putValues(out[r], &mine);
    }
    ranks.exchange(out, in);
    bool changed = false;
    for (int r = 0; r < n; ++r)
    {
        Export theirs;
        const unsigned char* from = in[r].data();
        takeValues(from, &theirs);
        words[r] = theirs.words;
        changed = changed || theirs.isNew;
        if (r == me || !theirs.isNew) continue;
        if (of_[r]) cudaIpcCloseMemHandle(of_[r]);
        of_[r] = nullptr;
        void* opened = nullptr;
        const cudaError_t e = cudaIpcOpenMemHandle(
            &opened, theirs.handle, cudaIpcMemLazyEnablePeerAccess);
        if (e == cudaSuccess) of_[r] = static_cast<unsigned char*>(opened);
        else failed = e;
    }
    // nobody has the old memory open any more
    if (changed) largestOfRanks(ranks, 0);
    cudaFree(old);
    if (failed != cudaSuccess) cudaGetLastError();
    checkCuda(failed, "memory shared by processes");
}

} // namespace riprap

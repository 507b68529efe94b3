/*  Large copies between a GPU and memory of the host that is not pinned.

    The driver makes such a copy with one thread, and waits for each page that is touched for the
    first time: 0.36 s for 400 MB on an H200's machine. In pieces through pinned memory, while
    threads of the host copy the piece before, it takes 0.04 s.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <mutex>
#include <stdexcept>
#include <string>
#include <cuda_runtime.h>
#include <omp.h>

namespace riprap
{

inline void checkCuda(cudaError_t e, const char* what)
{
    if (e != cudaSuccess)
        throw std::runtime_error(std::string("CUDA: ") + what + ": " + cudaGetErrorString(e));
}

class StagedCopies
{
public:
    //- From so many bytes on
    static constexpr std::size_t worth = std::size_t(2) << 20;

    //- One for all of a process: its memory is kept
    static StagedCopies& ofProcess()
    {
        static StagedCopies& all = *new StagedCopies;
        return all;
    }

    //- Another for threads that fetch what is written: the run does not wait for them
    static StagedCopies& ofWriting()
    {
        static StagedCopies& all = *new StagedCopies;
        return all;
    }

    //- Waits for the copy
    void toHost(cudaStream_t stream, void* to, const void* from, std::size_t bytes)
    {
        const std::lock_guard<std::mutex> locked(mutex_);
        prepare();
        const auto ask = [&](std::size_t p)
        {
            checkCuda(cudaMemcpyAsync(memory(p), at(from, p), size(p, bytes),
                          cudaMemcpyDeviceToHost, stream),
                "copy");
            checkCuda(cudaEventRecord(done_[p % pieces], stream), "event");
        };
        const std::size_t all = (bytes + piece - 1)/piece;
        for (std::size_t p = 0; p < std::min(all, pieces); ++p) ask(p);
        for (std::size_t p = 0; p < all; ++p)
        {
            checkCuda(cudaEventSynchronize(done_[p % pieces]), "copy");
            copy(static_cast<char*>(to) + p*piece, memory(p), size(p, bytes));
            if (p + pieces < all) ask(p + pieces);
        }
    }

    //- Waits for the copy
    void toDevice(cudaStream_t stream, void* to, const void* from, std::size_t bytes)
    {
        const std::lock_guard<std::mutex> locked(mutex_);
        prepare();
        for (std::size_t p = 0; p*piece < bytes; ++p)
        {
            if (p >= pieces) checkCuda(cudaEventSynchronize(done_[p % pieces]), "copy");
            copy(memory(p), at(from, p), size(p, bytes));
            checkCuda(cudaMemcpyAsync(static_cast<char*>(to) + p*piece, memory(p), size(p, bytes),
                          cudaMemcpyHostToDevice, stream),
                "copy");
            checkCuda(cudaEventRecord(done_[p % pieces], stream), "event");
        }
        checkCuda(cudaStreamSynchronize(stream), "copy");
    }

private:

    static constexpr std::size_t piece = std::size_t(4) << 20, pieces = 4;

    static const char* at(const void* from, std::size_t p)
    { return static_cast<const char*>(from) + p*piece; }
    static std::size_t size(std::size_t p, std::size_t bytes)
    { return std::min(piece, bytes - p*piece); }
    char* memory(std::size_t p) { return memory_ + (p % pieces)*piece; }

    //- By all threads
    static void copy(char* to, const char* from, std::size_t bytes)
    {
        const int threads = omp_get_max_threads();
        #pragma omp parallel for schedule(static) num_threads(threads)
        for (int t = 0; t < threads; ++t)
        {
            const std::size_t begin = bytes*t/threads, end = bytes*(t + 1)/threads;
            std::memcpy(to + begin, from + begin, end - begin);
        }
    }

    //- Events are of the device in use
    void prepare()
    {
        int device = 0;
        checkCuda(cudaGetDevice(&device), "device");
        if (device == device_) return;
        if (!memory_)
            checkCuda(cudaHostAlloc(reinterpret_cast<void**>(&memory_), pieces*piece,
                          cudaHostAllocPortable),
                "pinned memory");
        for (cudaEvent_t& e : done_)
            checkCuda(cudaEventCreateWithFlags(&e, cudaEventDisableTiming), "event");
        device_ = device;
    }

    std::mutex mutex_;
    char* memory_ = nullptr;
    cudaEvent_t done_[pieces] = {};
    int device_ = -1;
};

} // namespace riprap

/*  Arrays of the device as they are now, for one who reads them later.

    kept: each array is copied on the device, which takes a thousandth of the time that its way to
    the host takes; any thread fetches the copies while the run goes on. Where the device has no
    room for a copy, and on the CPU, it is made in the host's memory at once.

    Else nothing is copied: what is read is what the arrays have when it is read.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <functional>
#include <memory>
#include <vector>
#include "core/backend/backend.hpp"

namespace riprap
{

//- Puts what was there to memory of the host
using ReadBytes = std::function<void(void* to)>;
template<class T> using ReadValues = std::function<std::vector<T>()>;

inline ReadBytes readKept(const std::shared_ptr<const std::vector<unsigned char>>& bytes)
{
    return [bytes](void* to)
    { if (!bytes->empty()) std::memcpy(to, bytes->data(), bytes->size()); };
}

//- Copies of device memory: keep() gives nothing where there is no room
template<class Backend>
class DeviceCopies
{
public:
    ReadBytes keep(Context<Backend>&, const void*, std::size_t) { return nullptr; }
};

#ifdef __CUDACC__

template<>
class DeviceCopies<Gpu>
{
public:

    ReadBytes keep(Context<Gpu>& context, const void* from, std::size_t bytes)
    {
        if (!kept_) kept_ = std::make_shared<Kept>();
        if (!CopyBudget::ofProcess().take(bytes)) return nullptr;
        void* copy = nullptr;
        if (cudaMallocAsync(&copy, bytes, context.stream) != cudaSuccess)
        {
            cudaGetLastError();
            return nullptr;
        }
        kept_->copies.push_back(copy);
        checkCuda(cudaMemcpyAsync(copy, from, bytes, cudaMemcpyDeviceToDevice, context.stream),
            "copy");
        checkCuda(cudaEventRecord(kept_->taken, context.stream), "event");
        return [kept = kept_, copy, bytes](void* to) { kept->read(to, copy, bytes); };
    }

private:

    //- Of all arrays of a snapshot, until the last of them has been read
    struct Kept
    {
        int device = 0;
        cudaStream_t stream = nullptr;
        cudaEvent_t taken = nullptr;
        std::vector<void*> copies;

        Kept()
        {
            checkCuda(cudaGetDevice(&device), "device");
            checkCuda(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking), "stream");
            checkCuda(cudaEventCreateWithFlags(&taken, cudaEventDisableTiming), "event");
            CopyBudget::ofProcess().enter();
        }
        Kept(const Kept&) = delete;
        ~Kept()
        {
            cudaSetDevice(device);
            cudaStreamWaitEvent(stream, taken, 0);      // of copies that nobody has read
            for (void* copy : copies) cudaFreeAsync(copy, stream);
            CopyBudget::ofProcess().leave();
            cudaEventDestroy(taken);
            cudaStreamDestroy(stream);
        }

        void read(void* to, const void* copy, std::size_t bytes)
        {
            checkCuda(cudaSetDevice(device), "device");
            checkCuda(cudaStreamWaitEvent(stream, taken, 0), "event");
            if (bytes >= StagedCopies::worth)
                return StagedCopies::ofWriting().toHost(stream, to, copy, bytes);
            checkCuda(cudaMemcpyAsync(to, copy, bytes, cudaMemcpyDeviceToHost, stream), "copy");
            checkCuda(cudaStreamSynchronize(stream), "copy");
        }
    };

    std::shared_ptr<Kept> kept_;
};

#endif

template<class Backend>
class Snapshot
{
public:

    Snapshot(Context<Backend>& context, bool keeps) : context_(context), keeps_(keeps) {}

    bool keeps() const { return keeps_; }

    ReadBytes bytes(const void* from, std::size_t n)
    {
        if (!n) return [](void*) {};
        if (!keeps_)
            return [context = &context_, from, n](void* to) { context->toHost(to, from, n); };
        if (ReadBytes copy = copies_.keep(context_, from, n)) return copy;
        const auto there = std::make_shared<std::vector<unsigned char>>(n);
        context_.toHost(there->data(), from, n);
        return readKept(there);
    }

    template<class T>
    ReadValues<T> values(const T* from, std::size_t n)
    {
        const ReadBytes read = bytes(from, n*sizeof(T));
        return [read, n]
        {
            std::vector<T> host(n);
            read(host.data());
            return host;
        };
    }

    template<class T>
    ReadValues<T> values(const Array<Backend, T>& array)
    {
        return values(array.data(), array.size());
    }

private:

    Context<Backend>& context_;
    DeviceCopies<Backend> copies_;
    bool keeps_;
};

} // namespace riprap

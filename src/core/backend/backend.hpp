/*  Backends: Cpu (OpenMP) and Gpu (CUDA), the context in which kernels are launched, and device
    memory.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>
#include "core/simd/macros.hpp"
#include "core/backend/profile.hpp"
#ifdef __CUDACC__
    #include "core/backend/deviceMemory.hpp"
#endif

namespace riprap
{

struct Cpu { static constexpr bool gpu = false; };
struct Gpu { static constexpr bool gpu = true; };

template<class Backend> class Context;

template<>
class Context<Cpu>
{
public:
    Profile profile;
    void synchronise() {}
    void follow(const Context&) {}
    void* allocate(std::size_t bytes)
    {
        void* p = std::aligned_alloc(64, (bytes + 127)/64*64);
        if (!p) throw std::runtime_error("out of memory: " + std::to_string(bytes) + " bytes");
        return p;
    }
    void release(void* p) { std::free(p); }
    void toDevice(void* to, const void* from, std::size_t bytes) { std::memcpy(to, from, bytes); }
    void toHost(void* to, const void* from, std::size_t bytes) { std::memcpy(to, from, bytes); }
    void zero(void* p, std::size_t bytes) { std::memset(p, 0, bytes); }
};

#ifdef __CUDACC__

template<>
class Context<Gpu>
{
public:
    Profile profile;
    cudaStream_t stream = nullptr;
    cudaEvent_t start = nullptr, stop = nullptr;

    Context()
    {
        checkCuda(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking), "stream");
        checkCuda(cudaEventCreate(&start), "event");
        checkCuda(cudaEventCreate(&stop), "event");
    }
    Context(const Context&) = delete;
    ~Context()
    {
        cudaStreamSynchronize(stream);
        cudaFree(parts_);
        cudaEventDestroy(start);
        cudaEventDestroy(stop);
        if (own_) cudaStreamDestroy(stream);
    }

    //- From now on in the order of another context's launches, which must live longer
    void follow(const Context& other)
    {
        synchronise();
        if (own_) checkCuda(cudaStreamDestroy(stream), "stream");
        stream = other.stream;
        own_ = false;
    }
    void synchronise() { checkCuda(cudaStreamSynchronize(stream), "kernel"); }
    void* allocate(std::size_t bytes)
    {
        return allocateOnDevice(bytes + 256);
    }
    void release(void* p) { cudaFree(p); }
    void toDevice(void* to, const void* from, std::size_t bytes)
    {
        if (bytes >= StagedCopies::worth)
            return StagedCopies::ofProcess().toDevice(stream, to, from, bytes);
        checkCuda(cudaMemcpyAsync(to, from, bytes, cudaMemcpyHostToDevice, stream), "copy");
        synchronise();
    }
    void toHost(void* to, const void* from, std::size_t bytes)
    {
        if (bytes >= StagedCopies::worth)
            return StagedCopies::ofProcess().toHost(stream, to, from, bytes);
        checkCuda(cudaMemcpyAsync(to, from, bytes, cudaMemcpyDeviceToHost, stream), "copy");
        synchronise();
    }
    void zero(void* p, std::size_t bytes)
    {
        checkCuda(cudaMemsetAsync(p, 0, bytes, stream), "memset");
    }

    //- Room for partial sums, kept from one sum to the next: to give memory back would wait for the
    //  device
    double* parts(std::size_t n)
    {
        if (n > partsRoom_)
        {
            if (parts_) release(parts_);
            parts_ = static_cast<double*>(allocate(n*sizeof(double)));
            partsRoom_ = n;
        }
        return parts_;
    }

private:
    double* parts_ = nullptr;
    std::size_t partsRoom_ = 0;
    bool own_ = true;
};

#endif

//- Device memory of n T, owned; padded at the end so that vector loads may run over
template<class Backend, class T>
class Array
{
public:
    Array() = default;
    Array(const Array&) = delete;
    Array& operator=(const Array&) = delete;
    Array(Array&& o) noexcept { swap(o); }
    Array& operator=(Array&& o) noexcept { swap(o); return *this; }
    ~Array() { if (data_) context_->release(data_); }

    //- Contents are lost; grows only when it must
    void allocate(Context<Backend>& context, std::size_t n)
    {
        if (n > capacity_ || !data_)
        {
            if (data_) context_->release(data_);
            data_ = nullptr;
            context_ = &context;
            capacity_ = n;
            // a register of any type may be loaded at the last element: what it finds beyond must
            // be finite
            const std::size_t bytes = n*sizeof(T) + (sizeof(T) < 4 ? 64 : 16*sizeof(T));
            data_ = static_cast<T*>(context.allocate(bytes));
            context.zero(data_, bytes);
        }
        size_ = n;
    }

    void upload(Context<Backend>& context, const std::vector<T>& host)
    {
        allocate(context, host.size());
        if (!host.empty()) context.toDevice(data_, host.data(), host.size()*sizeof(T));
    }

    std::vector<T> download() const
    {
        std::vector<T> host(size_);
        if (size_) context_->toHost(host.data(), data_, size_*sizeof(T));
        return host;
    }

    T* data() { return data_; }
    const T* data() const { return data_; }
    std::size_t size() const { return size_; }
    std::size_t bytes() const { return data_ ? capacity_*sizeof(T) : 0; }

    void swap(Array& o) noexcept
    {
        std::swap(data_, o.data_);
        std::swap(size_, o.size_);
        std::swap(capacity_, o.capacity_);
        std::swap(context_, o.context_);
    }

private:
    T* data_ = nullptr;
    std::size_t size_ = 0, capacity_ = 0;
    Context<Backend>* context_ = nullptr;
};

} // namespace riprap

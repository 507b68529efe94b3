/*  Memory of the host that is copied to and from a device: pinned where there is one. Copies that
    the host does not wait for.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/backend.hpp"

namespace riprap
{

template<class Backend>
class HostMemory
{
public:
    //- Contents are lost where it must grow
    unsigned char* room(std::size_t n)
    {
        if (n > bytes_.size()) bytes_.resize(n + n/4);
        return bytes_.data();
    }
    unsigned char* data() { return bytes_.data(); }

private:
    std::vector<unsigned char> bytes_;
};

//- In the order of launches; `from` is of HostMemory, and must stay until something has waited
inline void toDeviceLater(Context<Cpu>&, void* to, const void* from, std::size_t bytes)
{
    std::memcpy(to, from, bytes);
}

//- Within the memory of a device, in the order of launches
inline void copyOnDevice(Context<Cpu>&, void* to, const void* from, std::size_t bytes)
{
    if (bytes) std::memcpy(to, from, bytes);
}

#ifdef __CUDACC__

inline void toDeviceLater(Context<Gpu>& context, void* to, const void* from, std::size_t bytes)
{
    checkCuda(cudaMemcpyAsync(to, from, bytes, cudaMemcpyHostToDevice, context.stream), "copy");
}

inline void copyOnDevice(Context<Gpu>& context, void* to, const void* from, std::size_t bytes)
{
    checkCuda(cudaMemcpyAsync(to, from, bytes, cudaMemcpyDeviceToDevice, context.stream), "copy");
}

template<>
class HostMemory<Gpu>
{
public:
    HostMemory() = default;
    HostMemory(const HostMemory&) = delete;
    HostMemory& operator=(const HostMemory&) = delete;
    ~HostMemory() { if (data_) cudaFreeHost(data_); }

    unsigned char* room(std::size_t n)
    {
        if (n <= size_ && data_) return data_;
        if (data_) checkCuda(cudaFreeHost(data_), "pinned memory");
        data_ = nullptr;
        size_ = n + n/4 + 256;
        checkCuda(cudaMallocHost(&data_, size_), "pinned memory");
        return data_;
    }
    unsigned char* data() { return data_; }

private:
    unsigned char* data_ = nullptr;
    std::size_t size_ = 0;
};

#endif

} // namespace riprap

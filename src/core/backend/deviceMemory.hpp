/*  Memory of a GPU that is shared between a scene and copies of it that are being fetched.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <thread>
#include "core/backend/stagedCopies.hpp"

namespace riprap
{

//- How much of a device copies may take: half of what was free when the first of those that there
//  are was made. Their memory comes from the device's pool, which keeps some for the next ones
class CopyBudget
{
public:

    static CopyBudget& ofProcess()
    {
        static CopyBudget all;
        return all;
    }

    //- One more who makes copies, on the device in use
    void enter()
    {
        const std::lock_guard<std::mutex> locked(mutex_);
        if (users_++ == 0) left_ = free()/2;
    }

    void leave()
    {
        const std::lock_guard<std::mutex> locked(mutex_);
        --users_;
    }

    bool take(std::size_t bytes)
    {
        const std::lock_guard<std::mutex> locked(mutex_);
        if (bytes > left_) return false;
        left_ -= bytes;
        return true;
    }

    int users()
    {
        const std::lock_guard<std::mutex> locked(mutex_);
        return users_;
    }

    //- What the device's pool keeps and nobody uses goes back to the device
    static void giveBack()
    {
        int device = 0;
        cudaMemPool_t pool;
        if (cudaGetDevice(&device) == cudaSuccess
            && cudaDeviceGetDefaultMemPool(&pool, device) == cudaSuccess)
            cudaMemPoolTrimTo(pool, 0);
        cudaGetLastError();
    }

private:

    static std::size_t free()
    {
        int device = 0, pools = 0;
        checkCuda(cudaGetDevice(&device), "device");
        checkCuda(cudaDeviceGetAttribute(&pools, cudaDevAttrMemoryPoolsSupported, device),
            "device");
        if (!pools) return 0;
        std::size_t free = 0, all = 0;
        checkCuda(cudaMemGetInfo(&free, &all), "memory");
        cudaMemPool_t pool;
        checkCuda(cudaDeviceGetDefaultMemPool(&pool, device), "memory");
        std::uint64_t kept = all/8, reserved = 0, used = 0;
        checkCuda(cudaMemPoolSetAttribute(pool, cudaMemPoolAttrReleaseThreshold, &kept), "memory");
        checkCuda(cudaMemPoolGetAttribute(pool, cudaMemPoolAttrReservedMemCurrent, &reserved),
            "memory");
        checkCuda(cudaMemPoolGetAttribute(pool, cudaMemPoolAttrUsedMemCurrent, &used), "memory");
        return free + std::size_t(reserved - used);
    }

    std::mutex mutex_;
    int users_ = 0;
    std::size_t left_ = 0;
};

//- Memory of the device in use. Where there is none, copies give theirs back first
inline void* allocateOnDevice(std::size_t bytes)
{
    void* p = nullptr;
    cudaError_t failed = cudaMalloc(&p, bytes);
    for (bool last = false; failed == cudaErrorMemoryAllocation && !last;)
    {
        cudaGetLastError();
        last = CopyBudget::ofProcess().users() == 0;
        if (!last) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        checkCuda(cudaDeviceSynchronize(), "allocation");
        CopyBudget::giveBack();
        failed = cudaMalloc(&p, bytes);
    }
    checkCuda(failed, "allocation");
    return p;
}

} // namespace riprap

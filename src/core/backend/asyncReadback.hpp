/*  Looks at a value on the device while work goes on behind it: what it was after the launches so
    far, read in the order of asking.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/backend.hpp"

namespace riprap
{

template<class Backend, class T>
class AsyncReadback
{
public:
    static constexpr int most = 2;          // at a time

    int waiting() const { return waiting_; }

    void ask(Context<Backend>& context, const T* from)
    {
        context.toHost(&seen_[(first_ + waiting_) % most], from, sizeof(T));
        ++waiting_;
    }

    //- The oldest one; waits for it
    T take(Context<Backend>&)
    {
        const T seen = seen_[first_];
        first_ = (first_ + 1) % most;
        --waiting_;
        return seen;
    }

private:
    T seen_[most];
    int first_ = 0, waiting_ = 0;
};

#ifdef __CUDACC__

template<class T>
class AsyncReadback<Gpu, T>
{
public:
    static constexpr int most = 2;

    AsyncReadback() = default;
    AsyncReadback(const AsyncReadback&) = delete;
    ~AsyncReadback()
    {
        if (!seen_) return;
        for (cudaEvent_t e : done_) cudaEventDestroy(e);
        cudaFreeHost(seen_);
    }

    int waiting() const { return waiting_; }

    void ask(Context<Gpu>& context, const T* from)
    {
        if (!seen_)
        {
            checkCuda(cudaMallocHost(&seen_, most*sizeof(T)), "pinned memory");
            for (cudaEvent_t& e : done_)
                checkCuda(cudaEventCreateWithFlags(&e, cudaEventDisableTiming), "event");
        }
        const int k = (first_ + waiting_) % most;
        checkCuda(
            cudaMemcpyAsync(seen_ + k, from, sizeof(T), cudaMemcpyDeviceToHost, context.stream),
            "copy");
        checkCuda(cudaEventRecord(done_[k], context.stream), "event");
        ++waiting_;
    }

    T take(Context<Gpu>&)
    {
        checkCuda(cudaEventSynchronize(done_[first_]), "kernel");
        const T seen = seen_[first_];
        first_ = (first_ + 1) % most;
        --waiting_;
        return seen;
    }

private:
    T* seen_ = nullptr;
    cudaEvent_t done_[most] = {};
    int first_ = 0, waiting_ = 0;
};

#endif

} // namespace riprap

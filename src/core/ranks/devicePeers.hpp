/*  Ranks whose GPUs send each other what a step needs without their hosts: a kernel writes into
    memory of the other GPU, then the number of the message; a kernel there waits for that number.
    Hosts launch ahead, and wait for nothing.

    What ranks read lies in two halves by turns. Partners send in both directions, if only the
    number: who has the other's message k + 1 knows that its own message k was read, as the other's
    kernels follow one another. So it may write message k + 2 where k was.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include "core/backend/launch.hpp"
#include "core/ranks/peerMemory.hpp"
#include "core/ranks/transport.hpp"

namespace riprap
{

template<class Backend> class DevicePeers;
template<class Backend> class PeerChannel;

//- None: messages are the host's
template<>
class DevicePeers<Cpu>
{
public:
    DevicePeers(Context<Cpu>&, Transport&, bool) {}
    static constexpr bool there() { return false; }
    void noticeWaiting() {}
    template<class F> void largest(const F&) {}
};

template<> class PeerChannel<Cpu> {};

#ifdef __CUDACC__

//- What kernels that wait have found
struct PeerWaits
{
    unsigned long long waited = 0;      // [ns] since the host looked
    int lost = 0;                       // 1 + a rank that did not answer
    int unused = 0;
};

//- A number that others write: of the last message that is there
class PeerFlag
{
public:
    static constexpr int bytes = 64;

    static __device__ void raise(unsigned char* at, std::uint64_t message)
    {
        __threadfence_system();
        *reinterpret_cast<volatile std::uint64_t*>(at) = message;
    }

    //- rank: whose message it is
    static __device__ void wait(
        const unsigned char* at, std::uint64_t message, int rank, PeerWaits* waits)
    {
        const auto* flag = reinterpret_cast<const volatile std::uint64_t*>(at);
        if (*flag < message)
        {
            const unsigned long long begin = now();
            while (*flag < message && !*reinterpret_cast<volatile int*>(&waits->lost))
                if (now() - begin > patience) waits->lost = 1 + rank;
        }
        __threadfence_system();
    }

    static __device__ unsigned long long now()
    {
        unsigned long long t = 0;
        asm volatile("mov.u64 %0, %%globaltimer;" : "=l"(t));
        return t;
    }

private:
    // [ns] a rank may write files meanwhile; one that has ended ends the run by itself
    static constexpr unsigned long long patience = 1000000000ull*1800;
};

//- A partner, as kernels see it
struct PeerSide
{
    unsigned char* flag;                // of this rank's messages, there
    unsigned char* halves;              // where its messages begin
    std::int64_t half;                  // bytes of one of the two
    const unsigned char* answer;        // the flag of its messages, here
    int rank, first, from, count;       // records: where the first lies there and here; how many
};

template<int threads>
__global__ void __launch_bounds__(threads) sendToPeers(
    const PeerSide* sides, const unsigned char* packed, int each, std::uint64_t message,
    unsigned* done)
{
    const PeerSide s = sides[blockIdx.y];
    const auto* from = reinterpret_cast<const std::uint32_t*>(packed + std::size_t(s.from)*each);
    auto* to = reinterpret_cast<std::uint32_t*>(
        s.halves + (message & 1)*s.half + std::size_t(s.first)*each);
    const std::size_t n = std::size_t(s.count)*each/sizeof(*to);
    for (std::size_t k = blockIdx.x*blockDim.x + threadIdx.x; k < n; k += gridDim.x*blockDim.x)
        to[k] = from[k];
    __threadfence_system();
    __syncthreads();
    if (threadIdx.x != 0 || atomicAdd(done + blockIdx.y, 1u) != gridDim.x - 1) return;
    done[blockIdx.y] = 0;
    PeerFlag::raise(s.flag, message);
}

//- f(k) for n records, when the messages of all partners are there
template<class F>
__global__ void __launch_bounds__(256) afterPeers(
    int n, const F f, const PeerSide* sides, int partners, std::uint64_t message, PeerWaits* waits)
{
    const unsigned long long begin = PeerFlag::now();
    for (int p = threadIdx.x; p < partners; p += blockDim.x)
        PeerFlag::wait(sides[p].answer, message, sides[p].rank, waits);
    __syncthreads();
    if (blockIdx.x == 0 && threadIdx.x == 0) waits->waited += PeerFlag::now() - begin;
    const int k = blockIdx.x*256 + threadIdx.x;
    if (k < n) f(k);
}

//- Numbers of all ranks, the largest of each: f.put(numbers), f.take(numbers)
template<class F>
__global__ void __launch_bounds__(256) agreeOnLargest(
    const F f, unsigned char* const* of, int ranks, int me, std::uint64_t message, PeerWaits* waits)
{
    constexpr int count = F::count;
    __shared__ double numbers[count];
    const std::size_t row = count*sizeof(double), header = std::size_t(ranks)*PeerFlag::bytes,
        half = header + (message & 1)*ranks*row;
    if (threadIdx.x == 0) f.put(numbers);
    __syncthreads();
    for (int r = threadIdx.x; r < ranks; r += blockDim.x)
    {
        if (r == me) continue;
        auto* to = reinterpret_cast<volatile double*>(of[r] + half + me*row);
        for (int k = 0; k < count; ++k) to[k] = numbers[k];
        PeerFlag::raise(of[r] + me*PeerFlag::bytes, message);
    }
    const unsigned long long begin = PeerFlag::now();
    for (int r = threadIdx.x; r < ranks; r += blockDim.x)
        if (r != me) PeerFlag::wait(of[me] + r*PeerFlag::bytes, message, r, waits);
    __syncthreads();
    for (int k = threadIdx.x; k < count; k += blockDim.x)
        for (int r = 0; r < ranks; ++r)
        {
            if (r == me) continue;
            const double x = reinterpret_cast<const volatile double*>(of[me] + half + r*row)[k];
            if (x > numbers[k]) numbers[k] = x;
        }
    __syncthreads();
    if (threadIdx.x != 0) return;
    waits->waited += PeerFlag::now() - begin;
    f.take(numbers);
}

//- Whether the GPUs of all ranks reach each other, and what all of them agree on
template<>
class DevicePeers<Gpu>
{
public:

    //- All ranks make theirs. wanted: else the host sends
    DevicePeers(Context<Gpu>& context, Transport& transport, bool wanted)
        : context_(context), transport_(transport)
    {
        if (!wanted || !PeerMemory::whyNot(transport).empty()) return;
        there_ = true;
        waits_.upload(context, std::vector<PeerWaits>(1));
    }

    bool there() const { return there_; }
    PeerWaits* waits() { return waits_.data(); }

    //- Waits for kernels; what theirs waited is no work of this rank.
    //  \throw std::runtime_error where another rank did not answer
    void noticeWaiting()
    {
        if (!there_) return;
        PeerWaits w;
        context_.toHost(&w, waits_.data(), sizeof(w));
        if (w.lost)
            throw std::runtime_error("GPU of rank " + std::to_string(transport_.rank())
                + ": no answer from rank " + std::to_string(w.lost - 1));
        if (!w.waited) return;
        transport_.waited(1e-9*double(w.waited));
        context_.zero(waits_.data(), sizeof(w));
    }

    //- F: count, put(double*), take(const double*), for the device
    template<class F>
    void largest(const F& f)
    {
        const int n = transport_.size();
        if (!of_.size())
        {
            PeerMemory::Words words(n);
            box_.fit(transport_,
                std::size_t(n)*(PeerFlag::bytes + 2*F::count*sizeof(double)), words);
            std::vector<unsigned char*> of(n);
            for (int r = 0; r < n; ++r) of[r] = r == transport_.rank() ? box_.own() : box_.of(r);
            of_.upload(context_, of);
        }
        ++message_;
        profiled(context_, F::name, [&]
        {
            agreeOnLargest<<<1, 256, 0, context_.stream>>>(
                f, of_.data(), n, transport_.rank(), message_, waits_.data());
        });
    }

private:
    Context<Gpu>& context_;
    Transport& transport_;
    bool there_ = false;
    Array<Gpu, PeerWaits> waits_;
    PeerMemory box_;
    Array<Gpu, unsigned char*> of_;
    std::uint64_t message_ = 0;
};

//- Records that partners send each other time and again
template<>
class PeerChannel<Gpu>
{
public:

    struct Partner { int rank = 0, out = 0, in = 0; };      // records

    //- All ranks, at the same time. Records are of up to `most` bytes
    void set(Context<Gpu>& context, DevicePeers<Gpu>& peers, Transport& transport,
        const std::vector<Partner>& partners, std::size_t most)
    {
        context.synchronise();
        const int n = transport.size();
        std::size_t in = 0, from = 0;
        for (const Partner& p : partners) in += p.in;
        const std::size_t half = (in*most + 255)/256*256;
        PeerMemory::Words words(n);
        in = 0;
        for (auto& w : words) w = {0, std::int64_t(half)};
        for (const Partner& p : partners) { words[p.rank][0] = std::int64_t(in); in += p.in; }
        memory_.fit(transport, header(n) + 2*half, words);
        std::vector<PeerSide> sides;
        for (const Partner& p : partners)
        {
            unsigned char* const there = memory_.of(p.rank);
            sides.push_back(PeerSide{there + transport.rank()*PeerFlag::bytes, there + header(n),
                words[p.rank][1], memory_.own() + p.rank*PeerFlag::bytes, p.rank,
                int(words[p.rank][0]), int(from), p.out});
            from += p.out;
        }
        sides_.upload(context, sides);
        done_.upload(context, std::vector<unsigned>(sides.size(), 0));
        packed_.allocate(context, from*most);
        out_ = int(from);
        in_ = int(in);
        half_ = half;
        most_ = most;
        received_ = memory_.own() + header(n);
        waits_ = peers.waits();
    }

    //- Records of slots, of partners one after the other. P, T: of a list of slots and of bytes
    template<class P, class T>
    void share(Context<Gpu>& context, std::size_t each, P put, T take)
    {
        if (each > most_ || each % sizeof(std::uint32_t))
            throw std::logic_error("records that GPUs send each other are of whole words");
        ++message_;
        const unsigned partners = unsigned(sides_.size());
        if (!partners) return;
        put.bytes = packed_.data();
        take.bytes = received_ + (message_ & 1)*half_;
        forEach(context, out_, put);
        profiled(context, "sendToPeers", [&]
        {
            // enough blocks to fill the way between two GPUs
            const std::size_t blocks = std::min<std::size_t>(64, out_*each/8192 + 1);
            sendToPeers<256><<<dim3(unsigned(blocks), partners), 256, 0, context.stream>>>(
                sides_.data(), packed_.data(), int(each), message_, done_.data());
        });
        profiled(context, T::name, [&]
        {
            afterPeers<<<std::max(1, (in_ + 255)/256), 256, 0, context.stream>>>(
                in_, take, sides_.data(), int(partners), message_, waits_);
        });
    }

private:

    //- Flags by rank, before what they tell of
    static std::size_t header(int ranks)
    {
        return (std::size_t(ranks)*PeerFlag::bytes + 255)/256*256;
    }

    PeerMemory memory_;
    Array<Gpu, PeerSide> sides_;
    Array<Gpu, unsigned> done_;             // blocks that have sent, by partner
    Array<Gpu, unsigned char> packed_;
    unsigned char* received_ = nullptr;
    PeerWaits* waits_ = nullptr;
    std::size_t half_ = 0, most_ = 0;
    int out_ = 0, in_ = 0;
    std::uint64_t message_ = 0;
};

#endif

} // namespace riprap

/*  What processes that share a scene send each other, whatever carries it (OpenFOAM's Pstream,
    threads of a test).

    All ranks make the same calls in the same order. What comes back does not depend on which
    message is faster.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <chrono>
#include <cstdint>
#include <cstring>
#include <vector>

namespace riprap
{

using RankBytes = std::vector<unsigned char>;

//- To or from a rank: memory of the caller, on the host
struct RankMessage { int rank = 0; unsigned char* bytes = nullptr; std::size_t size = 0; };

class Transport
{
public:
    virtual ~Transport() = default;

    virtual int rank() const = 0;
    virtual int size() const = 0;

    //- out[r] goes to rank r, which need not know how long it is; in[r] comes from there. Both are
    //  of length size()
    virtual void exchange(const std::vector<RankBytes>& out, std::vector<RankBytes>& in) = 0;

    //- The same between ranks that know what comes: in[k].bytes has room for in[k].size
    virtual void swap(const std::vector<RankMessage>& out, std::vector<RankMessage>& in) = 0;

    //- Entry by entry over all ranks
    virtual void sum(std::vector<std::int64_t>& values) = 0;
    virtual void largest(std::vector<double>& values) = 0;      // numbers, infinity included

    //- This rank has been in these calls for so long [s], waiting for others most of it
    double seconds() const { return seconds_; }
    //- It has waited elsewhere: in kernels of a GPU [s]
    void waited(double seconds) { seconds_ += seconds; }

protected:

    //- Of what carries the messages: a call, while this lives
    class Call
    {
    public:
        explicit Call(Transport& in) : in_(in), begin_(Clock::now()) {}
        Call(const Call&) = delete;
        Call& operator=(const Call&) = delete;
        ~Call() { in_.seconds_ += std::chrono::duration<double>(Clock::now() - begin_).count(); }

    private:
        using Clock = std::chrono::steady_clock;
        Transport& in_;
        const Clock::time_point begin_;
    };

private:
    double seconds_ = 0;
};

//- Appends plain values to bytes
template<class T>
void putValues(RankBytes& to, const T* from, std::size_t n = 1)
{
    const auto* b = reinterpret_cast<const unsigned char*>(from);
    to.insert(to.end(), b, b + n*sizeof(T));
}

//- Takes plain values from bytes, and goes on behind them
template<class T>
void takeValues(const unsigned char*& from, T* to, std::size_t n = 1)
{
    if (n) std::memcpy(to, from, n*sizeof(T));
    from += n*sizeof(T);
}

} // namespace riprap

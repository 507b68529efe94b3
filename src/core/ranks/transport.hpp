/*  What processes that share a scene send each other, whatever carries it (OpenFOAM's Pstream,
    threads of a test).

    All ranks make the same calls in the same order. What comes back does not depend on which
    message is faster.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

namespace riprap
{

using RankBytes = std::vector<unsigned char>;

//- To or from a rank
struct RankMessage { int rank = 0; RankBytes bytes; };

class Transport
{
public:
    virtual ~Transport() = default;

    virtual int rank() const = 0;
    virtual int size() const = 0;

    //- out[r] goes to rank r, which need not know how long it is; in[r] comes from there. Both are
    //  of length size()
    virtual void exchange(const std::vector<RankBytes>& out, std::vector<RankBytes>& in) = 0;

    //- The same between ranks that know what comes: in[k].bytes has its length already
    virtual void swap(const std::vector<RankMessage>& out, std::vector<RankMessage>& in) = 0;

    //- Entry by entry over all ranks
    virtual void sum(std::vector<std::int64_t>& values) = 0;
    virtual void largest(std::vector<double>& values) = 0;      // numbers, infinity included
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

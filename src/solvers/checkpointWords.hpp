/*  Bytes of a saved state as words, and their checksum.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>
#include "core/backend/machineMemory.hpp"

namespace riprap
{
namespace detail
{

//- FNV-1a over n words
inline std::uint32_t fnv(const std::uint32_t* words, std::size_t n)
{
    std::uint32_t h = 2166136261u;
    for (std::size_t i = 0; i < n; ++i) h = (h ^ words[i])*16777619u;
    return h;
}

//- Words that are summed by one thread
static constexpr std::size_t checksumBlock = 65536;

//- FNV-1a of eight lanes, each of every eighth word: a register's, where one sum would wait for
//  each product in turn
inline std::uint32_t laneChecksum(const std::int32_t* words, std::size_t n)
{
    constexpr int lanes = 8;
    std::uint32_t h[lanes];
    for (std::uint32_t& lane : h) lane = 2166136261u;
    std::size_t i = 0;
    for (; i + lanes <= n; i += lanes)
        for (int l = 0; l < lanes; ++l) h[l] = (h[l] ^ std::uint32_t(words[i + l]))*16777619u;
    for (; i < n; ++i) h[i%lanes] = (h[i%lanes] ^ std::uint32_t(words[i]))*16777619u;
    return fnv(h, lanes);
}

//- FNV-1a over all n words in order. States of any length once ended with it, and are still read
inline std::int32_t serialChecksum(const std::vector<std::int32_t>& words, std::size_t n)
{
    return std::int32_t(fnv(reinterpret_cast<const std::uint32_t*>(words.data()), n));
}

//- Of the first n words: FNV-1a; of more than a block FNV-1a over the lanes' sums of blocks, which
//  threads find at once. Does not depend on their number
inline std::int32_t checksum(const std::vector<std::int32_t>& words, std::size_t n)
{
    if (n <= checksumBlock) return serialChecksum(words, n);
    const std::ptrdiff_t blocks = (n + checksumBlock - 1)/checksumBlock;
    std::vector<std::uint32_t> sums(blocks);
    #pragma omp parallel for schedule(static)
    for (std::ptrdiff_t b = 0; b < blocks; ++b)
    {
        const std::size_t from = b*checksumBlock;
        sums[b] = laneChecksum(&words[from], std::min(checksumBlock, n - from));
    }
    return std::int32_t(fnv(sums.data(), sums.size()));
}

//- Is the last word the checksum of those before it?
inline bool checksumFits(const std::vector<std::int32_t>& words)
{
    const std::size_t n = words.size() - 1;
    return checksum(words, n) == words.back() || serialChecksum(words, n) == words.back();
}

//- Room for n words in all
inline void reserveWords(std::vector<std::int32_t>& words, std::size_t n)
{
    words.reserve(n);
    if (n > words.size()) touchMemory(words.data() + words.size(), 4*(n - words.size()));
}

inline void appendBytes(std::vector<std::int32_t>& words, const void* data, std::size_t bytes)
{
    const std::size_t at = words.size();
    words.resize(at + (bytes + 3)/4, 0);
    if (bytes) std::memcpy(&words[at], data, bytes);
}

} // namespace detail
} // namespace riprap

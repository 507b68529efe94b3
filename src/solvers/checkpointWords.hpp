/*  Bytes of a saved state as words, and their checksum.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

namespace riprap
{
namespace detail
{

//- FNV-1a over the first n words
inline std::int32_t checksum(const std::vector<std::int32_t>& words, std::size_t n)
{
    std::uint32_t h = 2166136261u;
    for (std::size_t i = 0; i < n; ++i) h = (h ^ std::uint32_t(words[i]))*16777619u;
    return std::int32_t(h);
}

inline void appendBytes(std::vector<std::int32_t>& words, const void* data, std::size_t bytes)
{
    const std::size_t at = words.size();
    words.resize(at + (bytes + 3)/4, 0);
    if (bytes) std::memcpy(&words[at], data, bytes);
}

} // namespace detail
} // namespace riprap

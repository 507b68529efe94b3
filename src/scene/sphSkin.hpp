/*  How far beyond the support fluid on the GPU is listed: a thin skin, or a fifth of the support.

    Skins of large scenes are thin, as measured where lists last for ten steps and more (skinRatio, sphSetup.hpp). Where water breaks they last for one
    alone, also without the fastest particles (docs/performance.md), and a rebuild takes as long as three steps.

    Decided by how long lists have lasted, which is the same in every run with the same input, and part of the exact state.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstdint>

namespace riprap
{

struct SkinChoice
{
    // A wide skin lasts about three times as long: between the two bounds neither changes
    static constexpr int few = 4, many = 20, patience = 3;

    bool wide = false;
    int votes = 0;              // pairs of lists that speak for the other skin, since one spoke for this

    //- Two lists have lasted for so many steps in all, or longer if they have not aged. Is it the other skin now?
    bool heed(int steps, bool aged)
    {
        // lists that were given few steps and have not aged say neither
        const bool other = wide ? steps >= 2*many : aged && steps < 2*few, same = wide ? aged && steps < 2*many : steps >= 2*few;
        votes = other ? votes + 1 : (same ? 0 : votes);
        if (votes < patience) return false;
        wide = !wide;
        votes = 0;
        return true;
    }

    std::int32_t word() const { return int(wide) + 2*votes; }
    static SkinChoice of(std::int32_t word) { return SkinChoice{(word & 1) != 0, word/2}; }
};

} // namespace riprap

/*  Checksums of saved states.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <gtest/gtest.h>
#include <omp.h>
#include "solvers/checkpointWords.hpp"

namespace riprap
{
namespace
{

using Words = std::vector<std::int32_t>;

Words someWords(std::size_t n)
{
    Words words(n);
    std::uint32_t x = 12345;
    for (std::int32_t& w : words) w = std::int32_t(x = 1664525u*x + 1013904223u);
    return words;
}

Words withSum(Words words)
{
    words.push_back(detail::checksum(words, words.size()));
    return words;
}

//- Of the published algorithm, over bytes' worth of a word each
std::uint32_t onePass(const std::int32_t* words, std::size_t n, std::size_t step)
{
    std::uint32_t h = 2166136261u;
    for (std::size_t i = 0; i < n; i += step) h = (h ^ std::uint32_t(words[i]))*16777619u;
    return h;
}

TEST(CheckpointWords, FewWordsAreSummedInOrder)
{
    const Words words = someWords(detail::checksumBlock);
    for (const std::size_t n : {std::size_t(0), std::size_t(1), std::size_t(7), words.size()})
        EXPECT_EQ(std::uint32_t(detail::checksum(words, n)), onePass(words.data(), n, 1)) << n;
}

TEST(CheckpointWords, ManyAreSummedByBlocksAndLanes)
{
    // the last block is no multiple of the lanes
    const std::size_t block = detail::checksumBlock, n = 2*block + 1003;
    const Words words = someWords(n);
    Words sums;
    for (std::size_t from = 0; from < n; from += block)
    {
        const std::size_t size = std::min(block, n - from);
        Words lanes;
        for (std::size_t l = 0; l < 8; ++l)
            lanes.push_back(std::int32_t(onePass(&words[from + l], size - l, 8)));
        sums.push_back(std::int32_t(onePass(lanes.data(), 8, 1)));
    }
    EXPECT_EQ(std::uint32_t(detail::checksum(words, n)), onePass(sums.data(), sums.size(), 1));
}

TEST(CheckpointWords, DoNotDependOnThreads)
{
    const Words words = someWords(40*detail::checksumBlock + 17);
    const int before = omp_get_max_threads();
    omp_set_num_threads(1);
    const std::int32_t one = detail::checksum(words, words.size());
    omp_set_num_threads(3);
    EXPECT_EQ(detail::checksum(words, words.size()), one);
    omp_set_num_threads(before);
}

TEST(CheckpointWords, NoticeOneBitAndTwoWordsInEachOthersPlace)
{
    const Words right = withSum(someWords(3*detail::checksumBlock + 5));
    ASSERT_TRUE(detail::checksumFits(right));
    for (std::size_t i = 0; i < right.size(); i += 9973)
    {
        Words words = right;
        words[i] ^= 1 << i % 32;
        EXPECT_FALSE(detail::checksumFits(words)) << i;

        // of one lane; of two blocks
        for (const std::size_t j : {i + 8, i + detail::checksumBlock})
        {
            if (j + 1 >= right.size()) continue;
            words = right;
            std::swap(words[i], words[j]);
            EXPECT_FALSE(detail::checksumFits(words)) << i << ' ' << j;
        }
    }
}

TEST(CheckpointWords, StatesSummedInOneGoAreStillRead)
{
    Words words = someWords(2*detail::checksumBlock);
    words.push_back(detail::serialChecksum(words, words.size()));
    EXPECT_NE(words.back(), detail::checksum(words, words.size() - 1));
    EXPECT_TRUE(detail::checksumFits(words));
    words.back() ^= 64;
    EXPECT_FALSE(detail::checksumFits(words));
}

TEST(CheckpointWords, RoomThatIsTouchedKeepsWhatThereIs)
{
    const Words some = someWords(1003);
    Words words = some;
    const std::size_t n = 3000000;
    detail::reserveWords(words, n);
    EXPECT_GE(words.capacity(), n);
    EXPECT_EQ(words, some);
    const std::int32_t* const at = words.data();
    words.resize(n, 7);
    EXPECT_EQ(words.data(), at);
    EXPECT_TRUE(std::equal(some.begin(), some.end(), words.begin()));
    EXPECT_TRUE(std::all_of(
        words.begin() + some.size(), words.end(), [](std::int32_t w) { return w == 7; }));
}

} // namespace
} // namespace riprap

/*  Sorting, scanning and tabulating cells: against the standard library, for any size and number of
    threads.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <algorithm>
#include <numeric>
#include "backendTest.hpp"
#include "core/neighbours/cellSort.hpp"

namespace riprap
{
namespace
{

struct SortTest : BackendTest
{
    //- Sizes around the limits of threads, blocks and digits
    const std::vector<int> sizes{
        0, 1, 2, 3, 31, 32, 33, 255, 256, 257, 1000, 19999, 20000, 20001, 65537};

    static std::vector<std::uint32_t> keys(int n, std::uint32_t below, unsigned seed)
    {
        Random random(seed);
        std::vector<std::uint32_t> k(n);
        for (auto& v : k) v = random.bits() % below;
        return k;
    }
};

#ifdef __CUDACC__
class GpuSort : public SortTest { };
#define SORT_TEST(name) TEST_F(GpuSort, name)
#else
class CpuSort : public SortTest { };
#define SORT_TEST(name) TEST_F(CpuSort, name)
#endif

SORT_TEST(PairsAreSortedAndStable)
{
    // one, two and three digits of the CPU's radix sort; few different keys: stability shows
    for (const int bits : {1, 3, 11, 12, 22, 23})
        for (const int n : sizes)
        {
            if (n == 0) continue;       // CellSort sorts nothing then
            const auto key = keys(n, 1u << bits, unsigned(n + bits));
            std::vector<std::uint32_t> expected(n), value(n);
            std::iota(expected.begin(), expected.end(), 0);
            std::stable_sort(expected.begin(), expected.end(),
                [&](std::uint32_t a, std::uint32_t b) { return key[a] < key[b]; });
            std::iota(value.begin(), value.end(), 0);
            withThreads([&](int threads)
            {
                Context<Backend> context;
                SortScratch<Backend> s;
                for (int k = 0; k < 2; ++k)
                {
                    s.keys[k].allocate(context, n);
                    s.values[k].allocate(context, n);
                }
                s.keys[0].upload(context, key);
                s.values[0].upload(context, value);
                sortPairs(context, s, n, bits);
                context.synchronise();
                EXPECT_EQ(s.values[1].download(), expected)
                    << n << " keys of " << bits << " bits, " << threads << " threads";
                auto sorted = key;
                std::sort(sorted.begin(), sorted.end());
                EXPECT_EQ(s.keys[1].download(), sorted);
            });
        }
}

SORT_TEST(ScanSumsAllBefore)
{
    for (const int n : sizes)
    {
        if (n == 0) continue;
        Random random{unsigned(n)};
        std::vector<int> data(n), expected(n);
        for (int& v : data) v = int(random.bits() % 20);
        std::exclusive_scan(data.begin(), data.end(), expected.begin(), 0);
        Context<Backend> context;
        SortScratch<Backend> s;
        Array<Backend, int> device;
        device.upload(context, data);
        exclusiveScan(context, s, device.data(), n);
        context.synchronise();
        EXPECT_EQ(device.download(), expected) << n;
    }
}

//- Cells begin where they should, order is stable, and what has the key `cells` (in no cell) comes
//  last
SORT_TEST(CellsAreTabulated)
{
    for (const int cells : {1, 2, 1000, 3000})
        for (const int n : sizes)
            withThreads(
                [&](int threads)
                {
                    SCOPED_TRACE(std::to_string(n) + " particles, " + std::to_string(cells)
                        + " cells, " + std::to_string(threads) + " threads");
                    const auto key = keys(n, std::uint32_t(cells) + 1, 5);
                    Context<Backend> context;
                    CellSort<Backend> sort;
                    sort.allocate(context, n, cells);
                    int active = -1;
                    context.toHost(&active, sort.active(), sizeof(int));
                    EXPECT_EQ(active, n) << "before the first sort all are in use";
                    std::vector<std::uint32_t> index(n);
                    std::iota(index.begin(), index.end(), 0);
                    if (n)
                    {
                        context.toDevice(sort.keys(), key.data(), n*sizeof(std::uint32_t));
                        context.toDevice(sort.indices(), index.data(), n*sizeof(std::uint32_t));
                    }
                    sort.sort(context, n);
                    context.synchronise();

                    std::stable_sort(index.begin(), index.end(),
                        [&](std::uint32_t a, std::uint32_t b) { return key[a] < key[b]; });
                    std::vector<std::uint32_t> order(n);
                    if (n) context.toHost(order.data(), sort.order(), n*sizeof(std::uint32_t));
                    EXPECT_EQ(order, index);
                    std::vector<int> start(cells + 2), expected(cells + 2, 0);
                    context.toHost(start.data(), sort.start(), start.size()*sizeof(int));
                    for (const auto k : key) ++expected[k + 1];
                    std::partial_sum(expected.begin(), expected.end(), expected.begin());
                    EXPECT_EQ(start, expected);
                    context.toHost(&active, sort.active(), sizeof(int));
                    EXPECT_EQ(active, expected[cells]);
                });
}

} // namespace
} // namespace riprap
